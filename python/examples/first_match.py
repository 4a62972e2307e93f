"""A first match: plays, looks at what robots believe and see, and moves the ball.

python first_match.py [--minutes MINUTES] [--seed SEED]
"""

import argparse

import numpy as np

import gt2003


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--minutes", type=float, default=2)
    parser.add_argument("--seed", type=int, default=7)
    given = parser.parse_args()

    match = gt2003.Match("match", seed=given.seed, minutes=given.minutes, threads=2)
    match.until(lambda: match.game_state == "playing", seconds=60)

    # What each robot believes, and where it truly is.
    for name, robot in match.robots.items():
        believed = robot.get("RobotPose.pose.translation")
        error = np.linalg.norm(believed - robot.true_pose.translation)
        print(f"{name}: {robot.solutions['SelfLocator']} is wrong by {error:.0f} mm")

    # An image: height, width, and the channels Y, Cb and Cr.
    image = match.robots["red1"].image
    assert image is not None  # as it is before the first one
    print(f"red1's image: {image.shape}, mean brightness {image[:, :, 0].mean():.0f}")

    # Another solution and another parameter, for one robot; and the ball somewhere else.
    red = match.robots["red2"]
    red.solve("SelfLocator", "GT2003")
    red.set("BallLocator.proportional", 0.3)
    match.place("ball", 500, 300)

    match.run()
    for event in match.events:
        print(f"{event.time / 1000:6.1f} s  {event.text}")
    print("Final score: red {} : {} blue".format(*match.score))


if __name__ == "__main__":
    main()
