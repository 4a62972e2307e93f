"""Measures how long it takes to build the tree: the figures speed.build.*.

build.py [--json out/build.json]

A clone of what is committed is built by all processors, once with an empty compiler cache (bare), then another one that this cache
serves (second). Figures are the clock's, in seconds: of an idle machine.
"""

from __future__ import annotations

import argparse
import os
import subprocess
import sys
import tempfile
import time
from pathlib import Path

from figures import add, figure

ROOT = Path(__file__).resolve().parents[2]


def built(tree: Path, cache: Path) -> float:
    """Clone and build a tree; return for how long it was built."""
    subprocess.run(["git", "clone", "--quiet", "--shared", str(ROOT), str(tree)], check=True)
    environment = {**os.environ, "CCACHE_DIR": str(cache), "CCACHE_BASEDIR": str(tree), "CCACHE_NOHASHDIR": "true"}
    begin = time.perf_counter()
    for command in (["cmake", "--preset", "release"], ["cmake", "--build", "build/release", "--parallel", str(os.cpu_count())]):
        done = subprocess.run(command, cwd=tree, env=environment, capture_output=True, text=True, check=False)
        if done.returncode:
            sys.exit(f"build: {' '.join(command)} failed: {(done.stderr or done.stdout).strip().splitlines()[-1]}")
    return time.perf_counter() - begin


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--json", type=Path, default=Path("out/build.json"))
    given = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        add([figure(f"speed.build.{name}", "s", [built(Path(folder, name), Path(folder, "cache"))]) for name in ("bare", "second")], given.json)


if __name__ == "__main__":
    main()
