"""Connects the actions of a window with what they do."""

from collections.abc import Callable
from functools import partial
from typing import TYPE_CHECKING

from mocapmend.views.action_calls import (
    COMMANDS,
    FILE_COMMANDS,
    PROOF_COMMANDS,
    SWITCHES,
    WINDOW_COMMANDS,
)

if TYPE_CHECKING:
    from mocapmend.views.file_actions import FileActions
    from mocapmend.views.main_window import MainWindow
    from mocapmend.views.proof_actions import ProofActions
    from mocapmend.views.workspace import Workspace


def connect_actions(window: "MainWindow") -> None:
    """Let the actions of a window work on its files and on the recording that is seen."""

    def on_trigger(name: str, call: Callable[[], object]) -> None:
        window.actions_by_id[name].triggered.connect(lambda _=False: call())

    def with_current(use: "Callable[[Workspace], object]") -> None:
        if window.workspace is not None:
            use(window.workspace)

    # What they work with is loaded when the first of them is asked for.
    def with_files(do: "Callable[[FileActions], object]") -> None:
        do(window.files)

    def with_proofs(do: "Callable[[ProofActions], object]") -> None:
        do(window.proofs)

    for name, order in WINDOW_COMMANDS.items():
        on_trigger(name, partial(order, window))
    for name, do in FILE_COMMANDS.items():
        on_trigger(name, partial(with_files, do))
    for name, prove in PROOF_COMMANDS.items():
        on_trigger(name, partial(with_proofs, prove))
    for name, use in COMMANDS.items():
        on_trigger(name, partial(with_current, use))
    for name, switch in SWITCHES.items():
        window.actions_by_id[name].toggled.connect(
            lambda on, switch=switch: window.with_all(lambda each: switch(each, on))
        )
