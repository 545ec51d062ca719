"""Which files a batch takes, and what their copies are called."""

import os
import sys
from pathlib import Path

import pytest

from mocapmend.batch import folder as folder_module
from mocapmend.batch.folder import Found, find, output_name
from mocapmend.batch.ledger import NAME as LEDGER
from mocapmend.errors import MocapmendError

RESERVED = frozenset({"summary.csv", "summary.html", LEDGER})


@pytest.fixture
def trials(tmp_path: Path) -> Path:
    """Return a folder with files and folders of all kinds."""
    folder = tmp_path / "trials"
    names = (
        "b.c3d", "A.C3D", "notes.txt", ".hidden.c3d", "b.c3d.mocapmend.json", "s 1/ö 1.c3d",
        "s 1/b.c3d", ".cache/x.c3d", "s 1/deep/b.c3d",
    )  # fmt: skip
    for name in names:
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).write_bytes(b"")
    return folder


def files(
    folder: Path, out: Path, pattern: str = "*.c3d", *, recursive: bool = True
) -> dict[str, Found]:
    found = find(folder, out, pattern, recursive=recursive, reserved=RESERVED)
    return {item.file: item for item in found}


def test_the_folder_alone_or_all_in_it(trials: Path, tmp_path: Path) -> None:
    out = tmp_path / "out"
    assert list(files(trials, out, recursive=False)) == ["A.C3D", "b.c3d"]
    found = files(trials, out)
    assert list(found) == ["A.C3D", "b.c3d", "s 1/b.c3d", "s 1/deep/b.c3d", "s 1/ö 1.c3d"]
    assert all(item.output == item.file and item.problem is None for item in found.values())
    assert all(item.path == trials / item.file for item in found.values())
    assert list(files(trials, out, ".*.c3d")) == [".hidden.c3d"]
    assert list(files(trials, out, "*.TXT")) == ["notes.txt"]


def test_what_batches_have_written_is_no_input(trials: Path) -> None:
    inside = trials / "out"
    (inside / "sub").mkdir(parents=True)
    (inside / "sub" / "b.c3d").write_bytes(b"")
    other = trials / "s 1" / "earlier"
    other.mkdir()
    (other / LEDGER).write_bytes(b"")
    (other / "c.c3d").write_bytes(b"")
    found = files(trials, inside)
    assert not any("out" in name or "earlier" in name for name in found)
    assert len(found) == 5
    # The folder itself may be one: what a batch has written may be repaired further.
    assert list(files(other, trials / "more")) == ["c.c3d"]


def test_a_folder_in_its_output_folder_is_read_all_the_same(tmp_path: Path) -> None:
    inner = tmp_path / "in" / "in"
    inner.mkdir(parents=True)
    for path in (inner / "x.c3d", inner.parent / "x.c3d", inner.parent / "y.c3d"):
        path.write_bytes(b"")
    found = files(tmp_path / "in", tmp_path)
    assert found["y.c3d"].problem is None
    problem = found["in/x.c3d"].problem
    assert problem is not None
    assert "would replace a recording" in problem.what


@pytest.mark.skipif(sys.platform == "win32", reason="links need rights there")
class TestLinks:
    def test_to_files_are_followed_and_those_to_folders_are_not(
        self, trials: Path, tmp_path: Path
    ) -> None:
        elsewhere = tmp_path / "elsewhere"
        elsewhere.mkdir()
        (elsewhere / "far.c3d").write_bytes(b"")
        (trials / "near.c3d").symlink_to(elsewhere / "far.c3d")
        (trials / "linked").symlink_to(elsewhere)
        (trials / "loop").symlink_to(trials)
        (trials / "nowhere.c3d").symlink_to(tmp_path / "gone.c3d")
        found = files(trials, tmp_path / "out")
        assert len(found) == 7
        assert found["near.c3d"].problem is None
        problem = found["nowhere.c3d"].problem
        assert problem is not None
        assert "leads nowhere" in problem.what

    def test_in_the_output_folder_do_not_lead_a_copy_onto_a_recording(
        self, trials: Path, tmp_path: Path
    ) -> None:
        out = tmp_path / "out"
        out.mkdir()
        (out / "A.C3D").symlink_to(trials / "b.c3d")
        (out / "s 1").symlink_to(trials / "s 1")
        found = files(trials, out)
        refused = [name for name, item in found.items() if item.problem is not None]
        assert refused == ["A.C3D", "s 1/b.c3d", "s 1/deep/b.c3d", "s 1/ö 1.c3d"]

    def test_an_output_folder_that_is_a_link_into_the_folder(
        self, trials: Path, tmp_path: Path
    ) -> None:
        (trials / "real").mkdir()
        (trials / "real" / "x.c3d").write_bytes(b"")
        (tmp_path / "out").symlink_to(trials / "real")
        assert "real/x.c3d" not in files(trials, tmp_path / "out")


def test_names_that_are_the_same_are_named(tmp_path: Path) -> None:
    folder = tmp_path / "in"
    folder.mkdir()
    for name in ("a.bvh", "a.bvh.c3d", "summary.csv", "walk.trc", "walk.csv"):
        (folder / name).write_bytes(b"")
    found = files(folder, tmp_path / "out", "*")
    assert found["a.bvh"].output == "a.bvh.c3d"
    refused = {name for name, item in found.items() if item.problem is not None}
    assert refused == {"a.bvh.c3d", "summary.csv"}


@pytest.mark.parametrize(
    ("name", "output"),
    [
        ("a.C3D", "a.C3D"),
        ("a.trc", "a.trc"),
        ("a.tsv", "a.tsv.c3d"),
        ("a.long.csv", "a.long.csv"),
        ("s/35_01.amc", "s/35_01.amc.c3d"),
        ("old.dat", "old.dat"),
        ("none", "none"),
    ],
)
def test_a_copy_has_a_name_that_can_be_written(name: str, output: str) -> None:
    assert output_name(name) == output


@pytest.mark.parametrize("kind", ["missing", "file", "same"])
def test_folders_that_cannot_be_meant(tmp_path: Path, kind: str) -> None:
    folder = tmp_path / "x"
    if kind == "file":
        folder.write_bytes(b"")
    elif kind == "same":
        folder.mkdir()
    with pytest.raises(MocapmendError) as raised:
        files(folder, folder if kind == "same" else tmp_path / "out")
    assert raised.value.where == str(folder)
    assert raised.value.todo


def test_a_folder_that_cannot_be_read_is_named_and_the_rest_is_found(
    trials: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    scan = os.scandir

    def refuse(path: str) -> object:
        if Path(path).name in closed:
            raise PermissionError(13, "Permission denied", str(path))
        return scan(path)

    closed = {"deep"}
    monkeypatch.setattr(folder_module.os, "scandir", refuse)
    found = files(trials, tmp_path / "out")
    problem = found["s 1/deep"].problem
    assert problem is not None
    assert "cannot be read" in problem.what
    assert found["s 1/b.c3d"].problem is None
    closed.add("trials")
    with pytest.raises(MocapmendError, match="cannot be read"):
        files(trials, tmp_path / "out")
