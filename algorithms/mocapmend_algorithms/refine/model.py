"""A trained network with all that is needed to use it, and its file.

The file is a NumPy archive (npz) without pickled objects; weights have single precision.
"""

import io
import json
from collections.abc import Mapping
from dataclasses import asdict, dataclass, field
from pathlib import Path
from typing import Any

import numpy as np

from mocapmend_algorithms.arrays import FloatArray
from mocapmend_algorithms.refine.network import Shape, Weights, stacked
from mocapmend_algorithms.refine.profile import Profile
from mocapmend_algorithms.refine.scaling import Scaling
from mocapmend_algorithms.zip_arrays import ArchiveError, ZipArrays, write_arrays

FORMAT = 1
LARGEST_FILE = 256 << 20
"""Bytes; the paper's network has 60 MB."""
LARGEST_HEAD = 1 << 20
LARGEST_WIDTH = 1024
MOST_STACKS = 32
LONGEST_QUOTE = 20
DAMAGED = (
    ArchiveError, OSError, ValueError, KeyError, TypeError, AttributeError, OverflowError,
    RecursionError,
)  # fmt: skip
"""What comes of a file whose content is not what it should be."""


class ModelError(ValueError):
    """A model cannot be used; the message says why, in words a user understands."""


@dataclass(frozen=True, eq=False)
class Model:
    """A trained network.

    Attributes
    ----------
    profile : Profile
        What it was made for.
    shape : Shape
        Its size.
    scaling : Scaling
        Of what goes in and comes out.
    weights : mapping of str to ndarray, float32
        As `Shape.expected` has them.
    card : mapping
        What people should know of it: "about", "data", "command", "seed", "trained_on",
        "figures"; numbers, text, and lists and tables of them.
    mirrored : bool
        Whether it has learnt from windows that are seen in a mirror too; see `mirroring`.
    """

    profile: Profile
    shape: Shape
    scaling: Scaling
    weights: Weights
    card: Mapping[str, Any] = field(default_factory=dict)
    mirrored: bool = False

    @property
    def size(self) -> int:
        """Number of weights."""
        return sum(array.size for array in self.weights.values())

    def outputs(self, windows: FloatArray) -> list[FloatArray]:
        """Return what each autoencoder makes of windows, the last one's being the result.

        Parameters
        ----------
        windows : ndarray, shape (windows, frames, inputs, 3)
            Joints in mm as `preparing` makes them, facing the same way.

        Returns
        -------
        list of ndarray, shape (windows, frames, outputs, 3)
            In mm relative to the root.
        """
        made = stacked(self.shape, self.weights, self.scaling.standardised(windows))
        return [self.scaling.restored(one) for one in made]


def encode_model(model: Model) -> bytes:
    """Return the file of a model: the same model gives the same bytes."""
    head = {
        "format": FORMAT,
        "profile": asdict(model.profile),
        "shape": asdict(model.shape),
        "card": dict(model.card),
        "mirrored": model.mirrored,
    }
    arrays = {"head": np.array(json.dumps(head))}
    arrays |= {name: np.asarray(value) for name, value in vars(model.scaling).items()}
    arrays |= {name: array.astype(np.float32) for name, array in model.weights.items()}
    stream = io.BytesIO()
    write_arrays(stream, arrays, compress=True)
    return stream.getvalue()


def read_model(path: Path) -> Model:
    """Read a model.

    Raises
    ------
    ModelError
        If there is no such file, or it is not a model.
    """
    try:
        # Opening a pipe or a device could wait for ever.
        if path.exists() and not path.is_file():
            raise ModelError("this is not a file")
        with path.open("rb", buffering=0) as stream:
            return _read(ZipArrays(stream))
    except FileNotFoundError:
        raise ModelError("there is no such model") from None
    except PermissionError:
        raise ModelError("this model may not be read") from None
    except ModelError:
        raise
    except DAMAGED as error:
        raise ModelError("this is not a model of mocapmend, or it is damaged") from error


def _read(arrays: ZipArrays) -> Model:
    if arrays.bytes > LARGEST_FILE:
        raise ModelError("the model is too large")
    raw = arrays.read("head")
    if raw.nbytes > LARGEST_HEAD:
        raise ModelError("the head of the model is too long")
    head = json.loads(str(raw))
    if head["format"] != FORMAT:
        raise ModelError(
            f"the model has format {str(head['format'])[:LONGEST_QUOTE]}, not {FORMAT}"
        )
    profile, shape = _profile(head["profile"]), _shape(head["shape"])
    if (shape.inputs, shape.outputs) != (3 * len(profile.inputs), 3 * len(profile.outputs)):
        raise ModelError("the model contradicts itself: its network is not for its profile")
    scaling = Scaling(
        **{
            name: _numbers(arrays, name, (len(labels), 3), np.float64)
            for name, labels in (
                ("input_mean", profile.inputs),
                ("input_spread", profile.inputs),
                ("output_mean", profile.outputs),
                ("output_spread", profile.outputs),
            )
        }
    )
    if not (scaling.input_spread > 0).all() or not (scaling.output_spread > 0).all():
        raise ModelError("the model has a spread that is not positive")
    weights = {
        name: _numbers(arrays, name, size, np.float32) for name, size in shape.expected().items()
    }
    return Model(
        profile, shape, scaling, weights, dict(head["card"]), mirrored=bool(head["mirrored"])
    )


def _profile(data: dict[str, Any]) -> Profile:
    def places(key: str) -> tuple[int, ...]:
        return tuple(map(int, data[key]))

    def pairs(key: str) -> tuple[tuple[int, int], ...]:
        return tuple((int(a), int(b)) for a, b in data[key])

    return Profile(
        id=str(data["id"]),
        name=str(data["name"]),
        inputs=tuple(map(str, data["inputs"])),
        outputs=tuple(map(str, data["outputs"])),
        bones=pairs("bones"),
        input_root=places("input_root"),
        output_root=places("output_root"),
        left=places("left"),
        right=places("right"),
        matches=pairs("matches"),
    )


def _shape(data: dict[str, Any]) -> Shape:
    sizes = {key: int(data[key]) for key in ("inputs", "outputs", "stacks", "width", "first_width")}
    shape = Shape(**sizes, skip=bool(data["skip"]), perceptual=bool(data["perceptual"]))
    if max(shape.width, shape.first_width) > LARGEST_WIDTH or shape.stacks > MOST_STACKS:
        raise ModelError("the model's network is too large")
    return shape


def _numbers(
    arrays: ZipArrays, name: str, size: tuple[int, ...], dtype: type[np.floating[Any]]
) -> np.ndarray[Any, np.dtype[Any]]:
    array = arrays.read(name)
    if array.dtype != dtype or array.shape != size:
        raise ModelError(f"the model contradicts itself: “{name}” is not as its head says")
    if not np.isfinite(array).all():
        raise ModelError(f"the model has weights that are no numbers in “{name}”")
    return array
