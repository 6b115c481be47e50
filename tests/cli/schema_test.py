"""`similitude schema` with the plugins that ship, against a real validator: it takes every case that ships, and complains of
each broken one at the place that the program itself names. Needs Debian's python3-jsonschema and python3-yaml."""

import glob
import json
import os
import re
import subprocess
import unittest

import jsonschema
import yaml
from jsonschema.exceptions import best_match

SIMILITUDE = os.environ["SIMILITUDE"]
SOURCE = os.environ["SIMILITUDE_SOURCE"]
HERE = os.path.dirname(os.path.abspath(__file__))


def read(path):
    with open(path, encoding="utf-8") as file:
        return yaml.safe_load(file)


def place_of(error):
    """Where the error is, as the program writes it; an unknown key is its own place."""
    place = [str(step) for step in error.absolute_path]
    if error.validator == "additionalProperties":
        place.append(re.search(r"'([^']+)' (was|were) unexpected", error.message).group(1))
    return ".".join(place)


def model_kinds(schema):
    return schema["properties"]["models"]["properties"]


class Schema(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        printed = subprocess.run([SIMILITUDE, "schema"], capture_output=True, text=True, check=True)
        cls.schema = json.loads(printed.stdout)
        jsonschema.Draft202012Validator.check_schema(cls.schema)
        cls.validator = jsonschema.Draft202012Validator(cls.schema)

    def complaint(self, case):
        """The most telling error of a case, among those of the model that its id means; None if it is valid."""
        errors = [self.inner(error, case) for error in self.validator.iter_errors(case)]
        return best_match(errors)

    def inner(self, error, case):
        """anyOf fails as a whole; the branch of the model that the case names says why."""
        if error.validator != "anyOf" or not isinstance(error.instance, dict) or "id" not in error.instance:
            return error
        for branch, schema in enumerate(error.validator_value):
            if schema.get("properties", {}).get("id", {}).get("const") == error.instance["id"]:
                inside = [one for one in error.context if one.relative_schema_path[0] == branch]
                return best_match(inside)
        return error

    def test_every_case_that_ships_is_valid(self):
        files = [path for pattern in ("configs/*.yaml", "configs/*/*.yaml", "tests/paraview/*.yaml")
                 for path in glob.glob(f"{SOURCE}/{pattern}")]
        cases = {path: case for path in files if "similitude" in (case := read(path))}
        self.assertGreaterEqual(len(cases), 20)
        for path, case in sorted(cases.items()):
            error = self.complaint(case)
            self.assertIsNone(error, f"{path}: {error and place_of(error)}: {error and error.message}")

    def test_a_third_partys_model_is_known_only_with_its_plugin(self):
        error = self.complaint(read(f"{SOURCE}/examples/01_drag_law/case.yaml"))
        self.assertEqual(place_of(error), "models.drag")

    def test_every_broken_case_is_refused_where_the_program_refuses_it(self):
        files = sorted(glob.glob(f"{HERE}/broken_cases/*.yaml"))
        self.assertGreaterEqual(len(files), 15)
        for path in files:
            with self.subTest(os.path.basename(path)):
                with open(path, encoding="utf-8") as file:
                    expected = file.readline().removeprefix("# complains of: ").strip()
                error = self.complaint(read(path))
                self.assertIsNotNone(error, "the schema takes it")
                self.assertEqual(place_of(error), expected, error.message)
                refused = subprocess.run([SIMILITUDE, "check", path], capture_output=True, text=True)
                self.assertIn(refused.returncode, (2, 3), refused.stdout)
                self.assertRegex(refused.stderr, rf"^error: .*{re.escape(os.path.basename(path))}:\d+:\d+: {re.escape(expected)}: ")

    def test_every_parameter_of_every_plugin_is_there_with_words(self):
        listed = json.loads(subprocess.run([SIMILITUDE, "plugins", "list", "--json"], capture_output=True, text=True, check=True).stdout)
        for plugin in listed["plugins"]:
            kind, name = plugin["kind"], plugin["id"]
            info = json.loads(subprocess.run([SIMILITUDE, "plugins", "info", name, "--json"], capture_output=True, text=True, check=True).stdout)
            parameters = next(one for one in info["plugins"] if one["kind"] == kind)["parameters"]
            section = model_kinds(self.schema)["effects" if kind == "effect" else kind]
            branches = section["anyOf"][1]["items"]["anyOf"] if kind == "effect" else section["anyOf"]
            branch = next(one for one in branches if one.get("properties", {}).get("id", {}).get("const") == name)
            self.assertEqual(branch["title"], plugin["title"])
            for parameter in parameters:
                row = branch["properties"][parameter["name"]]
                with self.subTest(f"{kind} {name} {parameter['name']}"):
                    self.assertIn(parameter["doc"].rstrip(".")[:40], row["description"])
                    if parameter["unit"] not in (None, "", "1"):
                        self.assertIn(f"[{parameter['unit']}]", row["description"])
                    if not parameter["required"] and parameter["default"] is not None:
                        self.assertIn("default", row)
                        jsonschema.Draft202012Validator(row).validate(row["default"])


if __name__ == "__main__":
    unittest.main()
