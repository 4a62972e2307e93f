"""Prints the tables of docs/environments.md: python -m gt2003.envs"""

from __future__ import annotations

import sys
from functools import cache
from itertools import groupby
from typing import Any

from .. import _core
from .._signals import quietly
from ._worlds import compiled

_KINDS = {
    "joints": "angles of joints",
    "parameters": "parameters of the walk",
    "motion": "motion request",
    "skills": "choice of a skill",
}


def _components(components: list[tuple[str, str, float, float, str]]) -> str:
    """Return the components in lines of a table, those of a group together."""
    lines = []
    for _, members in groupby(components, lambda c: ("." in c[0] and c[0].split(".")[0], c[1], c[4])):
        group = list(members)
        names = f"`{group[0][0]}`" if len(group) == 1 else f"`{group[0][0]}` … `{group[-1][0]}` ({len(group)})"
        lines.append(f"| {names} | {group[0][1]} | {group[0][4]} |")
    return "\n".join(lines)


def _table(title: str, components: list[tuple[str, str, float, float, str]]) -> str:
    return f"\n| {title} | | |\n| --- | --- | --- |\n{_components(components)}"


@cache
def _made(name: str, **options: str) -> _core.Environments:
    return compiled(name, 1, 1, options)


def _observed(known: dict[str, Any]) -> list[str]:
    """Return tables of what is observed: of each kind of numbers, and what joints add to them."""

    def components(kind: str, actions: str) -> list[tuple[str, str, float, float, str]]:
        return _made(known["name"], observations=kind, actions=actions).observation_components

    default, *others = known["actions"]
    kinds = [kind for kind in known["observations"] if kind != "image"]
    same = all(components(kind, default) == components(kinds[0], default) for kind in kinds)
    if same:
        titles = {kinds[0]: "observed as " + " or ".join(f"`{kind}`" for kind in kinds)}
    else:
        titles = {kind: f"observed as `{kind}`" for kind in kinds}
    tables = [_table(title, components(kind, default)) for kind, title in titles.items()]
    for actions in others:
        more = [c for c in components(kinds[0], actions) if c not in components(kinds[0], default)]
        if more:
            tables.append(_table(f"observed besides, with `{actions}`", more))
    return tables


def page() -> str:
    """Return the tables of all environments, as the descriptions in C++ have them."""
    parts = []
    for known in _core.environments():
        name = known["name"]
        parts.append(f"### {name}\n\n{known['summary']}\n")
        parts.append("| | |\n| --- | --- |")
        for agents in known["agents"]:
            those = f" with `{agents}`" if len(known["agents"]) > 1 else ""
            names = _made(name, agents=agents).agents
            parts.append(f"| agents{those} | {', '.join(f'`{agent}`' for agent in names)} |")
        parts.append(f"| observations | {', '.join(f'`{kind}`' for kind in known['observations'])} |")
        parts.append(f"| actions | {', '.join(f'`{kind}`' for kind in known['actions'])} |")
        parts.append(f"| fidelity | {', '.join(f'`{fidelity}`' for fidelity in known['fidelities'])} |")
        for actions in known["actions"]:
            step = _made(name, observations="state", actions=actions).seconds_per_step
            parts.append(f"| a step with `{actions}` | {1000 * step:g} ms |")
        parts.append(f"| terminated | {known['end']} |")
        parts.append(f"| truncated | after {known['seconds']:g} s |\n")
        parts.append("| reward: the sum of | |\n| --- | --- |")
        parts.extend(f"| `{term}` | {what} |" for term, what in _made(name, observations="state", actions=known["actions"][0]).terms)
        parts.extend(_observed(known))
        for kind in known["actions"]:
            components = _made(name, observations="state", actions=kind).action_components
            parts.append(_table(f"{_KINDS[kind]} (`{kind}`)", components))
        parts.append("")
    return "\n".join(parts)


def main() -> int:
    """Print the tables."""
    print(page(), end="")
    return 0


if __name__ == "__main__":
    sys.exit(quietly(main))
