"""The images that are compared: of an AIBO ERS-7, of a NAO's log, and simulated ones.

All are arrays of rows, columns and the channels Y, Cb, Cr.
"""
import json
import random
import subprocess

import numpy as np
from PIL import Image

SEEDS = range(1, 7)
MOMENTS = 2  # of each seed, seen by all eight robots
# Pixels: how many of them one radian has in the middle.
ERS7_FOCAL_LENGTH, ERS210_FOCAL_LENGTH, NAO_FOCAL_LENGTH = 192, 160, 385.54
ROBOTS = [team + str(number) for team in ("red", "blue") for number in range(1, 5)]


def run(*command):
    done = subprocess.run([str(word) for word in command], capture_output=True, text=True)
    if done.returncode:
        raise RuntimeError(done.stderr.strip() or done.stdout.strip())
    return done.stdout


def ers7(folder):
    files = sorted(folder.glob("*.png"))
    return [np.asarray(Image.open(file).convert("RGB")) for file in files]


def of_log(gtlog, log, text):
    """The images of a log, which is removed, through a file of text."""
    run(gtlog, "export", log, text, "--topic", "/input/Image")
    images = []
    with open(text) as lines:
        for line in lines:
            message = json.loads(line)["message"]
            pixels = [(pixel["y"], pixel["cb"], pixel["cr"]) for pixel in message["pixels"]]
            images.append(np.array(pixels, np.uint8).reshape(message["info"]["height"], -1, 3))
    log.unlink()
    text.unlink()
    return images


def nao(gtlog, log, out):
    imported = out / "nao.mcap"
    run(gtlog, "import", log, imported)
    return of_log(gtlog, imported, out / "nao.json")


def script_of(profile, seed, log):
    """Console commands: robots stand anywhere and look anywhere, as in experiments' random moments of matches."""
    chance = random.Random(seed)

    def somewhere():
        return f"{chance.uniform(-1950, 1950):.0f} {chance.uniform(-1150, 1150):.0f}"

    lines = [f"set profile {profile}", "msg off", "robot all", "sr BehaviorControl disabled",
             "sr HeadControl disabled", "mr stand", "hcm none"]
    for _ in range(MOMENTS):
        for robot in ROBOTS:
            lines += [f"place {robot} {somewhere()} {chance.uniform(-180, 180):.0f}", f"robot {robot}",
                      f"hmr {chance.uniform(-52, 14):.0f} {chance.uniform(-86, 86):.0f} 0 0"]
        # Heads come to rest before the images, as that of the real robot was.
        lines += [f"place ball0 {somewhere()}", "run 1 s", "robot all", "log start", "dk sendImage on", "run 40 ms",
                  "dk sendImage off", "log stop"]
    return "\n".join(lines + [f"log save {log}", ""])


def simulated(root, build, profile, out):
    """The images of a profile: of each seed, moment and robot one."""
    images = []
    for seed in SEEDS:
        script = out / "images.con"
        script.write_text(script_of(profile, seed, out / "simulated"))
        run(build / "bin/simgt", "console", root / "scenes/match.scene", "--seed", seed, "--script", script)
        for robot in ROBOTS:
            log = out / f"simulated-{robot}.mcap"
            images += of_log(build / "bin/gtlog", log, out / "simulated.json")
    return images
