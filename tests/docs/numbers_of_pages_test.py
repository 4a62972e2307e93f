"""Counts numbers of a page's tables by scripts/numbers-of-pages."""
import json
import pathlib
import subprocess
import tempfile
import unittest

SCRIPT = pathlib.Path(__file__).parents[2] / "scripts/numbers-of-pages"
PAGE = """# Page

| | measured | aim | at 95922f2 | real: log of an NAO | what |
| --- | --- | --- | --- | --- | --- |
| speed of 300 | 250 mm/s | 300 | 228 | 90 | 3.8.2: how fast |
| turns | **1.2** | 2 | 1 | 3 | `5` or so |

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
        self.page, self.figures = (pathlib.Path(folder.name, name) for name in ("page.md", "figures.json"))
        self.page.write_text(PAGE)
        self.figures.write_text(json.dumps([{"name": name} for name in FIGURES]))

    def count(self):
        return subprocess.run([SCRIPT, self.figures, self.page], capture_output=True, text=True, check=False)

    def test_tells_where_numbers_come_from(self):
        # By hand: 250, 1.2, 7, -90, 2. Quoted: 1, 2 (3), 5; the error of `back` in benign is not kept.
        run = self.count()
        self.assertEqual(run.stdout.splitlines()[1].split(), [str(self.page), "3", "1", "5"])
        self.assertEqual((run.returncode, run.stderr), (1, f"{self.page}: 1 numbers of tables aged and 5 by hand\n"))

    def test_quoted_and_stated_numbers_are_right(self):
        self.page.write_text(PAGE[PAGE.index("<!-- figures") : PAGE.index("| by hand")] + PAGE[PAGE.index("\n<!-- stated") : PAGE.index("| | counts")])
        self.figures.write_text(json.dumps([{"name": name} for name in [*FIGURES, "walk.benign.back.error"]]))
        run = self.count()
        self.assertEqual((run.returncode, run.stderr), (0, ""))

    def test_what_cannot_be_read_is_refused(self):
        self.figures.write_text("[{}]")
        run = self.count()
        self.assertEqual((run.returncode, len(run.stderr.splitlines())), (2, 1))



if __name__ == "__main__":
    unittest.main()
