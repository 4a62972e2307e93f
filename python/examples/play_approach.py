"""Plays a match in which the policy of train_approach.py takes the place of one robot's behavior.

    build/python/bin/python python/examples/play_approach.py [--scene match] [--minutes 2] [--seed 7] [--robot red3]

The solution of the task BehaviorControl walks to the ball as the policy decides, by what the robot believes, and kicks once
the ball lies right. Its teammates are told that it is the striker.
"""

from __future__ import annotations

import argparse
from pathlib import Path

import numpy as np
from train_approach import act

import gt2003
from gt2003.representations import (
    BallModel,
    BehaviorTeamMessage,
    FrameInfo,
    GameControlData,
    GameState,
    HeadControlMode,
    LedRequest,
    MotionInfo,
    MotionRequest,
    RobotPose,
    SoundRequest,
)

GOAL = np.array([2100, 0])  # mm: the middle of the opponent's
FULL_SPEED = np.array([250, 200, 2])  # of GT2003/Approach-v0 with motion requests: mm/s, mm/s, rad/s


class LearnedStriker:
    """Walks to the ball by the policy, and kicks it to the goal."""

    policy = np.loadtxt(Path(__file__).with_name("approach_policy.txt"))[None]

    def __init__(self) -> None:
        self.kicks = 0
        self.kicking = False

    def update(
        self,
        robot_pose: RobotPose,
        ball_model: BallModel,
        motion_info: MotionInfo,
        game_control_data: GameControlData,
        frame_info: FrameInfo,
    ) -> tuple[MotionRequest, HeadControlMode, LedRequest, SoundRequest, BehaviorTeamMessage]:
        request = MotionRequest(type="stand", time=frame_info.time)
        unseen = frame_info.time - ball_model.lastSeen  # ms
        if game_control_data.state == GameState.playing:
            request.type = "walk"
            if unseen > 2500:
                request.walk.rotation = 1.2 if ball_model.position[1] > 0 else -1.2
            else:
                self.play(request, robot_pose, ball_model, motion_info)
        striker = BehaviorTeamMessage(role="striker", estimatedTimeToReachBall=0 if unseen < 2500 else 1e6)
        return request, HeadControlMode(mode="searchAuto"), LedRequest(), SoundRequest(), striker

    def play(self, request: MotionRequest, robot_pose: RobotPose, ball_model: BallModel, motion_info: MotionInfo) -> None:
        """Request the kick until it has begun; else the walk."""
        ball = np.asarray(ball_model.position)
        turn, at = robot_pose.pose.rotation, GOAL - robot_pose.pose.translation
        goal = np.array([np.cos(turn) * at[0] + np.sin(turn) * at[1], np.cos(turn) * at[1] - np.sin(turn) * at[0]])
        aim = np.arctan2(goal[1] - ball[1], goal[0] - ball[0])
        right = abs(ball[0] - 150) < 30 and abs(ball[1]) < 30 and abs(aim) < np.radians(15)
        begun = motion_info.executed.specialAction == "pushStrong"
        if begun and self.kicking:
            self.kicks += 1
        self.kicking = (self.kicking or right) and not begun
        if self.kicking:
            request.type, request.specialAction = "specialAction", "pushStrong"
            return
        ahead, left, turn = FULL_SPEED * act(self.policy, ball[None] / 1000, goal[None] / 1000)[0]
        request.walk.translation, request.walk.rotation = [ahead, left], turn


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--minutes", type=float, default=2)
    parser.add_argument("--seed", type=int, default=7)
    parser.add_argument("--robot", default="red3")
    parser.add_argument("--scene", default="match")
    given = parser.parse_args()
    match = gt2003.Match(given.scene, seed=given.seed, minutes=given.minutes, threads=2)
    robot = match.robots[given.robot]
    striker = robot.solve("BehaviorControl", LearnedStriker)
    match.run()
    print(f"{given.robot}: {robot.solutions['BehaviorControl']} kicked {striker.kicks} times")
    for event in match.events:
        print(f"{event.time / 1000:6.1f} s  {event.text}")
    print("Final score: red {} : {} blue".format(*match.score))


if __name__ == "__main__":
    main()
