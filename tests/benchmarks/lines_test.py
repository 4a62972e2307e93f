"""Counts the lines of a small project by scripts/lines."""
import contextlib
import importlib.machinery
import importlib.util
import io
import json
import pathlib
import subprocess
import sys
import tempfile
import unittest
from unittest import mock

SCRIPT = pathlib.Path(__file__).parents[2] / "scripts/lines"
LOADER = importlib.machinery.SourceFileLoader("lines", str(SCRIPT))
lines = importlib.util.module_from_spec(importlib.util.spec_from_loader("lines", LOADER))
sys.dont_write_bytecode = True
LOADER.exec_module(lines)

CPP = """// A comment.
#include <string>

/* Two
   lines */ int a = 1;  // behind code
const char* link = "http://nowhere /* no comment";
/// One more.
char quote = '"';  // "
"""  # 4 lines
PYTHON = '''"""A docstring
of two lines."""

import os  # the first


def f():
    """Another one."""
    return """text
# that is no comment
"""
'''  # 5 lines
SHELL = "#!/bin/sh\n# a comment\n\necho a  # b\n"
FILES = {
    "src/a/A.cpp": CPP, "src/a/A_test.cpp": CPP, "src/a/support/Help.h": CPP, "apps/b/b.cpp": CPP, "python/gt2003/c.py": PYTHON,
    "behavior/d.xabsl": "/***\nTitle\n*/\noption a {\n}\n", "python/tests/test_c.py": PYTHON, "tests/data.txt": "1\n2\n",
    "tests/CMakeLists.txt": "# no\nyes()\n", "experiments/e.cpp": CPP, "scripts/f": SHELL, "scripts/g": "#!/usr/bin/env python3\n" + PYTHON,
    "src/CMakeLists.txt": "yes()\n", "docs/h.py": PYTHON, "models/i.xml": "<a/>\n",
}  # fmt: skip


class Lines(unittest.TestCase):
    def test_counts_code_by_kind(self):
        with tempfile.TemporaryDirectory() as folder:
            root = pathlib.Path(folder)
            for name, text in FILES.items():
                (root / name).parent.mkdir(parents=True, exist_ok=True)
                (root / name).write_text(text)
            (root / "src/picture.h").write_bytes(b"\xff\xfe")
            subprocess.run(["git", "init", "--quiet"], cwd=root, check=True)
            subprocess.run(["git", "add", "."], cwd=root, check=True)
            (root / "src/unknown.cpp").write_text(CPP)
            counted = {"production": 4 + 4 + 5 + 2, "measuring": 4 + 1 + 5 + 1, "tests": 4 + 4 + 5 + 1}
            self.assertEqual(lines.count(root), counted)
            file = root / "out/lines.json"
            with mock.patch.object(lines, "ROOT", root), mock.patch.object(sys, "argv", ["lines", "--json", str(file)]):
                with contextlib.redirect_stdout(io.StringIO()) as printed:
                    self.assertEqual(lines.main(), 0)
            self.assertIn("production        15", printed.getvalue())
            self.assertEqual({f["name"]: f["runs"] for f in json.loads(file.read_text())}, {f"lines.{k}": [n] for k, n in counted.items()})


if __name__ == "__main__":
    unittest.main()
