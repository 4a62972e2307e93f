"""Makes tables of kicks by scripts/kick-table."""
import json
import pathlib
import subprocess
import tempfile
import unittest

ROOT = pathlib.Path(__file__).parents[2]
SCRIPT = ROOT / "scripts/kick-table"


def figures_of(kick, lengths_of, seeds):
    """Return figures of a kick that hits the ball at all places of a grid: `lengths_of(x, y)` are the length and its spread."""
    figures = [
        {"name": f"kicks.{kick}.seconds", "runs": [1.5] * seeds},
        {"name": f"kicks.{kick}.strike", "runs": [0.8] * seeds},
    ]
    for x in range(100, 181, 20):
        for y in range(-40, 41, 20):
            length, spread = lengths_of(x, y)
            swing = [spread if seed % 2 else -spread for seed in range(seeds)]
            for name, runs in (("hit", [1] * seeds), ("fell", [0] * seeds), ("length", [length] * seeds), ("direction", swing)):
                figures.append({"name": f"kicks.{kick}.at.{x}.{y}.{name}", "runs": runs})
    return figures


class KickTable(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.team = pathlib.Path(self.folder.name) / "team"
        (self.team / "motions/kicks").mkdir(parents=True)
        (self.team / "motions/kicks/ownKick.mof").write_text("motion_id = ownKick\n")
        self.table = self.team / "config/kicks.cfg"

    def make(self, figures):
        file = pathlib.Path(self.folder.name) / "figures.json"
        file.write_text(json.dumps(figures))
        return subprocess.run([SCRIPT, self.table, file], capture_output=True, text=True)

    def test_says_which_place_it_took_and_why(self):
        done = self.make(figures_of("ownKick", lambda x, y: (1500, 12) if y > 20 else (1000, 1), 6))
        self.assertEqual(done.returncode, 0, done.stderr)
        best, farthest = done.stdout.splitlines()
        self.assertRegex(best, r"^ownKick, 6 seeds: best place 120, -20: 1000 mm to -?0 degrees, spread 1\.0; worth 800 = ")
        self.assertIn("hits at least 100% x 1000 mm with the places around it - 1.0 degrees astray x 200 mm", best)
        self.assertRegex(farthest, r"^ownKick: farthest from 100, 40: 1500 mm to -?0 degrees, spread 12\.0; worth ")

    def test_the_tables_place_is_the_one_it_names(self):
        self.make(figures_of("ownKick", lambda x, y: (1000, 0.5 if (x, y) == (140, 0) else 1), 4))
        section = self.table.read_text().split("motion ownKick\n")[1].splitlines()
        self.assertEqual(section[:2], ["x 140", "y 0"])

    def test_refuses_too_few_seeds(self):
        done = self.make(figures_of("ownKick", lambda x, y: (1000, 1), 3))
        self.assertEqual(done.returncode, 1)
        self.assertEqual(done.stderr, "kick-table: ownKick: measured on 3 seeds, expected 4 or more: --seeds 101..106\n")
        self.assertFalse(self.table.exists())

    def test_the_page_has_the_projects_table(self):
        text = (ROOT / "docs/motion.md").read_text()
        page = pathlib.Path(self.folder.name) / "page.md"
        page.write_text(text.replace("| `pushStrong` | 120, 0 |", "| `pushStrong` | 140, 0 |"))
        done = subprocess.run([SCRIPT, "--page", page, ROOT / "config/kicks.cfg"], capture_output=True, text=True)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(page.read_text(), text, "scripts/kick-table --page docs/motion.md config/kicks.cfg makes it anew")

    def test_a_teams_table_begins_as_the_projects(self):
        self.make(figures_of("ownKick", lambda x, y: (1000, 1), 4))
        names = {line.split()[1] for line in self.table.read_text().splitlines() if line.startswith("motion ")}
        project = {line.split()[1] for line in (ROOT / "config/kicks.cfg").read_text().splitlines() if line.startswith("motion ")}
        self.assertEqual(names, project | {"ownKick"})

    def test_what_hits_nowhere_is_no_kick(self):
        figures = figures_of("ownKick", lambda x, y: (1000, 1), 4)
        for figure in figures:
            if figure["name"].endswith(".hit"):
                figure["runs"] = [1, 0, 0, 1]
        done = self.make(figures)
        self.assertEqual(done.stdout, "ownKick, 4 seeds: is not in the table, since it hits 90% of the balls from no place\n")
        self.assertNotIn("ownKick", self.table.read_text())


if __name__ == "__main__":
    unittest.main()
