"""`mocapmend repair`: where it may write."""

import os
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from mocapmend.cli import target

Json = Callable[..., tuple[int, Any]]


def aliases(source: Path, folder: Path, kind: str) -> Path:
    """Return another name of a file."""
    if kind == "same":
        return source
    if kind == "relative":
        return Path(os.path.relpath(source))
    link = folder / "link.c3d"
    if kind == "symlink":
        link.symlink_to(source)
    elif kind == "hard link":
        link.hardlink_to(source)
    else:
        (folder / "sub").symlink_to(folder)
        return folder / "sub" / source.name
    return link


@pytest.mark.parametrize("kind", ["same", "relative", "symlink", "hard link", "linked folder"])
@pytest.mark.parametrize("option", ["-o", "--report"])
def test_the_source_is_never_replaced_by_mistake(
    run_json: Json, holed: Path, out: Path, tmp_path: Path, kind: str, option: str
) -> None:
    before = holed.read_bytes()
    name = aliases(holed, tmp_path, kind)
    arguments = ["-o", name] if option == "-o" else ["-o", out, "--report", name]
    code, document = run_json("repair", holed, *arguments, "--overwrite")
    assert code == 1
    assert document["error"]["where"] == str(name)
    assert document["error"]["todo"]
    assert holed.read_bytes() == before
    assert not out.exists()


def test_the_report_does_not_replace_the_repaired_file(
    run_json: Json, holed: Path, out: Path
) -> None:
    code, _ = run_json("repair", holed, "-o", out, "--report", out, "--overwrite")
    assert code == 1
    assert not out.exists()


@pytest.mark.parametrize("name", ["out.c3d", "report.html"])
def test_existing_files_are_kept_without_overwrite(
    run_json: Json, holed: Path, out: Path, tmp_path: Path, name: str
) -> None:
    html = tmp_path / "report.html"
    (tmp_path / name).write_text("precious")
    code, document = run_json("repair", holed, "-o", out, "--report", html)
    assert code == 1
    assert "--overwrite" in document["error"]["todo"]
    assert (tmp_path / name).read_text() == "precious"
    assert sorted(path.name for path in tmp_path.iterdir()) == sorted(["holed.c3d", name])
    code, _ = run_json("repair", holed, "-o", out, "--report", html, "--overwrite")
    assert code == 0
    assert b"precious" not in (tmp_path / name).read_bytes()


@pytest.mark.parametrize("through", ["same", "symlink"])
@pytest.mark.parametrize("named", [False, True])
def test_in_place_replaces_the_recording(
    run_json: Json, holed: Path, tmp_path: Path, through: str, *, named: bool
) -> None:
    original = tmp_path / "original.c3d"
    original.write_bytes(holed.read_bytes())
    given = aliases(holed, tmp_path, through)
    code, done = run_json("repair", given, *(["-o", holed] if named else []), "--in-place")
    assert code == 0
    assert done["check"]["passed"]
    assert not holed.is_symlink()
    assert given.resolve() == holed.resolve()
    code, proof = run_json("check", original, holed)
    assert (code, proof["changed_samples"]) == (0, done["totals"]["samples_filled"])
    assert proof["changed_samples"] > 0


@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="no named pipes here")
def test_a_pipe_is_not_replaced(run_json: Json, holed: Path, tmp_path: Path) -> None:
    pipe, page, out = tmp_path / "pipe", tmp_path / "pipe.html", tmp_path / "out.c3d"
    os.mkfifo(pipe)
    os.mkfifo(page)
    for arguments in (("-o", pipe), ("-o", out, "--report", page)):
        code, document = run_json("repair", holed, *arguments, "--overwrite")
        assert code == 1
        assert "device" in document["error"]["what"]
    assert pipe.is_fifo()
    assert page.is_fifo()


@pytest.mark.parametrize("words", ["", ",", " , "])
def test_markers_that_name_none_are_wrong_usage(
    run_json: Json, holed: Path, out: Path, words: str
) -> None:
    with pytest.raises(SystemExit) as stopped:
        run_json("repair", holed, "-o", out, "--markers", words)
    assert stopped.value.code == 2
    assert not out.exists()


def test_folders_and_missing_folders(run_json: Json, holed: Path, tmp_path: Path) -> None:
    for name in (tmp_path, tmp_path / "nowhere" / "out.c3d"):
        code, document = run_json("repair", holed, "-o", name)
        assert code == 1
        assert document["error"]["todo"]
    assert [path.name for path in tmp_path.iterdir()] == ["holed.c3d"]


def test_a_folder_that_may_not_be_written(
    run_json: Json, holed: Path, out: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(target.os, "access", lambda *_: False)
    code, document = run_json("repair", holed, "-o", out)
    assert code == 1
    assert document["error"]["where"] == str(out.parent)


@pytest.mark.skipif(
    getattr(os, "geteuid", lambda: 0)() == 0, reason="the superuser may write everywhere"
)
def test_a_folder_that_is_read_only(run_json: Json, holed: Path, tmp_path: Path) -> None:
    folder = tmp_path / "closed"
    folder.mkdir()
    folder.chmod(0o500)
    try:
        code, _ = run_json("repair", holed, "-o", folder / "out.c3d")
        assert code == 1
        assert list(folder.iterdir()) == []
    finally:
        folder.chmod(0o700)
