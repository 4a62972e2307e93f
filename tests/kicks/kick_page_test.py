"""The page of kicks says what their table says."""

import pathlib
import re
import subprocess
import tempfile
import unittest

ROOT = pathlib.Path(__file__).parents[2]


class KickPage(unittest.TestCase):
    def test_the_page_has_the_projects_table(self):
        text = (ROOT / "docs/motion.md").read_text()
        spoiled = re.sub(r"\| `pushStrong` \| \d+, ", "| `pushStrong` | 999, ", text)
        self.assertNotEqual(spoiled, text)
        with tempfile.TemporaryDirectory() as folder:
            page = pathlib.Path(folder) / "page.md"
            page.write_text(spoiled)
            subprocess.run([ROOT / "scripts/kick-page", page, ROOT / "config/kicks.cfg"], check=True)
            self.assertEqual(page.read_text(), text, "scripts/kick-page docs/motion.md config/kicks.cfg makes it anew")


if __name__ == "__main__":
    unittest.main()
