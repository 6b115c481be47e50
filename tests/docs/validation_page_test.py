"""The runs behind docs/validation.md, small and short: broken off and called again they go on, and the page says what was run."""
import json
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

SOURCE = pathlib.Path(os.environ["SIMILITUDE_SOURCE"])


class ValidationPage(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.results = pathlib.Path(scratch.name) / "results"
        self.page = pathlib.Path(scratch.name) / "docs" / "validation.md"

    def run_all(self, runs, until, *settings):
        words = [word for setting in settings for word in ("--set", setting)]
        subprocess.run([sys.executable, SOURCE / "docs" / "validation" / "run_all.py", self.results, "--only", *runs, "--until", str(until),
                        "--page", self.page, *words], check=True, stdout=subprocess.DEVNULL)
        return self.page.read_text(encoding="utf-8")

    def row(self, page, start):
        return next(line for line in page.split("\n") if line.startswith(start))

    def test_runs_that_are_broken_off_go_on(self):
        small = ("scene.particles.glass.count=32000", "output.profiles.from=0.01 s", "output.vtk=every 1 ms")
        page = self.run_all(["yue2020/link"], 0.02, *small)
        self.assertRegex(self.row(page, "| link "), r"\| 4000 \| 0\.02\d* s of 6 s \| too short to compare \|")
        self.assertIn("No run has come far enough to be compared", page)
        page = self.run_all(["yue2020/link"], 0.05, *small)
        self.assertRegex(self.row(page, "| link "), r"\| 4000 \| 0\.05\d* s of 6 s \| 0\.01 to 0\.05\d* s \|")
        self.assertIn("scene.particles.glass.count=32000; output.profiles.from=0.01 s", self.row(page, "| link "))
        self.assertIn("| not run |", self.row(page, "| exact "))
        self.assertIn("* **link**: peaks from ", page)
        self.assertTrue((self.page.parent / "pictures" / "yue2020.png").exists())
        manifest = json.loads((self.results / "yue2020" / "link" / "manifest.json").read_text(encoding="utf-8"))
        self.assertEqual(len(manifest["resumed"]), 1)

    def test_laws_are_judged_by_the_bed_of_every_grain(self):
        small = ("scene.particles.alumina.count=40000", "output.profiles.from=0.005 s", "output.profiles.z=[5 mm]", "output.vtk=none")
        page = self.run_all(["spouted_bed/link", "spouted_bed/exact"], 0.02, *small)
        self.assertRegex(self.row(page[page.index("draft plates"):], "| link "), r"0\.02\d* s of 5 s")
        self.assertIn("in shares of its largest speed", page)
        self.assertRegex(page, r"above 5 % a run warns\): link \d+\.\d %, exact \d+\.\d %\.")
        self.assertTrue((self.page.parent / "pictures" / "spouted_bed.png").exists())


if __name__ == "__main__":
    unittest.main()
