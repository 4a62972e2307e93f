"""Tournaments: jobs, standings, Elo, a run from start to end, and mistakes."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

import gt2003
from gt2003 import _intervals, tournament
from gt2003.tournament import Game

BUILD = Path(os.environ["GT_BUILD"])


def command(*arguments: str | Path) -> subprocess.CompletedProcess[str]:
    line = [sys.executable, "-m", "gt2003", "run", "tournament", *map(str, arguments)]
    return subprocess.run(line, capture_output=True, text=True)


def test_a_match_of_two_teams() -> None:
    match = gt2003.Match(red="kalman-study", minutes=0.02)
    tilt = {name: robot.get("SelfLocator.tiltError") for name, robot in match.robots.items()}
    assert all(value == (0.0755 if name.startswith("red") else 0.012) for name, value in tilt.items())
    with pytest.raises(gt2003.Error, match="nowhere: is no team"):
        gt2003.Match(blue="nowhere")


def test_lines_that_are_no_results_are_passed_over(tmp_path: Path) -> None:
    (tmp_path / "results.jsonl").write_text('{"job": "tourn\n' + 100_000 * '["]",' + "1" + 100_000 * "]" + "\n")
    assert tournament.games(tmp_path / "results.jsonl") == []


def test_what_is_wrong_in_a_team_is_told_with_its_file(tmp_path: Path) -> None:
    (tmp_path / "config/modules").mkdir(parents=True)
    (tmp_path / "config/modules/SelfLocator.Kalman.cfg").write_text("slip 0.4\nslop 1\n")
    with pytest.raises(gt2003.Error) as raised:
        gt2003.Match(blue=str(tmp_path))
    assert raised.value.file == str(tmp_path / "config/modules/SelfLocator.Kalman.cfg")
    assert (raised.value.line, raised.value.field) == (2, "slop")


def test_jobs_are_those_of_the_program() -> None:
    program = [BUILD / "bin/experiment", "tournament", "GT2003", "kalman-study", "--seeds", "3..4"]
    told = subprocess.run(program, check=True, capture_output=True, text=True)
    listed = tournament.jobs(["GT2003", "kalman-study"], "3..4")
    assert listed == told.stdout.splitlines() and len(listed) == 4


def random_games(strengths: dict[str, float], seeds: int) -> list[Game]:
    chance = np.random.default_rng(5)
    games = []
    for seed in range(seeds):
        for red in strengths:
            for blue in strengths:
                if red != blue:
                    wins = chance.random() < strengths[red] / (strengths[red] + strengths[blue])
                    games.append(Game(seed, red, blue, int(wins), int(not wins)))
    return games


def test_ratings_are_those_that_the_games_were_drawn_from() -> None:
    strengths = {"weak": 1.0, "middle": 10**0.5, "strong": 10.0}  # 200 apart
    ranked = tournament.standings(random_games(strengths, 300))
    assert [s.team for s in ranked] == ["strong", "middle", "weak"]
    for standing, true in zip(ranked, (1700, 1500, 1300), strict=True):
        assert standing.elo_low is not None and standing.elo_high is not None
        assert standing.elo_low < true < standing.elo_high
        assert standing.elo_high - standing.elo_low < 60
    assert sum(s.elo for s in ranked) == pytest.approx(4500)
    assert sum(s.difference for s in ranked) == pytest.approx(0)


def test_ratings_fulfil_the_equations_of_the_most_likely_ones() -> None:
    counts = np.array([[0, 10, 4], [10, 0, 6], [4, 6, 0]], dtype=float)
    scores = np.array([[0, 7.5, 3], [2.5, 0, 4.5], [1, 1.5, 0]])
    rating = tournament.elo(scores, counts)
    expected = 1 / (1 + 10 ** ((rating[None, :] - rating[:, None]) / 400))
    others = 1 - np.eye(3)
    left = (scores + others / 2).sum(axis=1)
    assert left == pytest.approx(((counts + others) * expected).sum(axis=1), rel=1e-6)


def test_standings_count_goals_and_points() -> None:
    games = [Game(1, "a", "b", 3, 1), Game(1, "b", "a", 0, 0), Game(2, "a", "b", 1, 2), Game(2, "b", "a", 1, 4)]
    a, b = tournament.standings(games)
    assert (a.team, a.won, a.drawn, a.lost, a.goals, a.against, a.points) == ("a", 2, 1, 1, 8, 4, 7)
    assert (b.won, b.drawn, b.lost, b.points) == (1, 1, 2, 4)
    assert a.difference == 1 == -b.difference
    assert a.difference_low == 1 == a.difference_high  # on both seeds
    assert a.elo > b.elo and a.elo - 1500 == pytest.approx(1500 - b.elo)
    never_lost = tournament.standings([Game(1, "a", "b", 5, 0)])
    assert np.isfinite(never_lost[0].elo)
    assert never_lost[0].difference_low is None and never_lost[0].elo_low is None  # one seed tells nothing of others


def test_few_seeds_have_wide_intervals(tmp_path: Path) -> None:
    """Differences of 0.5, 0.5 and 1: the bootstrap would have said 0.5 to 1, and better for sure."""
    goals = {1: (1, 0, 0, 0), 2: (1, 0, 0, 0), 3: (1, 0, 0, 1)}
    games = [game for seed, (a, b, c, d) in goals.items() for game in (Game(seed, "a", "b", a, b), Game(seed, "b", "a", c, d))]
    better, worse = tournament.standings(games)
    assert better.difference == pytest.approx(2 / 3)
    assert (better.difference_low, better.difference_high) == pytest.approx((2 / 3 - 0.717, 2 / 3 + 0.717), abs=1e-3)
    assert better.elo_low is not None and better.elo_low < 1500 < better.elo
    assert worse.elo_high is not None and worse.elo_high > 1500
    lines = [
        {"job": f"match blue={g.blue} red={g.red} seed={g.seed}", "values": [
            {"name": "match.goals.red", "value": g.red_goals}, {"name": "match.goals.blue", "value": g.blue_goals}]}
        for g in games
    ]
    (tmp_path / "results.jsonl").write_text("".join(json.dumps(line) + "\n" for line in lines))
    tournament.write(tmp_path / "results.jsonl", tmp_path)
    page = (tmp_path / "tournament.html").read_text()
    assert "Too few seeds to tell: 3, where 10 are the least." in page
    assert "standard deviation of up to 0.29 over the seeds: ±0.5 takes 4 seeds (8 matches), ±0.25 takes 8 seeds (16 matches)." in page


@pytest.mark.parametrize(("degrees", "quantile"), [(1, 12.706), (2, 4.303), (3, 3.182), (9, 2.262), (30, 2.042), (5000, 1.9604)])
def test_quantiles_are_those_of_the_table(degrees: int, quantile: float) -> None:
    assert _intervals.student(degrees) == pytest.approx(quantile, abs=1e-3)


def test_intervals_hold_the_true_mean_in_95_of_100_cases() -> None:
    chance = np.random.default_rng(7)
    for count in (3, 9):
        found = (_intervals.mean_interval(chance.normal(1, 2, count)) for _ in range(4000))
        held = np.mean([pair is not None and pair[0] <= 1 <= pair[1] for pair in found])
        assert 0.94 < held < 0.96


def test_how_many_seeds_it_takes() -> None:
    for deviation, half in ((0.83, 0.5), (0.83, 0.25), (2, 0.1)):
        wanted = _intervals.seeds_for(deviation, half)
        assert wanted is not None
        for seeds, narrow in ((wanted, True), (wanted - 1, False)):
            assert (_intervals.student(seeds - 1) * deviation / seeds**0.5 <= half) == narrow
    assert _intervals.seeds_for(1, 0) is None and _intervals.seeds_for(1e6, 0.1) is None


def test_the_page_names_commits(tmp_path: Path) -> None:
    commit = "0123456789abcdef0123456789abcdef01234567"
    goals = [{"name": "match.goals.red", "value": 1}, {"name": "match.goals.blue", "value": 0}]
    job = f"match blue=GT2003 minutes=1 red=commit:{commit}:kalman seed=1"
    (tmp_path / "results.jsonl").write_text(json.dumps({"job": job, "values": goals}) + "\n")
    tournament.write(tmp_path / "results.jsonl", tmp_path)
    page = (tmp_path / "tournament.html").read_text()
    assert "1. commit:0123456789ab:kalman<" in page and page.count(commit) == 1


def test_a_tournament_goes_on_after_a_stop(tmp_path: Path) -> None:
    team = tmp_path / "lazy"
    (team / "config").mkdir(parents=True)
    (team / "config/modules.cfg").write_text("WalkingEngine disabled\nSpecialActions disabled\n")
    arguments = ["GT2003", team, "--seeds", "1..2", "--set", "minutes=0.02"]
    told = command(*arguments, "--out", tmp_path / "a")
    assert told.returncode == 0, told.stderr
    assert "1. " in told.stdout and "4/4 jobs" in told.stderr
    page = (tmp_path / "a/tournament.html").read_text()
    assert "lazy" in page and "<svg" in page and "minutes=0.02" in page
    data = json.loads((tmp_path / "a/tournament.json").read_text())
    assert len(data["games"]) == 4 and {s["won"] + s["drawn"] + s["lost"] for s in data["standings"]} == {4}

    lines = (tmp_path / "a/results.jsonl").read_text().splitlines(keepends=True)
    (tmp_path / "b").mkdir()
    (tmp_path / "b/results.jsonl").write_text(lines[2] + lines[0] + lines[1][:60])
    told = command(*arguments, "--out", tmp_path / "b")
    assert told.returncode == 0, told.stderr
    assert "2 of 4 jobs are done" in told.stderr and "is not a whole result" in told.stderr
    for name in ("tournament.json", "tournament.html"):
        assert (tmp_path / "a" / name).read_bytes() == (tmp_path / "b" / name).read_bytes()

    # The team has changed: its results are those of other jobs.
    (team / "config/modules.cfg").write_text("WalkingEngine disabled\n")
    told = command(*arguments, "--out", tmp_path / "a")
    assert told.returncode == 2 and "holds results of other jobs" in told.stderr


@pytest.mark.parametrize(
    ("arguments", "what"),
    [
        (["GT2003"], "tournament: expected two teams or more"),
        (["GT2003", "nowhere"], "nowhere: is no team: there is no such folder"),
        (["GT2003", "src"], "src: is no team: expected folders behavior, config, motions; not '"),
        (["GT2003", "teams/kalman-study", "kalman-study"], "kalman-study: is given twice"),
        (["GT2003", "kalman-study", "--set", "minuets=1"], "minuets: is a parameter of none"),
        (["GT2003", "kalman-study", "--only", "match"], "--only: is of experiments"),
    ],
)
def test_a_mistake_is_told_in_one_line(arguments: list[str], what: str, tmp_path: Path) -> None:
    told = command(*arguments, "--out", tmp_path / "out")
    assert told.returncode == 2 and told.stdout == ""
    assert len(told.stderr.splitlines()) == 1 and what in told.stderr, told.stderr
    assert not (tmp_path / "out").exists()


def test_results_of_something_else_are_refused(tmp_path: Path) -> None:
    file = tmp_path / "results.jsonl"
    file.write_text('{"job": "fidelity walk=forward100 seed=1", "values": []}\n')
    with pytest.raises(gt2003.Error, match="is no match"):
        tournament.games(file)
    with pytest.raises(gt2003.Error, match="No such file"):
        tournament.games(tmp_path / "nowhere")
    with pytest.raises(gt2003.Error, match="there are no matches"):
        tournament.standings([])
