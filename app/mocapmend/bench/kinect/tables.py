"""The tables, as the paper has them, and the targets."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from mocapmend.bench.grid import Cell, Column, Grid, share
from mocapmend.bench.kinect.few_shot import Worth
from mocapmend.bench.kinect.networks import Network
from mocapmend_algorithms.refine.measures import Errors
from mocapmend_algorithms.refine.model import Model

ERRORS = (
    Column("position_mm2", "Lp (mm²)", ".0f"),
    Column("bones_mm2", "Lb (mm²)", ".1f"),
    Column("smoothness_mm2", "Ls (mm²)", ".3f"),
)
RATIOS = (
    Column("position_ratio", "Lp / ridge", ".2f"),
    Column("bones_ratio", "Lb / ridge", ".2f"),
    Column("smoothness_ratio", "Ls / ridge", ".2f"),
)


@dataclass(frozen=True)
class Row:
    """One way on one split.

    Attributes
    ----------
    split, way : str
        Which.
    errors : Errors
        Over the pairs held out.
    ridge : Errors
        Of what it is held against.
    """

    split: str
    way: str
    errors: Errors
    ridge: Errors

    def cells(self) -> dict[str, Cell]:
        """Return the cells of a table."""
        one, other = self.errors, self.ridge
        return {
            "split": self.split,
            "way": self.way,
            "position_mm2": one.position,
            "bones_mm2": one.bones,
            "smoothness_mm2": one.smoothness,
            "position_ratio": one.position / other.position,
            "bones_ratio": one.bones / other.bones,
            "smoothness_ratio": one.smoothness / other.smoothness,
        }


def stacks(found: Mapping[Network, tuple[Model, Errors]]) -> Grid:
    """Return the paper's table 1: smoothness and the number of stacks."""
    rows: list[dict[str, Cell]] = [
        {
            "network": network.name,
            "stacks": network.stacks,
            "weights": model.size,
            "position_mm2": errors.position,
            "bones_mm2": errors.bones,
            "smoothness_mm2": errors.smoothness,
        }
        for network, (model, errors) in sorted(found.items(), key=lambda item: item[0].stacks)
    ]
    columns = (Column("network", "network"), Column("stacks", "N"), Column("weights", "weights"))
    return Grid("stacks", "Smoothness and the number of stacks (seen)", (*columns, *ERRORS), rows)


def structures(networks: Sequence[Network]) -> Grid:
    """Return the paper's table 2: what the networks have."""
    rows: list[dict[str, Cell]] = [
        {"network": one.name, "stacked": one.stacks > 1, "latent": one.latent} for one in networks
    ]
    columns = (
        Column("network", "network"),
        Column("stacked", "stacked"),
        Column("latent", "latent loss"),
    )
    return Grid("structures", "What the networks have", columns, rows)


def comparison(rows: Sequence[Row]) -> Grid:
    """Return the paper's table 3: the errors of all ways, beside ridge regression."""
    columns = (Column("split", "split"), Column("way", "way"), *ERRORS, *RATIOS)
    return Grid("ways", "Errors on pairs held out", columns, [row.cells() for row in rows])


def calibration(rows: Sequence[Worth], ridge: float) -> Grid:
    """Return what calibration recordings are worth, beside ridge regression without any (mm^2)."""
    cells: list[dict[str, Cell]] = [
        {
            "way": row.way,
            "before": row.before.position,
            "one": row.one.position,
            "each": row.each.position,
            "ratio_one": row.one.position / ridge,
            "ratio_each": row.each.position / ridge,
        }
        for row in rows
    ]
    columns = (
        Column("way", "way"),
        Column("before", "Lp (mm²)", ".0f"),
        Column("one", "one repetition of one movement", ".0f"),
        Column("each", "one of each", ".0f"),
        Column("ratio_one", "one / ridge without", ".2f"),
        Column("ratio_each", "one of each / ridge without", ".2f"),
    )
    title = "Lp of performers that are not seen, calibrated by paired recordings of theirs"
    return Grid("calibration", title, columns, cells)


def speed(rows: Sequence[tuple[int, float, Errors]]) -> Grid:
    """Return the frames per second of each stride, and its errors."""
    cells: list[dict[str, Cell]] = [
        {
            "stride": stride,
            "frames_per_s": rate,
            "position_mm2": errors.position,
            "bones_mm2": errors.bones,
            "smoothness_mm2": errors.smoothness,
        }
        for stride, rate, errors in rows
    ]
    columns = (
        Column("stride", "stride"),
        Column("frames_per_s", "frames/s, one thread", ",.0f"),
        *ERRORS,
    )
    return Grid(
        "speed",
        "Strides of the network that ships, on 20 or so of the pairs (seen)",
        columns,
        cells,
    )


def targets(rows: Sequence[Row], shipped: str, filtered: str, rate: float) -> Grid:
    """Return what was asked for beside what was reached."""
    by_name = {(row.split, row.way): row.cells() for row in rows}
    asked = [
        ("seen", shipped, "position_ratio", "Lp / ridge, seen", "<= 0.45"),
        ("seen", shipped, "bones_ratio", "Lb / ridge, seen", "<= 0.25"),
        ("seen", filtered, "smoothness_ratio", "Ls / ridge, seen, 6 Hz output filter", "<= 0.9"),
        ("unseen", shipped, "position_ratio", "Lp / ridge, unseen", "<= 0.9"),
    ]
    cells: list[dict[str, Cell]] = [
        {"what": what, "way": way, "reached": by_name[split, way][key], "target": target}
        for split, way, key, what, target in asked
        if (split, way) in by_name
    ]
    cells.append(
        {
            "what": "frames/s at stride 60, of 1,000",
            "way": shipped,
            "reached": share(round(rate), 1000),
            "target": ">= 1",
        }
    )
    columns = (
        Column("what", "what"),
        Column("way", "of"),
        Column("reached", "reached", ".2f"),
        Column("target", "target"),
    )
    return Grid("targets", "Targets", columns, cells)
