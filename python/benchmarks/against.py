#!/usr/bin/env python3
"""Compares what a match costs with what it cost at another commit, and adds the ratios to out/bench.json.

    against.py COMMIT [--build build/release] [--pairs 5] [--minutes 2] [--json out/bench.json]

The commit's simgt is built in build/against/COMMIT. Both programs play the same seeds in turns (A B A B ...) on one and on two
threads, both in the profile `benign` (or, if a program knows no profiles, in its only world). A ratio is that of two matches of
one pair: speed.against.threads1.user, of processor time, and .elapsed, of real time. Threads that wait use the processor, too,
so that with two threads the real time on an idle machine counts.
"""

from __future__ import annotations

import argparse
import os
import resource
import statistics
import subprocess
import sys
import tempfile
import time
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

from figures import Figure, add, figure

ROOT = Path(__file__).resolve().parents[2]


class Failure(Exception):
    """Reported in one line."""


def run(command: list[str | Path], folder: Path, variables: Mapping[str, str] | None = None) -> str:
    """What a command prints."""
    done = subprocess.run(
        command, cwd=folder, env={**os.environ, **(variables or {})}, capture_output=True, text=True, check=False
    )
    if done.returncode != 0:
        lines = (done.stderr.strip() or done.stdout.strip()).splitlines()
        raise Failure(f"{command[0]} {command[1]} in {folder}: {lines[-1] if lines else 'failed'}")
    return done.stdout


def processor_seconds() -> float:
    """Of all commands so far, without the kernel's."""
    return resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime


def tree_of(commit: str, root: Path = ROOT, targets: Sequence[str] = ("simgt",)) -> Path:
    """A clone of a commit, with programs of it."""
    try:
        name = run(["git", "rev-parse", "--verify", "--short=12", commit + "^{commit}"], root).strip()
    except Failure:
        raise Failure(f"{commit}: there is no such commit") from None
    tree = root / "build/against" / name
    if not tree.exists():
        run(["git", "clone", "--quiet", "--shared", "--no-checkout", root, tree], root)
        run(["git", "checkout", "--quiet", "--detach", name], tree)
    # Clones in other folders are served from ccache, also at commits that did not ask for it.
    served = {"CCACHE_BASEDIR": str(tree), "CCACHE_NOHASHDIR": "true"}
    run(["cmake", "--preset", "release"], tree, served)
    run(["cmake", "--build", "build/release", "--target", *targets], tree, served)
    return tree


@dataclass(frozen=True)
class Cost:
    user: float
    elapsed: float


@dataclass(frozen=True)
class Program:
    tree: Path
    build: Path
    scene: str = "scenes/match.scene"
    profile: str = "benign"

    def play(self, seed: int, minutes: float, threads: int) -> Cost:
        """What a match takes, in seconds of the processor and of the clock."""
        simgt = self.build / "bin/simgt"
        profile = ["--profile", self.profile] if "--profile" in run([simgt, "play", "--help"], self.tree) else []
        with tempfile.TemporaryDirectory() as out:
            options = ["--seed", seed, "--minutes", minutes, "--threads", threads, "--no-logs", "--out", out]
            before, begin = processor_seconds(), time.perf_counter()
            run([simgt, "play", self.scene, *profile, *map(str, options)], self.tree)
            return Cost(processor_seconds() - before, time.perf_counter() - begin)


def compare(now: Program, then: Program, pairs: int, minutes: float, threads: int) -> list[Figure]:
    """How many times what it took then a match takes now."""
    users, elapsed = [], []
    for seed in range(1, pairs + 1):
        a, b = now.play(seed, minutes, threads), then.play(seed, minutes, threads)
        users.append(a.user / b.user)
        elapsed.append(a.elapsed / b.elapsed)
        print(
            f"threads {threads}, seed {seed}: user {a.user:.2f} s and {b.user:.2f} s, {users[-1]:.3f} times;"
            f" elapsed {a.elapsed:.2f} s and {b.elapsed:.2f} s, {elapsed[-1]:.3f} times",
            flush=True,
        )
    print(f"threads {threads}: median user {statistics.median(users):.3f}, elapsed {statistics.median(elapsed):.3f} times")
    name = f"speed.against.threads{threads}."
    return [figure(name + "user", "x", users, ("at most", 1)), figure(name + "elapsed", "x", elapsed, ("at most", 1))]


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("commit")
    parser.add_argument("--build", type=Path, default=Path("build/release"))
    parser.add_argument("--pairs", type=int, default=5)
    parser.add_argument("--minutes", type=float, default=2)
    parser.add_argument("--json", type=Path, default=Path("out/bench.json"))
    given = parser.parse_args()
    try:
        now, then = Program(ROOT, given.build.resolve()), tree_of(given.commit)
        measured: list[Figure] = []
        for threads in (1, 2):
            measured += compare(now, Program(then, then / "build/release"), given.pairs, given.minutes, threads)
    except Failure as failure:
        print(f"against: {failure}", file=sys.stderr)
        return 2
    add(measured, given.json)
    return 0


if __name__ == "__main__":
    sys.exit(main())
