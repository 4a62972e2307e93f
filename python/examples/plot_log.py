"""Plots a robot's log as SVG: its path on the field, and how far away the ball was over time.

python plot_log.py LOG.mcap [OUT.svg]
python plot_log.py --play SECONDS [OUT.svg]      plays a match for so long, and plots red2's log
"""

from __future__ import annotations

import argparse
import tempfile
from pathlib import Path

import numpy as np

import gt2003

WIDTH, HEIGHT, PLOT = 420.0, 270.0, 120.0  # of the field's drawing and of the curve's: px
LENGTH = 4200.0  # of the field with the goals: mm


def path_of(x: np.ndarray, y: np.ndarray, color: str) -> str:
    points = " ".join(f"{a:.1f},{b:.1f}" for a, b in zip(x, y, strict=True))
    return f'<polyline points="{points}" fill="none" stroke="{color}"/>'


def field_of(log: gt2003.Log) -> list[str]:
    """The robot's path, as it believes it, on the field; a dot for each ball that it saw."""
    scale = WIDTH / LENGTH
    poses = log["RobotPose"]["pose"]
    x, y = poses["translation"]["x"], poses["translation"]["y"]
    drawn = [f'<rect width="{WIDTH}" height="{HEIGHT}" fill="#3a6"/>']
    drawn.append(path_of(WIDTH / 2 + scale * x, HEIGHT / 2 - scale * y, "white"))
    seen = log["BallPercept"]["seen"]
    # Both are written after each image.
    for at in np.flatnonzero(seen[: len(poses)])[::5]:
        c, s = np.cos(poses["rotation"][at]), np.sin(poses["rotation"][at])
        offset = log["BallPercept"]["offset"][at]
        ball = x[at] + c * offset["x"] - s * offset["y"], y[at] + s * offset["x"] + c * offset["y"]
        cx, cy = WIDTH / 2 + scale * ball[0], HEIGHT / 2 - scale * ball[1]
        drawn.append(f'<circle cx="{cx:.1f}" cy="{cy:.1f}" r="1.5" fill="orange"/>')
    return drawn


def curve_of(log: gt2003.Log) -> list[str]:
    """The distance of the ball, as the robot believes it."""
    balls = log["BallModel"]
    distance = np.hypot(balls["position"]["x"], balls["position"]["y"])
    time = balls["log_time"]
    span = max(float(np.ptp(time)), 1.0)
    top = HEIGHT + 10
    drawn = [f'<rect y="{top}" width="{WIDTH}" height="{PLOT}" fill="#eee"/>']
    shown = np.clip(distance, 0, LENGTH)
    drawn.append(
        path_of(
            WIDTH * (time - time[0]) / span, top + PLOT * (1 - shown / LENGTH), "#c40"
        )
    )
    text = f"distance of the ball, 0 to {LENGTH / 1000:g} m, over {span / 1000:.0f} s"
    drawn.append(f'<text x="5" y="{top + 15}" font-size="12">{text}</text>')
    return drawn


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--play", type=float)
    parser.add_argument("files", nargs="*")
    given = parser.parse_args()

    with tempfile.TemporaryDirectory() as folder:
        if given.play:
            match = gt2003.Match(logs=folder, threads=2)
            match.run(given.play)
            match.close()
            given.files.insert(0, str(Path(folder) / "red2.mcap"))
        log = gt2003.Log(given.files[0])
        drawn = field_of(log) + curve_of(log)
    out = Path(given.files[1] if len(given.files) > 1 else "log.svg")
    size = f'width="{WIDTH}" height="{HEIGHT + PLOT + 10}"'
    svg = f'<svg xmlns="http://www.w3.org/2000/svg" {size}>'
    out.write_text("\n".join([svg, *drawn, "</svg>"]) + "\n")
    print(f"{out}: {len(log['RobotPose'])} poses, {int(log['BallPercept']['seen'].sum())} balls seen")


if __name__ == "__main__":
    main()
