"""Prints the tables of docs/environments.md: python -m gt2003.envs"""

from __future__ import annotations

from itertools import groupby

from .. import _core
from ._worlds import make

_KINDS = {"joints": "angles of joints", "parameters": "parameters of the walk"}


def _components(components: list[tuple[str, str, float, float, str]]) -> str:
    """Return the components in lines of a table, those of a group together."""
    lines = []
    for _, members in groupby(components, lambda c: ("." in c[0] and c[0].split(".")[0], c[1], c[4])):
        group = list(members)
        names = f"`{group[0][0]}`" if len(group) == 1 else f"`{group[0][0]}` … `{group[-1][0]}` ({len(group)})"
        lines.append(f"| {names} | {group[0][1]} | {group[0][4]} |")
    return "\n".join(lines)


def page() -> str:
    """Return the tables of all environments, as the descriptions in C++ have them."""
    parts = []
    for known in _core.environments():
        name = known["name"]
        worlds = make(name, 1, 1, {})
        parts.append(f"### {name}\n\n{known['summary']}\n")
        parts.append("| | |\n| --- | --- |")
        parts.append(f"| agents | {', '.join(f'`{agent}`' for agent in worlds.agents)} |")
        parts.append(f"| observations | {', '.join(f'`{kind}`' for kind in known['observations'])} |")
        parts.append(f"| actions | {', '.join(f'`{kind}`' for kind in known['actions'])} |")
        for actions in known["actions"]:
            step = make(name, 1, 1, {"actions": actions}).seconds_per_step
            parts.append(f"| a step with `{actions}` | {1000 * step:g} ms |")
        parts.append(f"| terminated | {known['end']} |")
        parts.append(f"| truncated | after {known['seconds']:g} s |\n")
        parts.append("| reward: the sum of | |\n| --- | --- |")
        parts.extend(f"| `{term}` | {what} |" for term, what in worlds.terms)
        for kind in known["observations"]:
            if kind == "image":
                continue
            components = make(name, 1, 1, {"observations": kind}).observation_components
            parts.append(f"\n| observed as `{kind}` | | |\n| --- | --- | --- |\n{_components(components)}")
        for kind in known["actions"]:
            components = make(name, 1, 1, {"actions": kind}).action_components
            parts.append(f"\n| {_KINDS[kind]} (`{kind}`) | | |\n| --- | --- | --- |\n{_components(components)}")
        parts.append("")
    return "\n".join(parts)


if __name__ == "__main__":
    print(page(), end="")
