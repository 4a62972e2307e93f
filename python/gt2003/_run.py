"""Does lists of jobs and merges their results: `gt2003 run`."""

from __future__ import annotations

import os
import sys
import time
from collections.abc import Callable, Iterable, Sequence
from contextlib import closing, suppress
from pathlib import Path
from typing import TextIO

from . import _core, _files, jobs
from ._error import Error
from ._run_page import write_page
from ._signals import Interrupted
from ._workers import Outcome, Processes, Ray


class Results:
    """A file of results, one a line, to which each is appended by one write."""

    def __init__(self, path: Path) -> None:
        self.path = path
        self.warnings: list[str] = []
        self.done: set[str] = set()
        path.parent.mkdir(parents=True, exist_ok=True)
        if path.exists():
            done, self.warnings = _core._read_results(str(path))
            self.done = set(done)
        self._file = os.open(path, os.O_RDWR | os.O_CREAT | os.O_APPEND | os.O_CLOEXEC, 0o666)
        size = os.lseek(self._file, 0, os.SEEK_END)
        if size and os.pread(self._file, 1, size - 1) != b"\n":
            os.write(self._file, b"\n")  # somebody was stopped in the middle of a line

    def add(self, job: str, line: str) -> None:
        """Append a result; the second one of a job is passed over."""
        if job in self.done:
            return
        left = line.encode() + b"\n"
        try:
            while left:
                left = left[os.write(self._file, left) :]
        except OSError as wrong:
            raise Error(f"cannot be written: {wrong.strerror}", str(self.path)) from None
        self.done.add(job)


class Progress:
    """Prints how far a list of jobs is, what it has cost and how long it will take."""

    def __init__(self, total: int, quiet: bool = False, stream: TextIO = sys.stderr) -> None:
        self._total, self._quiet, self._stream = total, quiet, stream
        self._began = self._printed = time.monotonic()
        self._done = self._failed = 0
        self._seconds = 0.0

    def add(self, outcome: Outcome, who: Processes | Ray) -> None:
        """Count a job; at most once a second (in a file: ten) there is a line."""
        self._done += 1
        self._seconds += outcome.seconds
        if outcome.error:
            self._failed += 1
            self._print(f"{outcome.job}: {outcome.error}\n")
        if self._quiet:
            return
        now = time.monotonic()
        terminal = self._stream.isatty()
        last = self._done == self._total
        if last or now - self._printed >= (1 if terminal else 10):
            self._printed = now
            self._print(self.text(who, now) + ("\r" if terminal and not last else "\n"))

    def text(self, who: Processes | Ray, now: float) -> str:
        """Return the line."""
        left = (now - self._began) / max(1, self._done) * (self._total - self._done)
        failed = f", {self._failed} failed" if self._failed else ""
        again = f", {who.redone} done again" if who.redone else ""
        return (
            f"{self._done}/{self._total} jobs{failed}{again}, {self._seconds / 3600:.3f} CPU hours, "
            f"{who.cpus} at once, {_clock(now - self._began)} gone, {_clock(left)} left"
        )

    def _print(self, text: str) -> None:
        with suppress(OSError):  # jobs do not end because nobody can see how far they are
            self._stream.write(text)
            self._stream.flush()


def _clock(seconds: float) -> str:
    minutes, seconds = divmod(round(seconds), 60)
    return f"{minutes // 60}:{minutes % 60:02}:{seconds:02}"


def workers(address: str | None, count: int | None, retries: int) -> Processes | Ray:
    """Return what does jobs: Ray, if an address is given, or processes of this machine."""
    return Ray(address, count, retries) if address else Processes(count, retries)


def do(todo: Sequence[str], results: Results, who: Processes | Ray, quiet: bool = False) -> list[Outcome]:
    """Do those jobs that have no result. Return those that failed. Quiet: prints failures only."""
    missing = [job for job in todo if job not in results.done]
    if len(missing) < len(todo) and not quiet:
        print(f"{results.path}: {len(todo) - len(missing)} of {len(todo)} jobs are done", file=sys.stderr)
    progress = Progress(len(missing), quiet)
    failed: list[Outcome] = []
    for outcome in who.results(missing):
        if outcome.error:
            failed.append(outcome)
        else:
            results.add(outcome.job, outcome.result)
        progress.add(outcome, who)
    return failed


Merge = Callable[[Path, list[str], str], list[str]]


def _merge(results: Path, listed: list[str], note: str) -> list[str]:
    figures = results.with_name("experiments.json")
    warnings = jobs.merge([results], figures, listed, note)
    write_page(figures, results.with_name("run.html"), note)
    return warnings


def _what_differs(others: Sequence[str], listed: Sequence[str]) -> str:
    """Return why results are not those of these jobs; they may differ in nothing but what measured them."""

    def job(line: str) -> str:
        return line.partition(" commit=")[0]

    if {job(line) for line in others} <= {job(line) for line in listed}:
        return "holds results of these jobs by another program, or of other files of the project (commit=)"
    return "holds results of other jobs"


def run(todo: Iterable[str], out: Path, who: Processes | Ray, merge: Merge | None = None, parquet: bool = False) -> int:
    """Do jobs, and write results, figures and pages into a folder. Return how many failed.

    merge: makes the figures and pages of the results in a folder, which hold those jobs, with a note
    at their top; without it those of experiments. parquet: writes results.parquet, too.

    A run that was stopped goes on where it was: jobs that have a result there are not done again. It
    is stopped by a signal, or because results cannot be written; figures and pages then are of the
    jobs that are done, and the exception is raised afterwards. They name the jobs that failed, too. An Error if another run works in the
    folder.
    """
    listed = list(dict.fromkeys(todo))
    with closing(_core._OutputLock(os.fspath(out))):
        results = Results(out / "results.jsonl")
        others = sorted(results.done.difference(listed))
        if others:
            raise Error(f"{_what_differs(others, listed)}; choose another folder", str(results.path), field=others[0])
        _files.write(out / "jobs", "".join(job + "\n" for job in listed))
        failed: list[Outcome] = []
        stopped: Interrupted | Error | None = None
        try:
            failed = do(listed, results, who)
        except (Interrupted, Error) as reason:
            stopped = reason
        if stopped and not results.done:
            raise stopped
        note = ""
        if stopped:
            word = "Interrupted"
            if isinstance(stopped, Error):
                print(f"gt2003: {stopped}", file=sys.stderr)
                word = "Stopped by an error"
            note = f"{word}: {len(results.done)} of {len(listed)} jobs are done."
        elif failed:
            note = f"{len(failed)} of {len(listed)} jobs failed, the first of them: {failed[0].job}: {failed[0].error}"
        warnings = results.warnings + (merge or _merge)(results.path, [] if stopped else listed, note)
        if parquet:
            jobs.convert(results.path, out / "results.parquet")
    for warning in dict.fromkeys(warnings):
        print(f"gt2003: warning: {warning}", file=sys.stderr)
    if stopped:
        raise stopped
    return len(failed)
