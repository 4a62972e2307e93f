"""The examples run and print what they promise."""

from __future__ import annotations

import os
import re
import subprocess
import sys
from pathlib import Path
from xml.etree import ElementTree

EXAMPLES = Path(__file__).resolve().parents[1] / "examples"


def run(name: str, *arguments: str, folder: Path) -> str:
    done = subprocess.run(
        [sys.executable, EXAMPLES / name, *arguments],
        cwd=folder,
        env=os.environ,
        capture_output=True,
        text=True,
    )
    assert done.returncode == 0, done.stdout + done.stderr
    assert not done.stderr
    return done.stdout


def test_a_detector_sees_the_ball(tmp_path: Path) -> None:
    told = run("detector.py", "--seconds", "12", folder=tmp_path)
    found = re.search(r"red2: OrangeBlob +saw the ball +(\d+) times, wrong by (\d+) %", told)
    assert found and int(found[1]) > 8 and int(found[2]) < 25, told
    assert "red3: GT2003" in told


def test_a_locator_knows_where_the_ball_is(tmp_path: Path) -> None:
    told = run("locator.py", "--seconds", "8", folder=tmp_path)
    for name in ("KalmanLocator", "PIDSmoothed"):
        found = re.search(name + r" +(\d+) times: wrong by (\d+) mm", told)
        assert found and int(found[1]) > 10 and int(found[2]) < 400, told


def test_a_log_is_plotted(tmp_path: Path) -> None:
    told = run("plot_log.py", "--play", "15", "a.svg", folder=tmp_path)
    assert re.match(r"a.svg: 3\d\d poses, \d+ balls seen\n", told), told
    drawn = ElementTree.parse(tmp_path / "a.svg").getroot()
    names = [element.tag.rsplit("}")[-1] for element in drawn]
    assert names.count("polyline") == 2 and names.count("circle") > 3
