"""What a team learns from matches: worths against a closed form, places, the file, and mistakes."""

from __future__ import annotations

import json
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

import gt2003
from gt2003 import values
from gt2003.values import CORNER, Play


def drifting(chance: np.random.Generator, ahead: float, count: int) -> list[Play]:
    """Balls that the team nearer to them moves ahead by a normal distribution until they are in a goal."""
    plays = []
    for _ in range(count):
        x, balls, leads = chance.uniform(-2000, 2000), [], []
        while abs(x) < CORNER[0]:
            lead = chance.choice([-1000, 1000])
            balls.append([x, chance.uniform(-1300, 1300)])
            leads.append(lead)
            x += np.sign(lead) * ahead + chance.normal(0, 200)
        plays.append(Play(np.array(balls), np.array(leads, float), float(np.sign(x))))
    return plays


def test_worths_are_the_discounted_goals_to_come() -> None:
    chance = np.random.default_rng(1)
    ours, theirs = values.worths(values.of_both_teams(drifting(chance, 300, 400)))
    # The same by brute force: many balls from one place.
    for column, side, lead in ((7, ours, 1000), (11, ours, 1000), (4, theirs, -1000)):
        begin = values.grid()[column, 2, 0]
        total = 0.0
        for _ in range(4000):
            x, seconds, next_lead = begin, 0, lead
            while abs(x) < CORNER[0]:
                x += np.sign(next_lead) * 300 + chance.normal(0, 200)
                next_lead = chance.choice([-1000, 1000])
                seconds += 1
            total += np.sign(x) * values.DISCOUNT ** (seconds - 1)
        assert side[column].mean() == pytest.approx(total / 4000, abs=0.08)
    assert np.all(ours.mean(axis=1)[1:-1] > theirs.mean(axis=1)[1:-1])


def test_both_teams_see_the_same_worth() -> None:
    ours, theirs = values.worths(values.of_both_teams(drifting(np.random.default_rng(2), 200, 100)))
    np.testing.assert_allclose(ours, -theirs[::-1], atol=1e-6)


def test_supporters_stand_where_balls_come() -> None:
    # All balls go from the middle to one of two places.
    ends = [[1000.0, 600.0], [-400.0, -800.0]]
    plays = [
        Play(np.array([[0.0, 10.0]] * values.AHEAD + [end]), np.zeros(values.AHEAD + 1), 0.0) for end in ends * 10
    ]
    ours = np.ones((values.COLUMNS, values.ROWS))
    ahead, behind = values.places(plays, ours, -ours)
    middle = (values.COLUMNS // 2, 0)
    assert np.linalg.norm(ahead[middle] - ends[0]) < 200 and np.linalg.norm(behind[middle] - ends[1]) < 200


def summary(folder: Path) -> Path:
    ball = [{"x": 100 * second, "y": 50} for second in range(22)]
    robots = [
        {"team": team, "samples": [{"pose": {"translation": {"x": x, "y": 0}}}] * 22} for team, x in (("red", 0), ("blue", 2000))
    ]
    score = {"redScore": 0, "blueScore": 0}
    events = [{"kind": "kickOff", "time": 0, **score}, {"kind": "goal", "time": 21000, **score, "redScore": 1}]
    file = folder / "match.json"
    file.write_text(json.dumps({"ball": ball, "robots": robots, "events": events}))
    return file


def test_reads_the_summary_of_a_match(tmp_path: Path) -> None:
    (play,) = values.plays_of(json.loads(summary(tmp_path).read_text()))
    assert play.goal == 1 and play.ball.shape == (21, 2)
    assert play.lead[0] == pytest.approx(1950, abs=1) and play.lead[10] == 0 and play.lead[20] < -1900


def test_a_robot_plays_with_what_was_learned(tmp_path: Path) -> None:
    command = [sys.executable, "-m", "gt2003", "values", summary(tmp_path), "--out", tmp_path / "team/config/values.cfg"]
    subprocess.run(command, check=True)
    gt2003.Match(red=str(tmp_path / "team"), minutes=0.02)
    file = tmp_path / "team/config/values.cfg"
    file.write_text(file.read_text().replace("rows 5", "rows 6"))
    with pytest.raises(gt2003.Error, match="ours: has 75 elements; the grid has 90"):
        gt2003.Match(red=str(tmp_path / "team"), minutes=0.02)


def test_what_is_no_match_is_one_line(tmp_path: Path) -> None:
    (tmp_path / "match.json").write_text("{}")
    command = [sys.executable, "-m", "gt2003", "values", tmp_path / "match.json", "--out", tmp_path / "values.cfg"]
    failed = subprocess.run(command, capture_output=True, text=True)
    assert failed.returncode == 2
    assert failed.stderr == f"gt2003: {tmp_path}/match.json: is no summary of a match: 'ball'\n"


def test_a_summary_that_is_nested_too_deeply_is_an_error(tmp_path: Path) -> None:
    (tmp_path / "match.json").write_text(100_000 * '["]",' + "1" + 100_000 * "]")
    command = [sys.executable, "-m", "gt2003", "values", tmp_path / "match.json", "--out", tmp_path / "values.cfg"]
    failed = subprocess.run(command, capture_output=True, text=True)
    assert failed.returncode == 2
    place = f"gt2003: {tmp_path}/match.json: is no summary of a match"
    assert failed.stderr == f"{place}: is nested too deeply, at most 100 levels\n"
