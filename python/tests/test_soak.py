"""The soak test: it tells when something lasts that must not."""

import json
import os
import subprocess
import sys
from pathlib import Path

SOAK = Path(__file__).with_name("soak.py")


def soak(tmp_path: Path, *arguments: str, before: str = "") -> tuple[int, list[dict], str]:
    file = tmp_path / "soak.json"
    program = f"import runpy, sys; sys.argv = {['soak', '--json', str(file), *arguments]!r}\n{before}\nrunpy.run_path({str(SOAK)!r}, run_name='__main__')"
    done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, env=os.environ, check=False)
    return done.returncode, json.loads(file.read_text()), done.stderr


def test_sound_matches_have_no_fault(tmp_path):
    status, figures, errors = soak(tmp_path, "--hours", "0.01", "--scene", "one-robot")
    assert status == 0, errors
    named = {figure["name"]: figure["value"] for figure in figures}
    assert named["soak.faults"] == 0
    assert named["soak.hours"] >= 0.01


def test_a_match_that_fails_is_a_fault(tmp_path):
    broken = "import gt2003\ndef fail(*_): raise RuntimeError('broken')\ngt2003.Match.place = fail"
    status, figures, errors = soak(tmp_path, "--hours", "0.005", "--scene", "one-robot", "--seed", "3", before=broken)
    assert status == 1
    assert {figure["name"]: figure["value"] for figure in figures}["soak.faults"] > 0
    assert "broken" in errors
