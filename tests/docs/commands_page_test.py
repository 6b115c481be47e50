#!/usr/bin/env python3
"""docs/reference/commands.md tells every command, every option that --help prints, and every key of check's and scale's JSON."""
import json
import os
import pathlib
import re
import subprocess
import tempfile
import unittest

PROGRAM = os.environ["SIMILITUDE"]
SOURCE = pathlib.Path(os.environ["SIMILITUDE_SOURCE"])
PAGE = (SOURCE / "docs" / "reference" / "commands.md").read_text(encoding="utf-8")
PLUGINS = ("list", "info", "failures", "new", "doctor")
CASE = """\
similitude: 1
scene:
  domain:    {size: [20 mm, 10 mm, 40 mm], cell: 2.5 mm}
  gas:       {density: 1.225 kg/m^3, viscosity: 1.79e-5 Pa s}
  particles: {glass: {diameter: 1 mm, density: 2500 kg/m^3, count: 100}}
  patches:
    spout:  {face: bottom, x: [7.5 mm, 12.5 mm], velocity: 3 m/s}
    outlet: {face: top, pressure: 0 Pa}
models: {drag: gidaspow, contact: {id: linear_spring, stiffness: 100 N/m, restitution: 0.74, friction: 0.2}, fluid: vans}
time: {end: 1 ms}
"""


def asked(*words):
    return subprocess.run([PROGRAM, *words], check=True, capture_output=True, text=True).stdout


def section(command):
    """Of the page, from its heading to the next."""
    return re.search(rf"^## {command}\n(.*?)(?=^## |\Z)", PAGE, re.MULTILINE | re.DOTALL)[1]


def keys_of(page):
    """All keys of the objects in a JSON value, but names that a case gives."""
    if isinstance(page, list):
        return set().union(*map(keys_of, page))
    if not isinstance(page, dict):
        return set()
    return set(page).union(*(keys_of(value) for key, value in page.items()))


class CommandsPage(unittest.TestCase):
    def assert_told(self, words, text):
        self.assertEqual([word for word in sorted(words) if not re.search(rf"(?<![\w-]){re.escape(word)}(?![\w-])", text)], [])

    def test_every_command_has_its_section(self):
        commands = re.findall(r"^  (\w+) ", asked("--help").split("Subcommands:")[1], re.MULTILINE)
        self.assertEqual(commands, re.findall(r"^## (\w+)$", PAGE, re.MULTILINE))
        self.assertEqual(re.findall(r"^  (\w+) ", asked("plugins", "--help").split("Subcommands:")[1], re.MULTILINE), list(PLUGINS))

    def test_every_option_is_told(self):
        for words in [(name,) for name in re.findall(r"^## (\w+)$", PAGE, re.MULTILINE)] + [("plugins", name) for name in PLUGINS]:
            with self.subTest(command=" ".join(words)):
                options = set(re.findall(r"--[a-z]+", asked(*words, "--help"))) - {"--help"}
                self.assert_told(options, section(words[0]))

    def test_every_key_of_json_is_told(self):
        with tempfile.TemporaryDirectory() as folder:
            case = pathlib.Path(folder) / "case.yaml"
            case.write_text(CASE, encoding="utf-8")
            self.assert_told(keys_of(json.loads(asked("check", case, "--threads", "1", "--json"))), section("check"))
            strategy = json.loads(asked("scale", case, "--law", "link:n=2", "--threads", "1", "--json"))["strategies"][0]
        group = next(iter(strategy.pop("groups").values()))
        self.assert_told({"strategies", "groups"} | keys_of(strategy) | keys_of(group), section("scale"))
        self.assert_told(keys_of(json.loads(asked("plugins", "info", "gidaspow", "--json"))), section("plugins"))


if __name__ == "__main__":
    unittest.main()
