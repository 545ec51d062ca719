"""The translations are complete, say the same as the source, and are compiled."""

import ast
import importlib
import re
import shutil
import xml.etree.ElementTree as ET
from collections.abc import Iterator
from pathlib import Path
from types import ModuleType
from typing import NamedTuple

import pytest
from PySide6.QtCore import QObject, QTranslator

from mocapmend.views.language import CHOICES, ENGLISH, SYSTEM

ROOT = Path(__file__).resolve().parent.parent.parent
FOLDER = ROOT / "resources" / "mocapmend_resources" / "translations"
LANGUAGES = [choice for choice in CHOICES if choice not in (SYSTEM, ENGLISH)]
CHINESE = re.compile(r"[\u4e00-\u9fff]")
SAME = re.compile(
    r", |English|PCHIP|XYZ|1:1|ms|\{0\}[:,]? \{1\}|\{0\} s|\{0\} \(\{1\} ms\)|\{0\}: \{1\}|"
    r"\{0\}: \{1\} \(\{2\} ms\)\{3\}|(C3D|TRC|NumPy|HTML|PDF) \(\*\.\w+\)"
)
"""Texts of numbers, signs and names that have nothing to translate."""


class Message(NamedTuple):
    """What identifies a text."""

    context: str
    source: str
    comment: str


@pytest.fixture
def translate(monkeypatch: pytest.MonkeyPatch) -> ModuleType:
    """Return the script that brings the translations up to date."""
    monkeypatch.syspath_prepend(str(ROOT / "packaging"))
    return importlib.import_module("translate")


def messages(file: Path) -> dict[Message, str]:
    """Return the translations of a .ts file."""
    return {
        Message(
            context.findtext("name", ""),
            message.findtext("source", ""),
            message.findtext("comment", ""),
        ): message.findtext("translation", "")
        for context in ET.parse(file).getroot().iter("context")
        for message in context.iter("message")
    }


def calls() -> Iterator[tuple[str, Message]]:
    """Yield place and text of every call that names a text to translate."""
    for path in sorted((ROOT / "app").rglob("*.py")):
        tree = ast.parse(path.read_text(encoding="utf-8"))
        for owner, call in _calls_in(tree, ""):
            function = call.func
            name = function.attr if isinstance(function, ast.Attribute) else ""
            name = function.id if isinstance(function, ast.Name) else name
            place = f"{path.relative_to(ROOT)}:{call.lineno}"
            if name == "tr":
                assert isinstance(function, ast.Attribute), place
                assert ast.unparse(function.value) == "self", f"{place}: whose context is that?"
                yield place, Message(owner, *_literals(call.args, place), *_no_comment(call, 1))
            elif name in ("translate", "QT_TRANSLATE_NOOP") and len(call.args) > 1:
                if name == "translate" and not isinstance(call.args[1], ast.Constant):
                    continue  # a text that is marked with QT_TRANSLATE_NOOP elsewhere
                yield place, Message(*_literals(call.args, place), *_no_comment(call, 2))


def _calls_in(node: ast.AST, owner: str) -> Iterator[tuple[str, ast.Call]]:
    for child in ast.iter_child_nodes(node):
        inside = child.name if isinstance(child, ast.ClassDef) else owner
        if isinstance(child, ast.Call):
            yield inside, child
        yield from _calls_in(child, inside)


def _literals(arguments: list[ast.expr], place: str) -> list[str]:
    assert all(isinstance(each, ast.Constant) for each in arguments), f"{place}: not literal"
    return [str(each.value) for each in arguments if isinstance(each, ast.Constant)]


def _no_comment(call: ast.Call, needed: int) -> list[str]:
    return [""] if len(call.args) == needed else []


def test_qt_linguist_sees_every_text(translate: ModuleType, tmp_path: Path) -> None:
    file = tmp_path / "all.ts"
    translate.collect(file, "zh_CN")
    seen, written = set(messages(file)), list(calls())
    assert [(place, message) for place, message in written if message not in seen] == []
    assert seen == {message for _, message in written}


@pytest.mark.parametrize("language", LANGUAGES)
def test_nothing_is_left_to_translate(translate: ModuleType, tmp_path: Path, language: str) -> None:
    committed = FOLDER / f"mocapmend_{language}.ts"
    file = shutil.copy(committed, tmp_path / committed.name)
    translate.collect(file, language)
    hint = "run python3 packaging/translate.py, translate what it lists, and run it again"
    assert translate.unfinished(file) == [], hint
    assert messages(file) == messages(committed), hint


@pytest.mark.parametrize("language", LANGUAGES)
def test_translations_keep_places_and_tags(language: str) -> None:
    parts = re.compile(r"\{\d\}|</?\w+>|\n")
    for message, text in messages(FOLDER / f"mocapmend_{language}.ts").items():
        assert sorted(parts.findall(text)) == sorted(parts.findall(message.source)), message
        assert text.count(";;") == message.source.count(";;"), message
        assert re.findall(r"\*\.\w+", text) == re.findall(r"\*\.\w+", message.source), message
        assert text[:1].isspace() == message.source[:1].isspace(), message


def test_translations_are_chinese() -> None:
    for message, text in messages(FOLDER / "mocapmend_zh_CN.ts").items():
        if SAME.fullmatch(message.source) or message.source == "中文":
            signs = str.maketrans({"：": ": ", "，": ", ", "、": ", "})
            assert text.translate(signs) == message.source
        else:
            assert CHINESE.search(text), message


def test_menus_have_different_keys_in_chinese() -> None:
    titles = [
        text
        for message, text in messages(FOLDER / "mocapmend_zh_CN.ts").items()
        if message.context == "Menus" and "&" in message.source
    ]
    keys = [re.findall(r"\(&(\w)\)", text) for text in titles]
    assert len(keys) == 9
    assert all(len(found) == 1 for found in keys)
    assert len({found[0] for found in keys}) == len(keys)


@pytest.mark.parametrize("language", LANGUAGES)
def test_compiled_translations_are_of_this_text(
    translate: ModuleType, tmp_path: Path, language: str
) -> None:
    """All texts are in the file that the program reads, and nothing older."""
    committed = FOLDER / f"mocapmend_{language}.qm"
    translate.compile_to(committed.with_suffix(".ts"), tmp_path / "new.qm")
    current, new = QTranslator(), QTranslator()
    assert current.load(str(committed))
    assert new.load(str(tmp_path / "new.qm"))
    for message, text in messages(committed.with_suffix(".ts")).items():
        for each in (current, new):
            assert each.translate(*message) == text, message


@pytest.mark.usefixtures("chinese")
def test_texts_of_a_base_class_are_translated_in_its_subclasses() -> None:
    class PlotCanvas(QObject):
        def text(self) -> str:
            return self.tr("+{0} more")

    class Trajectories(PlotCanvas):
        pass

    assert Trajectories().text() == PlotCanvas().text() == "另有 {0} 个"
