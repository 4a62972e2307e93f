"""Many worlds in one process, as Gymnasium has them."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from gymnasium.vector import AutoresetMode, VectorEnv
from gymnasium.vector.utils import batch_space
from numpy.typing import ArrayLike, NDArray

from .. import _core
from . import _worlds


class VectorEnvironment(VectorEnv):
    """Many worlds that are stepped together, by `threads` threads (0: as many as there are cores).

    Options are those of `Environment`. What is returned is a copy; with ``copy=False`` it is the
    worlds' own memory, which the next step overwrites. A world whose episode is over begins the
    next one in the next step. The rewards are those of the first agent of each world;
    ``worlds.rewards`` has all: (worlds, agents). World i with the seed s is the same as an `Environment` with the seed
    s + i.
    """

    metadata = {**_worlds.METADATA, "autoreset_mode": AutoresetMode.NEXT_STEP}

    def __init__(
        self,
        environment: str,
        num_envs: int = 1,
        *,
        threads: int = 0,
        copy: bool = True,
        render_mode: str | None = None,
        **options: Any,
    ) -> None:
        self.render_mode = _worlds.render_mode(render_mode)
        self._worlds = _worlds.make(environment, num_envs, threads, options)
        self.num_envs = num_envs
        agents = len(self._worlds.agents)
        self.single_observation_space, self.single_action_space = _worlds.spaces(self._worlds, agents)
        self.observation_space = batch_space(self.single_observation_space, num_envs)
        self.action_space = batch_space(self.single_action_space, num_envs)
        self._copy = copy
        self._seeded = False
        worlds = self._worlds
        self._observations = worlds.observations[:, 0] if agents == 1 else worlds.observations
        self._rewards = worlds.rewards[:, 0]
        self._terminated, self._truncated = worlds.terminated, worlds.truncated
        self._terms = {name: worlds.term_values[:, 0, i] for i, (name, _) in enumerate(worlds.terms)}
        self._all = np.ones(num_envs, bool)

    @property
    def worlds(self) -> _core.Environments:
        """The compiled environments, with the names of all components."""
        return self._worlds

    def reset(
        self, *, seed: int | Sequence[int | None] | None = None, options: dict[str, Any] | None = None
    ) -> tuple[NDArray[Any], dict[str, Any]]:
        """Begin an episode in each world, with the seeds seed, seed + 1, … or those of a list."""
        if isinstance(seed, Sequence):
            if len(seed) != self.num_envs:
                raise _worlds.Error(f"expected {self.num_envs} seeds", field="seed")
            seeds = [None if one is None else _worlds.checked_seed(one) for one in seed]
            for world, one in enumerate(seeds):
                self._worlds.reset_one(world, one)
        else:
            if seed is not None:
                seed = _worlds.checked_seed(seed)
                self._np_random_seed, self._np_random = seed, np.random.default_rng(seed)
            elif not self._seeded:
                seed = int(self.np_random.integers(2**62))
            self._worlds.reset(seed)
        self._seeded = True
        return self._given(self._observations), {}

    def step(self, actions: ArrayLike) -> tuple[Any, Any, Any, Any, dict[str, Any]]:
        """Act for one step in each world; the info has the terms of the rewards by name."""
        self._worlds.step(_worlds.checked_actions(actions, self.action_space.shape), True)
        info: dict[str, Any] = {}
        for name, values in self._terms.items():
            info[name] = self._given(values)
            info["_" + name] = self._all
        return (
            self._given(self._observations),
            self._given(self._rewards),
            self._given(self._terminated),
            self._given(self._truncated),
            info,
        )

    def render(self) -> tuple[NDArray[np.uint8], ...] | None:
        """Return an image of each scene: (height, width, 3), RGB."""
        if not self.render_mode:
            return None
        return tuple(self._worlds.picture(world) for world in range(self.num_envs))

    def save_state(self) -> list[str]:
        """Return the state of each world, as `Environment.save_state` does."""
        return [self._worlds.save(world) for world in range(self.num_envs)]

    def load_state(self, states: Sequence[str]) -> NDArray[Any]:
        """Continue all worlds from such states; return the observations."""
        if isinstance(states, str) or len(states) != self.num_envs:
            raise _worlds.Error(f"expected {self.num_envs} states", field="states")
        for world, state in enumerate(states):
            self._worlds.load(world, state)
        self._seeded = True
        return self._given(self._observations)

    def _given(self, array: NDArray[Any]) -> NDArray[Any]:
        return array.copy() if self._copy else array
