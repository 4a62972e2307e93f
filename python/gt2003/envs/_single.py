"""One world, as Gymnasium has it."""

from __future__ import annotations

from typing import Any

import gymnasium
import numpy as np
from numpy.typing import ArrayLike, NDArray

from .. import _core
from . import _worlds


class Environment(gymnasium.Env):
    """One world with one agent, or with one that decides for several robots.

    observations: ``state``, ``beliefs`` or ``image``; actions: ``joints``, ``parameters``, ``motion``
    or ``skills``; fidelity: ``kinematic`` or ``dynamic``: each as far as the environment offers it, by
    default its first. profile: how far all is from perfect (docs/realism.md); seconds: of simulated
    time until an episode is truncated; randomize: what each reset draws anew, names with lower and upper bound, such as
    ``{"dynamics.friction": (0.7, 1.3), "noise.joints": (0, 0.5)}``; root: the data root.

    agents: ``red``, or ``all`` where the environment offers it: whose robots are decided for. Those of
    several lie along the first axis of observations and actions; the reward is the first one's.

    The same options, seed and actions give the same bits, alone and in a `VectorEnvironment`. A copy (`copy.deepcopy`, pickle) goes on
    from the same state in a world of its own.
    """

    metadata = _worlds.METADATA

    def __init__(self, environment: str, *, render_mode: str | None = None, **options: Any) -> None:
        self.render_mode = _worlds.render_mode(render_mode)
        self._worlds = _worlds.Worlds(environment, 1, 1, options)
        self.metadata = self._worlds.metadata()
        self.observation_space, self.action_space = _worlds.spaces(self.worlds, len(self.worlds.agents))
        self.terms = self._worlds.term_names
        self._seeded = False

    @property
    def worlds(self) -> _core.Environments:
        """The compiled environment, with the names of all components."""
        return self._worlds.compiled

    def reset(
        self, *, seed: int | None = None, options: dict[str, Any] | None = None
    ) -> tuple[NDArray[Any], dict[str, Any]]:
        """Begin an episode; without a seed, the next of those that follow from the last one. There are no options."""
        if options:
            raise _worlds.Error("there is no such option", field=str(next(iter(options))))
        if seed is not None:
            seed = _worlds.checked_seed(seed)
        super().reset(seed=seed)
        if seed is None and not self._seeded:
            seed = int(self.np_random.integers(2**63))
        self.worlds.reset(seed)
        self._seeded = True
        return self._worlds.observations[0].copy(), {}

    def step(self, action: ArrayLike) -> tuple[NDArray[Any], float, bool, bool, dict[str, Any]]:
        """Act for one step; the info has the terms of the reward by name."""
        if not self._seeded:
            raise _worlds.Error("reset the environment first", field="step")
        worlds = self._worlds
        worlds.compiled.step(_worlds.checked_actions(action, self.action_space.shape), False)
        return (
            worlds.observations[0].copy(),
            float(worlds.rewards[0, 0]),
            bool(worlds.terminated[0]),
            bool(worlds.truncated[0]),
            dict(zip(self.terms, worlds.terms[0, 0].tolist())),
        )

    def render(self) -> NDArray[np.uint8] | None:
        """Return an image of the scene: (height, width, 3), RGB."""
        return self.worlds.picture(0) if self.render_mode else None

    def save_state(self) -> str:
        """Return the state of the episode as text: options, seed and actions."""
        return self.worlds.save(0)

    def load_state(self, state: str) -> NDArray[Any]:
        """Continue from a state of an environment with the same options; return the observation.

        The episode is played again, so that all that follows has the same bits.
        """
        if not isinstance(state, str):
            raise _worlds.Error("expected a text of save_state", field="state")
        self.worlds.load(0, state)
        self._seeded = True
        return self._worlds.observations[0].copy()
