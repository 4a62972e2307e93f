"""A ball locator in Python, a Kalman filter, against one of the robots' own: how wrong is each?

python locator.py [--seconds SECONDS] [--seed SEED] [--against SOLUTION]
"""

from __future__ import annotations

import argparse

import numpy as np

import gt2003
from gt2003.representations import BallModel, BallPercept, FrameInfo, OdometryData

FRICTION = 0.5  # of the speed that is left after a second
ACCELERATION = 300.0  # mm/s within a second: how much the ball's speed changes by chance
NEAR, SHARE = 30.0, 0.1  # standard deviation of a percept: mm, and share of its distance


class KalmanLocator:
    """Position and speed of the ball relative to the robot, from percepts and odometry."""

    def __init__(self) -> None:
        self.state = np.zeros(4)  # x, y, speed in x and y: mm, mm/s
        self.covariance = np.diag([1e6, 1e6, 1e4, 1e4])
        self.ball = BallModel()
        self.before: tuple[int, np.ndarray, float] | None = None

    def update(
        self, ball_percept: BallPercept, odometry_data: OdometryData, frame_info: FrameInfo
    ) -> BallModel:
        pose = odometry_data.pose
        if self.before is not None:
            self.predict(frame_info.time, pose.translation, pose.rotation)
        self.before = frame_info.time, pose.translation, pose.rotation
        if ball_percept.seen:
            self.correct(ball_percept.offset)
            self.ball.lastSeen = frame_info.time
        self.ball.position, self.ball.speed = self.state[:2], self.state[2:]
        self.ball.standardDeviation = float(np.sqrt(max(np.trace(self.covariance[:2, :2]), 0)))
        return self.ball

    def predict(self, time: int, translation: np.ndarray, rotation: float) -> None:
        """The ball rolls on, and the robot has moved."""
        assert self.before is not None
        last, last_translation, last_rotation = self.before
        seconds = (time - last) / 1000
        turned = rotation - last_rotation
        back = rotation_by(-turned)
        step = rotation_by(-last_rotation) @ (translation - last_translation)
        motion = np.eye(4)
        motion[:2, 2:] = seconds * np.eye(2)
        motion[2:, 2:] *= FRICTION**seconds
        whole = np.kron(np.eye(2), back) @ motion
        self.state = whole @ self.state
        self.state[:2] -= back @ step
        noise = np.diag([10 * seconds, 10 * seconds, ACCELERATION * seconds, ACCELERATION * seconds])
        self.covariance = whole @ self.covariance @ whole.T + noise**2 / max(seconds, 1e-3)

    def correct(self, offset: np.ndarray) -> None:
        """A percept says where the ball is."""
        deviation = NEAR + SHARE * np.linalg.norm(offset)
        residual = self.covariance[:2, :2] + deviation**2 * np.eye(2)
        gain = self.covariance[:, :2] @ np.linalg.inv(residual)
        self.state = self.state + gain @ (offset - self.state[:2])
        self.covariance = self.covariance - gain @ self.covariance[:2]


def rotation_by(angle: float) -> np.ndarray:
    c, s = np.cos(angle), np.sin(angle)
    return np.array([[c, -s], [s, c]])


def error_of(match: gt2003.Match, robot: gt2003.Robot) -> float | None:
    """How far the ball truly is from where the robot believes it (mm), if it saw it just now."""
    if match.time - robot.get("BallModel.lastSeen") > 500:
        return None
    pose = robot.true_pose
    offset = rotation_by(-pose.rotation) @ (match.ball_position - pose.translation)
    return float(np.linalg.norm(robot.get("BallModel.position") - offset))


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--seconds", type=float, default=60)
    parser.add_argument("--seed", type=int, default=7)
    parser.add_argument("--against", default="PIDSmoothed")
    given = parser.parse_args()

    for solution in (KalmanLocator, given.against):
        match = gt2003.Match(seed=given.seed, threads=2)
        for name in ("red2", "red3", "red4"):
            match.robots[name].solve("BallLocator", solution)
        match.until(lambda: match.game_state == "playing", seconds=60)
        errors = []
        end = match.time + 1000 * given.seconds
        while match.time < end and match.run(0.2):
            found = (error_of(match, match.robots[name]) for name in ("red2", "red3", "red4"))
            errors += [error for error in found if error is not None]
        watch = match.robots["red2"].times["BallLocator"]
        print(
            f"{match.robots['red2'].solutions['BallLocator']:14} {len(errors):4} times: wrong by "
            f"{np.median(errors) if errors else np.nan:.0f} mm (median), "
            f"{1000 * watch.totalMs / watch.count:.0f} us a call"
        )


if __name__ == "__main__":
    main()
