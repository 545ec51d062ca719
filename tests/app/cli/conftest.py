"""Fixtures of the command-line tests: a log of their own, JSON that is validated."""

import json
import logging
from collections.abc import Callable, Iterator
from importlib.resources import files
from typing import Any

import pytest
from jsonschema import Draft202012Validator

from mocapmend import log
from mocapmend.cli import main

Json = Callable[..., tuple[int, Any]]


@pytest.fixture(scope="session")
def validator() -> Draft202012Validator:
    """Return the published schema of the JSON output."""
    text = files("mocapmend_resources").joinpath("schemas/cli.json").read_text("utf-8")
    return Draft202012Validator(json.loads(text))


@pytest.fixture(autouse=True)
def log_file(tmp_path_factory: pytest.TempPathFactory, monkeypatch: pytest.MonkeyPatch) -> Iterator:
    """Send the log to a file of the test."""
    path = tmp_path_factory.mktemp("log") / "mocapmend.log"
    monkeypatch.setattr(log, "log_path", lambda: path)
    logger = logging.getLogger("mocapmend")
    before = logger.handlers[:]
    logger.handlers.clear()
    yield path
    for handler in logger.handlers:
        handler.close()
    logger.handlers[:] = before


@pytest.fixture
def run_json(capsys: pytest.CaptureFixture[str], validator: Draft202012Validator) -> Json:
    """Return a function that runs a command with --json and validates what it prints."""

    def run(*arguments: object) -> tuple[int, Any]:
        code = main([*map(str, arguments), "--json"])
        document = json.loads(capsys.readouterr().out, parse_constant=pytest.fail)
        validator.validate(document)
        return code, document

    return run
