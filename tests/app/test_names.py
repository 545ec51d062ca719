"""Marker names for people."""

import pytest

from mocapmend.names import short_names


@pytest.mark.parametrize(
    ("labels", "names"),
    [
        (["Matt:LASI", "Matt:RASI"], ("LASI", "RASI")),
        (["Matt:LASI", "Ann:LASI"], ("Matt:LASI", "Ann:LASI")),
        (["Matt:LASI", "*12"], ("Matt:LASI", "*12")),
        (["LASI", "RASI"], ("LASI", "RASI")),
        (["Matt:a:b", "Matt:c"], ("a:b", "c")),
        ([], ()),
    ],
)
def test_the_common_subject_is_left_out(labels: list[str], names: tuple[str, ...]) -> None:
    assert short_names(labels) == names
