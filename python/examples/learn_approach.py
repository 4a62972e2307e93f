"""Trains a policy for GT2003/Approach-v0 by a learner of others, PPO of Stable-Baselines3, and draws its curve.

    build/python/bin/pip install stable-baselines3 matplotlib  # some 5 GB, most of it PyTorch's
    build/python/bin/python python/examples/learn_approach.py --minutes 10 --out out/approach

The policy sees the observation as it is and chooses five times a second how to walk. The same seeds as in train_approach.py
are unseen; on these it is compared with the robots' own skill.
"""

from __future__ import annotations

import argparse
import time
from pathlib import Path

import gymnasium
import numpy as np
import torch
from numpy.typing import NDArray
from stable_baselines3 import PPO
from stable_baselines3.common.callbacks import BaseCallback
from stable_baselines3.common.env_util import make_vec_env
from stable_baselines3.common.monitor import Monitor
from stable_baselines3.common.vec_env import VecNormalize
from train_approach import UNSEEN, report, skill

import gt2003.envs  # registers the environments

HELD = 5  # steps: 0.2 s


class Held(gymnasium.Wrapper):
    """Each action is held for some steps, whose rewards are added up."""

    def step(self, action: NDArray) -> tuple:
        total, info = 0.0, {}
        for _ in range(HELD):
            observation, reward, terminated, truncated, info = self.env.step(action)
            total += float(reward)
            if terminated or truncated:
                break
        return observation, total, terminated, truncated, info


class Curve(BaseCallback):
    """Notes the returns of episodes, and ends the training in time."""

    def __init__(self, seconds: float) -> None:
        super().__init__()
        self.seconds, self.begin = seconds, time.monotonic()
        self.returns: list[tuple[float, int, float]] = []  # seconds, steps, return

    def _on_step(self) -> bool:
        past = time.monotonic() - self.begin
        for info in self.locals["infos"]:
            if "episode" in info:
                self.returns.append((past, self.num_timesteps * HELD, info["episode"]["r"]))
        return past < self.seconds

    def _on_rollout_end(self) -> None:
        newest = [value for _, _, value in self.returns[-200:]]
        if newest:
            print(f"{self.returns[-1][0]:4.0f} s, {self.num_timesteps * HELD} steps: return {np.mean(newest):.2f}", flush=True)


def draw(curve: Curve, file: Path) -> None:
    """Draw the mean return of 200 episodes each over the time."""
    import matplotlib

    matplotlib.use("Agg")
    from matplotlib import pyplot

    past, _, returns = np.array(curve.returns).T
    mean = np.convolve(returns, np.ones(200) / 200, "valid")
    figure, axes = pyplot.subplots(figsize=(6, 3.5), layout="constrained")
    axes.plot(past[199:] / 60, mean)
    axes.set(xlabel="minutes of training", ylabel="return, mean of 200 episodes", title="PPO on GT2003/Approach-v0")
    axes.grid(alpha=0.3)
    figure.savefig(file, dpi=120)


def learn(seconds: float, seed: int) -> tuple[PPO, VecNormalize, Curve]:
    torch.set_num_threads(1)  # networks are small
    worlds = make_vec_env(
        lambda: Monitor(Held(gymnasium.make("GT2003/Approach-v0", seconds=12.0))), n_envs=16, seed=1000 + seed
    )
    worlds = VecNormalize(worlds, norm_reward=False, clip_obs=5)
    policy = {"net_arch": [64, 64], "log_std_init": -0.5}
    learner = PPO(
        "MlpPolicy", worlds, n_steps=128, batch_size=512, n_epochs=8, gamma=0.97, learning_rate=1e-3, policy_kwargs=policy, seed=seed
    )
    curve = Curve(seconds)
    learner.learn(10**9, callback=curve)
    return learner, worlds, curve


class Learned:
    """What the learner decides for several worlds, held as it has learned."""

    def __init__(self, learner: PPO, worlds: VecNormalize) -> None:
        self.learner, self.worlds, self.steps = learner, worlds, 0
        self.actions = np.zeros(0)

    def __call__(self, observed: NDArray) -> NDArray:
        if self.steps % HELD == 0:
            self.actions, _ = self.learner.predict(self.worlds.normalize_obs(observed), deterministic=True)
        self.steps += 1
        return self.actions


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--minutes", type=float, default=10)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--unseen", type=int, default=len(UNSEEN), help="seeds to compare on")
    parser.add_argument("--out", type=Path, default=Path("out/approach"), help="folder for policy and curve")
    given = parser.parse_args()
    given.out.mkdir(parents=True, exist_ok=True)
    learner, worlds, curve = learn(60 * given.minutes, given.seed)
    learner.save(given.out / "policy")
    worlds.save(str(given.out / "observations.pkl"))
    draw(curve, given.out / "curve.png")
    seeds = UNSEEN[: given.unseen]
    report("learned policy", Learned(learner, worlds), seeds)
    report("go_to_ball", skill, seeds, actions="skills")


if __name__ == "__main__":
    main()
