"""A few letters find what is meant."""

import pytest

from mocapmend.views.fuzzy import ranked, score

TEXTS = ["Next gap", "Previous gap", "Export repaired recording…", "Zoom in on the time axis"]


@pytest.mark.parametrize(
    ("typed", "found"),
    [
        ("", TEXTS),
        ("gap", TEXTS[:2]),
        ("GAP next", TEXTS[:1]),
        ("rec exp", TEXTS[2:3]),
        ("err", TEXTS[2:3]),
        ("zoom time", TEXTS[3:]),
        ("ng", [TEXTS[0], TEXTS[2]]),
        ("prvs", TEXTS[1:2]),
        ("time+axis", TEXTS[3:]),
        ("gap+", TEXTS[:2]),
        ("xyz", []),
        ("gap xyz", []),
    ],
)
def test_all_typed_words_must_fit(typed: str, found: list[str]) -> None:
    assert [TEXTS[k] for k in ranked(typed, TEXTS)] == found


def test_the_start_of_a_word_is_better_than_its_inside() -> None:
    assert score("port", "Portable") > score("port", "Export") > 0
    assert ranked("port", ["Export", "Portable"]) == [1, 0]
