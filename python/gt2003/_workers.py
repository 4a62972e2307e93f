"""What does jobs: processes of this machine, or the nodes of a Ray cluster.

Both have `cpus`, the number of jobs at once, and `results`, which does jobs in any order. A worker
that dies loses the job that it is at; another one does that again, which `redone` counts. Whatever
goes wrong with a job otherwise is its error.
"""

from __future__ import annotations

import json
import os
import queue
import socket
import subprocess
import sys
import threading
import time
from collections import deque
from collections.abc import Iterator, Sequence
from dataclasses import asdict, dataclass
from typing import Any

from . import _json, jobs
from ._error import Error


@dataclass(frozen=True)
class Outcome:
    """What became of a job: a line of JSON, or what went wrong. CPU time in seconds."""

    job: str
    result: str
    error: str
    seconds: float


def work(job: str) -> Outcome:
    """Do one job."""
    began = time.process_time()
    result = error = ""
    try:
        result = jobs.measure(job)
    except Exception as wrong:
        error = _text(wrong)
    return Outcome(job, result, error, time.process_time() - began)


def _lost(job: str, times: int) -> Outcome:
    return Outcome(job, "", f"its worker died {times} times", 0)


def _text(wrong: Exception) -> str:
    return str(wrong) if isinstance(wrong, Error) else f"{type(wrong).__name__}: {wrong}"


class Processes:
    """Processes of this machine, each of which does one job at a time."""

    program = "from gt2003._workers import serve; serve()"

    def __init__(self, count: int | None = None, retries: int = 3) -> None:
        self.cpus = count or len(os.sched_getaffinity(0))
        self.redone = 0
        self._retries = retries
        self._closed = False
        self._starting = threading.Lock()
        self._all: list[subprocess.Popen[str]] = []
        self._idle: list[subprocess.Popen[str]] = []

    def results(self, todo: Sequence[str]) -> Iterator[Outcome]:
        """Do jobs and yield what became of each, in the order in which they are done."""
        waiting = deque(todo)  # its methods are atomic
        done: queue.Queue[Outcome | Exception | None] = queue.Queue()
        serving, left = 0, len(todo)
        why: Exception | None = None
        try:
            for _ in range(min(self.cpus, len(waiting))):
                threading.Thread(target=self._serve, args=(waiting, done), daemon=True).start()
                serving += 1
        except RuntimeError as wrong:  # there are too many threads
            why = wrong
        while left and serving:
            outcome = done.get()
            if isinstance(outcome, Outcome):
                left -= 1
                yield outcome
            else:  # a thread has ended
                serving -= 1
                why = outcome or why
        if left:
            raise Error(f"no worker can be started: {why}")

    def close(self) -> None:
        """End the processes."""
        with self._starting:
            self._closed = True
        for process in self._all:
            process.kill()
            process.wait()

    def _serve(self, waiting: deque[str], done: queue.Queue[Outcome | Exception | None]) -> None:
        """Do jobs until none is waiting; the last that is put is None, or what kept it from going on."""
        try:
            process = self._idle.pop() if self._idle else self._start()
            while True:
                try:
                    job = waiting.popleft()
                except IndexError:
                    break
                try:
                    outcome, process = self._do(job, process)
                except Exception as wrong:
                    done.put(Outcome(job, "", _text(wrong), 0))
                    process.kill()  # nobody knows what it is at
                    process = self._start()
                else:
                    done.put(outcome)
            self._idle.append(process)
            done.put(None)
        except Exception as wrong:
            done.put(wrong)

    def _do(self, job: str, process: subprocess.Popen[str]) -> tuple[Outcome, subprocess.Popen[str]]:
        """Return what became of a job, and the process that does the next one."""
        died = 0
        while not (outcome := self._ask(process, job)) and died <= self._retries:
            died += 1
            self.redone += 1
            process = self._start()
        return outcome or _lost(job, died), process

    def _start(self) -> subprocess.Popen[str]:
        with self._starting:
            if self._closed:
                raise Error("the workers are closed")
            process = subprocess.Popen(
                [sys.executable, "-c", self.program],
                stdin=subprocess.PIPE,
                stdout=subprocess.PIPE,
                text=True,
                errors="replace",
                bufsize=1,
                start_new_session=True,  # Ctrl-C is for this process, which ends them
            )
            self._all.append(process)
        return process

    @staticmethod
    def _ask(process: subprocess.Popen[str], job: str) -> Outcome | None:
        assert process.stdin and process.stdout
        try:
            process.stdin.write(job + "\n")
            answer = process.stdout.readline()
        except (BrokenPipeError, ValueError):
            return None
        if not answer.endswith("\n"):
            return None
        try:
            outcome = Outcome(**_json.parse(answer))
            if outcome.job == job:
                return outcome
        except (Error, TypeError):
            pass
        raise Error(f"its worker answered {answer.strip()[:200]!r}")


def serve() -> None:
    """Do the jobs of the standard input, one a line; end with it.

    What jobs print on the standard output goes to the standard error: it is no answer.
    """
    with os.fdopen(os.dup(1), "w") as answers:
        os.dup2(2, 1)
        sys.stdout.reconfigure(line_buffering=True)  # a worker may be ended at any time
        for line in sys.stdin:
            print(json.dumps(asdict(work(line.strip()))), file=answers, flush=True)


def _check(address: str) -> None:
    """Raise an Error if nobody listens at an address HOST:PORT."""
    host, _, port = address.rpartition(":")
    try:
        socket.create_connection((host.removeprefix("ray://"), int(port)), timeout=5).close()
    except (OSError, ValueError):
        raise Error("there is no Ray cluster; expected HOST:PORT, auto or local", field=address) from None


class Ray:
    """The nodes of a Ray cluster, which may come and go; of this machine alone, if there is none."""

    def __init__(self, address: str, count: int | None = None, retries: int = 3) -> None:
        try:
            import ray
        except ModuleNotFoundError:
            raise Error("--address needs Ray: pip install 'gt2003[cluster]'") from None
        os.environ.setdefault("RAY_USAGE_STATS_ENABLED", "0")  # it would report to its makers
        # By default its workers would yield to everything else on the machine: 15 steps of niceness.
        os.environ.setdefault("RAY_worker_niceness", "0")
        self.redone = 0
        self._ray: Any = ray
        self._retries = retries
        quiet = {"log_to_driver": False, "logging_level": "warning"}
        if address not in ("auto", "local"):
            _check(address)  # Ray would try for minutes
        alone = address == "local"
        if not alone:
            try:
                ray.init(address=address, **quiet)
            except ConnectionError:
                if address != "auto":
                    raise Error("there is no Ray cluster", field=address) from None
                alone = True
        if alone:
            ray.init(address="local", num_cpus=count, include_dashboard=False, **quiet)
        self._task = ray.remote(num_cpus=1, max_retries=0, scheduling_strategy="SPREAD")(work)

    @property
    def cpus(self) -> int:
        """As many as the cluster has now."""
        return max(1, int(self._ray.cluster_resources().get("CPU", 0)))

    def results(self, todo: Sequence[str]) -> Iterator[Outcome]:
        """Do jobs and yield what became of each, in the order in which they are done.

        Not all are handed over at once: no more than twice what the cluster can do now.
        """
        waiting = deque(todo)
        lost: dict[str, int] = {}
        pending: dict[Any, str] = {}
        while waiting or pending:
            while waiting and len(pending) < 2 * self.cpus:
                job = waiting.popleft()
                pending[self._task.remote(job)] = job
            # All that are done within a moment at once: on a large cluster asking takes longer than a job.
            ready, _ = self._ray.wait(list(pending), num_returns=len(pending), timeout=0.2)
            for reference in ready:
                job = pending.pop(reference)
                try:
                    yield self._ray.get(reference)
                except self._ray.exceptions.RayTaskError as wrong:
                    yield Outcome(job, "", repr(wrong.cause), 0)
                except self._ray.exceptions.RayError:  # the worker or its node is gone
                    lost[job] = lost.get(job, 0) + 1
                    if lost[job] > self._retries:
                        yield _lost(job, lost[job])
                    else:
                        self.redone += 1
                        waiting.appendleft(job)

    def close(self) -> None:
        """Leave the cluster; one of this machine alone ends."""
        self._ray.shutdown()
