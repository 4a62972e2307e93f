"""Plays match after match in one process, under all that varies, and watches what lasts: faults, memory, speed, and the bits.

soak.py [--hours HOURS] [--scene SCENE...] [--seed SEED] [--json FILE]

HOURS are simulated ones. Each round takes a scene, a profile, a seed, a number of threads and logs or none by chance; while it plays,
solutions of tasks are switched, robots and balls are placed, and a state is saved, loaded, and played beside what it was saved from.
After each round the same short match is played and timed: it must end in the same bits, and take as long as in the beginning.

Figures: faults; memory (MB per simulated hour) and drift of speed (percent per simulated hour) as slopes of a line through all rounds but
the first tenth, with their 95 % intervals. Exit status 1 if anything failed, or memory grew for sure.
"""

from __future__ import annotations

import argparse
import gc
import json
import math
import os
import random
import resource
import sys
import tempfile
import time
import traceback
from pathlib import Path

import numpy as np

import gt2003
from gt2003 import modules

SCENES = ["match", "no-opponents", "one-robot", "ball-challenge", "obstacle-challenge", "localization-challenge", "penalty-shoot-out"]
PROFILES = ["", "perfect", "benign", "padova"]
TEAMS = ["", "kalman-study", "learned"]
SECONDS = (20, 120)  # of a round
BESIDE = 10  # s that a loaded match is played beside the one that it was saved from
STEADY = 20  # s of the match that is played again and again
MOST_GROWTH = 1.0  # MB per simulated hour


def has_ball(match: gt2003.Match) -> bool:
    try:
        match.ball_position
    except gt2003.Error:
        return False
    return True


def state_of(match: gt2003.Match) -> bytes:
    """All that the simulator knows of where things are."""
    parts = [np.asarray(match.ball_position)] if has_ball(match) else []
    for robot in match.robots.values():
        pose = robot.true_pose
        parts += [np.asarray(pose.translation), np.asarray([pose.rotation])]
    return np.concatenate(parts).tobytes()


def disturb(match: gt2003.Match, chance: random.Random) -> None:
    """Does to a match what a user may do."""
    robot = chance.choice(list(match.robots.values()))
    what = chance.random()
    if what < 0.6:
        task = chance.choice(list(robot.solutions))
        solutions = [name for name in modules.solutions()[task] if name != "Oracled"]
        robot.solve(task, chance.choice(solutions))
    elif what < 0.8:
        match.place(robot.name, chance.uniform(-2000, 2000), chance.uniform(-1300, 1300), chance.uniform(-3, 3))
    elif has_ball(match):
        match.place("ball", chance.uniform(-2000, 2000), chance.uniform(-1300, 1300))


def play(scenes: list[str], chance: random.Random, folder: Path) -> float:
    """A round; returns how many seconds were simulated."""
    scene = chance.choice(scenes)
    teams = {"red": chance.choice(TEAMS), "blue": chance.choice(TEAMS)} if scene == "match" else {}
    logs = str(folder / "logs") if chance.random() < 0.2 else ""
    match = gt2003.Match(
        scene, seed=chance.randrange(1, 1000), profile=chance.choice(PROFILES), threads=chance.choice([1, 2]), logs=logs, **teams
    )
    wanted, played = chance.uniform(*SECONDS), 0.0
    saved_at = chance.uniform(0, 15) if chance.random() < 0.3 else math.inf
    while played < wanted and not match.finished:
        part = chance.uniform(1, 8)
        match.run(part)
        played += part
        disturb(match, chance)
        if played > saved_at:
            saved_at = math.inf
            match.save(str(folder / "state"))
            loaded = gt2003.Match.load(str(folder / "state"))
            for each in (match, loaded):
                each.run(BESIDE)
            played += match.time / 1000 + BESIDE
            if state_of(match) != state_of(loaded):
                raise AssertionError(f"a state of {scene} goes on otherwise after it was loaded")
    match.close()
    return played


def steady() -> tuple[float, bytes]:
    """Processor time and end of the match that is always the same."""
    begin = time.process_time()
    match = gt2003.Match("match", seed=7)
    match.run(STEADY)
    return time.process_time() - begin, state_of(match)


def memory() -> float:
    gc.collect()
    return int(Path("/proc/self/statm").read_text().split()[1]) * resource.getpagesize() / 1e6


def slope(x: np.ndarray, y: np.ndarray) -> tuple[float, float, float]:
    """Of a line through points, and its 95 % interval."""
    if len(x) < 4:
        return math.nan, math.nan, math.nan
    centered = x - x.mean()
    value = float(centered @ y / (centered @ centered))
    rest = y - y.mean() - value * centered
    error = math.sqrt(float(rest @ rest) / (len(x) - 2) / float(centered @ centered))
    return value, value - 1.96 * error, value + 1.96 * error


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--hours", type=float, default=24)
    parser.add_argument("--scene", nargs="+", default=SCENES)
    parser.add_argument("--seed", type=int, default=7)
    parser.add_argument("--json", type=Path, default=Path("out/soak.json"))
    given = parser.parse_args()

    chance = random.Random(given.seed)
    hours, faults, rounds = 0.0, 0, []
    first_time, first_state = steady()
    with tempfile.TemporaryDirectory() as folder:
        while hours < given.hours:
            number = len(rounds) + 1
            try:
                hours += play(given.scene, chance, Path(folder)) / 3600
                took, state = steady()
                hours += STEADY / 3600
                if state != first_state:
                    raise AssertionError("the same match has other bits than in the beginning")
            except Exception:  # noqa: BLE001
                faults += 1
                hours += 1 / 3600
                print(f"round {number} of seed {given.seed}:", file=sys.stderr)
                traceback.print_exc()
                continue
            rounds.append((hours, memory(), took))
            print(f"round {number}: {hours:.3f} h, {rounds[-1][1]:.0f} MB, {STEADY / took:.1f} times real time", flush=True)

    kept = np.array(rounds[len(rounds) // 10 :])
    grown = slope(kept[:, 0], kept[:, 1])
    slower = slope(kept[:, 0], 100 * kept[:, 2] / first_time)
    figures = [
        {"name": "soak.hours", "value": hours, "unit": "h"},
        {"name": "soak.faults", "value": faults, "unit": ""},
        {"name": "soak.memory", "value": grown[0], "low": grown[1], "high": grown[2], "unit": "MB/h"},
        {"name": "soak.slower", "value": slower[0], "low": slower[1], "high": slower[2], "unit": "%/h"},
    ]
    for figure in figures:
        interval = f" ({figure['low']:.2f} to {figure['high']:.2f})" if "low" in figure else ""
        print(f"{figure['name']}: {figure['value']:.2f}{interval} {figure['unit']}")
    given.json.parent.mkdir(parents=True, exist_ok=True)
    given.json.write_text(json.dumps([{"n": len(rounds), **figure} for figure in figures], indent=1) + "\n")
    sys.exit(faults > 0 or grown[1] > MOST_GROWTH)


if __name__ == "__main__":
    os.environ.setdefault("OMP_NUM_THREADS", "1")
    main()
