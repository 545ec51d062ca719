"""Case files: what is read, how recordings are split, and files that are wrong."""

from pathlib import Path
from typing import Any

import numpy as np
import pytest
from gap_case_samples import RIGID, SPLINE, TITS, case, entry, write_cases

from mocapmend.bench.gaps.cases import halves, read_cases
from mocapmend.bench.gaps.protocols import TARGETS, Protocol, reference
from mocapmend.bench.gaps.trials import load
from mocapmend.errors import MocapmendError
from mocapmend_algorithms import Gap


def test_a_case_says_what_its_entry_says(tmp_path: Path) -> None:
    peers = {TITS: {"rmse_mm": 3}, "prototype": {"rmse_mm": 1.0}, "pchip": {"rmse_mm": None}}
    path = write_cases(tmp_path / "cases.json", entry(peers=peers, gaps=[[0, 1, 3], [2, 0, 40]]))
    (found,) = read_cases([path])
    assert (found.name, found.recording, found.frames, found.markers) == ("P3_a_0", "a", 40, 3)
    assert found.gaps == (Gap(0, 1, 3), Gap(2, 0, 40))
    assert found.peers == {TITS: 3.0, "prototype": 1.0}
    assert found.reference_mm == 3.0
    assert found.best_published_mm == 3.0


def test_protocols_are_split_by_the_length_of_their_gaps() -> None:
    names = {
        "P2 0.5 s": case("a", "P2", length=50),
        "P2 5 s": case("b", "P2", length=500),
        "P6 20 samples": case("c", "P6", length=20),
        "P7": case("d", "P7", length=370),
        "mine": case("e", "mine"),
    }
    assert [str(each.protocol) for each in names.values()] == list(names)
    order = [Protocol("P6", 100), Protocol("P6", 20), Protocol("P2", 5)]
    assert [str(each) for each in sorted(order)] == ["P2 5 s", "P6 20 samples", "P6 100 samples"]
    assert all(reference(protocol) for protocol in TARGETS)


def test_references_are_those_of_the_protocol_and_of_the_case() -> None:
    peers = {"tits": 5.0, "spline": 2.0, "rigid": 3.0, "prototype": 1.0}
    assert case("a", "P4", **peers).reference_mm == 5.0
    assert case("b", "P6", length=20, **peers).reference_mm == 2.0
    assert case("c", "P6", length=20, rigid=3.0).reference_mm == 3.0
    assert case("d", "P6", length=21, **peers).reference_mm is None
    assert case("e", "mine", **peers).reference_mm is None
    assert case("e", "mine", **peers).best_published_mm == 2.0
    assert case("f", "P3", prototype=1.0).best_published_mm is None
    assert reference(Protocol("P6", 10)) == (SPLINE, RIGID)


def test_every_other_recording_is_in_the_other_half_whatever_the_protocol() -> None:
    pairs = [("P2", "c"), ("P2", "a"), ("P2", "b"), ("P4", "e"), ("P4", "d"), ("P7", "b")]
    cases = [case(f"{family}{name}", family, name) for family, name in pairs]
    split = {"a": "A", "b": "B", "c": "A", "d": "A", "e": "B"}
    assert halves(cases) == split
    assert halves(cases[::-1]) == split


@pytest.mark.parametrize(
    ("content", "message"),
    [
        (b"", "no JSON file"),
        (b"\xff\xfe", "no JSON file"),
        (b"[" * 100_000, "no JSON file"),
        (b"1" * 5000, "no JSON file"),
        (b"{}", "no list of cases"),
        (b"[]", "no list of cases"),
    ],
)
def test_a_file_that_is_none(content: bytes, message: str, tmp_path: Path) -> None:
    path = tmp_path / "cases.json"
    path.write_bytes(content)
    with pytest.raises(MocapmendError, match=message):
        read_cases([path])


@pytest.mark.parametrize(
    ("changes", "message"),
    [
        ({"case": 3}, "'case' is no text"),
        ({"protocol": ""}, "'protocol' is no text"),
        ({"recording": None}, "'recording' is no text"),
        ({"file": "a\x1b[2J"}, "'file' is no text"),
        ({"rate": 0}, "'rate' is no frame rate"),
        ({"rate": float("nan")}, "'rate' is no frame rate"),
        ({"rate": "120"}, "'rate' is no frame rate"),
        ({"frames": True}, "'frames' is no number of frames"),
        ({"markers": 1e30}, "'markers' is no number of markers"),
        ({"gaps": []}, "'gaps' is no list of gaps"),
        ({"gaps": [[0, 1]]}, "not \\[marker, first, stop\\]"),
        ({"gaps": [[0, 1.0, 2]]}, "not \\[marker, first, stop\\]"),
        ({"gaps": [[-1, 1, 2]]}, "not \\[marker, first, stop\\]"),
        ({"gaps": [[3, 1, 2]]}, "\\[3, 1, 2\\] is not inside"),
        ({"gaps": [[0, 2, 2]]}, "\\[0, 2, 2\\] is not inside"),
        ({"gaps": [[0, 1, 41]]}, "\\[0, 1, 41\\] is not inside"),
        ({"peers": []}, "'peers' is no table"),
        ({"peers": {"x": {}}}, "peer 'x' has no 'rmse_mm'"),
        ({"peers": {"x": 3.0}}, "peer 'x' has no 'rmse_mm'"),
        ({"peers": {"x": {"rmse_mm": -1.0}}}, "peer 'x' has no 'rmse_mm'"),
        ({"peers": {"x": {"rmse_mm": float("nan")}}}, "peer 'x' has no 'rmse_mm'"),
        ({"peers": {"\n": {"rmse_mm": 1.0}}}, "name of a peer"),
    ],
)
def test_a_case_that_is_wrong(changes: dict[str, Any], message: str, tmp_path: Path) -> None:
    path = write_cases(tmp_path / "cases.json", entry("good"), entry(**changes))
    with pytest.raises(MocapmendError, match=message) as error:
        read_cases([path])
    assert error.value.where == f"{path}, case 2"


def test_an_entry_that_is_no_case_and_a_case_that_is_there_twice(tmp_path: Path) -> None:
    with pytest.raises(MocapmendError, match="This is no case"):
        read_cases([write_cases(tmp_path / "a.json", 3)])
    with pytest.raises(MocapmendError, match="two cases 'x'"):
        read_cases([write_cases(tmp_path / f"{k}.json", entry("x")) for k in range(2)])


def test_a_recording_that_is_not_there_or_is_another(tmp_path: Path) -> None:
    made = case("x", recording="gone")
    with pytest.raises(MocapmendError, match="no such file"):
        load(made, tmp_path)
    np.savez(tmp_path / "gone.npz", pos=np.ones((7, 3, 3)), fps=100.0)
    with pytest.raises(MocapmendError, match="7 frames and 3 markers, but the case x is about 500"):
        load(made, tmp_path)
