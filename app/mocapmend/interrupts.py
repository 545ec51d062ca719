"""Ctrl-C as a wish that is looked at when it suits, so that nothing is left half done. No Qt."""

import signal
import threading
from collections.abc import Iterator
from contextlib import contextmanager
from types import FrameType


class Wish:
    """Whether somebody wants the work to stop."""

    def __init__(self) -> None:
        self.stop = False


@contextmanager
def wish_to_stop() -> Iterator[Wish]:
    """Take the first Ctrl-C for a wish; the second one interrupts as usual."""
    wish = Wish()
    if threading.current_thread() is not threading.main_thread():
        yield wish
        return

    def hear(number: int, frame: FrameType | None) -> None:
        if wish.stop:
            signal.default_int_handler(number, frame)
        wish.stop = True

    before = signal.signal(signal.SIGINT, hear)
    try:
        yield wish
    finally:
        signal.signal(signal.SIGINT, before)
