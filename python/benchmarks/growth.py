"""Measures how cost grows with size, and fits an exponent to each: docs/performance.md.

growth.py [--only players standing threads pixels particles matches log] [--rounds 3] [--json out/growth.json]

Cost is processor time, in rounds in which all sizes take their turn: other programs on the machine disturb it less than the clock's, and
all sizes alike. The exponent is the slope of a line through the logarithms of size and cost, one for each round; that of the two largest
sizes (`last`) shows where it leads.
"""

from __future__ import annotations

import argparse
import json
import math
import re
import tempfile
import time
from collections.abc import Callable
from pathlib import Path

import figures
import gt2003
import numpy as np
from gt2003 import logs

SECONDS = 10  # of a match that is measured, after its robots have begun to walk
BEGIN = 5  # s
ROLES = ["striker1", "striker2", "defender", "goalie"]
WIDTH, HEIGHT, FOCAL = 176, 144, 160.1  # of the AIBO's camera
EXPOSURE = 30  # ms: of all rows, one after another

Work = Callable[[], object]
Setup = Callable[[int], Work]


def match_of(folder: Path, robots: int = 8, width: int = WIDTH, threads: int = 1) -> gt2003.Match:
    """A match that has begun, with so many robots, whose cameras have images so wide. The rules know eight players; others stand about."""
    listed = ["", ""]
    for i in range(robots):
        team, side = (("red", -1), ("blue", 1))[i % 2]
        x, y = side * (300 + 500 * (i // 8)), -1050 + 700 * (i // 2 % 4)
        name = f'name="standing{i}"' if i >= 8 else ""
        listed[i >= 8] += f'<robot {name} team="{team}" role="{ROLES[i // 2 % 4]}" x="{x}" y="{y}" rotation="0"/>'
    height, focal = width * HEIGHT // WIDTH, FOCAL * width / WIDTH
    optics = f'<optics width="{width}" height="{height}" focalX="{focal}" focalY="{focal}" rowTime="{EXPOSURE / height}"/>'
    text = Path("scenes/match.scene").read_text()
    text = re.sub(r"<robots>.*</robots>", optics + f"<robots>{listed[0]}</robots><extras>{listed[1]}</extras>", text, flags=re.DOTALL)
    for part in ("config", "layouts", "models"):
        (folder / part).unlink(missing_ok=True)
        (folder / part).symlink_to(Path(part).absolute())
    file = folder / "scenes/growth.scene"
    file.parent.mkdir(exist_ok=True)
    file.write_text(text)
    match = gt2003.Match(str(file), seed=7, threads=threads)
    match.run(BEGIN)
    return match


def robots(folder: Path) -> Setup:
    def setup(size: int) -> Work:
        match = match_of(folder, robots=size)
        return lambda: match.run(SECONDS)

    return setup


def threads(folder: Path) -> Setup:
    def setup(size: int) -> Work:
        match = match_of(folder, threads=size)
        return lambda: match.run(SECONDS)

    return setup


def pixels(folder: Path) -> Setup:
    def setup(size: int) -> Work:
        match = match_of(folder, width=round(math.sqrt(size * WIDTH / HEIGHT)))
        return lambda: match.run(SECONDS)

    return setup


def particles(folder: Path) -> Setup:
    def setup(size: int) -> Work:
        match = match_of(folder, robots=1)
        for robot in match.robots.values():
            robot.solve("SelfLocator", "GT2003")
            robot.set("SelfLocator.GT2003.particles", size)
        return lambda: match.run(SECONDS)

    return setup


def matches(folder: Path) -> Setup:
    """Matches in one process, in turn by a second each; the cost is that of all of them."""

    def setup(size: int) -> Work:
        all_of_them = [match_of(folder) for _ in range(size)]

        def run() -> None:
            for match in all_of_them:
                match.run(1)

        return run

    return setup


def log(folder: Path) -> Setup:
    """Logs of so many seconds of a match, each read as a whole."""

    def setup(size: int) -> Work:
        out = folder / f"log{size}"
        if not out.exists():
            match = gt2003.Match("one-robot", seed=7, logs=str(out))
            match.run(size)
            match.close()
        file = next(out.glob("*.mcap"))
        return lambda: logs.Log(str(file)).read()

    return setup


SERIES: dict[str, tuple[Callable[[Path], Setup], list[int]]] = {
    "players": (robots, [1, 2, 4, 6, 8]),
    "standing": (robots, [8, 12, 16, 22]),
    "threads": (threads, [1, 2]),
    "pixels": (pixels, [88 * 72, 176 * 144, 352 * 288, 640 * 523]),
    "particles": (particles, [25, 50, 100, 200, 400, 800]),
    "matches": (matches, [1, 2, 4, 8, 16, 32]),
    "log": (log, [10, 30, 100, 300]),
}


def exponent(sizes: list[int], costs: list[float]) -> float:
    """The slope of a line through the logarithms."""
    x, y = np.log(sizes), np.log(costs)
    x = x - x.mean()
    return float(x @ y / (x @ x))


def measure(setup: Setup, sizes: list[int], rounds: int) -> list[list[float]]:
    """The processor time of each size, in s, in each round."""
    costs = []
    for _ in range(rounds):
        costs.append([])
        for size in sizes:
            work = setup(size)
            begin = time.process_time()
            work()
            costs[-1].append(time.process_time() - begin)
    return costs


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--only", nargs="+", choices=SERIES, default=list(SERIES))
    parser.add_argument("--rounds", type=int, default=3)
    parser.add_argument("--json", type=Path, default=Path("out/growth.json"))
    given = parser.parse_args()
    measured = []
    for name in given.only:
        make, sizes = SERIES[name]
        with tempfile.TemporaryDirectory() as folder:
            rounds = measure(make(Path(folder)), sizes, given.rounds)
        print(f"{name}: " + ", ".join(f"{size}: {min(costs):.3f} s" for size, costs in zip(sizes, zip(*rounds, strict=True), strict=True)))
        measured.append(figures.figure(f"growth.{name}", "", [exponent(sizes, costs) for costs in rounds]))
        measured.append(figures.figure(f"growth.{name}.last", "", [exponent(sizes[-2:], costs[-2:]) for costs in rounds]))
    figures.add(measured, given.json)


if __name__ == "__main__":
    main()
