"""The set-up from a checkout: packaging/dev.py and the modules behind it."""

import ast
import importlib
import re
import subprocess
import sys
from pathlib import Path
from types import SimpleNamespace

import pytest

ROOT = Path(__file__).resolve().parent.parent
PACKAGING = ROOT / "packaging"


@pytest.fixture
def dev(monkeypatch: pytest.MonkeyPatch) -> SimpleNamespace:
    """Return the modules behind dev.py."""
    monkeypatch.syspath_prepend(str(PACKAGING))
    names = ("environment", "libraries", "tasks", "steps")
    return SimpleNamespace(**{name: importlib.import_module(name) for name in names})


class TestDevScript:
    def test_old_python_can_read_the_entry(self) -> None:
        source = (PACKAGING / "dev.py").read_text(encoding="utf-8")
        tree = ast.parse(source, feature_version=(3, 7))
        at_top = [node.module for node in tree.body if isinstance(node, ast.ImportFrom)]
        at_top += [a.name for node in tree.body if isinstance(node, ast.Import) for a in node.names]
        assert set(at_top) <= {"shutil", "subprocess", "sys", "pathlib"}

    def test_old_python_without_a_newer_one_gets_a_sentence(self) -> None:
        code = f"""
import sys
sys.path.insert(0, {str(PACKAGING)!r})
import dev
dev.MINIMUM = (99, 0)
print(dev.main())
"""
        done = subprocess.run(
            [sys.executable, "-c", code], capture_output=True, text=True, check=True
        )
        assert done.stdout == "1\n"
        assert "needs Python 3.11 or newer" in done.stderr

    @pytest.mark.parametrize(
        ("words", "expected"),
        [
            (["run"], ("run", None, [])),
            (["run", "a.c3d"], ("run", Path("a.c3d"), [])),
            (["test"], ("test", None, [])),
            (
                ["test", "-x", "tests/app", "-k", "a"],
                ("test", None, ["-x", "tests/app", "-k", "a"]),
            ),
        ],
    )
    def test_command_line(self, dev: SimpleNamespace, words: list[str], expected: object) -> None:
        assert dev.tasks.parse(words) == expected

    @pytest.mark.parametrize("words", [[], ["walk"], ["run", "a.c3d", "b.c3d"]])
    def test_wrong_usage_is_exit_code_2(
        self, dev: SimpleNamespace, words: list[str], capsys: pytest.CaptureFixture[str]
    ) -> None:
        with pytest.raises(SystemExit) as ended:
            dev.tasks.main(words)
        assert ended.value.code == 2
        assert "usage: dev.py" in capsys.readouterr().err


STUB = """
import pathlib, sys
with open({log!r}, "a") as log:
    print(*sys.argv[1:], sep="|", file=log)
sys.exit(3 if sys.argv[1] == {fails!r} else 0)
"""


SOME_TESTS = """
import os
def test_that_aborts(): os.abort()
def test_that_fails(): assert False
def test_that_passes(): pass
"""


class TestTasks:
    def program(
        self,
        dev: SimpleNamespace,
        monkeypatch: pytest.MonkeyPatch,
        folder: Path,
        *,
        fails: str = "",
        display: bool = True,
    ) -> Path:
        """Put a program that only notes its arguments in the place of mocapmend."""
        log = folder / "calls"
        package = folder / "stub" / "mocapmend"
        package.mkdir(parents=True)
        (package / "__init__.py").touch()
        (package / "__main__.py").write_text(STUB.format(log=str(log), fails=fails))
        monkeypatch.setenv("PYTHONPATH", str(package.parent))
        ready = SimpleNamespace(python=Path(sys.executable), reaches_display=lambda: display)
        monkeypatch.setattr(dev.tasks, "prepare", lambda *_, **__: ready)
        monkeypatch.setattr(dev.tasks, "HEADLESS", folder / "out")
        return log

    def test_headless_run_repairs_then_checks(
        self, dev: SimpleNamespace, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
    ) -> None:
        log = self.program(dev, monkeypatch, tmp_path)
        monkeypatch.setattr(dev.libraries, "has_display", lambda: False)
        assert dev.tasks.main(["run"]) == 0
        repaired = tmp_path / "out" / "sprint_basketball_repaired.c3d"
        report = tmp_path / "out" / "sprint_basketball_report.html"
        assert log.read_text().splitlines() == [
            f"repair|{dev.tasks.SAMPLE}|-o|{repaired}|--report|{report}",
            f"check|{dev.tasks.SAMPLE}|{repaired}",
        ]
        assert dev.tasks.SAMPLE.is_file()

    def test_headless_run_ends_with_the_code_of_what_failed(
        self, dev: SimpleNamespace, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
    ) -> None:
        log = self.program(dev, monkeypatch, tmp_path, fails="repair")
        monkeypatch.setattr(dev.libraries, "has_display", lambda: False)
        assert dev.tasks.main(["run", "other.c3d"]) == 3
        calls = [line.split("|") for line in log.read_text().splitlines()]
        assert [call[:2] for call in calls] == [["repair", str(Path("other.c3d").absolute())]]

    def test_run_with_a_display_opens_the_window(
        self, dev: SimpleNamespace, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
    ) -> None:
        log = self.program(dev, monkeypatch, tmp_path)
        monkeypatch.setattr(dev.libraries, "has_display", lambda: True)
        assert dev.tasks.main(["run"]) == 0
        assert log.read_text().splitlines() == [str(dev.tasks.SAMPLE)]

    @pytest.mark.skipif(sys.platform != "linux", reason="elsewhere there always is a display")
    def test_run_with_a_display_that_is_out_of_reach_is_headless(
        self,
        dev: SimpleNamespace,
        monkeypatch: pytest.MonkeyPatch,
        tmp_path: Path,
        capsys: pytest.CaptureFixture[str],
    ) -> None:
        log = self.program(dev, monkeypatch, tmp_path, display=False)
        monkeypatch.setattr(dev.libraries, "has_display", lambda: True)
        assert dev.tasks.main(["run"]) == 0
        assert log.read_text().startswith("repair|")
        assert "cannot be reached" in capsys.readouterr().out

    @pytest.mark.skipif(sys.platform != "linux", reason="elsewhere there always is a display")
    def test_a_display_that_nobody_serves_is_not_reached(
        self, dev: SimpleNamespace, monkeypatch: pytest.MonkeyPatch
    ) -> None:
        here = dev.environment.Environment(Path(sys.prefix))
        monkeypatch.setenv("QT_QPA_PLATFORM", "xcb")
        monkeypatch.setenv("DISPLAY", ":987")
        assert not here.reaches_display()
        monkeypatch.setenv("QT_QPA_PLATFORM", "offscreen")
        assert here.reaches_display()

    @pytest.mark.parametrize(
        ("arguments", "failing", "pytest_code", "code"),
        [
            ([], "", 0, 0),
            ([], "Linting", 0, 1),
            ([], "Checking the types", 4, 4),
            (["-x"], "Linting", 0, 0),
            (["-x"], "", 1, 1),
        ],
    )
    def test_test_fails_when_any_part_fails(
        self,
        dev: SimpleNamespace,
        monkeypatch: pytest.MonkeyPatch,
        arguments: list[str],
        failing: str,
        pytest_code: int,
        code: int,
    ) -> None:
        calls: list[list[str]] = []

        def call(command: list[str], **_: object) -> int:
            calls.append(command)
            return pytest_code

        monkeypatch.setattr(
            dev.tasks, "prepare", lambda *_, **__: SimpleNamespace(python=Path("python"))
        )
        monkeypatch.setattr(dev.tasks, "step", lambda title, _: title != failing)
        monkeypatch.setattr(dev.tasks.subprocess, "call", call)
        assert dev.tasks.main(["test", *arguments]) == code
        assert calls == [["python", "-m", "pytest", *dev.tasks.IN_PARALLEL, *arguments]]

    def test_tests_that_fail_or_end_their_process_are_named(
        self,
        dev: SimpleNamespace,
        monkeypatch: pytest.MonkeyPatch,
        tmp_path: Path,
        capfd: pytest.CaptureFixture[str],
    ) -> None:
        (tmp_path / "pytest.ini").write_text("[pytest]\nqt_api = pyside6\n")
        (tmp_path / "test_some.py").write_text(SOME_TESTS)
        here = SimpleNamespace(python=Path(sys.executable))
        monkeypatch.setattr(dev.tasks, "prepare", lambda *_, **__: here)
        words = ["-c", str(tmp_path / "pytest.ini"), "-n2", str(tmp_path)]
        assert dev.tasks.main(["test", *words]) == 1
        text = capfd.readouterr().out
        failed = re.findall(r"^FAILED .*test_some\.py::(\w+)", text, re.MULTILINE)
        assert sorted(failed) == ["test_that_aborts", "test_that_fails"]
        assert "2 failed, 1 passed" in text


class TestEnvironment:
    @pytest.fixture
    def checkout(
        self, dev: SimpleNamespace, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
    ) -> SimpleNamespace:
        """Return an environment whose installations are only counted."""
        (tmp_path / "pyproject.toml").write_text("one")
        (tmp_path / "venv").mkdir()
        installed: list[str] = []
        monkeypatch.setattr(dev.environment, "ROOT", tmp_path)
        monkeypatch.setattr(
            dev.environment.Environment, "probe", lambda _: ("3.11", bool(installed))
        )
        monkeypatch.setattr(dev.environment, "install", lambda _, extra: installed.append(extra))
        return SimpleNamespace(
            environment=dev.environment.Environment(tmp_path / "venv"),
            installed=installed,
            project=tmp_path / "pyproject.toml",
        )

    def test_second_call_installs_nothing(
        self, dev: SimpleNamespace, checkout: SimpleNamespace
    ) -> None:
        for extra in ("", "test", "test", ""):
            dev.environment.refresh(checkout.environment, extra)
        assert checkout.installed == ["", "test"]

    def test_changed_project_file_installs_again(
        self, dev: SimpleNamespace, checkout: SimpleNamespace
    ) -> None:
        dev.environment.refresh(checkout.environment, "test")
        checkout.project.write_text("two")
        dev.environment.refresh(checkout.environment)
        assert checkout.installed == ["test", ""]

    def test_failed_installation_leaves_no_stamp(
        self, dev: SimpleNamespace, checkout: SimpleNamespace, monkeypatch: pytest.MonkeyPatch
    ) -> None:
        def fail(*_: object) -> None:
            raise dev.steps.SetupError("no")

        monkeypatch.setattr(dev.environment, "install", fail)
        with pytest.raises(dev.steps.SetupError):
            dev.environment.refresh(checkout.environment)
        assert list(checkout.environment.folder.iterdir()) == []

    def test_broken_environment_is_made_again(self, dev: SimpleNamespace, tmp_path: Path) -> None:
        broken = dev.environment.Environment(tmp_path)
        (tmp_path / "pyvenv.cfg").touch()
        broken.python.parent.mkdir()
        broken.python.symlink_to(tmp_path / "gone")
        assert broken.probe() is None
        dev.environment.create(broken)
        _, packages_there = broken.probe()
        assert not packages_there

    def test_folder_of_something_else_is_left_alone(
        self, dev: SimpleNamespace, tmp_path: Path
    ) -> None:
        treasure = tmp_path / "thesis.txt"
        treasure.write_text("years of work")
        with pytest.raises(dev.steps.SetupError, match="not a virtual environment"):
            dev.environment.create(dev.environment.Environment(tmp_path))
        assert treasure.read_text() == "years of work"

    def test_variable_names_the_folder(
        self, dev: SimpleNamespace, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
    ) -> None:
        monkeypatch.setenv("MOCAPMEND_VENV", str(tmp_path / "here"))
        assert dev.environment.chosen().folder == tmp_path / "here"
        monkeypatch.delenv("MOCAPMEND_VENV")
        assert dev.environment.chosen().folder == ROOT / ".venv"


@pytest.mark.skipif(sys.platform != "linux", reason="only Linux needs system libraries")
class TestLibraries:
    @pytest.fixture
    def system(self, dev: SimpleNamespace, monkeypatch: pytest.MonkeyPatch) -> SimpleNamespace:
        """Return a Debian without libGL, whose apt-get calls are only noted."""
        calls: list[list[str]] = []
        libraries = dev.libraries

        def step(_: str, command: list[str]) -> bool:
            calls.append(command)
            return True

        monkeypatch.setattr(libraries, "loads", lambda name: name != "libGL.so.1")
        monkeypatch.setattr(libraries, "step", step)
        monkeypatch.setattr(libraries.shutil, "which", lambda name: f"/usr/bin/{name}")
        monkeypatch.setattr(libraries.os, "geteuid", lambda: 1000)
        monkeypatch.setattr(libraries, "administrator", lambda: ["sudo", "-n"])
        return SimpleNamespace(calls=calls, libraries=libraries, error=dev.steps.SetupError)

    def test_loader_is_asked(self, dev: SimpleNamespace) -> None:
        assert dev.libraries.loads("libc.so.6")
        assert not dev.libraries.loads("libnothing-of-the-kind.so.0")

    def test_only_what_is_missing_is_installed(self, system: SimpleNamespace) -> None:
        system.libraries.provide(window=False, new_environment=False)
        update, install = system.calls
        assert update[:2] == install[:2] == ["sudo", "-n"]
        assert update[-1] == "update"
        assert install[-4:] == ["install", "--yes", "--no-install-recommends", "libgl1"]

    def test_nothing_missing_calls_nothing(
        self, system: SimpleNamespace, monkeypatch: pytest.MonkeyPatch
    ) -> None:
        monkeypatch.setattr(system.libraries, "loads", lambda _: True)
        system.libraries.provide(window=True, new_environment=False)
        assert system.calls == []

    def test_without_rights_the_command_is_named(
        self, system: SimpleNamespace, monkeypatch: pytest.MonkeyPatch
    ) -> None:
        monkeypatch.setattr(system.libraries, "administrator", lambda: None)
        monkeypatch.setattr(system.libraries.importlib.util, "find_spec", lambda _: None)
        with pytest.raises(system.error) as raised:
            system.libraries.provide(window=False, new_environment=True)
        version = ".".join(str(number) for number in sys.version_info[:2])
        assert "libGL.so.1" in str(raised.value)
        assert (
            "sudo sh -c 'apt-get update && apt-get install --yes --no-install-recommends "
            f"libgl1 python{version}-venv'"
        ) in str(raised.value)
        assert system.calls == []

    def test_other_distributions_get_the_file_names(
        self, system: SimpleNamespace, monkeypatch: pytest.MonkeyPatch
    ) -> None:
        monkeypatch.setattr(system.libraries.shutil, "which", lambda _: None)
        with pytest.raises(system.error, match=r"libGL\.so\.1\.\nInstall them with"):
            system.libraries.provide(window=False, new_environment=False)
        assert system.calls == []

    def test_window_needs_more_than_drawing_off_screen(
        self, dev: SimpleNamespace, monkeypatch: pytest.MonkeyPatch
    ) -> None:
        monkeypatch.setenv("DISPLAY", ":0")
        monkeypatch.delenv("WAYLAND_DISPLAY", raising=False)
        needed = dev.libraries.needed
        assert needed(window=False) == dev.libraries.OFFSCREEN
        assert needed(window=True) == dev.libraries.OFFSCREEN | dev.libraries.X11
