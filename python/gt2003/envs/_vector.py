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
    s + i. A copy (`copy.deepcopy`, pickle) goes on from the same states in worlds of its own.
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
        self._worlds = _worlds.Worlds(environment, num_envs, threads, options)
        self.metadata = self._worlds.metadata(autoreset_mode=AutoresetMode.NEXT_STEP)
        self.num_envs = num_envs
        self.single_observation_space, self.single_action_space = _worlds.spaces(self.worlds, len(self.worlds.agents))
        self.observation_space = batch_space(self.single_observation_space, num_envs)
        self.action_space = batch_space(self.single_action_space, num_envs)
        self._copy = copy
        self._seeded = False

    @property
    def worlds(self) -> _core.Environments:
        """The compiled environments, with the names of all components."""
        return self._worlds.compiled

    def reset(
        self, *, seed: int | Sequence[int | None] | None = None, options: dict[str, Any] | None = None
    ) -> tuple[NDArray[Any], dict[str, Any]]:
        """Begin an episode in each world, with the seeds seed, seed + 1, … or those of a list.

        With the option ``reset_mask``, (worlds,) booleans, only in those where it is true.
        """
        mask = _worlds.checked_mask(options, self.num_envs)
        if isinstance(seed, (Sequence, np.ndarray)):
            if len(seed) != self.num_envs:
                raise _worlds.Error(f"expected {self.num_envs} seeds", field="seed")
            seeds = [None if one is None else _worlds.checked_seed(one) for one in seed]
            mask = np.ones(self.num_envs, bool) if mask is None else mask
        else:
            if seed is not None:
                seed = _worlds.checked_seed(seed)
                self._np_random_seed, self._np_random = seed, np.random.default_rng(seed)
            elif not self._seeded:
                seed = int(self.np_random.integers(2**62))
            seeds = [None if seed is None else seed + world for world in range(self.num_envs)]
        if mask is None:
            self.worlds.reset(seed)
        else:
            for world in np.flatnonzero(mask):
                self.worlds.reset_one(int(world), seeds[world])
        self._seeded = True
        return self._given(self._worlds.observations), {}

    def step(self, actions: ArrayLike) -> tuple[Any, Any, Any, Any, dict[str, Any]]:
        """Act for one step in each world; the info has the terms of the rewards by name, of those worlds that did not begin anew."""
        if not self._seeded:
            raise _worlds.Error("reset the environment first", field="step")
        worlds = self._worlds
        acted = ~worlds.over
        worlds.compiled.step(_worlds.checked_actions(actions, self.action_space.shape), True)
        info: dict[str, Any] = {}
        if acted.any():
            for i, name in enumerate(worlds.term_names):
                info[name] = self._given(worlds.terms[:, 0, i])
                info["_" + name] = acted
        return (
            self._given(worlds.observations),
            self._given(worlds.rewards[:, 0]),
            self._given(worlds.terminated),
            self._given(worlds.truncated),
            info,
        )

    def render(self) -> tuple[NDArray[np.uint8], ...] | None:
        """Return an image of each scene: (height, width, 3), RGB."""
        if not self.render_mode:
            return None
        return tuple(self.worlds.picture(world) for world in range(self.num_envs))

    def save_state(self) -> list[str]:
        """Return the state of each world, as `Environment.save_state` does."""
        return [self.worlds.save(world) for world in range(self.num_envs)]

    def load_state(self, states: Sequence[str]) -> NDArray[Any]:
        """Continue all worlds from such states; return the observations."""
        if isinstance(states, str) or len(states) != self.num_envs:
            raise _worlds.Error(f"expected {self.num_envs} states", field="states")
        for world, state in enumerate(states):
            self.worlds.load(world, state)
        self._seeded = True
        return self._given(self._worlds.observations)

    def _given(self, array: NDArray[Any]) -> NDArray[Any]:
        return array.copy() if self._copy else array
