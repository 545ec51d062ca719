"""The user's own skeleton templates."""

from pathlib import Path

import pytest
from c3d_synthetic import Synthetic, encode, walk

from mocapmend import engine, user_templates
from mocapmend_algorithms import no_progress

GOOD = """
name = "Ours"
required = ["M001", "M002", "M003", "M004", "M005"]
chains = [["M001", "M002", "M003"], ["M004", "M005"]]
[segments]
arm = ["M001", "M002"]
"""


@pytest.fixture
def templates(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Return an empty folder where the program looks for the user's templates."""
    where = tmp_path / "skeletons"
    where.mkdir()
    monkeypatch.setattr(user_templates, "folder", lambda: where)
    return where


@pytest.fixture
def recording(tmp_path: Path) -> Path:
    path = tmp_path / "walk.c3d"
    path.write_bytes(encode(Synthetic(walk())))
    return path


def test_the_folder_is_the_users_own() -> None:
    assert user_templates.folder().name == "skeletons"
    assert "mocapmend" in str(user_templates.folder())


def test_a_missing_or_empty_folder_is_no_error(tmp_path: Path) -> None:
    assert user_templates.load(tmp_path / "nothing") == ((), ())
    assert user_templates.load(tmp_path) == ((), ())


def test_a_template_of_the_users_is_used(templates: Path, recording: Path) -> None:
    (templates / "ours.toml").write_text(GOOD, "utf-8")
    source, skeleton = engine.load(recording, no_progress)
    assert not any("template" in warning for warning in source.warnings)
    assert (skeleton.name, skeleton.source) == ("Ours", "template")
    assert skeleton.bones == ((0, 1), (1, 2), (3, 4))
    assert [(part.name, part.markers) for part in skeleton.segments] == [("arm", (0, 1))]


def test_segments_are_measured_where_a_template_names_none(
    templates: Path, recording: Path
) -> None:
    (templates / "ours.toml").write_text(GOOD.split("[segments]")[0], "utf-8")
    _, skeleton = engine.load(recording, no_progress)
    assert skeleton.bones == ((0, 1), (1, 2), (3, 4))
    assert sorted(m for part in skeleton.segments for m in part.markers) == [0, 1, 2, 3, 4]


def test_wrong_files_are_named_and_the_others_used(templates: Path, recording: Path) -> None:
    (templates / "a.toml").write_text("name = ", "utf-8")
    (templates / "b.toml").write_bytes(b'name = "\xff"')
    (templates / "c.toml").write_text(GOOD.replace('"M003"]', '"M009"]'), "utf-8")
    (templates / "d.toml").mkdir()
    (templates / "e.toml").write_text("x = " + "[" * 100_000, "utf-8")
    (templates / "f.toml").write_bytes(b"#" * 1_000_001)
    (templates / "notes.txt").write_text("Not looked at.", "utf-8")
    (templates / "ours.toml").write_text(GOOD, "utf-8")
    source, skeleton = engine.load(recording, no_progress)
    assert skeleton.name == "Ours"
    said = [warning for warning in source.warnings if "template" in warning]
    assert len(said) == 6
    for name, why in {
        "a": "it is not TOML",
        "b": "it is not UTF-8 text",
        "c": "it uses labels that it does not list: M009",
        "d": "",
        "e": "",
        "f": "it is larger than 1 MB",
    }.items():
        start = f"The skeleton template {templates / name}.toml is left out: {why}"
        assert any(warning.startswith(start) for warning in said), name
    assert all(warning.endswith(".") and "\n" not in warning for warning in said)
