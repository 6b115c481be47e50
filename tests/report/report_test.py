"""report.html without a browser: when it is written, what it holds, and that losing it loses nothing else."""
import json
import os
import re
import shutil
import sys
import unittest

sys.path.insert(0, os.path.join(os.environ["SIMILITUDE_SOURCE"], "tests/cli"))
from command import SMALL, CommandTest   # noqa: E402


def numbers_of(page):
    return json.loads(re.search(r'<script type="application/json" id="numbers">(.*?)</script>', page, re.S).group(1))


class Report(CommandTest):
    def page(self, folder="out"):
        with open(self.path(folder + "/report.html"), encoding="utf-8") as file:
            return file.read()

    def test_a_run_writes_its_report_with_the_numbers_of_its_files(self):
        done = self.run_case(SMALL)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("report " + self.path("out/report.html"), done.stdout)
        page = self.page()
        numbers = numbers_of(page)
        self.assertEqual(numbers["kind"], "run")
        self.assertEqual(numbers["title"], "a small bed")
        run = numbers["runs"][0]
        for name in ("manifest", "timing", "audit"):
            with open(self.path(f"out/{name}.json"), encoding="utf-8") as file:
                self.assertEqual(run[name], json.load(file))
        self.assertGreater(len(run["monitors"]["columns"]["time [s]"]), 5)
        self.assertIn(run["view"]["pictures"], range(30, 82))   # eighty and the start, at most one for each step of the gas
        self.assertEqual([profile["sampler"] for profile in run["profiles"]], ["vertical_velocity [m/s]", "gas_fraction [1]"])

    def test_the_page_is_one_file_that_may_load_nothing(self):
        self.run_case(SMALL)
        page = self.page()
        self.assertIn("default-src 'none'", page)
        markup = re.sub(r"<script.*?</script>", "", page, flags=re.S)
        self.assertNotRegex(markup, r"\b(?:src|href)=[\"'](?!#|data:)")
        self.assertNotIn("@import", page)
        self.assertNotIn("url(", markup)
        self.assertIn("Permission is hereby granted, free of charge", page)   # the library's licence
        self.assertLess(len(page), 15e6)

    def test_it_is_made_anew_from_files_alone_and_gaps_are_no_error(self):
        self.run_case(SMALL)
        before = self.page()
        os.remove(self.path("out/report.html"))
        self.assertEqual(self.command("report", "out").returncode, 0)
        self.assertEqual(self.page(), before)
        for name in ("monitors.csv", "profiles.csv", "front_view.bin", "audit.json"):
            os.remove(self.path("out/" + name))
        self.write("{", "out/timing.json")
        self.assertEqual(self.command("report", "out").returncode, 0)
        run = numbers_of(self.page())["runs"][0]
        for name in ("monitors", "profiles", "view", "audit", "timing"):
            self.assertIsNone(run[name])

    def test_a_report_that_cannot_be_written_is_a_warning(self):
        self.run_case(SMALL)
        os.remove(self.path("out/report.html"))
        os.makedirs(self.path("out/report.html/in the way"))
        done = self.command("run", "case.yaml", "-o", "out", "--resume")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("warning: the report was not written: ", done.stderr)
        self.assertIn("state ", done.stdout)

    def test_a_folder_without_results_is_refused(self):
        os.mkdir(self.path("empty"))
        self.assert_refused(self.command("report", "empty"), 2,
                            "error: empty holds no finished study and no run.\n"
                            "  A report is made of the folder that similitude run or similitude study wrote.\n")

    def test_pictures_go_on_after_a_break_as_if_there_had_been_none(self):
        self.run_case(SMALL)
        with open(self.path("out/front_view.bin"), "rb") as file:
            whole = file.read()
        shutil.rmtree(self.path("out"))
        self.assertEqual(self.command("run", "case.yaml", "-o", "out", "--until", "4 ms").returncode, 0)
        with open(self.path("out/front_view.bin"), "ab") as file:
            file.write(b"half a picture")   # as a killed run leaves it
        self.assertEqual(self.command("run", "case.yaml", "-o", "out", "--resume").returncode, 0)
        with open(self.path("out/front_view.bin"), "rb") as file:
            self.assertEqual(file.read(), whole)

    def test_words_of_a_case_cannot_become_markup(self):
        done = self.run_case(SMALL.replace("title: a small bed", "title: \"</script><b>a & b</b>\""))
        self.assertEqual(done.returncode, 0, done.stderr)
        page = self.page()
        self.assertNotIn("<b>a & b", page)
        self.assertEqual(numbers_of(page)["title"], "</script><b>a & b</b>")


if __name__ == "__main__":
    unittest.main()
