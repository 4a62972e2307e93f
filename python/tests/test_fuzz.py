"""Nothing that Python calls ends the interpreter: a short run of fuzz_bindings.py."""

from __future__ import annotations

import os
import re
import subprocess
import sys
from pathlib import Path


def test_random_calls_do_not_end_the_interpreter(tmp_path: Path) -> None:
    program = Path(__file__).with_name("fuzz_bindings.py")
    done = subprocess.run(
        [sys.executable, program, "--seed", "1", "--calls", "1500", "--seconds", "600"],
        env={**os.environ, "TMPDIR": str(tmp_path)},
        capture_output=True,
        text=True,
        timeout=800,
    )
    assert done.returncode == 0, done.stdout + done.stderr
    calls, raised = re.search(r"(\d+) calls of \d+ names, (\d+) exceptions", done.stdout).groups()  # type: ignore[union-attr]
    assert int(calls) >= 1000 and 0 < int(raised) < int(calls)
    assert "not called: none" in done.stdout
