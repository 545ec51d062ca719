"""Fixtures that every test may use."""

import os
from collections.abc import Iterator
from pathlib import Path

import pytest
from hypothesis import settings
from threadpoolctl import threadpool_limits

import mocapmend  # noqa: F401 - what is loaded from now on, and other processes, use one thread

# A plugin of pytest may have loaded numpy before.
threadpool_limits(1, user_api="blas")
os.environ.setdefault("QT_QPA_PLATFORM", "offscreen")

# The same examples on every machine and in every order; slow machines are no failures.
settings.register_profile("mocapmend", derandomize=True, deadline=None)
settings.load_profile("mocapmend")

ROOT = Path(__file__).resolve().parent.parent
SHARED = ROOT.parent / "shared" / "data"
SAMPLES = ROOT / "resources" / "mocapmend_resources" / "samples"


@pytest.fixture(scope="session", autouse=True)
def _log_of_its_own(tmp_path_factory: pytest.TempPathFactory) -> Iterator[None]:
    """Keep the user's log as it is: programs that tests start write another one, on Linux."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("XDG_STATE_HOME", str(tmp_path_factory.mktemp("state")))
        yield


@pytest.fixture(scope="session")
def shared() -> Path:
    """Return the folder of recordings that cannot be shipped; skip where it is absent."""
    if not SHARED.is_dir():
        pytest.skip("the shared recordings (../shared/data) are not on this machine")
    return SHARED


@pytest.fixture(scope="session")
def samples() -> Path:
    """Return the folder of bundled recordings."""
    return SAMPLES
