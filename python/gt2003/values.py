"""What a ball is worth, and where supporters help most, learned from matches: `config/values.cfg` of a team.

The worth of a ball is the discounted sum of goals to come: 1 for an own one, -1 for one of the opponents. It is linear in
the weights of the points of a grid around the ball, once for a ball that the own team is nearer to, once for the opponents',
and follows from what happened in the matches by LSTD(lambda) (Bradtke and Barto 1996, Boyan 2002), regularized towards the
rule by which a team without values plays. Each match counts four times: for both teams, and mirrored.

A supporter helps where the ball comes next: the balls that lay at a place come to others some seconds later, and there it is
worth more by some amount to be nearer than the opponents. The places of the two supporters cover as much of that worth as
possible beside what striker and goalie cover; the second place is chosen after the first (maximal coverage, by the greedy
rule).
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from . import _files, _json
from ._error import Error

Array = NDArray[np.float64]

CORNER = np.array([2100.0, 1350.0])  # mm: at the left of the opponent's goal
GOAL = 300.0  # mm: half its width
GOALIE = np.array([-1980.0, 0.0])
COLUMNS, ROWS = 15, 5
NEARER = 200.0  # mm: see PlayValues
DISCOUNT = 0.98  # of a second
TRACE = 0.9  # lambda
SMOOTH = 20.0  # samples: how strongly what is learned is alike at neighbors on the grid
BELIEF = 2.0  # samples at each point that say what the rule says
AHEAD = 4  # s after which a ball is looked for
NEAR = 350.0  # mm: balls that count for a place of the ball
REACH = 500.0  # mm: how far a robot gets until a ball is elsewhere
APART = 500.0  # mm: from the ball, and from each other


@dataclass
class Play:
    """The ball once a second, as one team sees it, until a goal or until somebody moved it by hand."""

    ball: Array  # (n, 2) mm
    lead: Array  # (n,) mm by which the own team is nearer
    goal: float  # 1, -1, or 0 if there was none


def _points(vectors: Iterable[dict[str, float]]) -> Array:
    return np.array([(vector["x"], vector["y"]) for vector in vectors], dtype=float).reshape(-1, 2)


def plays_of(summary: dict) -> list[Play]:
    """The plays of a match (`match.json`), as red sees them."""
    ball = _points(summary["ball"])
    if len(ball) == 0:
        return []
    nearest = {}
    for team in ("red", "blue"):
        robots = [robot["samples"] for robot in summary["robots"] if robot["team"] == team]
        poses = np.array([_points(sample["pose"]["translation"] for sample in samples[: len(ball)]) for samples in robots])
        nearest[team] = np.linalg.norm(poses - ball[: poses.shape[1]], axis=2).min(axis=0)
    lead = nearest["blue"] - nearest["red"]
    plays: list[Play] = []
    begin, before = None, 0
    for event in summary["events"]:
        second = event["time"] // 1000
        if event["kind"] in ("goal", "halfTime", "stuckBall", "ballOut", "gameOver") and begin is not None:
            score = event["redScore"] - event["blueScore"]
            goal = np.sign(score - before) if event["kind"] == "goal" else 0
            if second > begin + 1:
                plays.append(Play(ball[begin:second], lead[begin:second], float(goal)))
            begin = second + 1 if event["kind"] in ("stuckBall", "ballOut") else None
        elif event["kind"] == "kickOff":
            begin = second
        before = event["redScore"] - event["blueScore"]
    return plays


def of_both_teams(plays: Iterable[Play]) -> list[Play]:
    """The same plays as red and as blue sees them."""
    return [seen for play in plays for seen in (play, Play(-play.ball, -play.lead, -play.goal))]


def features(ball: Array, lead: Array) -> Array:
    """(n, 2 * COLUMNS * ROWS): the weights of the points around each ball, for the team that has it."""
    column = np.clip((ball[:, 0] / CORNER[0] + 1) / 2, 0, 1) * (COLUMNS - 1)
    row = np.clip(np.abs(ball[:, 1]) / CORNER[1], 0, 1) * (ROWS - 1)
    across = np.maximum(0, 1 - np.abs(column[:, None] - np.arange(COLUMNS)))
    along = np.maximum(0, 1 - np.abs(row[:, None] - np.arange(ROWS)))
    points = (across[:, :, None] * along[:, None, :]).reshape(len(ball), -1)
    ours = 1 / (1 + np.exp(-np.clip(lead / NEARER, -30, 30)))[:, None]
    return np.hstack([points * ours, points * (1 - ours)])


def _unevenness() -> Array:
    """The quadratic form of the differences between neighbors on the grid."""
    size = COLUMNS * ROWS
    form = np.zeros((2 * size, 2 * size))
    for side in (0, size):
        for i in range(COLUMNS):
            for j in range(ROWS):
                for di, dj in ((1, 0), (0, 1)):
                    if i + di < COLUMNS and j + dj < ROWS:
                        a, b = side + i * ROWS + j, side + (i + di) * ROWS + j + dj
                        form[a, a] += 1
                        form[b, b] += 1
                        form[a, b] -= 1
                        form[b, a] -= 1
    return form


def rule() -> Array:
    """The worth at each point by the rule of `KickChoice` for both sides: the goals' angles, how far ahead, who has the ball."""

    def angle(x: float) -> Array:
        left, right = np.array([x, GOAL]) - grid(), np.array([x, -GOAL]) - grid()
        across = left[..., 0] * right[..., 1] - left[..., 1] * right[..., 0]
        return np.asarray(np.minimum(1, np.abs(np.arctan2(across, (left * right).sum(axis=-1)))))

    both = 0.1 * grid()[..., 0] / CORNER[0] + 0.5 * (angle(CORNER[0]) - angle(-CORNER[0]))
    return np.concatenate([both.reshape(-1) + 0.15, both.reshape(-1) - 0.15])


def worths(plays: Iterable[Play]) -> tuple[Array, Array]:
    """The worth of a ball at each point of the grid, (COLUMNS, ROWS): the own team's and the opponents'."""
    size = 2 * COLUMNS * ROWS
    matrix = SMOOTH * _unevenness() + BELIEF * np.eye(size)
    target = matrix @ rule()
    for play in plays:
        seen = features(play.ball, play.lead)
        after = np.vstack([seen[1:], np.zeros(size)])
        traces = np.empty_like(seen)
        trace = np.zeros(size)
        for i, now in enumerate(seen):
            traces[i] = trace = DISCOUNT * TRACE * trace + now
        last = len(seen) if play.goal else len(seen) - 1  # what somebody moved by hand says nothing
        matrix += traces[:last].T @ (seen - DISCOUNT * after)[:last]
        target += play.goal * traces[-1]
    ours, theirs = np.linalg.solve(matrix, target).reshape(2, COLUMNS, ROWS)
    return ours, theirs


def grid() -> Array:
    """The points of the grid, (COLUMNS, ROWS, 2)."""
    x = np.linspace(-CORNER[0], CORNER[0], COLUMNS)
    y = np.linspace(0, CORNER[1], ROWS)
    return np.stack(np.meshgrid(x, y, indexing="ij"), axis=2)


def _smoothed(values: Array) -> Array:
    """Each point of the grid as the mean of itself and its neighbors."""
    padded = np.pad(values, ((1, 1), (1, 1), (0, 0)), mode="edge")
    weights = {(0, 0): 4, (0, 1): 2, (1, 0): 2, (0, -1): 2, (-1, 0): 2, (1, 1): 1, (1, -1): 1, (-1, 1): 1, (-1, -1): 1}
    total = sum(
        w * padded[1 + i : 1 + i + values.shape[0], 1 + j : 1 + j + values.shape[1]] for (i, j), w in weights.items()
    )
    return np.asarray(total / sum(weights.values()))


def places(plays: Iterable[Play], ours: Array, theirs: Array) -> tuple[Array, Array]:
    """Where the supporters help while the ball lies at each point of the grid, (COLUMNS, ROWS, 2): ahead and behind."""
    now, after = [], []
    for play in plays:
        if len(play.ball) > AHEAD:
            now.append(play.ball[:-AHEAD])
            after.append(play.ball[AHEAD:])
    balls, ends = np.vstack(now), np.vstack(after)
    side = np.where(balls[:, 1] < 0, -1.0, 1.0)  # mirrored to the left half
    balls, ends = balls * np.stack([np.ones_like(side), side], 1), ends * np.stack([np.ones_like(side), side], 1)
    points = features(ends, np.zeros(len(ends)))[:, : COLUMNS * ROWS] * 2  # both teams have it by half
    gain = np.maximum(0, points @ (ours - theirs).reshape(-1))
    x, y = np.linspace(-1800, 1800, 19), np.linspace(-1100, 1100, 12)
    all_places = np.stack(np.meshgrid(x, y, indexing="ij"), axis=2).reshape(-1, 2)
    in_area = (all_places[:, 0] < -1450) & (np.abs(all_places[:, 1]) < 700)
    all_places = all_places[~in_area]

    def reached(place: Array) -> Array:
        return np.asarray(np.exp(-np.square(np.linalg.norm(ends[:, None] - place[None], axis=2) / REACH)))

    of_places, of_goalie = reached(all_places), reached(GOALIE[None])[:, 0]
    ahead, behind = np.zeros((2, COLUMNS, ROWS, 2))
    for index in np.ndindex(COLUMNS, ROWS):
        ball = grid()[index]
        weight = gain * np.exp(-np.square(np.linalg.norm(balls - ball, axis=1) / NEAR) / 2)
        covered = np.maximum(reached(ball[None])[:, 0], of_goalie)
        allowed = np.linalg.norm(all_places - ball, axis=1) > APART
        chosen = []
        for _ in range(2):
            more = weight @ np.maximum(0, of_places - covered[:, None])
            best = int(np.argmax(np.where(allowed, more, -1)))
            chosen.append(all_places[best])
            covered = np.maximum(covered, of_places[:, best])
            allowed &= np.linalg.norm(all_places - all_places[best], axis=1) > APART
        behind[index], ahead[index] = sorted(chosen, key=lambda place: place[0])
    return _smoothed(ahead), _smoothed(behind)


def text_of(plays: list[Play]) -> str:
    """The file `values.cfg`."""
    ours, theirs = worths(plays)
    ahead, behind = places(plays, ours, theirs)
    goals = sum(play.goal > 0 for play in plays)
    seconds = sum(len(play.ball) for play in plays) // 2
    lines = [
        f"// Learned from {seconds} s of play with {goals} goals by `gt2003 values` (docs/playing.md).",
        f"columns {COLUMNS}",
        f"rows {ROWS}",
        f"nearer {NEARER:g}",
    ]
    for name, values in (("ours", ours), ("theirs", theirs)):
        lines += [f"{name}.{i} {value:.4f}" for i, value in enumerate(values.reshape(-1))]
    for name, place in (("ahead", ahead), ("behind", behind)):
        lines += [f"{name}.{i} {x:.0f} {y:.0f}" for i, (x, y) in enumerate(place.reshape(-1, 2))]
    return "\n".join(lines) + "\n"


def learn(summaries: Iterable[Path], out: Path) -> None:
    """Learn from the files `match.json` of matches, and write `values.cfg`."""
    plays: list[Play] = []
    for file in summaries:
        try:
            plays += plays_of(_json.parse(file.read_text()))
        except (Error, OSError, ValueError, KeyError, TypeError) as error:
            raise Error(f"is no summary of a match: {error}", file=str(file)) from None
    if not any(play.goal for play in plays):
        raise Error("nobody scored in these matches", file=str(out))
    out.parent.mkdir(parents=True, exist_ok=True)
    _files.write(out, text_of(of_both_teams(plays)))
