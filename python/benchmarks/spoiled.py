"""Spoils one parameter each of vision, roles, walk, kick and speed, and checks that `make figures` calls a figure of it worse.

spoiled.py --build build/release [--only vision]

The parameter is spoiled in a clone of what is committed, whose data the tree's programs read. Exit status 1 if no figure is called worse.
"""

from __future__ import annotations

import argparse
import os
import re
import subprocess
import sys
import tempfile
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]


@dataclass(frozen=True)
class Spoil:
    """What is done to a file, and the figures that suffer."""

    says: str
    file: str
    change: Callable[[bytes], bytes]
    only: str


def without(color: int) -> Callable[[bytes], bytes]:
    """A color table in which no color is of a class: runs of four bytes for their length, and one for the class."""

    def change(table: bytes) -> bytes:
        spoiled = bytearray(table)
        for i in range(4, len(table), 5):
            spoiled[i] = 0 if table[i] == color else table[i]
        return bytes(spoiled)

    return change


def put(line: bytes) -> Callable[[bytes], bytes]:
    """The line of this name has this text."""
    name = line[: line.rindex(b" ")]
    return lambda text: re.sub(rb"^" + re.escape(name) + rb" .*$", line, text, count=1, flags=re.MULTILINE)


def added(text: bytes) -> Callable[[bytes], bytes]:
    return lambda before: before + text


SPOILS = {
    "vision": Spoil("no color is orange", "config/coltable.c64", without(1), "vision.ball.found"),
    "roles": Spoil("gone 0", "config/modules/BehaviorControl.GT2003.cfg", added(b"[tactics.roles]\ngone 0\n"), "play.red.strikers"),
    "walk": Spoil("maxStepSizeX 15", "config/modules/WalkingEngine.InvKin.cfg", put(b"maxStepSizeX 15"), "motion.walk"),
    "kick": Spoil("lunge-frames = 100", "motions/kicks/pushStrong.mof", put(b"value lunge-frames = 100"), "motion.kick"),
    "speed": Spoil("SelfLocator GT2003", "config/modules.cfg", put(b"SelfLocator GT2003"), "speed.cost.kinematic"),
}


def spoil(root: Path, what: Spoil) -> None:
    """Spoil a file of a tree."""
    file = root / what.file
    file.write_bytes(what.change(file.read_bytes() if file.exists() else b""))


def worse(what: Spoil, build: Path) -> list[str]:
    """Return the figures that `make figures` calls worse; all that it says goes to stderr."""
    with tempfile.TemporaryDirectory() as folder:
        root = Path(folder, "tree")
        subprocess.run(["git", "clone", "--quiet", "--shared", str(ROOT), str(root)], check=True)
        spoil(root, what)
        measure = [sys.executable, "-B", str(root / "python/benchmarks/measure.py"), "--build", str(build.resolve()), "--only", what.only]
        environment = {**os.environ, "GT2003_ROOT": str(root), "PYTHONPATH": str(build.resolve() / "python")}
        done = subprocess.run(measure, cwd=root, env=environment, stdout=subprocess.PIPE, text=True, check=False)
    if done.returncode > 1:
        sys.exit(f"spoiled: {what.only} cannot be measured")
    print(done.stdout, file=sys.stderr, end="")
    figures = [line.split()[0] for line in done.stdout.splitlines() if line.endswith(" worse")]
    return figures


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--build", type=Path, default=Path("build/release"))
    parser.add_argument("--only", nargs="+", choices=SPOILS, default=list(SPOILS))
    given = parser.parse_args()
    found = {name: worse(SPOILS[name], given.build) for name in given.only}
    for name, figures in found.items():
        what = SPOILS[name]
        print(f"{name}: {what.file}: {what.says}: worse: {', '.join(figures) or 'no figure ' + what.only}")
    sys.exit(0 if all(found.values()) else 1)


if __name__ == "__main__":
    main()
