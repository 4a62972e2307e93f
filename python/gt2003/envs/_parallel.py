"""One world with several agents, as PettingZoo has it."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from .. import _core
from .._error import Error
from . import _worlds

try:
    from pettingzoo import ParallelEnv
except ImportError as missing:
    raise Error("needs pettingzoo: pip install 'gt2003[envs]'", field="gt2003.envs") from missing


class ParallelEnvironment(ParallelEnv):
    """One world in which each agent has a robot; options are those of `Environment`.

    Observations, rewards, ends and infos are dicts with the names of the agents; an episode ends for
    all at once. A copy (`copy.deepcopy`, pickle) goes on from the same state in a world of its own.
    """

    def __init__(self, environment: str, *, render_mode: str | None = None, **options: Any) -> None:
        self.render_mode = _worlds.render_mode(render_mode)
        self._worlds = _worlds.Worlds(environment, 1, 1, options)
        self.metadata = self._worlds.metadata(name=f"GT2003/{environment}-v0", is_parallelizable=True)
        self.possible_agents = list(self.worlds.agents)
        self.agents: list[str] = []
        self._spaces = {agent: _worlds.spaces(self.worlds) for agent in self.possible_agents}
        self.terms = self._worlds.term_names
        self._seeded = False

    @property
    def worlds(self) -> _core.Environments:
        """The compiled environment, with the names of all components."""
        return self._worlds.compiled

    def observation_space(self, agent: str) -> Any:
        """Return the space of what an agent observes."""
        return self._spaces[agent][0]

    def action_space(self, agent: str) -> Any:
        """Return the space of an agent's actions."""
        return self._spaces[agent][1]

    def reset(
        self, seed: int | None = None, options: dict[str, Any] | None = None
    ) -> tuple[dict[str, NDArray[Any]], dict[str, dict[str, Any]]]:
        """Begin an episode; without a seed, the next of those that follow from the last one.

        There are no options. Whatever is given is ignored, since PettingZoo's own checks give some.
        """
        if seed is not None:
            seed = _worlds.checked_seed(seed)
        elif not self._seeded:
            seed = int(np.random.default_rng().integers(2**63))
        self.worlds.reset(seed)
        self._seeded = True
        self.agents = list(self.possible_agents)
        return self._observations(), {agent: {} for agent in self.agents}

    def step(self, actions: Mapping[str, ArrayLike]) -> tuple[dict[str, Any], ...]:
        """Act for one step; the infos have the terms of the rewards by name."""
        if not self.agents:
            raise Error("the episode is over; reset the environment", field="step")
        if not isinstance(actions, Mapping) or set(actions) != set(self.agents):
            raise Error(f"expected one for each of {', '.join(self.agents)}", field="actions")
        shape = self.action_space(self.agents[0]).shape
        self.worlds.step(np.stack([_worlds.checked_actions(actions[agent], shape) for agent in self.agents]), False)
        terminated, truncated = bool(self._worlds.terminated[0]), bool(self._worlds.truncated[0])
        rewards, terms = self._worlds.rewards[0].tolist(), self._worlds.terms[0].tolist()
        given = (
            self._observations(),
            dict(zip(self.agents, rewards)),
            dict.fromkeys(self.agents, terminated),
            dict.fromkeys(self.agents, truncated),
            {agent: dict(zip(self.terms, own)) for agent, own in zip(self.agents, terms)},
        )
        if terminated or truncated:
            self.agents = []
        return given

    def render(self) -> NDArray[np.uint8] | None:
        """Return an image of the scene: (height, width, 3), RGB."""
        return self.worlds.picture(0) if self.render_mode else None

    def save_state(self) -> str:
        """Return the state of the episode as text: options, seed and actions."""
        return self.worlds.save(0)

    def load_state(self, state: str) -> dict[str, NDArray[Any]]:
        """Continue from a state of an environment with the same options; return the observations."""
        if not isinstance(state, str):
            raise Error("expected a text of save_state", field="state")
        self.worlds.load(0, state)
        self._seeded = True
        self.agents = [] if self._worlds.over[0] else list(self.possible_agents)
        return self._observations()

    def _observations(self) -> dict[str, NDArray[Any]]:
        observations = self.worlds.observations[0]
        return {agent: observations[i].copy() for i, agent in enumerate(self.possible_agents)}
