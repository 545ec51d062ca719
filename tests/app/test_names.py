"""Marker names: for people, as people type them, and where others have come."""

import pytest

from mocapmend.errors import MocapmendError
from mocapmend.names import new_names, short_names, with_donors
from mocapmend.renaming import checked_label, full_label, hints, without_label
from mocapmend_algorithms.fill.registry import METHODS


@pytest.mark.parametrize(
    ("labels", "names"),
    [
        (["Matt:LASI", "Matt:RASI"], ("LASI", "RASI")),
        (["Matt:LASI", "Ann:LASI"], ("Matt:LASI", "Ann:LASI")),
        (["Matt:LASI", "*12"], ("LASI", "*12")),
        (["LASI", "RASI"], ("LASI", "RASI")),
        (["Matt:a:b", "Matt:c"], ("a:b", "c")),
        ([], ()),
    ],
)
def test_the_common_subject_is_left_out(labels: list[str], names: tuple[str, ...]) -> None:
    assert short_names(labels) == names


@pytest.mark.parametrize(
    ("labels", "short"),
    [
        (("S:A", "*1", "S:B"), ("A", "*1", "B")),
        (("S:A", "B"), ("S:A", "B")),
        (("S:A", "T:B", "*1"), ("S:A", "T:B", "*1")),
        (("S:*1", "*1"), ("S:*1", "*1")),
        (("*1", "*2"), ("*1", "*2")),
    ],
)
def test_points_that_nobody_has_named_need_no_subject(
    labels: tuple[str, ...], short: tuple[str, ...]
) -> None:
    assert short_names(labels) == short


def test_new_names_leave_out_what_is_ambiguous() -> None:
    assert new_names(("A", "B", "B", "C"), ("B", "A", "D", "C")) == {"A": "B"}
    assert new_names(("A", "B"), ("B", "A")) == {"A": "B", "B": "A"}


def test_donors_are_called_as_they_are_now() -> None:
    params = METHODS["rigid"].params(donors=("A", "B"))
    assert with_donors(params, {"A": "Z"}).donors == ("Z", "B")
    assert with_donors(params, {"C": "Z"}) is params
    assert with_donors({"donors": ["A"], "x": 1}, {"A": "Z"}) == {"donors": ["Z"], "x": 1}
    without = METHODS["linear"].params()
    assert with_donors(without, {"A": "Z"}) is without


@pytest.mark.parametrize("bad", ["", "  ", "a\nb", "a\x07", "x" * 256, "ü" * 128])
def test_names_that_no_marker_can_have(bad: str) -> None:
    with pytest.raises(MocapmendError):
        checked_label(bad)


@pytest.mark.parametrize("good", ["LASI", " LASI ", "x" * 255, "ü" * 127, "左膝", "S:LASI"])
def test_names_that_markers_can_have(good: str) -> None:
    assert checked_label(good) == good.strip()


def test_a_typed_name_gets_the_subject_that_all_have() -> None:
    assert full_label(("S:A", "S:B", "*1"), "C") == "S:C"
    assert full_label(("S:A", "S:B"), "T:C") == "T:C"
    assert full_label(("S:A", "B"), "C") == "C"
    assert full_label(("A", "B"), "C") == "C"


def test_points_without_a_label_are_counted_and_hinted_at() -> None:
    labels = ("LASI", "*1", "", "S:*7", "Unlabelled3", "point 4", "U_5")
    assert without_label(labels) == [1, 2, 3, 4, 5, 6]
    (hint,) = hints(labels)
    assert hint.startswith("6 of 7 points have no label.")
    assert not hints(("LASI", "RASI", "*1"))
    assert hints(("*1",))
    assert not hints(())
