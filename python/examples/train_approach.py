"""Trains a policy for GT2003/Approach-v0 from scratch by evolution strategies, and compares it with the robots' own skill.

    build/python/bin/python python/examples/train_approach.py --out approach_policy.txt
    build/python/bin/python python/examples/train_approach.py --policy python/examples/approach_policy.txt

Evolution strategies (Salimans et al. 2017): each generation tries pairs of policies on both sides of the present one, all
on the same seeds, and moves it by their ranks. The policy is a network with one hidden layer in NumPy; it sees where the
ball, the place behind it and the goal are. The second line compares a policy that was trained before.
"""

from __future__ import annotations

import argparse
import json
import time
from collections.abc import Callable, Sequence
from pathlib import Path

import gymnasium
import numpy as np
from numpy.typing import NDArray

import gt2003.envs  # registers the environments

INPUTS, HIDDEN, OUTPUTS = 10, 8, 3
SIZE = (INPUTS + 1) * HIDDEN + (HIDDEN + 1) * OUTPUTS
TRAINED, UNSEEN = range(300, 1000), range(200, 300)  # seeds

Decide = Callable[[NDArray], NDArray]


def inputs(ball: NDArray, goal: NDArray) -> NDArray:
    """Return what the policy sees, numbers around 1: (n, INPUTS). Ball and goal are relative to the robot: m, (n, 2)."""
    way = goal - ball
    kick = way / np.maximum(np.linalg.norm(way, axis=1, keepdims=True), 1e-6)
    place = ball - 0.15 * kick
    near = np.exp(-((np.linalg.norm(ball, axis=1, keepdims=True) / 0.35) ** 2))
    distance = np.linalg.norm(place, axis=1, keepdims=True)
    return np.hstack(
        [np.tanh(3 * ball), np.tanh(3 * place), np.tanh(10 * place), kick, near * kick[:, 1:], np.tanh(3 * distance)]
    )


def act(policies: NDArray, ball: NDArray, goal: NDArray) -> NDArray:
    """Return the actions of n policies (n, SIZE), or of one (1, SIZE), for one situation each."""
    first = policies[:, : (INPUTS + 1) * HIDDEN].reshape(-1, INPUTS + 1, HIDDEN)
    second = policies[:, (INPUTS + 1) * HIDDEN :].reshape(-1, HIDDEN + 1, OUTPUTS)
    hidden = np.tanh((inputs(ball, goal)[:, None] @ first[:, :-1])[:, 0] + first[:, -1])
    return np.tanh((hidden[:, None] @ second[:, :-1])[:, 0] + second[:, -1]).astype(np.float32)


def decided_by(policies: NDArray) -> Decide:
    return lambda observed: act(policies, observed[:, 0:2], observed[:, 5:7])


def skill(observed: NDArray) -> NDArray:
    """Return the actions that choose the robots' own skill go_to_ball, facing the goal."""
    way = observed[:, 5:7] - observed[:, 0:2]
    facing = observed[:, 9] + np.arctan2(way[:, 1], way[:, 0])
    actions = np.zeros((len(observed), 4), np.float32)
    actions[:, 1] = 1  # go_to_ball
    actions[:, 3] = (facing + np.pi) % (2 * np.pi) / np.pi - 1
    return actions


def run(worlds: gymnasium.vector.VectorEnv, seeds: Sequence[int], decide: Decide) -> tuple[NDArray, NDArray, NDArray]:
    """Play an episode in each world; return the returns, which were done, and how long they took (s)."""
    observed, _ = worlds.reset(seed=list(seeds))
    returns, seconds = np.zeros(len(seeds)), np.zeros(len(seeds))
    over, done = np.zeros(len(seeds), bool), np.zeros(len(seeds), bool)
    while not over.all():
        observed, rewards, terminated, truncated, _ = worlds.step(decide(observed))
        returns += np.where(over, 0, rewards)
        seconds += np.where(over, 0, worlds.unwrapped.worlds.seconds_per_step)
        done |= terminated & ~over
        over |= terminated | truncated
    return returns, done, seconds


def train(generations: int, pairs: int, episodes: int = 2, spread: float = 0.3, rate: float = 0.4) -> NDArray:
    """Return the parameters of a policy: (SIZE,)."""
    random = np.random.default_rng(1)
    policy = 0.3 * random.standard_normal(SIZE)
    momentum = np.zeros(SIZE)
    worlds = gymnasium.make_vec("GT2003/Approach-v0", num_envs=2 * pairs * episodes, seconds=12.0)
    begin, worked = time.monotonic(), time.process_time()
    for generation in range(generations):
        noise = random.standard_normal((pairs, SIZE))
        tried = policy + spread * np.vstack([noise, -noise])
        seeds = random.choice(TRAINED, episodes, replace=False).tolist()
        returns, done, _ = run(worlds, seeds * (2 * pairs), decided_by(np.repeat(tried, episodes, axis=0)))
        ranks = returns.reshape(-1, episodes).mean(axis=1).argsort().argsort() / (2 * pairs - 1) - 0.5
        momentum = 0.7 * momentum + rate * (ranks[:pairs] - ranks[pairs:]) @ noise / pairs
        policy = policy + momentum
        print(
            f"generation {generation + 1}: return {returns.mean():.2f}, done {done.mean():.0%}, "
            f"{time.monotonic() - begin:.0f} s, {time.process_time() - worked:.0f} s of processor time",
            flush=True,
        )
    return policy


def report(name: str, decide: Decide, seeds: Sequence[int], observations: str, **options: str) -> list[dict[str, object]]:
    """Print how well seeds are played; return the figures."""
    worlds = gymnasium.make_vec("GT2003/Approach-v0", num_envs=len(seeds), observations=observations, **options)
    returns, done, seconds = run(worlds, seeds, decide)
    error = 1.96 * returns.std(ddof=1) / np.sqrt(len(seeds))
    print(f"{name}: return {returns.mean():.2f} +- {error:.2f}, done {done.sum()} of {len(seeds)}, {seconds.mean():.1f} s")
    figures = {"return": ("", returns), "done": ("%", 100 * done), "seconds": ("s", seconds)}
    return [
        {"name": f"environments.approach.{observations}.{name}.{of}", "unit": unit, "runs": runs.tolist(), "seeds": list(seeds)}
        for of, (unit, runs) in figures.items()
    ]


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--generations", type=int, default=60)
    parser.add_argument("--pairs", type=int, default=16, help="of policies in each generation")
    parser.add_argument("--out", default="", help="file for the policy's parameters")
    parser.add_argument("--policy", type=Path, help="a file to compare instead of training one")
    parser.add_argument("--unseen", type=int, default=len(UNSEEN), help="seeds to compare on")
    parser.add_argument("--observations", default="state", choices=["state", "beliefs"], help="to compare with")
    parser.add_argument("--json", type=Path, help="file for the figures")
    options = parser.parse_args()
    policy = np.loadtxt(options.policy) if options.policy else train(options.generations, options.pairs)
    if options.out:
        np.savetxt(options.out, policy, fmt="%.4f")
    seeds = UNSEEN[: options.unseen]
    figures = report("learned", decided_by(policy[None]), seeds, options.observations)
    figures += report("go_to_ball", skill, seeds, options.observations, actions="skills")
    if options.json:
        options.json.write_text(json.dumps(figures))


if __name__ == "__main__":
    main()
