"""`similitude plugins doctor` as a script meets it: exit status, both forms of the report."""

import json
import os
import subprocess
import unittest

SIMILITUDE = os.environ["SIMILITUDE"]
PATIENTS = os.environ["SIMILITUDE_PATIENTS"]
HEALTHY = os.environ["SIMILITUDE_HEALTHY"]


def doctor(*arguments):
    return subprocess.run([SIMILITUDE, "plugins", "doctor", *arguments], capture_output=True, text=True, timeout=120)


class Doctor(unittest.TestCase):
    def test_a_healthy_plugin_leaves_with_status_0(self):
        visit = doctor(HEALTHY)
        self.assertEqual(visit.returncode, 0, visit.stdout)
        self.assertTrue(visit.stdout.startswith(HEALTHY + "\n"))
        self.assertRegex(visit.stdout, r"\nHealthy: \d+ checks passed, 1 skipped\.\n$")
        self.assertEqual(visit.stderr, "")

    def test_an_ill_plugin_leaves_with_status_3(self):
        visit = doctor(f"{PATIENTS}/scaling_laws.so")
        self.assertEqual(visit.returncode, 3)
        self.assertRegex(visit.stdout, r"  FAIL     identity +with size = 1 the ratio of gas_viscosity is 1\.5\.\n")

    def test_the_report_is_also_json(self):
        visit = doctor(f"{PATIENTS}/scaling_laws.so", "--json")
        self.assertEqual(visit.returncode, 3)
        page = json.loads(visit.stdout)
        self.assertFalse(page["healthy"])
        self.assertEqual(set(page["findings"][0]), {"model", "check", "verdict", "seen", "advice"})
        self.assertEqual({finding["verdict"] for finding in page["findings"]}, {"ok", "FAIL", "skipped"})

    def test_a_file_that_is_not_there_is_a_finding(self):
        visit = doctor("/nowhere/drag_law.so")
        self.assertEqual(visit.returncode, 3)
        self.assertIn("it cannot be read: No such file or directory.", visit.stdout)


if __name__ == "__main__":
    unittest.main()
