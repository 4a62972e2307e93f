"""The examples run and print what they promise."""

from __future__ import annotations

import os
import re
import subprocess
import sys
from pathlib import Path
from xml.etree import ElementTree

EXAMPLES = Path(__file__).resolve().parents[1] / "examples"
PAGE = Path(__file__).resolve().parents[2] / "docs/python.md"


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
    told = run("detector.py", "--seconds", "30", "--seed", "9", folder=tmp_path)
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


def test_a_policy_learns_to_approach_the_ball(tmp_path: Path) -> None:
    def learned(generations: str) -> float:
        told = run("train_approach.py", "--generations", generations, "--pairs", "8", "--unseen", "16", folder=tmp_path)
        assert told.count("generation ") == int(generations), told
        found = re.search(r"learned: return (-?\d\.\d\d) ", told)
        assert found, told
        return float(found[1])

    assert learned("8") > learned("0") + 0.5


def test_the_learned_policy_keeps_up_with_the_skill(tmp_path: Path) -> None:
    policy = str(EXAMPLES / "approach_policy.txt")
    told = run("train_approach.py", "--policy", policy, "--unseen", "16", folder=tmp_path)
    found = re.search(r"learned: .* done (\d+) of 16, .*\ngo_to_ball: .* done (\d+) of 16", told)
    assert found and int(found[1]) >= 14 and int(found[2]) >= 14, told


def test_the_learned_policy_plays_in_a_match(tmp_path: Path) -> None:
    told = run("play_approach.py", "--scene", "no-opponents", "--minutes", "1.5", folder=tmp_path)
    found = re.search(r"red3: LearnedStriker kicked (\d+) times", told)
    assert found and int(found[1]) >= 1, told
    assert "Final score" in told


def test_the_pages_lines_film_an_episode_and_plot_a_log(tmp_path: Path) -> None:
    blocks = re.findall(r"^```python\n(.*?)^```$", PAGE.read_text(), re.MULTILINE | re.DOTALL)
    film = next(block for block in blocks if "RecordVideo" in block)
    plot = next(block for block in blocks if "matplotlib" in block)
    play = "import gt2003\nmatch = gt2003.Match(seed=1, logs='out/match')\nmatch.run(2)\nmatch.close()\n"
    for lines in (film, play + plot):
        done = subprocess.run(
            [sys.executable, "-c", lines],
            cwd=tmp_path,
            env={**os.environ, "MPLBACKEND": "agg", "MPLCONFIGDIR": str(tmp_path)},
            capture_output=True,
            text=True,
        )
        assert done.returncode == 0, done.stdout + done.stderr
    assert (tmp_path / "out/videos/rl-video-episode-0.mp4").stat().st_size > 1000
    assert (tmp_path / "validity.png").read_bytes().startswith(b"\x89PNG")
