"""A detector in NumPy plays as an image processor in a match: it finds the orange ball.

python detector.py [--seconds SECONDS] [--seed SEED]
"""

from __future__ import annotations

import argparse

import numpy as np

import gt2003
from gt2003.representations import (
    BallPercept,
    CameraMatrix,
    ColorClass,
    ColorTable64,
    Image,
    LandmarksPercept,
    LinesPercept,
    ObstaclesPercept,
    PlayersPercept,
)

RADIUS = 43  # of the ball: mm
LEAST_PIXELS = 20  # of jerseys there may be some

Percepts = tuple[BallPercept, LandmarksPercept, LinesPercept, PlayersPercept, ObstaclesPercept]


class OrangeBlob:
    """The ball is where most of the orange pixels are, if it is as large as it has to be there."""

    def update(
        self, image: Image, color_table64: ColorTable64, camera_matrix: CameraMatrix
    ) -> Percepts:
        ball = BallPercept(time=image.time)
        table = color_table64.classes.reshape(64, 64, 64)
        pixels = image.pixels.reshape(image.info.height, image.info.width, 4)[:, :, :3]
        orange = gt2003.colors.classify(table, pixels) == ColorClass.orange
        if camera_matrix.valid and orange.sum() >= LEAST_PIXELS:
            self.locate(orange, camera_matrix, ball)
        others = LandmarksPercept(), LinesPercept(), PlayersPercept(), ObstaclesPercept()
        return ball, *others

    def locate(self, orange: np.ndarray, matrix: CameraMatrix, ball: BallPercept) -> None:
        """Fill the percept, if there is a ball."""
        info = matrix.info
        pixels = np.argwhere(orange)[:, ::-1] + 0.5  # x, y
        off = np.linalg.norm(pixels - np.median(pixels, axis=0), axis=1)
        pixels = pixels[off <= 2 * np.sqrt(len(pixels) / np.pi) + 1]  # without jerseys elsewhere
        if len(pixels) < LEAST_PIXELS:
            return
        center = pixels.mean(axis=0)
        ahead = [1, (info.centerX - center[0]) / info.focalX, (info.centerY - center[1]) / info.focalY]
        ray = matrix.pose.rotation.reshape(3, 3) @ ahead
        camera = matrix.pose.translation
        if ray[2] > -0.01:
            return
        distance = (camera[2] - RADIUS) / -ray[2]
        radius = float(np.sqrt(len(pixels) / np.pi))
        expected = info.focalX * RADIUS / (distance * np.linalg.norm(ray))
        if not 0.5 < radius / expected < 2:
            return
        ball.seen = True
        ball.offset = camera[:2] + distance * ray[:2]
        ball.centerInImage = center
        ball.radiusInImage = radius
        ball.distanceByProjection = float(distance * np.linalg.norm(ray))
        ball.angle = np.array([np.arctan2(ray[1], ray[0]), np.arctan2(ray[2], np.hypot(*ray[:2]))])


def true_offset(match: gt2003.Match, robot: gt2003.Robot) -> np.ndarray:
    """Where the ball truly lies, as the robot sees it: mm."""
    pose = robot.true_pose
    c, s = np.cos(pose.rotation), np.sin(pose.rotation)
    return np.array([[c, s], [-s, c]]) @ (match.ball_position - pose.translation)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--seconds", type=float, default=60)
    parser.add_argument("--seed", type=int, default=7)
    given = parser.parse_args()

    match = gt2003.Match(
        seed=given.seed, threads=2, solutions={"red2": {"ImageProcessor": OrangeBlob}}
    )
    match.until(lambda: match.game_state == "playing", seconds=60)
    # red2 sees by NumPy, red3 by the robots' own vision. Who sees no landmarks loses its way, so the
    # ball is put before red2 now and then.
    errors: dict[str, list[float]] = {"red2": [], "red3": []}
    begin = match.time
    while match.time < begin + 1000 * given.seconds and match.run(0.2):
        if (match.time - begin) % 5000 == 200:
            pose = match.robots["red2"].true_pose
            ahead = np.array([np.cos(pose.rotation), np.sin(pose.rotation)])
            match.place("ball", *np.clip(pose.translation + 600 * ahead, [-2000, -1300], [2000, 1300]))
        for name, seen in errors.items():
            robot = match.robots[name]
            percept = robot.get("BallPercept")
            if percept.seen and percept.time > match.time - 100:
                offset = true_offset(match, robot)
                seen.append(float(np.linalg.norm(percept.offset - offset) / np.linalg.norm(offset)))
    for name, seen in errors.items():
        robot = match.robots[name]
        cost = robot.times["ImageProcessor"]
        print(
            f"{name}: {robot.solutions['ImageProcessor']:12} saw the ball {len(seen):4} times, "
            f"wrong by {100 * np.median(seen) if seen else np.nan:.0f} % of its distance, "
            f"{cost.totalMs / max(cost.count, 1):.2f} ms an image"
        )


if __name__ == "__main__":
    main()
