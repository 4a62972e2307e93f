"""Tournaments: teams play all against all; who is better, and how sure that is (docs/tournaments.md).

    jobs = gt2003.tournament.jobs(["GT2003", "kalman-study"], seeds="1..20")
    table = gt2003.tournament.standings(gt2003.tournament.games("out/results.jsonl"))
"""

from __future__ import annotations

import json
import os
from collections.abc import Iterable, Sequence
from dataclasses import asdict, dataclass
from html import escape
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from . import _core, _files, _json
from ._error import Error
from ._intervals import around, mean_interval, seeds_for, too_few
from ._page import Dot, dots, interval, page, table

__all__ = ["Game", "Standing", "elo", "games", "jobs", "merge", "standings", "write"]

Array = NDArray[np.float64]


@dataclass(frozen=True)
class Game:
    """A match that was played. Teams have the names of the jobs, with fingerprints."""

    seed: int
    red: str
    blue: str
    red_goals: int
    blue_goals: int


@dataclass(frozen=True)
class Standing:
    """What a team has reached. Intervals are of 95 %, over seeds; a single seed has none.

    points: 3 for a victory, 1 for a draw; difference: goals less those against it, in a match.
    """

    team: str
    won: int
    drawn: int
    lost: int
    goals: int
    against: int
    points: int
    difference: float
    difference_low: float | None
    difference_high: float | None
    elo: float
    elo_low: float | None
    elo_high: float | None


def jobs(teams: Iterable[str], seeds: str = "1..10", settings: Iterable[str] = ()) -> list[str]:
    """Return the jobs of a tournament: every two teams play on each seed, once in each color.

    teams: folders, names of the folder teams, GT2003 (the project's own files), or commit:REVISION,
    whose programs are built when they play; settings: NAME=VALUE of the experiment `match`. The same as `experiment tournament`.
    """
    return _core._list_tournament(list(teams), seeds, list(settings))


def games(file: str | os.PathLike[str]) -> list[Game]:
    """Return the matches whose results a file holds, in the order of their jobs. Half a line is passed over."""
    try:
        text = Path(file).read_text(encoding="utf-8-sig")
    except OSError as error:
        raise Error(error.strerror or "cannot be read", str(file)) from None
    played: dict[str, Game] = {}
    for line in text.splitlines():
        try:
            result = _json.parse(line)
        except Error:
            continue
        words = dict(word.split("=", 1) for word in result["job"].split()[1:])
        values = {v["name"].replace(".benign.", "."): v["value"] for v in result["values"]}
        if "red" not in words or "match.goals.red" not in values:
            raise Error("is no match", str(file), field=result["job"])
        goals = [int(values["match.goals.red"]), int(values["match.goals.blue"])]
        played[result["job"]] = Game(int(words["seed"]), words["red"], words["blue"], *goals)
    return [played[job] for job in sorted(played)]


def elo(scores: Array, counts: Array) -> Array:
    """Return ratings: the most likely ones of the model of Bradley and Terry (1952).

    scores: (..., teams, teams), victories of one team (row) over another, a draw counting as half;
    counts: matches of both. The mean is 1500; 400 more are 10 times the chance to win. The fit is the
    minorization of Hunter, MM algorithms for generalized Bradley-Terry models, Annals of Statistics
    32 (2004). Every two teams have drawn one match more than they have played: so ratings stay finite.
    """
    teams = scores.shape[-1]
    others = 1 - np.eye(teams)
    won = (scores + others / 2).sum(axis=-1)
    both = counts + others
    strength = np.ones(won.shape)
    for _ in range(10_000):
        chance = both / (strength[..., :, None] + strength[..., None, :])
        after = won / chance.sum(axis=-1)
        after /= np.exp(np.log(after).mean(axis=-1, keepdims=True))
        done = np.abs(after / strength - 1).max() < 1e-9
        strength = after
        if done:
            break
    rating: Array = 1500 + 400 * np.log10(strength)
    return rating


def _by_seed(played: Sequence[Game], teams: Sequence[str]) -> tuple[Array, Array, Array]:
    """Return scores, counts and goal differences: (seeds, teams, teams)."""
    seeds = sorted({game.seed for game in played})
    shape = (len(seeds), len(teams), len(teams))
    scores, counts, differences = np.zeros(shape), np.zeros(shape), np.zeros(shape)
    for game in played:
        s, a, b = seeds.index(game.seed), teams.index(game.red), teams.index(game.blue)
        ahead = game.red_goals - game.blue_goals
        score = (np.sign(ahead) + 1) / 2
        for i, j, value, goals in ((a, b, score, ahead), (b, a, 1 - score, -ahead)):
            scores[s, i, j] += value
            counts[s, i, j] += 1
            differences[s, i, j] += goals
    return scores, counts, differences


def _of_seeds(differences: Array, counts: Array, team: int) -> Array:
    """Return a team's mean goal difference on each seed."""
    matches = counts[:, team].sum(axis=1)
    goals: Array = differences[:, team].sum(axis=1)[matches > 0] / matches[matches > 0]
    return goals


def standings(played: Sequence[Game]) -> list[Standing]:
    """Return the teams, the one with the best rating first.

    The interval of the goal difference is Student's, of the seeds' means; that of Elo, too, of the
    jackknife's pseudo-values: how much the rating changes without one of the seeds.
    """
    if not played:
        raise Error("there are no matches", field="tournament")
    teams = sorted({name for game in played for name in (game.red, game.blue)})
    scores, counts, differences = _by_seed(played, teams)
    rating = elo(scores.sum(axis=0), counts.sum(axis=0))
    seeds = len(scores)
    without = elo(scores.sum(axis=0) - scores, counts.sum(axis=0) - counts)
    pseudo = seeds * rating - (seeds - 1) * without
    matches = counts.sum(axis=(0, 2))
    mean = differences.sum(axis=(0, 2)) / matches
    table = []
    for i, team in enumerate(teams):
        results = [(g.red_goals, g.blue_goals) for g in played if g.red == team]
        results += [(g.blue_goals, g.red_goals) for g in played if g.blue == team]
        won, lost = sum(a > b for a, b in results), sum(a < b for a, b in results)
        drawn = len(results) - won - lost
        goals, against = sum(a for a, _ in results), sum(b for _, b in results)
        low, high = mean_interval(list(_of_seeds(differences, counts, i))) or (None, None)
        table.append(
            Standing(
                team, won, drawn, lost, goals, against, 3 * won + drawn,
                float(mean[i]), low, high,
                float(rating[i]), *(around(float(rating[i]), pseudo[:, i]) or (None, None)),
            )
        )
    return sorted(table, key=lambda s: (-s.elo, s.team))


def _how_many_seeds(played: Sequence[Game], teams: Sequence[str]) -> str:
    """Return how many seeds it takes for narrow intervals of the goal difference, as far as these seeds show it."""
    _, counts, differences = _by_seed(played, teams)
    seeds = len(counts)
    if seeds < 2:
        return too_few(seeds)
    matches = len(played) / seeds
    deviation = max(float(_of_seeds(differences, counts, i).std(ddof=1)) for i in range(len(teams)))
    takes = [
        f"±{half:g} takes {wanted} seeds ({round(wanted * matches)} matches)"
        for half in (0.5, 0.25)
        if (wanted := seeds_for(deviation, half)) is not None
    ]
    spread = f"A team's goal difference in a match has a standard deviation of up to {deviation:.2f} over the seeds: "
    return f"{too_few(seeds)} {spread}{', '.join(takes)}.".strip() if takes else too_few(seeds)


def _bracket(low: float | None, high: float | None, mark: str) -> str:
    return "unknown" if low is None or high is None else f"{low:.0f} {mark} {high:.0f}"


def _short(team: str) -> str:
    words = team.partition("@")[0].split(":")
    if words[0] == "commit":
        words[1] = words[1][:12]
    return ":".join(words)


def _version(team: str) -> str:
    """Return what tells which files a team plays with."""
    if team.startswith("commit:"):
        return team.split(":")[1]
    return team.partition("@")[2] or "the project"


def _cross_table(played: Sequence[Game], teams: Sequence[str]) -> str:
    """Draw how each team played against each other one, the better the greener."""
    _, counts, differences = _by_seed(played, teams)
    mean = differences.sum(axis=0) / np.maximum(counts.sum(axis=0), 1)
    scale = max(1.0, float(np.abs(mean).max()))
    rows = ["<table><tr><th></th>" + "".join(f"<th>{escape(_short(t))}</th>" for t in teams) + "</tr>"]
    for i, team in enumerate(teams):
        cells = [f"<td>{escape(_short(team))}</td>"]
        for j, other in enumerate(teams):
            results = [g.red_goals - g.blue_goals for g in played if (g.red, g.blue) == (team, other)]
            results += [g.blue_goals - g.red_goals for g in played if (g.blue, g.red) == (team, other)]
            if not results:
                cells.append("<td></td>")
                continue
            color = "10,122,48" if mean[i, j] > 0 else "176,32,32"
            won, lost = sum(r > 0 for r in results), sum(r < 0 for r in results)
            cells.append(
                f'<td style="background:rgba({color},{abs(mean[i, j]) / scale / 2:.2f})">{mean[i, j]:+.2f}'
                f"<br><small>{won} – {len(results) - won - lost} – {lost}</small></td>"
            )
        rows.append("<tr>" + "".join(cells) + "</tr>")
    return "\n".join(rows) + "</table>"


def _page(played: Sequence[Game], ranked: Sequence[Standing], settings: str, note: str) -> str:
    teams = [s.team for s in ranked]
    seeds = len({game.seed for game in played})
    red = sum(g.red_goals for g in played) / len(played)
    blue = sum(g.blue_goals for g in played) / len(played)
    rows = [
        [f"{i}. {escape(_short(s.team))}", str(s.won + s.drawn + s.lost), str(s.won), str(s.drawn), str(s.lost),
         f"{s.goals} : {s.against}", f"{s.difference:+.2f}", interval(s.difference_low, s.difference_high),
         f"<b>{s.points}</b>", f"<b>{s.elo:.0f}</b>", _bracket(s.elo_low, s.elo_high, "…")]
        for i, s in enumerate(ranked, 1)
    ]
    head = ["team", "matches", "won", "drawn", "lost", "goals", "a match", "interval", "points", "Elo", "interval"]
    ratings = [Dot(_short(s.team), s.elo, s.elo_low, s.elo_high) for s in ranked]
    leads = [Dot(_short(s.team), s.difference, s.difference_low, s.difference_high) for s in ranked]
    files = [[escape(_short(t)), f"<code>{escape(_version(t))}</code>"] for t in teams]
    return page(
        "Tournament: " + ", ".join(_short(t) for t in teams),
        [
            f"<p>{len(teams)} teams, {len(played)} matches on {seeds} seeds, each pair in both colors on the same seeds: "
            f"<code>{escape(settings)}</code>. Red scored {red:.2f} goals in a match, blue {blue:.2f}.</p>",
            table(head, rows),
            "<p>Points: 3 for a victory, 1 for a draw. Intervals: 95 %, Student's t over seeds; of Elo by the jackknife. "
            f"{escape(_how_many_seeds(played, teams))}</p>",
            "<h2>Elo</h2>",
            dots(ratings, 1500, "Bradley-Terry, most likely ratings; 1500 is the mean, a lead of 100 wins 64 % of the matches"),
            "<h2>Goal difference in a match</h2>",
            dots(leads),
            "<h2>Against each other</h2><p>The row's goals less the column's, in a match; below: won – drawn – lost.</p>",
            _cross_table(played, teams),
            "<h2>Files</h2><p>Fingerprints of what the teams have of their own, or the commits of their programs.</p>",
            table(["team", "fingerprint"], files),
        ],
        note,
    )


def merge(results: Path, listed: Sequence[str], note: str = "") -> list[str]:
    """Write tournament.json and tournament.html beside a file of results, and print the standings.

    Returns a warning for each of the jobs that has no result.
    """
    with_results, _ = _core._read_results(str(results))
    missing = [f"{job}: has no result" for job in sorted(set(listed).difference(with_results))]
    if not with_results:
        return missing
    for place, s in enumerate(write(results, results.parent, note), 1):
        print(
            f"{place}. {_short(s.team):<30} {s.won} won, {s.drawn} drawn, {s.lost} lost, {s.goals}:{s.against} goals, "
            f"{s.points} points, Elo {s.elo:.0f} ({_bracket(s.elo_low, s.elo_high, 'to')})"
        )
    played = games(results)
    print(_how_many_seeds(played, sorted({name for game in played for name in (game.red, game.blue)})))
    return missing


def write(results: str | os.PathLike[str], out: Path, note: str = "") -> list[Standing]:
    """Write tournament.json and tournament.html of results into a folder. Returns the standings.

    note: a sentence for both, such as that the tournament was interrupted.
    """
    played = games(results)
    ranked = standings(played)
    told = {"note": note, "standings": [asdict(s) for s in ranked], "games": [asdict(g) for g in played]}
    _files.write(out / "tournament.json", json.dumps(told, indent=1) + "\n")
    _files.write(out / "tournament.html", _page(played, ranked, _settings(results), note))
    return ranked


def _settings(results: str | os.PathLike[str]) -> str:
    """Return what the jobs have in common: their words but teams and seed."""
    with open(results) as lines:
        for line in lines:
            try:
                words = _json.parse(line)["job"].split()
            except Error:
                continue
            return " ".join(w for w in words if w.partition("=")[0] not in ("red", "blue", "seed"))
    return ""
