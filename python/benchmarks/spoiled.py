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
from dataclasses import dataclass
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]


@dataclass(frozen=True)
class Spoil:
    """A parameter's line that is put in place of what fits `old`, or at the end of a file of its own, and figures that suffer."""

    file: str
    line: str
    only: str
    old: str = ""


SPOILS = {
    "vision": Spoil("config/modules/ImageProcessor.GT2003.cfg", "denseSpacing 12", "vision.ball.found"),
    "roles": Spoil("config/modules/BehaviorControl.GT2003.cfg", "[tactics.roles]\ngone 100", "play.red.strikers"),
    "walk": Spoil("config/modules/WalkingEngine.InvKin.cfg", "maxStepSizeX 15", "motion.walk", old=r"maxStepSizeX 19\.7"),
    "kick": Spoil("motions/kicks/pushStrong.mof", "value strike-frames = 40", "motion.kick", old=r"value strike-frames = \d+"),
    "speed": Spoil("config/modules/SelfLocator.GT2003.cfg", "particles 2000", "speed.cost.kinematic"),
}


def spoil(root: Path, what: Spoil) -> None:
    """Spoil a parameter in a tree."""
    file = root / what.file
    text = file.read_text() if file.exists() else ""
    spoiled, times = re.subn(what.old, what.line, text, count=1) if what.old else (f"{text}{what.line}\n", 1)
    if not times:
        sys.exit(f"{what.file}: has no line {what.old}")
    file.write_text(spoiled)


def worse(what: Spoil, build: Path) -> list[str]:
    """Return the figures that `make figures` calls worse; all that it says goes to stderr."""
    with tempfile.TemporaryDirectory() as folder:
        root = Path(folder, "tree")
        subprocess.run(["git", "clone", "--quiet", "--shared", str(ROOT), str(root)], check=True)
        spoil(root, what)
        measure = [sys.executable, "-B", str(root / "python/benchmarks/measure.py"), "--build", str(build.resolve()), "--only", what.only]
        done = subprocess.run(measure, cwd=root, env={**os.environ, "GT2003_ROOT": str(root)}, stdout=subprocess.PIPE, text=True, check=False)
    print(done.stdout, file=sys.stderr, end="")
    figures = [line.split()[0] for line in done.stdout.splitlines() if line.endswith(" worse")]
    return figures if done.returncode == 1 else []


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--build", type=Path, default=Path("build/release"))
    parser.add_argument("--only", nargs="+", choices=SPOILS, default=list(SPOILS))
    given = parser.parse_args()
    found = {name: worse(SPOILS[name], given.build) for name in given.only}
    for name, figures in found.items():
        what = SPOILS[name]
        print(f"{name}: {what.file}: {what.line.splitlines()[-1]}: " + (", ".join(figures) or f"no figure {what.only} is worse"))
    sys.exit(0 if all(found.values()) else 1)


if __name__ == "__main__":
    main()
