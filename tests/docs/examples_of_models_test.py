#!/usr/bin/env python3
"""The **Example.** of every plugin's README is typed into a case, and `similitude check` accepts it. Keys of the scene that
stand beside it in backquotes, `scene.gas.temperature: 600 K`, are set."""

import os
import pathlib
import re
import subprocess
import tempfile
import unittest

PROGRAM = os.environ["SIMILITUDE"]
PLUGINS = pathlib.Path(os.environ["SIMILITUDE_SOURCE"]) / "plugins"

CASE = """similitude: 1
scene:
  domain:    {size: [60 mm, 20 mm, 200 mm], cell: 5 mm}
  gas:       {density: 1.225 kg/m^3, viscosity: 1.79e-5 Pa s}
  particles: {alumina: {diameter: 1 mm, density: 1040 kg/m^3, count: 5000}}
  patches:
    spout:  {face: bottom, x: [25 mm, 35 mm], velocity: 5 m/s}
    outlet: {face: top, pressure: 0 Pa}
models:
MODELS
time: {end: 1 ms}
"""
MODELS = {"drag": "drag: gidaspow", "contact": "contact: {id: linear_spring, stiffness: 500 N/m, restitution: 0.74, friction: 0.2}",
          "fluid": "fluid: vans", "scaling": "scaling: exact"}


class ExamplesOfModels(unittest.TestCase):
    def test_every_example_is_a_case(self):
        for readme in sorted(PLUGINS.glob("*/*/README.md")):
            kind = readme.parts[-3]
            with self.subTest(plugin="/".join(readme.parts[-3:-1])):
                found = re.search(r"\*\*Example\.\*\*\s*`([^`]+)`", readme.read_text())
                self.assertIsNotNone(found, "**Example.** is followed by a line of a case in backquotes")
                models = MODELS | {kind: found[1]}
                with tempfile.TemporaryDirectory() as folder:
                    case = pathlib.Path(folder) / "case.yaml"
                    case.write_text(CASE.replace("MODELS", "\n".join("  " + line for line in models.values())))
                    beside = readme.read_text().split("**Example.**")[1].split("\n\n")[0]
                    keys = [f"--set={key}={value}" for key, value in re.findall(r"`(scene\.[^`:]+): ([^`]+)`", beside)]
                    said = subprocess.run([PROGRAM, "check", case, *keys], capture_output=True, text=True)
                self.assertEqual(said.returncode, 0, said.stdout + said.stderr)


if __name__ == "__main__":
    unittest.main()
