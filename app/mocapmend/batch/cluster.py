"""A batch on a Dask cluster. The workers read and write the files themselves.

The library is an optional extra, and is imported only here and only when it is needed.
"""

import logging
import queue
import secrets
import shutil
import warnings
from collections.abc import Iterator, Sequence
from contextlib import contextmanager, suppress
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

from mocapmend import __version__
from mocapmend.batch.crew import Watcher
from mocapmend.batch.local import TICK_S
from mocapmend.batch.results import Finished, Problem
from mocapmend.batch.running import Order
from mocapmend.batch.work import Task
from mocapmend.errors import MocapmendError
from mocapmend.plan import Plan
from mocapmend.training import whole_paths

if TYPE_CHECKING:
    from distributed import Client, Future

CONNECT_S = 15.0
"""How long the scheduler may take to answer."""
FIRST_WORKER_S = 60.0
"""How long a cluster that grows with its work may take to start its first worker."""
FETCH_S = 5.0
"""How long to wait for a result before the user is told again how things stand."""
QUIET = ("distributed", "distributed.client", "tornado", "tornado.application")
"""The loggers whose words are not for the user."""
RUN = ".mocapmend-batch-{}"


class Cluster:
    """The workers of a scheduler.

    Parameters
    ----------
    client : distributed.Client
        Connected to it.
    run : Path
        A folder that all workers see; they stop when it goes.
    warnings : tuple of str
        What is odd about the cluster.
    """

    def __init__(self, client: "Client", run: Path, warnings: tuple[str, ...]) -> None:
        self._client = client
        self._run = run
        self.warnings = warnings

    @property
    def size(self) -> int:
        """How many tasks the workers do at once."""
        return max(int(sum(self._client.nthreads().values())), 1)

    def work(self, tasks: Sequence[Task], watcher: Watcher) -> None:
        """See `Crew.work`."""
        from mocapmend.batch.remote import attempt

        ended: queue.SimpleQueue[Future] = queue.SimpleQueue()
        given: dict[str, tuple[Task, Future]] = {}
        for number, task in enumerate(tasks):
            watcher.began(task)
            key = f"mocapmend-{self._run.name}-{number}"
            future = self._client.submit(attempt, task, self._run, __version__, key=key, pure=False)
            given[key] = task, future
        for _, future in given.values():
            future.add_done_callback(ended.put)
        while given and not watcher.stopping:
            with suppress(queue.Empty):
                future = ended.get(timeout=TICK_S)
                task, _ = given[future.key]
                finished = _result(future, task)
                if finished is None:
                    future.add_done_callback(ended.put)
                else:
                    del given[future.key]
                    watcher.finished(task, finished)
            watcher.tick()
        self._client.cancel([future for _, future in given.values()])


@contextmanager
def connected(address: str, order: Order) -> Iterator[Cluster]:
    """Connect to a scheduler whose workers can do a batch.

    Parameters
    ----------
    address : str
        Of the scheduler.
    order : Order
        What they are to do.

    Raises
    ------
    MocapmendError
        If the library is not there, the scheduler or a worker does not answer in time, or a worker
        has another version of the program or does not see the folders.
    """
    client, odd = _connect(address)
    run = order.out / RUN.format(secrets.token_hex(8))
    try:
        run.mkdir()
        _require_workers(client, address)
        _require_able(client, [order.folder, run])
        yield Cluster(client, run, odd)
    finally:
        shutil.rmtree(run, ignore_errors=True)
        client.close()


def with_whole_paths(plan: Plan) -> Plan:
    """Return a plan that means the same training sets from whichever folder it is used."""
    way = plan.way
    return replace(plan, way=way._replace(params=whole_paths(way.params)))


def _connect(address: str) -> "tuple[Client, tuple[str, ...]]":
    try:
        import distributed
        import threadpoolctl  # noqa: F401 - the workers' part needs it
    except ImportError:
        raise MocapmendError(
            "Dask is not installed.",
            address,
            "Install it to use a cluster: pip install 'mocapmend[cluster]'.",
        ) from None
    for name in QUIET:
        logging.getLogger(name).setLevel(logging.CRITICAL)
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        try:
            _check_address(address)
            client = distributed.Client(
                address, timeout=CONNECT_S, set_as_default=False, name="mocapmend-batch"
            )
        except (OSError, TimeoutError, ValueError) as error:
            raise MocapmendError(
                f"The scheduler does not answer ({' '.join(str(error).split())}).",
                address,
                "Check the address and that the scheduler runs, as in tcp://HOST:8786.",
            ) from None
    return client, tuple(dict.fromkeys(str(item.message) for item in caught))


def _check_address(address: str) -> None:
    """Refuse what cannot be connected to: a client that has tried cannot be closed."""
    from distributed.comm import resolve_address
    from distributed.security import Security

    secure = resolve_address(address).startswith("tls:")
    if secure and Security().get_connection_args("client")["ssl_context"] is None:
        raise ValueError("TLS needs certificates, which Dask's configuration names")


def _require_workers(client: "Client", address: str) -> None:
    try:
        client.wait_for_workers(1, timeout=FIRST_WORKER_S)
    except TimeoutError:
        raise MocapmendError(
            f"No worker has come to the scheduler in {FIRST_WORKER_S:.0f} s.",
            address,
            f"Start some: dask worker {address} --nthreads 1.",
        ) from None


def _require_able(client: "Client", folders: Sequence[Path]) -> None:
    """Refuse workers of another version, and those that do not see the files."""
    from mocapmend.batch.remote import introduce

    answers: dict[str, Any] = client.run(introduce(), list(map(str, folders)), on_error="return")
    for worker, answer in sorted(answers.items()):
        if isinstance(answer, BaseException):
            raise MocapmendError(
                f"A worker cannot do this ({type(answer).__name__}: {answer}).",
                worker,
                "Give it the same Python and the same packages as here.",
            )
        version, hidden = answer
        if version != __version__:
            has = f"mocapmend {version}" if version else "no mocapmend"
            raise MocapmendError(
                f"A worker has {has}; this is mocapmend {__version__}.",
                worker,
                "Install the same version everywhere, and start the workers again.",
            )
        if hidden:
            raise MocapmendError(
                "A worker does not see this folder.",
                f"{worker}: {hidden}",
                "Use a file system that all workers share, under the same path.",
            )


def _result(future: "Future", task: Task) -> Finished | None:
    """Return what a worker has said, or what has become of it; None where it is to be made again.

    A result is lost when its worker dies of another file before it was fetched.
    """
    error: BaseException | None = None
    try:
        said = future.result(timeout=FETCH_S)
    except TimeoutError:
        return None
    except Exception as raised:  # noqa: BLE001 - what a worker or the scheduler has died of
        error = raised
    else:
        if isinstance(said, Finished):
            return said
    problem = Problem(
        f"The worker at this file, or the scheduler, was lost ({type(error).__name__}).",
        str(task.request.file),
        "Look at the logs of the scheduler and its workers, or leave this file out.",
    )
    return Finished(task.failed(problem))
