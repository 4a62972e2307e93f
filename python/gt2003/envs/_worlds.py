"""What all forms of environments share: options, spaces, and checks of what is given."""

from __future__ import annotations

import numbers
from collections.abc import Mapping
from typing import Any

import numpy as np
from gymnasium.spaces import Box
from numpy.typing import ArrayLike, NDArray

from .. import _core
from .._error import Error

METADATA = {"render_modes": ["rgb_array"]}
DEFAULTS = {
    "observations": "",
    "actions": "",
    "agents": "",
    "fidelity": "",
    "profile": "benign",
    "seconds": 0.0,
    "randomize": None,
    "root": "",
}


class Worlds:
    """Worlds that are stepped together, and their memory: what the last step or reset left of each.

    options are those of DEFAULTS. observations: (worlds, ...) of one agent, (worlds, agents, ...) of several; rewards: (worlds, agents);
    terms: (worlds, agents, terms); terminated, truncated: (worlds,). A copy, or what is loaded of a pickle, has worlds of its own: they
    are made by the options and continue from the states of the first ones.

    Raises Error if an option is unknown or wrong.
    """

    def __init__(self, environment: str, count: int, threads: int, options: Mapping[str, Any]) -> None:
        self._made = environment, count, threads, dict(options)
        self.compiled = compiled(environment, count, threads, options)
        self.observations = self.compiled.observations
        if len(self.compiled.agents) == 1:
            self.observations = self.observations[:, 0]
        self.rewards, self.terms = self.compiled.rewards, self.compiled.term_values
        self.terminated, self.truncated = self.compiled.terminated, self.compiled.truncated
        self.term_names = [name for name, _ in self.compiled.terms]

    @property
    def over(self) -> NDArray[np.bool_]:
        """Which episodes are over: (worlds,)."""
        return self.terminated | self.truncated

    def metadata(self, **further: Any) -> dict[str, Any]:
        """Return the metadata of environments; videos of one image a step last as long as what they show."""
        return {**METADATA, "render_fps": 1 / self.compiled.seconds_per_step, **further}

    def __reduce__(self) -> tuple[Any, ...]:
        states = [self.compiled.save(world) for world in range(len(self.terminated))]
        return type(self), self._made, states

    def __setstate__(self, states: list[str]) -> None:
        for world, state in enumerate(states):
            self.compiled.load(world, state)


def compiled(environment: str, count: int, threads: int, options: Mapping[str, Any]) -> _core.Environments:
    for name in options:
        if name not in DEFAULTS:
            raise Error(f"there is no such option; expected {', '.join(DEFAULTS)}", field=name)
    chosen = {**DEFAULTS, **options}
    for name in ("observations", "actions", "agents", "fidelity", "profile", "root"):
        if not isinstance(chosen[name], str):
            raise Error("expected a text", field=name)
    chosen["seconds"] = _number(chosen["seconds"], "seconds")
    chosen["randomize"] = _bounds(chosen["randomize"])
    count, threads = _count(count, "num_envs"), _count(threads, "threads")
    return _core.Environments(environment, count=count, threads=threads, **chosen)


def render_mode(mode: str | None) -> str | None:
    """Return the mode; raises Error if there is no such one."""
    if mode not in (None, "rgb_array"):
        raise Error("expected None or 'rgb_array'", field="render_mode")
    return mode


def spaces(worlds: _core.Environments, agents: int = 1) -> tuple[Box, Box]:
    """Return the spaces of agents: observations, actions. Those of several have them along the first axis."""
    if worlds.observations.dtype == np.uint8:
        seen = Box(0, 255, worlds.observations.shape[2:], np.uint8)
    else:
        seen = _box(worlds.observation_components)
    both = seen, _box(worlds.action_components)
    return both if agents == 1 else tuple(_stacked(space, agents) for space in both)


def checked_actions(actions: ArrayLike, shape: tuple[int, ...]) -> NDArray[np.float32]:
    """Return actions as the worlds take them; raises Error if they are no numbers of this shape."""
    try:
        given = np.asarray(actions)
    except ValueError as wrong:
        raise Error(str(wrong), field="actions") from None
    if given.dtype.kind not in "fiu":
        raise Error(f"expected numbers, not {given.dtype}", field="actions")
    if given.shape != shape:
        raise Error(f"expected the shape {shape}, not {given.shape}", field="actions")
    with np.errstate(over="ignore"):  # what is too large for a float is not finite, which is refused
        return np.ascontiguousarray(given, np.float32)


def checked_mask(options: Mapping[str, Any] | None, count: int) -> NDArray[np.bool_] | None:
    """Return the ``reset_mask`` of the options of a reset, which worlds it is for; raises Error if it is none, or for other options."""
    if not options:
        return None
    for name in options:
        if name != "reset_mask":
            raise Error("there is no such option; expected reset_mask", field=str(name))
    mask = options["reset_mask"]
    if not isinstance(mask, np.ndarray) or mask.dtype != np.bool_ or mask.shape != (count,) or not mask.any():
        raise Error(f"expected an array of {count} booleans, one of them true", field="reset_mask")
    return mask


def checked_seed(seed: Any) -> int:
    """Return a seed; raises Error if it is no number that can be one."""
    if isinstance(seed, bool) or not isinstance(seed, numbers.Integral) or not 0 <= seed < 2**63:
        raise Error("expected a whole number from 0 to 2^63 - 1", field="seed")
    return int(seed)


def _box(components: list[tuple[str, str, float, float, str]]) -> Box:
    low = np.array([component[2] for component in components], np.float32)
    high = np.array([component[3] for component in components], np.float32)
    return Box(low, high, dtype=np.float32)


def _stacked(space: Box, count: int) -> Box:
    return Box(np.stack([space.low] * count), np.stack([space.high] * count), dtype=space.dtype)


def _number(value: Any, name: str) -> float:
    if isinstance(value, bool) or not isinstance(value, numbers.Real) or not np.isfinite(value):
        raise Error("expected a number", field=name)
    return float(value)


def _count(value: Any, name: str) -> int:
    if isinstance(value, bool) or not isinstance(value, numbers.Integral) or not 0 <= value < 2**31:
        raise Error("expected a whole number", field=name)
    return int(value)


def _bounds(randomize: Any) -> list[tuple[str, float, float]]:
    if randomize is None:
        return []
    if not isinstance(randomize, Mapping):
        raise Error("expected names with bounds, such as {'dynamics.friction': (0.7, 1.3)}", field="randomize")
    bounds = []
    for name, pair in randomize.items():
        if not isinstance(name, str) or not isinstance(pair, (tuple, list)) or len(pair) != 2:
            raise Error("expected a lower and an upper bound", field=str(name))
        bounds.append((name, _number(pair[0], name), _number(pair[1], name)))
    return bounds
