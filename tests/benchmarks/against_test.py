"""Compares programs that only note how they were called with each other, and builds a commit of a small project."""
import contextlib
import io
import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).parents[2]
sys.path.insert(0, str(ROOT / "python/benchmarks"))

import against  # noqa: E402
import figures  # noqa: E402

SIMGT = """#!/bin/sh
if [ "$2" = --help ]; then echo "{options}"; exit; fi
echo "{name} $*" >>{calls}
i=0; while [ $i -lt {work} ]; do i=$((i + 1)); done
"""
PROJECT = """cmake_minimum_required(VERSION 3.25)
project(small NONE)
add_custom_target(simgt COMMAND ${CMAKE_COMMAND} -E echo made > simgt)
"""
PRESETS = '{"version": 6, "configurePresets": [{"name": "release", "generator": "Ninja", "binaryDir": "build/release"}]}'


class Against(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def program(self, name, options, work):
        tree = self.folder / name
        (tree / "bin").mkdir(parents=True)
        simgt = tree / "bin/simgt"
        simgt.write_text(SIMGT.format(name=name, options=options, calls=self.folder / "calls", work=work))
        simgt.chmod(0o755)
        return against.Program(tree, tree)

    def git(self, *arguments):
        subprocess.run(["git", "-c", "user.name=a", "-c", "user.email=a@a", *arguments], cwd=self.folder, check=True)

    def test_both_play_each_seed_in_turns(self):
        now = self.program("now", "--seed --profile", 400000)
        then = self.program("then", "--seed", 100000)
        with contextlib.redirect_stdout(io.StringIO()):
            user, elapsed = against.compare(now, then, pairs=2, minutes=3, threads=2)
        calls = [call.split(" --out")[0] for call in (self.folder / "calls").read_text().splitlines()]
        played = "play scenes/match.scene{} --seed {} --minutes 3 --threads 2 --no-logs"
        self.assertEqual(calls, [
            "now " + played.format(" --profile benign", 1), "then " + played.format("", 1),
            "now " + played.format(" --profile benign", 2), "then " + played.format("", 2)])
        self.assertEqual((user["name"], elapsed["name"]),
                         ("speed.against.threads2.user", "speed.against.threads2.elapsed"))
        self.assertEqual(user["n"], 2)
        self.assertGreater(user["median"], 2)
        self.assertFalse(user["met"])

    def test_a_figure_replaces_that_of_before(self):
        file = self.folder / "bench.json"
        file.write_text(json.dumps([{"name": "other"}, {"name": "cost", "value": 1}]))
        with contextlib.redirect_stdout(io.StringIO()):
            figures.add([figures.figure("cost", "x", [2., 4., 9.], ("at most", 4))], file)
        other, cost = json.loads(file.read_text())
        self.assertEqual(other, {"name": "other"})
        self.assertEqual((cost["value"], cost["median"], cost["met"], cost["runs"]), (5, 4, False, [2, 4, 9]))

    def test_builds_the_commit_beside_the_own_tree(self):
        (self.folder / "CMakeLists.txt").write_text(PROJECT)
        (self.folder / "CMakePresets.json").write_text(PRESETS)
        self.git("init", "--quiet")
        self.git("add", ".")
        self.git("commit", "--quiet", "--message", "small")
        (self.folder / "CMakeLists.txt").write_text("not committed")
        tree = against.tree_of("HEAD", self.folder)
        self.assertEqual(tree.parent, self.folder / "build/against")
        self.assertTrue((tree / "build/release/simgt").exists())
        self.assertEqual(against.tree_of("HEAD", self.folder), tree)

    def test_a_commit_that_is_not_there_is_an_error(self):
        run = subprocess.run([ROOT / "python/benchmarks/against.py", "nowhere"], capture_output=True, text=True, check=False)
        self.assertEqual((run.returncode, run.stderr), (2, "against: nowhere: there is no such commit\n"))


if __name__ == "__main__":
    unittest.main()
