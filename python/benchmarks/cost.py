"""Measures what a minute of a match and some 10,000 steps of an environment cost, as multiples of a fixed piece of work that is done beside
them: the figures speed.cost.*.

cost.py --build build/release [--seeds 101..106] [--minutes 1] [--json out/cost.json]

The piece, which no change of the project touches, is done before and after each, so that another machine or other programs on it
change both alike. With one thread the processor's time counts, with two the clock's, while two threads do a piece each.
"""

from __future__ import annotations

import argparse
import sys
import threading
import time
import zlib
from collections.abc import Callable
from pathlib import Path

import gt2003.envs  # registers the environments
import gymnasium
import numpy as np
from against import ROOT, Cost, Failure, Program
from figures import Figure, add, figure

PROFILE = "padova"
SCENES = {"kinematic": "scenes/match.scene", "dynamic": "scenes/dynamic.scene"}
THREADS = (1, 2)


def piece() -> None:
    """A third of a second of comparing, computing and moving numbers, in libraries."""
    numbers = np.arange(1_500_000, dtype=np.float64)
    ordered = np.sort(np.sin(numbers))
    zlib.compress((ordered[::97] * 1e6).astype(np.int64).tobytes() * 40, 6)


def cost_of_piece(threads: int) -> Cost:
    """What it takes when each thread does it."""
    workers = [threading.Thread(target=piece) for _ in range(threads)]
    user, begin = time.process_time(), time.perf_counter()
    for worker in workers:
        worker.start()
    for worker in workers:
        worker.join()
    return Cost(time.process_time() - user, time.perf_counter() - begin)


def ratio(match: Cost, pieces: tuple[Cost, Cost], threads: int) -> float:
    """How many times the mean of two pieces a match took."""
    if threads == 1:
        return match.user * 2 / (pieces[0].user + pieces[1].user)
    return match.elapsed * 2 / (pieces[0].elapsed + pieces[1].elapsed)


def measure(
    programs: dict[str, Program], seeds: list[int], minutes: float, work: Callable[[int], Cost] = cost_of_piece
) -> list[Figure]:
    """The figures of each fidelity and number of threads: all take turns on each seed."""
    runs: dict[str, list[float]] = {f"speed.cost.{f}.threads{t}": [] for f in programs for t in THREADS}
    for seed in seeds:
        for fidelity, program in programs.items():
            for threads in THREADS:
                before = work(threads)
                match = program.play(seed, minutes, threads)
                runs[f"speed.cost.{fidelity}.threads{threads}"].append(ratio(match, (before, work(threads)), threads) / minutes)
    return [figure(name, "x", values, seeds=seeds) for name, values in runs.items()]


def steps(seed: int) -> Cost:
    """Of 32 worlds of `Walk` on one thread, which a policy in Python walks by random actions."""
    worlds, times = 32, 10_000 // 32
    made = gymnasium.make_vec("GT2003/Walk-v0", worlds, vectorization_mode="vector_entry_point", threads=1)
    chance = np.random.default_rng(seed)
    actions = chance.uniform(-1, 1, (times, *made.action_space.shape)).astype(np.float32)
    made.reset(seed=seed)
    user, begin = time.process_time(), time.perf_counter()
    for action in actions:
        made.step(action)
    return Cost(time.process_time() - user, time.perf_counter() - begin)


def measure_steps(seeds: list[int]) -> Figure:
    """What steps of an environment cost."""
    runs = []
    for seed in seeds:
        before = cost_of_piece(1)
        walked = steps(seed)
        runs.append(ratio(walked, (before, cost_of_piece(1)), 1))
    return figure("speed.cost.python.steps", "x", runs, seeds=seeds)


def seeds_of(text: str) -> list[int]:
    first, _, last = text.partition("..")
    return list(range(int(first), int(last or first) + 1))


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--build", type=Path, default=Path("build/release"))
    parser.add_argument("--seeds", type=seeds_of, default="101..106")
    parser.add_argument("--minutes", type=float, default=1)
    parser.add_argument("--json", type=Path, default=Path("out/cost.json"))
    given = parser.parse_args()
    programs = {fidelity: Program(ROOT, given.build.resolve(), scene, PROFILE) for fidelity, scene in SCENES.items()}
    try:
        measured = [*measure(programs, given.seeds, given.minutes), measure_steps(given.seeds)]
    except Failure as failure:
        print(f"cost: {failure}", file=sys.stderr)
        return 2
    add(measured, given.json)
    return 0


if __name__ == "__main__":
    sys.exit(main())
