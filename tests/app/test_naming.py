"""Names of new files, and what a name and a chosen kind mean together."""

from pathlib import Path

import pytest

from mocapmend.views.naming import kind_of, meant, repaired_name

KINDS = {"C3D": ".c3d", "TRC": ".trc", "Table": ".csv", "Samples": ".long.csv"}


@pytest.mark.parametrize(
    ("name", "expected"),
    [
        ("walk.c3d", "walk_repaired.c3d"),
        ("WALK.C3D", "WALK_repaired.C3D"),
        ("walk.trc", "walk_repaired.trc"),
        ("walk.long.csv", "walk_repaired.long.csv"),
        ("walk.v2.csv", "walk.v2_repaired.csv"),
        ("walk_repaired.c3d", "walk_repaired_2.c3d"),
        ("walk_repaired_9.long.csv", "walk_repaired_10.long.csv"),
        ("walk_repaired.bvh", "walk_repaired_2.c3d"),
        ("repaired_9.trc", "repaired_9_repaired.trc"),
        ("walk.bvh", "walk_repaired.c3d"),
        ("walk.tsv", "walk_repaired.c3d"),
        ("walk", "walk_repaired.c3d"),
    ],
)
def test_a_repaired_copy_is_of_the_same_format_where_that_can_be_written(
    name: str, expected: str
) -> None:
    assert repaired_name(name) == expected


@pytest.mark.parametrize(
    ("name", "kind"),
    [("a.C3D", "C3D"), ("a.csv", "Table"), ("a.long.csv", "Samples"), ("a.bvh", ""), ("a", "")],
)
def test_the_longest_ending_says_the_kind(name: str, kind: str) -> None:
    assert kind_of(name, KINDS) == kind


@pytest.mark.parametrize(
    ("name", "kind", "expected"),
    [
        ("x.c3d", "C3D", "x.c3d"),
        ("x.c3d", "TRC", "x.trc"),
        ("x.c3d", "Samples", "x.long.csv"),
        ("x.c3d", "", "x.c3d"),
        ("mine.trc", "C3D", "mine.trc"),
        ("mine.trc", "Table", "mine.trc"),
        ("mine", "C3D", "mine.c3d"),
        ("mine", "Samples", "mine.long.csv"),
        ("mine", "", "mine.c3d"),
    ],
)
def test_a_kind_changes_the_proposed_name_and_none_that_was_typed(
    name: str, kind: str, expected: str
) -> None:
    assert meant(Path("folder", name), "x.c3d", KINDS, kind) == Path("folder", expected)


def test_a_kind_replaces_an_ending_of_two_parts() -> None:
    assert meant(Path("x.long.csv"), "x.long.csv", KINDS, "C3D") == Path("x.c3d")
    assert meant(Path("X.C3D"), "X.C3D", KINDS, "Table") == Path("X.csv")
