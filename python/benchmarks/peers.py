"""What bench.py compares with, each in a process of its own: prints steps or images a second.

peers.py ant sync|async|envpool --worlds N [--threads N]
peers.py images [--samples N]
"""

from __future__ import annotations

import argparse
import os
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np

ROOT = Path(__file__).resolve().parents[2]
SIZE = 176, 144
"""Of our robots' images."""
SECONDS = 2.0
"""For which each piece is measured."""


def rate(step: Callable[[], object], each: float = 1) -> float:
    """How often something is done in a second, `each` times in a call."""
    for _ in range(5):
        step()
    calls, begin = 0, time.perf_counter()
    while (now := time.perf_counter()) < begin + SECONDS:
        step()
        calls += 1
    return calls * each / (now - begin)


def random_steps(environment: Any, worlds: int, actions: int) -> float:
    """How many steps worlds of a vectorized environment make in a second, with random actions."""
    chance = np.random.default_rng(1)
    drawn = [chance.uniform(-1, 1, (worlds, actions)).astype(np.float32) for _ in range(64)]
    environment.reset()
    following = iter(range(10**9))
    return rate(lambda: environment.step(drawn[next(following) % len(drawn)]), worlds)


def ant(form: str, worlds: int, threads: int) -> float:
    """Ant-v5 as Gymnasium or EnvPool steps it."""
    if form == "envpool":
        import envpool

        made = envpool.make("Ant-v5", "gymnasium", num_envs=worlds, num_threads=threads)
    else:
        import gymnasium

        made = gymnasium.make_vec("Ant-v5", worlds, vectorization_mode=form)
    return random_steps(made, worlds, 8)


def images(samples: int) -> float:
    """Images by MuJoCo's renderer: our field with eight robots and a ball, by their cameras."""
    os.environ.setdefault("MUJOCO_GL", "egl")
    import mujoco

    scene = mujoco.MjSpec.from_file(str(ROOT / "models/field2003.xml"))
    scene.visual.quality.offsamples = samples
    places = [(-2, 0), (-1, 0.8), (-1, -0.8), (-0.3, 0), (2, 0), (1, 0.8), (1, -0.8), (0.3, 0.3)]
    for number, (x, y) in enumerate(places):
        robot = mujoco.MjSpec.from_file(str(ROOT / "models/ers210.xml"))
        place = scene.worldbody.add_frame(pos=[x, y, 0.15], quat=[float(x < 0), 0, 0, float(x > 0)])
        scene.attach(robot, prefix=f"{number}/", frame=place)
    ball = mujoco.MjSpec.from_file(str(ROOT / "models/ball.xml"))
    scene.attach(ball, prefix="ball/", frame=scene.worldbody.add_frame(pos=[0, 0, 0.04]))
    model = scene.compile()
    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)
    following = iter(range(10**9))
    with mujoco.Renderer(model, height=SIZE[1], width=SIZE[0]) as renderer:

        def render() -> np.ndarray:
            renderer.update_scene(data, f"{next(following) % len(places)}/camera")
            return renderer.render()

        for _ in places:
            assert render().std() > 10, "the image is empty"
        return rate(render)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    pieces = parser.add_subparsers(dest="piece", required=True)
    steps = pieces.add_parser("ant")
    steps.add_argument("form", choices=["sync", "async", "envpool"])
    steps.add_argument("--worlds", type=int, default=1)
    steps.add_argument("--threads", type=int, default=1)
    pieces.add_parser("images").add_argument("--samples", type=int, default=0)
    given = parser.parse_args()
    if given.piece == "ant":
        print(ant(given.form, given.worlds, given.threads))
    else:
        print(images(given.samples))


if __name__ == "__main__":
    main()
