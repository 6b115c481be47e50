#!/usr/bin/env python3
"""`similitude check` judges eight scenes as expected.csv says, which was worked out by hand from the sources that it names.

Values are compared to two digits. What no row speaks of is a mistake, as is a row whose effect is not there."""

import csv
import json
import os
import pathlib
import subprocess
import unittest

PROGRAM = os.environ["SIMILITUDE"]
HERE = pathlib.Path(__file__).resolve().parent


def expected():
    with open(HERE / "expected.csv", newline="") as file:
        rows = list(csv.DictReader(file))
    return {(row["scene"], row["effect"]): row for row in rows}


def two_digits(effect):
    """JSON knows neither infinity nor what is not known: both are null, and `because` says which."""
    if effect["value"] is not None:
        return f"{effect['value']:.2g}"
    return "unknown" if f"{effect['group']} = unknown" in effect["because"] else "inf"


class Relevance(unittest.TestCase):
    def test_eight_scenes(self):
        table = expected()
        seen = set()
        for case in sorted(HERE.glob("*.yaml")):
            said = subprocess.run([PROGRAM, "check", case, "--json"], capture_output=True, text=True)
            self.assertEqual(said.returncode, 0, f"{case.stem}: {said.stdout}{said.stderr}")
            for effect in json.loads(said.stdout)["effects"]:
                key = (case.stem, effect["id"])
                seen.add(key)
                with self.subTest(scene=key[0], effect=key[1]):
                    self.assertIn(key, table, "no row of expected.csv speaks of it")
                    row = table[key]
                    found = (effect["group"], two_digits(effect), effect["verdict"])
                    self.assertEqual(found, (row["group"], row["value"], row["verdict"]))
                    self.assertEqual(effect["chosen"], row["verdict"] == "needed", "effects: auto follows the verdicts")
        self.assertEqual({key for key in table if key not in seen}, set())


if __name__ == "__main__":
    unittest.main()
