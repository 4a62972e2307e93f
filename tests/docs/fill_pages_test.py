"""Fills tables of a page by scripts/fill-pages."""
import json
import pathlib
import subprocess
import tempfile
import unittest

SCRIPT = pathlib.Path(__file__).parents[2] / "scripts/fill-pages"
PAGE = """# Page

<!-- figures: {walk.*.mean, benign} mm | {walk.*.p95:.2f}
near
-
far
.
-->
| | mean | 95 % |
| --- | --- | --- |
| near | old | old |
| kept | 1 | |
| far | not measured | |
| all | | |

| another | table |
| --- | --- |
"""
FIGURES = {"walk.near.mean": 12.34, "walk.benign.near.mean": 1.234, "walk.near.p95": 20, "walk.far.mean": 3, "walk.far.p95": 0.5,
           "walk.mean": 0.123, "walk.benign.mean": 0, "walk.p95": 1}


class FillPages(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.page = pathlib.Path(folder.name, "page.md")
        self.figures = pathlib.Path(folder.name, "figures.json")
        self.figures.write_text(json.dumps([{"name": name, "value": value} for name, value in FIGURES.items()]))

    def fill(self, page, *options):
        self.page.write_text(page)
        return subprocess.run([SCRIPT, *options, self.figures, self.page], capture_output=True, text=True, check=False)

    def test_fills_what_was_measured_and_nothing_else(self):
        self.assertEqual(self.fill(PAGE).returncode, 0)
        filled = PAGE.replace("| near | old | old |", "| near | 12.3 (1.2) mm | 20.00 |")
        filled = filled.replace("| far | not measured | |", "| far | not measured | 0.50 |")
        filled = filled.replace("| all | | |", "| all | 0.12 (0.00) mm | 1.00 |")
        self.assertEqual(self.page.read_text(), filled)

    def test_a_filled_page_stays_as_it_is(self):
        self.fill(PAGE)
        filled = self.page.read_text()
        self.fill(filled)
        self.assertEqual(self.page.read_text(), filled)

    def test_a_check_writes_nothing_and_tells_the_line(self):
        run = self.fill(PAGE, "--check")
        self.assertEqual((run.returncode, run.stderr), (1, f"{self.page}:11: has other values than {self.figures}\n"))
        self.assertEqual(self.page.read_text(), PAGE)
        self.fill(PAGE)
        run = self.fill(self.page.read_text(), "--check")
        self.assertEqual((run.returncode, run.stderr), (0, ""))

    def test_a_table_that_does_not_fit_is_an_error(self):
        for wrong, error in ((PAGE.replace("near\n-", "near"), "page.md:3: figures: 3 names for 4 rows"),
                             (PAGE.replace("| old | old |", "| old |"), "page.md:3: figures: 2 columns for row 1 of 1")):
            run = self.fill(wrong)
            self.assertEqual(run.returncode, 2)
            self.assertIn(error, run.stderr)
            self.assertEqual(self.page.read_text(), wrong)

    def test_a_page_that_cannot_be_written_stays_as_it_was(self):
        self.page.write_text(PAGE)
        limited = ["sh", "-c", "ulimit -f 0; exec \"$@\"", "sh", SCRIPT, self.figures, self.page]
        run = subprocess.run(limited, capture_output=True, text=True, check=False)
        self.assertEqual(run.returncode, 2)
        self.assertIn("fill-pages: ", run.stderr)
        self.assertEqual(self.page.read_text(), PAGE)
        self.assertEqual(sorted(file.name for file in self.page.parent.iterdir()), ["figures.json", "page.md"])

    def test_figures_that_cannot_be_read_are_an_error(self):
        self.figures.write_text("[{]")
        self.assertEqual(self.fill(PAGE).returncode, 2)


if __name__ == "__main__":
    unittest.main()
