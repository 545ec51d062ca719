"""`mocapmend batch --scheduler` on a real Dask scheduler with two worker processes."""

import os
import subprocess
import sys
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import cloudpickle
import pytest
from batch_trials import write_trial

from mocapmend.batch import cluster
from mocapmend.batch.remote import attempt, introduce
from mocapmend.batch.work import Task
from mocapmend.cli import batch as cli_batch
from mocapmend.plan import Plan
from mocapmend.prospects import Way
from mocapmend.repairing import Request

Json = Callable[..., tuple[int, Any]]
HERE = Path(__file__).parents[2] / "batch"

pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="signals differ")


@pytest.fixture(scope="module")
def scheduler(tmp_path_factory: pytest.TempPathFactory) -> Iterator[str]:
    """Return the address of a scheduler with two workers in processes of their own."""
    process = subprocess.Popen(
        [sys.executable, HERE / "cluster_process.py", HERE / "cluster_preload.py"],
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        stderr=subprocess.DEVNULL,
        cwd=tmp_path_factory.mktemp("dask"),
        env=os.environ | {"DASK_LOGGING__DISTRIBUTED": "critical"},
        text=True,
    )
    assert process.stdout is not None
    yield process.stdout.readline().strip()
    process.communicate(timeout=60)


@pytest.fixture
def run(run_json: Json, scheduler: str, trials: Path, plan: Path, out: Path) -> Any:
    """Return a function that does the batch of `trials` on the cluster."""

    def do(*more: object) -> tuple[int, Any]:
        arguments = ("batch", trials, "--plan", plan, "-o", out, "--recursive")
        return run_json(*arguments, "--scheduler", scheduler, *more)

    return do


def test_a_cluster_does_what_one_would_and_a_death_costs_one_file(
    run: Any, run_json: Json, trials: Path, plan: Path, out: Path, tmp_path: Path
) -> None:
    (trials / "bad.c3d").write_text("nothing")
    write_trial(trials / "killer.c3d")
    write_trial(trials / "kills once.c3d")
    code, done = run()
    assert code == 1
    states = {row["file"]: row["state"] for row in done["files"]}
    assert [name for name, state in states.items() if state == "failed"] == [
        "bad.c3d", "killer.c3d",
    ]  # fmt: skip
    assert states["kills once.c3d"] == "repaired"
    assert "2 workers have died" in done["files"][1]["problem"]["what"]
    assert done["workers"].startswith("2 workers of tcp://127.0.0.1:")
    alone = tmp_path / "alone.c3d"
    assert run_json("repair", trials / "b.c3d", "-o", alone, "--plan", plan)[0] == 0
    assert (out / "b.c3d").read_bytes() == alone.read_bytes()
    assert not [path for path in out.iterdir() if path.name.startswith(".")]
    (trials / "killer.c3d").unlink()
    (trials / "bad.c3d").unlink()
    code, again = run()
    assert code == 0
    assert again["totals"]["unchanged"] == 5


def test_stopping_reaches_the_workers(
    run: Any, trials: Path, out: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    tried = write_trial(trials / "forever.c3d", frames=500).with_suffix(".tried")
    tick = cli_batch._Watcher.tick

    def stop(watcher: Any) -> None:
        tick(watcher)
        watcher._wish.stop = tried.exists()

    monkeypatch.setattr(cli_batch._Watcher, "tick", stop)
    code, done = run()
    assert code == 130
    assert done["interrupted"]
    assert done["totals"]["waiting"] >= 1
    stopped = Path(f"{tried}.stopped")
    while not stopped.exists():
        os.sched_yield()
    assert not (out / "forever.c3d").exists()


def test_workers_of_another_version_are_refused(run: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(cluster, "__version__", "0.0.1")
    code, done = run()
    assert code == 1
    assert "this is mocapmend 0.0.1" in done["error"]["what"]
    assert "Install the same version everywhere" in done["error"]["todo"]


def test_a_worker_of_another_version_that_comes_later_repairs_nothing(tmp_path: Path) -> None:
    out = tmp_path / "out.c3d"
    request = Request(file=tmp_path / "a.c3d", plan=Plan(Way.default("linear")), out=out)
    task = Task(file="a.c3d", request=request, output="out.c3d", report="", size=1, key="")
    finished = attempt(task, tmp_path, "0.0.1")
    assert finished.row.problem is not None
    assert "this is mocapmend 0.0.1" in finished.row.problem.what
    assert finished.untouched
    assert list(tmp_path.iterdir()) == []


def test_workers_that_do_not_see_the_folder_are_refused(
    run: Any, monkeypatch: pytest.MonkeyPatch, trials: Path
) -> None:
    seen = cluster._require_able
    hidden = trials / "hidden"
    monkeypatch.setattr(
        cluster, "_require_able", lambda client, folders: seen(client, [*folders, hidden])
    )
    code, done = run()
    assert code == 1
    assert "does not see this folder" in done["error"]["what"]
    assert done["error"]["where"].endswith(str(hidden))


@pytest.mark.parametrize(
    ("address", "text"),
    [
        ("tcp://127.0.0.1:9", "does not answer"),
        ("nonsense", "missing port number"),
        ("tls://127.0.0.1:9", "certificates"),
        ("ftp://127.0.0.1:9", "unknown address scheme"),
    ],
)
def test_addresses_that_do_not_answer(
    run_json: Json, trials: Path, plan: Path, out: Path, address: str, text: str,
    monkeypatch: pytest.MonkeyPatch,
) -> None:  # fmt: skip
    monkeypatch.setattr(cluster, "CONNECT_S", 0.5)
    code, done = run_json("batch", trials, "--plan", plan, "-o", out, "--scheduler", address)
    assert code == 1
    assert done["error"]["where"] == address
    assert text in done["error"]["what"]
    assert done["error"]["todo"]


def test_without_the_extra(
    run_json: Json, trials: Path, plan: Path, out: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setitem(sys.modules, "distributed", None)
    code, done = run_json("batch", trials, "--plan", plan, "-o", out, "--scheduler", "tcp://h:1")
    assert code == 1
    assert "mocapmend[cluster]" in done["error"]["todo"]


def test_the_program_is_loaded_without_the_library_and_without_qt() -> None:
    code = """
import sys
import mocapmend.cli.batch
print(*(name for name in sys.modules if name.split(".")[0] in {names}))
"""
    names = {"PySide6", "pyqtgraph", "distributed", "dask"}
    done = subprocess.run(
        [sys.executable, "-c", code.format(names=names)], capture_output=True, text=True, check=True
    )
    assert done.stdout.split() == []


def test_a_worker_without_the_program_can_say_so(tmp_path: Path) -> None:
    question = cloudpickle.dumps(introduce())
    code = """
import pickle, sys
sys.modules["mocapmend"] = None
print(pickle.loads(bytes.fromhex(sys.argv[1]))([sys.argv[2], sys.argv[2] + "/none"]))
"""
    done = subprocess.run(
        [sys.executable, "-c", code, question.hex(), tmp_path],
        capture_output=True,
        text=True,
        check=True,
    )
    assert done.stdout.strip() == str(("", f"{tmp_path}/none"))
