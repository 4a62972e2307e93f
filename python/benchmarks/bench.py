"""Measures the figures python.*, and adds them to those that `bench` has written.

bench.py --build build/release [--only match|log|solution|walk|images] [--json out/bench.json]
"""

from __future__ import annotations

import argparse
import json
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable
from pathlib import Path

import gt2003
import gt2003.envs
import gymnasium
from figures import Figure, add, figure
from gt2003.representations import BallModel, BallPercept, FrameInfo
from mcap_ros2.reader import read_ros2_messages
from peers import random_steps, rate

THREADS = 2
WORLDS = 32
ROUNDS = 3
IMAGES_A_SECOND = 25  # of each camera


def timed(work: Callable[[], object]) -> float:
    """The seconds that a piece of work takes."""
    begin = time.perf_counter()
    work()
    return time.perf_counter() - begin


def measure_match(build: Path, folder: Path) -> list[Figure]:
    """A match of a minute with logs, from Python and by `simgt play`, in turn."""
    from_python, by_simgt = [], []
    for run in range(5):
        match = gt2003.Match(seed=run, minutes=1, threads=THREADS, logs=str(folder / "python"))
        from_python.append(timed(match.run))
        match.close()
        out = folder / "simgt"
        subprocess.run(
            [build / "bin/simgt", "play", "--seed", str(run), "--minutes", "1"]
            + ["--threads", str(THREADS), "--out", str(out)],
            check=True,
            capture_output=True,
        )
        by_simgt.append(json.loads((out / "times.json").read_text())["seconds"])
    ratios = [simgt / python for simgt, python in zip(by_simgt, from_python, strict=True)]
    return [
        figure("python.match", "s", from_python),
        figure("python.match.simgt", "s", by_simgt),
        figure("python.match.ratio", "", ratios, ("at least", 0.95)),
    ]


def measure_log(build: Path, folder: Path) -> list[Figure]:
    """A log of about 15 MB as arrays; mcap-ros2-support makes an object of each message."""
    match = gt2003.Match(seed=1, minutes=3, threads=THREADS, logs=str(folder))
    match.run()
    match.close()
    file = min(folder.glob("*.mcap"), key=lambda log: abs(log.stat().st_size - 15e6))
    ours, theirs = [], []
    for _ in range(3):
        ours.append(timed(lambda: gt2003.Log(file).read()))
        theirs.append(timed(lambda: sum(1 for _ in read_ros2_messages(file))))
    return [
        figure("python.log.size", "MB", [file.stat().st_size / 1e6]),
        figure("python.log", "s", ours),
        figure("python.log.mcap", "s", theirs),
        figure(
            "python.log.ratio",
            "",
            [b / a for a, b in zip(ours, theirs, strict=True)],
            ("at least", 20),
        ),
    ]


class Locator:
    """Does next to nothing, and measures that."""

    def __init__(self) -> None:
        self.ball = BallModel()
        self.own = 0

    def update(self, ball_percept: BallPercept, frame_info: FrameInfo) -> BallModel:
        begin = time.perf_counter_ns()
        if ball_percept.seen:
            self.ball.position = ball_percept.offset
            self.ball.lastSeen = frame_info.time
        self.own += time.perf_counter_ns() - begin
        return self.ball


def measure_solution(build: Path, folder: Path) -> list[Figure]:
    """What a call of a solution written in Python costs in a match, beside its own work."""
    figures = []
    for threads in (1, THREADS):
        costs = []
        for seed in range(5):
            match = gt2003.Match(seed=seed, threads=threads)
            made = {
                name: robot.solve("BallLocator", Locator) for name, robot in match.robots.items()
            }
            match.run(20)
            for name, robot in match.robots.items():
                watch = robot.times["BallLocator"]
                costs.append((watch.totalMs * 1e3 - made[name].own / 1e3) / watch.count)
        name = "python.solution" if threads == 1 else f"python.solution.threads.{threads}"
        figures.append(figure(name, "us", costs, ("at most", 20)))
    return figures


def by_peer(*arguments: object) -> float:
    """What peers.py measures, in a process of its own."""
    command = [sys.executable, Path(__file__).with_name("peers.py"), *map(str, arguments)]
    done = subprocess.run(command, capture_output=True, text=True)
    if done.returncode:
        raise SystemExit(f"{done.stderr}\n{' '.join(map(str, command))} failed")
    return float(done.stdout)


def in_turn(measures: dict[str, Callable[[], float]]) -> dict[str, list[float]]:
    """Measures each once a round, so that what else the machine does meets all of them."""
    measured: dict[str, list[float]] = {name: [] for name in measures}
    for _ in range(ROUNDS):
        for name, measure in measures.items():
            measured[name].append(measure())
    return measured


def worlds(count: int, threads: int, **options: object) -> gymnasium.vector.VectorEnv:
    return gymnasium.make_vec(
        "GT2003/Walk-v0", count, vectorization_mode="vector_entry_point", threads=threads, **options
    )


def measure_walk(build: Path, folder: Path) -> list[Figure]:
    """Steps of `Walk` with random actions, and of Gymnasium's Ant-v5."""

    def ours(count: int, threads: int) -> float:
        made = worlds(count, threads)
        return random_steps(made, count, made.single_action_space.shape[0])

    measured = in_turn(
        {
            "1": lambda: ours(1, 1),
            f"{WORLDS}": lambda: ours(WORLDS, 1),
            f"{WORLDS}.threads.{THREADS}": lambda: ours(WORLDS, THREADS),
            "ant.sync.1": lambda: by_peer("ant", "sync"),
            f"ant.sync.{WORLDS}": lambda: by_peer("ant", "sync", "--worlds", WORLDS),
            "ant.async.4": lambda: by_peer("ant", "async", "--worlds", 4),
            f"ant.async.{WORLDS}": lambda: by_peer("ant", "async", "--worlds", WORLDS),
            f"ant.envpool.{WORLDS}.threads.{THREADS}": lambda: by_peer(
                "ant", "envpool", "--worlds", WORLDS, "--threads", THREADS
            ),
        }
    )
    best = [max(runs) for runs in zip(*(v for k, v in measured.items() if "ant" in k), strict=True)]
    ratios = [a / b for a, b in zip(measured[f"{WORLDS}.threads.{THREADS}"], best, strict=True)]
    return [
        *(figure(f"python.walk.{name}", "1/s", runs) for name, runs in measured.items()),
        figure("python.walk.ratio", "", ratios, ("at least", 2)),
    ]


def measure_images(build: Path, folder: Path) -> list[Figure]:
    """Camera images that Python gets of environments and of a match, and by MuJoCo's renderer.

    Ours have no smoothed edges, but all errors of a camera; MuJoCo's are made of 4 samples a pixel,
    its default, or of 1 ("plain"). Its scene stands still; ours is simulated meanwhile.
    """

    def of_environments() -> float:
        made = worlds(WORLDS, THREADS, observations="image", copy=False)
        steps = random_steps(made, WORLDS, made.single_action_space.shape[0])
        return steps * made.worlds.seconds_per_step * IMAGES_A_SECOND

    def of_match() -> float:
        match = gt2003.Match(seed=1, threads=THREADS)
        robots = list(match.robots.values())

        def images() -> None:
            match.run(1 / IMAGES_A_SECOND)
            assert all(robot.image is not None for robot in robots)

        return rate(images, len(robots))

    measured = in_turn(
        {
            f"{WORLDS}.threads.{THREADS}": of_environments,
            "match": of_match,
            "mujoco": lambda: by_peer("images", "--samples", 4),
            "mujoco.plain": lambda: by_peer("images", "--samples", 0),
        }
    )
    ratios = {
        name: [a / b for a, b in zip(measured[ours], measured[theirs], strict=True)]
        for name, ours, theirs in (
            ("ratio", f"{WORLDS}.threads.{THREADS}", "mujoco"),
            ("match.ratio", "match", "mujoco"),
            ("ratio.plain", f"{WORLDS}.threads.{THREADS}", "mujoco.plain"),
            ("match.ratio.plain", "match", "mujoco.plain"),
        )
    }
    return [
        *(figure(f"python.images.{name}", "1/s", runs) for name, runs in measured.items()),
        *(
            figure(f"python.images.{name}", "", runs, None if "plain" in name else ("at least", 10))
            for name, runs in ratios.items()
        ),
    ]


PIECES: dict[str, Callable[[Path, Path], list[Figure]]] = {
    "match": measure_match,
    "log": measure_log,
    "solution": measure_solution,
    "walk": measure_walk,
    "images": measure_images,
}


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--build", type=Path, required=True)
    parser.add_argument("--only", choices=list(PIECES), action="append")
    parser.add_argument("--json", type=Path, default=Path("out/bench.json"))
    given = parser.parse_args()

    for name in given.only or PIECES:
        with tempfile.TemporaryDirectory() as folder:
            add(PIECES[name](given.build, Path(folder)), given.json)


if __name__ == "__main__":
    sys.exit(main())
