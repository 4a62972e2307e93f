"""Ends the command in order when it is asked to: Ctrl-C (SIGINT), SIGTERM, or a closed terminal (SIGHUP)."""

from __future__ import annotations

import os
import signal
import sys
import time
from collections.abc import Callable
from types import FrameType

SIGNALS = (signal.SIGINT, signal.SIGTERM, signal.SIGHUP)
TOGETHER = 0.3  # s; signals that come within this time are one: shells and `timeout` send theirs twice


class Interrupted(KeyboardInterrupt):
    """A signal has come; `status` is what the command ends with."""

    def __init__(self, number: int) -> None:
        super().__init__()
        self.status = 128 + number


class EndSignals:
    """Raises Interrupted at the first of the signals; a second one ends the command at once.

    A signal that the command was started to ignore (nohup) is ignored.
    """

    def __init__(self) -> None:
        self._terminals = [file for file in range(3) if _is_terminal(file)]
        self._first = 0.0
        self._ignored = {number for number in SIGNALS if signal.getsignal(number) == signal.SIG_IGN}
        self.install()

    def install(self) -> None:
        """Take the signals, also those that somebody else has taken since."""
        for number in SIGNALS:
            if number not in self._ignored:
                signal.signal(number, self._take)

    def _take(self, number: int, frame: FrameType | None) -> None:
        if self._first:
            if time.monotonic() - self._first > TOGETHER:
                signal.signal(number, signal.SIG_DFL)
                signal.raise_signal(number)
            return
        self._first = time.monotonic()
        if number == signal.SIGHUP:
            self._leave_closed_terminal()
        raise Interrupted(number)

    def _leave_closed_terminal(self) -> None:
        """What is printed would be an error, for which the command would end before it has written all."""
        nowhere = os.open(os.devnull, os.O_RDWR)
        for file in self._terminals:
            if not _is_terminal(file):
                os.dup2(nowhere, file)
        os.close(nowhere)


def _is_terminal(file: int) -> bool:
    try:
        return os.isatty(file)
    except OSError:
        return False


def quietly(main: Callable[[], int]) -> int:
    """Return what a program's main returns, or the status of SIGPIPE if who reads what it prints has gone (`| head`)."""
    try:
        try:
            return main()
        finally:
            sys.stdout.flush()
    except BrokenPipeError:
        nowhere = os.open(os.devnull, os.O_WRONLY)
        os.dup2(nowhere, sys.stdout.fileno())  # or Python would report it at its end
        os.close(nowhere)
        return 128 + signal.SIGPIPE
