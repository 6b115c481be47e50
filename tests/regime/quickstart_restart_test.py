#!/usr/bin/env python3
"""The quickstart bed broken off half-way and resumed ends in the bits of the undisturbed run, under every contact law, gas
solver and scaling law that is installed, with another number of threads. Some minutes; the exact bed has 461 000 grains."""

import json
import os
import pathlib
import subprocess
import tempfile
import unittest

PROGRAM = os.environ["SIMILITUDE"]
CASE = pathlib.Path(os.environ["SIMILITUDE_SOURCE"]) / "configs/quickstart.yaml"
END, HALF = "4 ms", "2 ms"

PARAMETERS = {
    "linear_spring": "stiffness: 500 N/m, restitution: 0.74, friction: 0.2",
    "fluent_dem": "stiffness: 500 N/m, restitution: 0.74",
    "hertz_mindlin": "youngs_modulus: 5 MPa, poisson_ratio: 0.25, restitution: 0.74, friction: 0.2",
    "hertz_thornton": "youngs_modulus: 5 MPa, poisson_ratio: 0.25, restitution: 0.74, friction: 0.2",
    "prescribed": "velocity_z: 0.5 m/s",
    "terminal_velocity": "geometry: 0.25", "glicksman": "geometry: 0.25", "glicksman_full": "geometry: 0.25",
    "similarity": "geometry: 0.25, n: 0.7", "custom": "length: 0.25, diameter: 0.62",
    "link": "n: 3", "parcel": "n: 3", "coarse_grain": "n: 3", "bierwisch": "n: 3",
}


def installed(kind):
    said = subprocess.run([PROGRAM, "plugins", "list", "--json"], check=True, capture_output=True)
    return [plugin["id"] for plugin in json.loads(said.stdout)["plugins"] if plugin["kind"] == kind]


class QuickstartRestart(unittest.TestCase):
    def run_case(self, folder, setting, threads, *words):
        command = [PROGRAM, "run", CASE, "-o", folder, "--threads", str(threads), "--set", setting, "--set", "scene.bed.fill=lattice",
                   "--set", "output.vtk=none", *words]
        said = subprocess.run(command, capture_output=True, text=True)
        self.assertEqual(said.returncode, 0, said.stderr)
        return json.loads((pathlib.Path(folder) / "manifest.json").read_text())["state_hash"]

    def test_every_model_goes_on_with_the_same_bits(self):
        for kind in ("contact", "fluid", "scaling"):
            for model in installed(kind):
                given = f"{{id: {model}, {PARAMETERS[model]}}}" if model in PARAMETERS else model
                with self.subTest(kind=kind, model=model), tempfile.TemporaryDirectory() as scratch:
                    setting = f"models.{kind}={given}"
                    whole = self.run_case(scratch + "/whole", setting, 2, "--until", END)
                    half = self.run_case(scratch + "/parts", setting, 2, "--until", HALF)
                    self.assertNotEqual(half, whole)
                    self.assertEqual(self.run_case(scratch + "/parts", setting, 1, "--until", END, "--resume"), whole)
                    print(kind, model, whole, flush=True)


if __name__ == "__main__":
    unittest.main()
