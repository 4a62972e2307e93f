"""Counts numbers of a page's tables by scripts/numbers-of-pages."""
import json
import pathlib
import subprocess
import tempfile
import unittest

SCRIPT = pathlib.Path(__file__).parents[2] / "scripts/numbers-of-pages"
PAGE = """# Page

| | measured | aim | what |
| --- | --- | --- | --- |
| speed of 300 | 250 mm/s | 300 | 3.8.2: how fast |
| turns | **1.2** | 2 | `5` or so |

<!-- figures: {walk.*.speed} | {walk.*.error, benign} |
ahead
back
-
-->
| | speed | error | report |
| --- | --- | --- | --- |
| ahead | 1 | 2 (3) | 4 |
| back | 5 | 6 | none |
| by hand | 7 | none | 8 |

<!-- stated: limits.h -->
| | most |
| --- | --- |
| angle | 90 |

| | counts again |
| --- | --- |
| angle | -90 |

<!-- keys -->
| key | times |
| --- | --- |
| a | 2 |

<!-- end -->
| key | times |
| --- | --- |
| b | 2 |
"""
FIGURES = ["walk.ahead.speed", "walk.back.speed", "walk.ahead.error", "walk.benign.ahead.error", "walk.back.error"]


class NumbersOfPages(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.page, self.figures, self.left = (pathlib.Path(folder.name, name) for name in ("page.md", "figures.json", "left"))
        self.page.write_text(PAGE)
        self.figures.write_text(json.dumps([{"name": name} for name in FIGURES]))

    def count(self, left):
        self.left.write_text(left)
        return subprocess.run([SCRIPT, "--left", self.left, self.figures, self.page], capture_output=True, text=True, check=False)

    def test_tells_where_numbers_come_from(self):
        # By hand: 250, 1.2, 7, -90, 2. Quoted: 1, 2 (3), 5; the error of `back` in benign is not kept.
        run = self.count(f"{self.page} 1 5\n")
        self.assertEqual((run.returncode, run.stderr), (0, ""))
        self.assertEqual(run.stdout.splitlines()[1].split(), [str(self.page), "3", "1", "5"])

    def test_no_number_more_and_none_less_than_the_list_says(self):
        for left in ("1 4", "1 6", "0 5", "2 5"):
            run = self.count(f"{self.page} {left}\n")
            self.assertEqual(run.returncode, 1)
            self.assertIn(f"{self.page}: 1 aged and 5 by hand; ", run.stderr)
        self.assertEqual(self.count("").returncode, 1)
        run = self.count(f"{self.page} 1 5\ngone.md 1 1\n")
        self.assertEqual(run.returncode, 1)
        self.assertIn("gone.md: 0 aged and 0 by hand", run.stderr)

    def test_what_cannot_be_read_is_refused(self):
        for left in ("page.md 1\n", "page.md a b\n"):
            run = self.count(left)
            self.assertEqual((run.returncode, len(run.stderr.splitlines())), (2, 1))
        self.figures.write_text("[{}]")
        self.assertEqual(self.count("").returncode, 2)


if __name__ == "__main__":
    unittest.main()
