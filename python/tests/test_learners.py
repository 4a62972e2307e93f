"""Learners of others learn from the environments: `make learners` runs this with all of them, `make test` with those at hand."""

from __future__ import annotations

import re
import subprocess
import sys
from pathlib import Path

import gymnasium
import numpy as np
import pytest

import gt2003.envs  # registers the environments
from gt2003.envs import soccer_v0

EXAMPLES = Path(__file__).resolve().parents[1] / "examples"


def test_cleanrl_steps_worlds_in_all_its_wrappers() -> None:
    """The loop of its PPO for continuous actions: these wrappers, in this order, and rewards of whole episodes from the infos."""

    def world(index: int) -> gymnasium.Env:
        made = gymnasium.make("GT2003/Approach-v0", seconds=0.4)
        made = gymnasium.wrappers.RecordEpisodeStatistics(gymnasium.wrappers.FlattenObservation(made))
        made = gymnasium.wrappers.NormalizeObservation(gymnasium.wrappers.ClipAction(made))
        made = gymnasium.wrappers.TransformObservation(made, lambda seen: np.clip(seen, -10, 10), made.observation_space)
        made = gymnasium.wrappers.NormalizeReward(made, gamma=0.99)
        return gymnasium.wrappers.TransformReward(made, lambda reward: float(np.clip(reward, -10, 10)))

    worlds = gymnasium.vector.SyncVectorEnv([lambda index=index: world(index) for index in range(3)])
    worlds.action_space.seed(1)
    seen, _ = worlds.reset(seed=1)
    episodes = 0
    for _ in range(32):
        seen, rewards, _, _, infos = worlds.step(worlds.action_space.sample())
        assert np.isfinite(seen).all() and np.abs(seen).max() <= 10 and np.isfinite(rewards).all()
        if "episode" in infos:
            episodes += int(infos["_episode"].sum())
            assert np.isfinite(infos["episode"]["r"][infos["_episode"]]).all()
            assert (infos["episode"]["l"][infos["_episode"]] == 10).all()
    assert episodes == 9


def test_stable_baselines_learns() -> None:
    checks = pytest.importorskip("stable_baselines3.common.env_checker")
    from stable_baselines3 import PPO

    checks.check_env(gymnasium.make("GT2003/Approach-v0").unwrapped)
    learner = PPO("MlpPolicy", gymnasium.make("GT2003/Approach-v0", seconds=1.0), n_steps=64, batch_size=32, seed=1)
    learner.learn(128)
    assert learner.num_timesteps == 128 and len(learner.ep_info_buffer) >= 4


def test_stable_baselines_learns_a_team_by_supersuit() -> None:
    supersuit = pytest.importorskip("supersuit")
    PPO = pytest.importorskip("stable_baselines3").PPO
    agents = supersuit.pettingzoo_env_to_vec_env_v1(soccer_v0.parallel_env(agents="red", actions="motion", seconds=0.4))
    worlds = supersuit.concat_vec_envs_v1(agents, 2, base_class="stable_baselines3")
    learner = PPO("MlpPolicy", worlds, n_steps=16, batch_size=32)
    learner.learn(128)
    assert learner.num_timesteps == 128


def test_rllib_learns() -> None:
    ppo = pytest.importorskip("ray.rllib.algorithms.ppo", exc_type=ImportError)
    from ray.tune import register_env

    register_env("approach", lambda _: gymnasium.make("GT2003/Approach-v0", seconds=1.0))
    config = ppo.PPOConfig().environment("approach")
    config = config.env_runners(num_env_runners=0).training(train_batch_size_per_learner=200, minibatch_size=50, num_epochs=1)
    learner = config.build_algo()
    result = learner.train()
    learner.stop()
    assert result["env_runners"]["num_episodes"] >= 4
    assert np.isfinite(result["env_runners"]["episode_return_mean"])


def test_torchrl_rolls_out() -> None:
    envs = pytest.importorskip("torchrl.envs")
    one = envs.GymWrapper(gymnasium.make("GT2003/Approach-v0", seconds=1.0))
    envs.check_env_specs(one)
    assert one.rollout(100).shape == (25,)
    team = envs.PettingZooWrapper(soccer_v0.parallel_env(agents="red", actions="motion", seconds=0.4), return_state=False)
    played = team.rollout(100)
    assert played.shape == (10,) and all(played[f"red{number}", "observation"].shape[0] == 10 for number in range(1, 5))


def test_the_example_learns_to_approach_the_ball(tmp_path: Path) -> None:
    pytest.importorskip("stable_baselines3")
    pytest.importorskip("matplotlib")
    command = [sys.executable, EXAMPLES / "learn_approach.py", "--minutes", "1", "--unseen", "20", "--out", tmp_path]
    told = subprocess.run(command, check=True, capture_output=True, text=True).stdout
    found = re.search(r"learned policy: return (-?\d\.\d\d) ", told)
    assert found and float(found[1]) > -0.5, told
    assert {file.name for file in tmp_path.iterdir()} == {"curve.png", "observations.pkl", "policy.zip"}
