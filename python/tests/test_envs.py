"""Environments: the checks of Gymnasium, the same bits in all forms, and what is refused."""

from __future__ import annotations

import copy
import pickle
import threading
import warnings
from pathlib import Path

import cloudpickle
import gymnasium
import numpy as np
import pytest
from gymnasium.utils.env_checker import check_env
from pettingzoo.test import parallel_api_test, parallel_seed_test

import gt2003
import gt2003.envs
from gt2003 import _core
from gt2003.envs import soccer_v0
from gt2003.envs.__main__ import page

DESCRIBED = {known["name"]: known for known in _core.environments()}
NAMES = [name for name in DESCRIBED if f"GT2003/{name}-v0" in gymnasium.registry]
RANDOMIZE = {
    "dynamics.friction": (0.7, 1.3),
    "dynamics.mass": (0.9, 1.1),
    "camera.brightness": (0.8, 1.2),
    "noise.joints": (0, 0.5),
}


def make(name: str, **options: object) -> gymnasium.Env:
    return gymnasium.make(f"GT2003/{name}-v0", **options)


@pytest.mark.parametrize("name", NAMES)
@pytest.mark.parametrize("observations", ["state", "beliefs", "image"])
def test_passes_the_checks_of_gymnasium(name: str, observations: str) -> None:
    if observations not in DESCRIBED[name]["observations"]:
        pytest.skip("offers no such observations")
    environment = make(name, observations=observations, render_mode="rgb_array", randomize=RANDOMIZE)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        warnings.filterwarnings("ignore", ".*obs.*image.*")  # YCbCr in 0..255 is what it is
        check_env(environment.unwrapped, skip_render_check=observations != "state")


@pytest.mark.parametrize("name", NAMES)
@pytest.mark.parametrize("threads", [1, 2])
def test_vectorized_worlds_are_those_alone_and_those_loaded(name: str, threads: int) -> None:
    step_time = make(name).unwrapped.worlds.seconds_per_step
    options = {"seconds": 25 * step_time, "randomize": RANDOMIZE}
    many = gymnasium.make_vec(f"GT2003/{name}-v0", num_envs=2, threads=threads, **options)
    alone = [make(name, **options) for _ in range(2)]
    seen, _ = many.reset(seed=7)
    for world, environment in enumerate(alone):
        np.testing.assert_array_equal(environment.reset(seed=7 + world)[0], seen[world])
    many.action_space.seed(1)
    over = [False, False]
    for step in range(60):
        actions = many.action_space.sample()
        seen, rewards, terminated, truncated, info = many.step(actions)
        for world in range(2):
            environment = alone[world]
            if over[world]:
                observation, _ = environment.reset()
                reward, ends, terms = 0.0, (False, False), dict.fromkeys(environment.unwrapped.terms, 0.0)
            else:
                observation, reward, *ends, terms = environment.step(actions[world])
                assert terms == {term: info[term][world] for term in terms}
            np.testing.assert_array_equal(observation, seen[world])
            assert (reward, *ends) == (rewards[world], terminated[world], truncated[world])
            assert all("_" + term not in info or info["_" + term][world] != over[world] for term in terms)
            assert reward == pytest.approx(sum(terms.values()))
            over[world] = any(ends)
        if step == 10:
            states = many.unwrapped.save_state()
            assert states == [environment.unwrapped.save_state() for environment in alone]
            many = gymnasium.make_vec(f"GT2003/{name}-v0", num_envs=2, threads=3 - threads, **options)
            np.testing.assert_array_equal(many.unwrapped.load_state(states), seen)
            many.action_space.seed(2)


@pytest.mark.parametrize("name", NAMES)
def test_seeds_decide(name: str) -> None:
    environment = make(name)
    first, _ = environment.reset(seed=1)
    second, _ = environment.reset()
    assert not np.array_equal(first, second)
    np.testing.assert_array_equal(environment.reset(seed=1)[0], first)
    np.testing.assert_array_equal(environment.reset()[0], second)
    assert not np.array_equal(environment.reset(seed=2)[0], first)


@pytest.mark.parametrize("agents", ["red", "all"])
def test_soccer_passes_the_checks_of_pettingzoo(agents: str) -> None:
    def soccer() -> soccer_v0.ParallelEnvironment:
        return soccer_v0.parallel_env(agents=agents, seconds=0.8, randomize=RANDOMIZE, render_mode="rgb_array")

    with warnings.catch_warnings():
        warnings.simplefilter("error")
        parallel_api_test(soccer(), num_cycles=30)
        parallel_seed_test(soccer, num_cycles=30)
    environment = soccer()
    assert len(environment.possible_agents) == (4 if agents == "red" else 8)
    environment.reset(seed=1)
    assert environment.render().shape == (360, 640, 3)


def test_each_agent_of_soccer_is_a_row_of_its_form_for_gymnasium() -> None:
    options = {"agents": "all", "actions": "skills", "seconds": 0.4, "randomize": RANDOMIZE}
    each, many = soccer_v0.parallel_env(**options), make("Soccer", **options)
    seen, _ = each.reset(seed=3)
    np.testing.assert_array_equal(many.reset(seed=3)[0], np.stack(list(seen.values())))
    many.action_space.seed(1)
    for step in range(10):
        actions = many.action_space.sample()
        together, reward, *ends, terms = many.step(actions)
        seen, rewards, terminated, truncated, infos = each.step(dict(zip(each.possible_agents, actions)))
        np.testing.assert_array_equal(together, np.stack(list(seen.values())))
        assert reward == rewards["red1"] == rewards["red4"] and rewards["blue1"] == rewards["blue4"]
        assert terms == infos["red1"] and infos["red1"]["ball"] == -infos["blue2"]["ball"]
        assert ends == [terminated["blue4"], truncated["red2"]]
        if step == 4:
            state = each.save_state()
            assert state == many.unwrapped.save_state()
            each = soccer_v0.parallel_env(**options)
            again = each.load_state(state)
            np.testing.assert_array_equal(together, np.stack(list(again.values())))
    assert not each.agents and truncated["red1"]


def test_wrong_names_of_options_are_told() -> None:
    for option, message in (
        ({"observations": "stat"}, "observations: there is no 'stat'; expected state, .*; did you mean 'state'"),
        ({"actions": "joint"}, "did you mean 'joints'"),
        ({"profile": "padua"}, "profile: there is no 'padua'; did you mean 'padova'"),
    ):
        with pytest.raises(gt2003.Error, match=message):
            gymnasium.make("GT2003/Walk-v0", **option)


def test_wrong_things_of_soccer_are_errors() -> None:
    for options in ({"agents": "blue"}, {"agents": 4}, {"render_mode": "human"}, {"observation": "state"}):
        with pytest.raises(gt2003.Error):
            soccer_v0.parallel_env(**options)
    environment = soccer_v0.parallel_env(agents="red")
    right = {agent: np.zeros(6) for agent in environment.possible_agents}
    with pytest.raises(gt2003.Error, match="over"):
        environment.step(right)
    environment.reset(seed=1)
    for wrong in (
        None,
        [np.zeros(6)] * 4,
        {"red1": np.zeros(6)},
        {**right, "blue1": np.zeros(6)},
        {**right, "red2": np.zeros(5)},
        {**right, "red2": np.full(6, np.nan)},
    ):
        with pytest.raises(gt2003.Error):
            environment.step(wrong)
    with pytest.raises(gt2003.Error):
        environment.reset(seed=-1)
    with pytest.raises(gt2003.Error):
        environment.load_state(b"")


WAYS = {"deepcopy": copy.deepcopy, "pickle": lambda e: pickle.loads(pickle.dumps(e)), "cloudpickle": lambda e: cloudpickle.loads(cloudpickle.dumps(e))}


@pytest.mark.parametrize("way", WAYS)
@pytest.mark.parametrize("steps", [0, 3, 6], ids=lambda steps: f"after {steps} steps")
def test_copies_go_on_with_the_same_bits(way: str, steps: int) -> None:
    """In worlds of their own, in the middle of an episode and at its end, which is after six steps here."""
    options = {"seconds": 0.048, "randomize": RANDOMIZE}
    for first in (make("Walk", **options), gymnasium.make_vec("GT2003/Walk-v0", num_envs=3, threads=2, **options)):
        first.reset(seed=4)
        first.action_space.seed(1)
        for _ in range(steps):
            first.step(first.action_space.sample())
        second = WAYS[way](first)
        assert second.spec == first.spec
        for _ in range(6 - steps if isinstance(first, gymnasium.Env) else 10):
            left, right = (environment.step(environment.action_space.sample()) for environment in (first, second))
            for a, b in zip(left, right):
                np.testing.assert_equal(a, b)
        np.testing.assert_array_equal(first.reset()[0], second.reset()[0])
        first.step(first.action_space.sample())
        assert first.unwrapped.save_state() != second.unwrapped.save_state()


@pytest.mark.parametrize("way", WAYS)
def test_copies_of_several_agents_go_on_with_the_same_bits(way: str) -> None:
    first = soccer_v0.parallel_env(seconds=0.12, randomize=RANDOMIZE)
    assert not WAYS[way](first).agents, "was never reset"
    first.reset(seed=4)
    actions = {agent: first.action_space(agent).sample() for agent in first.agents}
    first.step(actions)
    second = WAYS[way](first)
    while first.agents:
        assert second.agents == first.agents
        for a, b in zip(first.step(actions), second.step(actions)):
            np.testing.assert_equal(a, b)
    assert not second.agents and not WAYS[way](first).agents


@pytest.mark.parametrize("processes", [0, 2])
def test_supersuit_makes_a_vector_of_agents_as_for_stable_baselines(processes: int) -> None:
    supersuit = pytest.importorskip("supersuit")  # has no packages for newer Pythons
    agents = supersuit.pettingzoo_env_to_vec_env_v1(soccer_v0.parallel_env(agents="red", actions="motion", seconds=0.4))
    many = supersuit.concat_vec_envs_v1(agents, 2, num_cpus=processes, base_class="gymnasium")
    observations, _ = many.reset(seed=3)
    assert observations.shape == (8, *agents.observation_space.shape)
    ended = np.zeros(8, bool)
    for _ in range(12):
        observations, rewards, terminated, truncated, _ = many.step(np.zeros((8, *agents.action_space.shape), np.float32))
        ended |= np.asarray(truncated, bool)
        assert np.isfinite(observations).all() and np.isfinite(rewards).all()
    assert ended.all()
    many.close()


@pytest.mark.parametrize(
    ("name", "options", "fps"), [("Walk", {}, 125), ("Walk", {"actions": "parameters"}, 1.5625), ("Approach", {"actions": "motion"}, 25)]
)
def test_videos_last_as_long_as_what_they_show(name: str, options: dict[str, str], fps: float) -> None:
    for environment in (make(name, **options), gymnasium.make_vec(f"GT2003/{name}-v0", num_envs=1, **options)):
        assert environment.metadata["render_fps"] == pytest.approx(fps)
    assert soccer_v0.parallel_env(actions="joints").metadata["render_fps"] == pytest.approx(125)


def test_a_mask_says_which_worlds_begin_anew() -> None:
    """As Gymnasium's own vector of single environments."""
    options = {"num_envs": 3, "seconds": 0.048, "randomize": RANDOMIZE}
    many, alone = (gymnasium.make_vec("GT2003/Walk-v0", vectorization_mode=mode, **options) for mode in ("vector_entry_point", "sync"))
    many.reset(seed=1)
    alone.reset(seed=1)
    many.action_space.seed(1)
    for step in range(20):
        actions = many.action_space.sample()
        for a, b in zip(many.step(actions), alone.step(actions)):
            np.testing.assert_equal(a, b)
        if step in (2, 13):
            for seed in (7, [8, None, 9], None):
                mask = np.array([True, step == 13, False])
                before = many.step(actions)[0]
                np.testing.assert_array_equal(before, alone.step(actions)[0])
                after, expected = (e.reset(seed=seed, options={"reset_mask": mask.copy()})[0] for e in (many, alone))
                np.testing.assert_array_equal(after[mask], expected[mask])
                np.testing.assert_array_equal(after[~mask], before[~mask])


def test_arrays_without_copies_are_the_memory_of_the_worlds() -> None:
    many = gymnasium.make_vec("GT2003/Walk-v0", num_envs=3, copy=False)
    first, _ = many.reset(seed=1)
    before = first.copy()
    second, *_ = many.step(many.action_space.sample())
    assert np.shares_memory(first, second) and not np.array_equal(before, second)
    del many
    assert np.isfinite(second).all()


def test_renders_what_it_is_asked_for() -> None:
    assert make("Walk").unwrapped.render() is None
    image = gymnasium.make("GT2003/Walk-v0", render_mode="rgb_array", disable_env_checker=True).unwrapped.render()
    assert image.shape == (360, 640, 3) and image.dtype == np.uint8 and image.std() > 20


@pytest.mark.parametrize(
    "options",
    [
        {"observation": "state"},
        {"observations": "smell"},
        {"observations": 3},
        {"actions": "skill"},
        {"agents": "all"},
        {"fidelity": "kinematic"},
        {"profile": "ideal"},
        {"seconds": -1},
        {"seconds": "long"},
        {"seconds": float("nan")},
        {"render_mode": "human"},
        {"root": "/nowhere"},
        {"randomize": ["friction"]},
        {"randomize": {"dynamics.friction": 1}},
        {"randomize": {"dynamics.friction": (2, 1)}},
        {"randomize": {"dynamics.friction": (float("nan"), 1)}},
        {"randomize": {"dynamics.fraction": (1, 2)}},
        {"randomize": {"noise.joints": (0, "much")}},
    ],
)
def test_wrong_options_are_errors(options: dict[str, object]) -> None:
    with pytest.raises(gt2003.Error):
        gt2003.envs.Environment("Walk", **options)


def test_other_wrong_things_are_errors() -> None:
    with pytest.raises(gt2003.Error):
        gt2003.envs.Environment("Fly")
    for wrong in ({"num_envs": 0}, {"num_envs": "two"}, {"num_envs": 2, "threads": -1}):
        with pytest.raises(gt2003.Error):
            gt2003.envs.VectorEnvironment("Walk", **wrong)
    environment = gt2003.envs.Environment("Walk")
    before = environment.reset(seed=1)[0]
    for seed in (-1, 2**63, 1.5, "one", True):
        with pytest.raises(gt2003.Error):
            environment.reset(seed=seed)
    many = gt2003.envs.VectorEnvironment("Walk", 2)
    for never_reset, action in ((gt2003.envs.Environment("Walk"), np.zeros(12)), (many, np.zeros((2, 12)))):
        with pytest.raises(gt2003.Error, match="reset the environment first"):
            never_reset.step(action)
    seen = many.reset(seed=np.array([3, 4]))[0]
    np.testing.assert_array_equal(seen, many.reset(seed=3)[0])
    for options in ({"nonsense": 1}, {"reset_mask": [True, False]}, {"reset_mask": np.zeros(2, bool)}, {"reset_mask": np.ones(3, bool)}):
        for refusing in (many, environment):
            with pytest.raises(gt2003.Error):
                refusing.reset(options=options)
    np.testing.assert_array_equal(many.worlds.observations[:, 0], seen)
    for action in (
        np.zeros(11),
        np.zeros((1, 12)),
        0,
        None,
        "walk",
        ["a"] * 12,
        [[1], [1, 2]],
        np.zeros(12, complex),
        np.full(12, np.nan),
        np.full(12, np.inf),
        np.full(12, 1e300),
    ):
        with pytest.raises(gt2003.Error):
            environment.step(action)
    for state in ("", "{}", b"{}", 4, environment.save_state()[:-9]):
        with pytest.raises(gt2003.Error):
            environment.load_state(state)
    np.testing.assert_array_equal(environment.worlds.observations[0, 0], before)
    for _ in range(1000):
        *_, terminated, truncated, _ = environment.step(np.zeros(12))
    assert truncated and not terminated
    with pytest.raises(gt2003.Error, match="over"):
        environment.step(np.zeros(12))


def test_asked_from_two_threads_it_refuses_or_serves() -> None:
    many = gymnasium.make_vec("GT2003/Walk-v0", num_envs=2)
    many.reset(seed=1)
    failures = []

    def steps() -> None:
        for _ in range(50):
            try:
                many.step(np.zeros((2, 12)))
            except gt2003.Error as error:
                failures.append(str(error))

    threads = [threading.Thread(target=steps) for _ in range(2)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert set(failures) <= {"environment: runs in another thread"}


def test_the_page_has_what_the_environments_state() -> None:
    text = (Path(__file__).parents[2] / "docs/environments.md").read_text()
    assert text.partition("<!-- environments -->\n")[2] == page()
