"""Bring the translations up to date: texts of the program into .ts, .ts into .qm."""

import argparse
import subprocess
import sys
import sysconfig
import xml.etree.ElementTree as ET
from collections.abc import Sequence
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
FOLDER = ROOT / "resources" / "mocapmend_resources" / "translations"
LANGUAGES = ("zh_CN",)
HELP = """\
python3 packaging/translate.py          collect the texts, and compile what is translated

Needs the tools of PySide6 (pyside6-lupdate, pyside6-lrelease) beside the Python that runs it. Edit
the .ts file between two runs, with pyside6-linguist or by hand.
"""


def main() -> int:
    """Update every language; the exit code is 1 where texts are not translated yet."""
    argparse.ArgumentParser(
        description=HELP, formatter_class=argparse.RawDescriptionHelpFormatter
    ).parse_args()
    left = 0
    for language in LANGUAGES:
        file = FOLDER / f"mocapmend_{language}.ts"
        collect(file, language)
        compile_to(file, file.with_suffix(".qm"))
        open_texts = unfinished(file)
        for context, text in open_texts:
            print(f"{language}: {context}: {text}")
        print(f"{language}: {len(open_texts)} texts are unfinished")
        left += len(open_texts)
    return 1 if left else 0


def collect(file: Path, language: str) -> None:
    """Put the texts of the program into a .ts file, and take out those that are gone."""
    sources = sorted(str(path) for path in (ROOT / "app").rglob("*.py"))
    options = ("-no-obsolete", "-locations", "none", "-source-language", "en")
    _run("lupdate", *sources, *options, "-target-language", language, "-ts", str(file))


def compile_to(file: Path, compiled: Path) -> None:
    """Make the file that the program reads."""
    _run("lrelease", str(file), "-qm", str(compiled))


def unfinished(file: Path) -> list[tuple[str, str]]:
    """Return context and text of what is not translated yet."""
    contexts = ET.parse(file).getroot().iter("context")  # noqa: S314 - a file of this repository
    return [
        (context.findtext("name", ""), message.findtext("source", ""))
        for context in contexts
        for message in context.iter("message")
        if _is_open(message.find("translation"))
    ]


def _is_open(translation: "ET.Element | None") -> bool:
    return translation is None or not translation.text or "type" in translation.attrib


def _run(tool: str, *arguments: str) -> None:
    """Run one of Qt Linguist's tools; its output is of interest only when it fails."""
    command: Sequence[str] = (str(Path(sysconfig.get_path("scripts")) / f"pyside6-{tool}"),)
    done = subprocess.run([*command, *arguments], capture_output=True, text=True, check=False)
    if done.returncode:
        sys.exit(f"{tool} failed:\n{done.stdout}{done.stderr}")


if __name__ == "__main__":
    sys.exit(main())
