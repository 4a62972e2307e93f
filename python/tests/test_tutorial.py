"""Tutorial 12 does what it says, and counts seeds as the page of a tournament does."""

from __future__ import annotations

import os
import re
import subprocess
import sys
from pathlib import Path

from gt2003._intervals import seeds_for

ROOT = Path(__file__).resolve().parents[2]
TUTORIAL = ROOT / "docs/tutorial/12-better-team.md"


def test_leads_from_a_team_to_the_tournaments_page(tmp_path: Path) -> None:
    environment = tmp_path / "python"
    (environment / "bin").mkdir(parents=True)
    program = environment / "bin/gt2003"
    program.write_text(f'#!/bin/sh\nexec {sys.executable} -m gt2003 "$@"\n')
    program.chmod(0o755)
    done = subprocess.run(
        [ROOT / "tests/tutorial/run-walk-through", TUTORIAL, os.environ["GT_BUILD"], environment],
        cwd=ROOT,
        capture_output=True,
        text=True,
    )
    assert done.returncode == 0, done.stdout + done.stderr
    for place, team in ((1, r"\S+"), (2, r"\S+")):
        assert re.search(rf"^{place}\. {team} +\d won, \d drawn, \d lost, ", done.stdout, re.MULTILINE), done.stdout
    assert "/behind " in done.stdout and "GT2003 " in done.stdout


def test_its_table_of_seeds_is_that_of_students_t() -> None:
    rows = re.findall(r"^\| ([\d.]+) goals? \| (\d+) \| (\d+) \|$", TUTORIAL.read_text(), re.MULTILINE)
    assert len(rows) == 4
    for half, seeds, matches in rows:
        assert (int(seeds), int(matches)) == (seeds_for(0.8, float(half)), 2 * int(seeds))
