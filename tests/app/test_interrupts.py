"""Ctrl-C as a wish."""

import signal
import threading

import pytest

from mocapmend.interrupts import wish_to_stop


def test_the_first_is_a_wish_and_the_second_interrupts() -> None:
    before = signal.getsignal(signal.SIGINT)
    with wish_to_stop() as wish:
        assert not wish.stop
        signal.raise_signal(signal.SIGINT)
        assert wish.stop
        with pytest.raises(KeyboardInterrupt):
            signal.raise_signal(signal.SIGINT)
    assert signal.getsignal(signal.SIGINT) is before


def test_in_another_thread_there_is_none() -> None:
    before = signal.getsignal(signal.SIGINT)
    heard = []

    def work() -> None:
        with wish_to_stop() as wish:
            heard.append((wish.stop, signal.getsignal(signal.SIGINT)))

    thread = threading.Thread(target=work)
    thread.start()
    thread.join()
    assert heard == [(False, before)]
