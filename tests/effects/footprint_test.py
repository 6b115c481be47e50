#!/usr/bin/env python3
"""What nobody asks for costs nothing: the same case with all effect plugins installed and with none of them at all.

The program and its plugins are copied twice, once without effect plugins. Pipeline, fields with their bytes, and the bytes per
particle that a run reports are equal; instructions per gas step, counted by callgrind, within 0.1 %. The count takes a program
without AVX-512, which valgrind does not know, so it is not among the tests of a build for this machine:

    SIMILITUDE=build-portable/bin/similitude tests/effects/footprint_test.py"""

import json
import os
import pathlib
import re
import shutil
import subprocess
import tempfile
import unittest

PROGRAM = pathlib.Path(os.environ["SIMILITUDE"]).resolve()
STEPS = (20, 120)  # gas steps of the short and the long run
BY_THE_CLOCK = ("::copy_rows(", "::collect_touching(")
GAS_DT = 1e-4      # [s]
CASE = f"""similitude: 1
title: footprint
scene:
  domain:    {{size: [20 mm, 20 mm, 60 mm], cell: 5 mm}}
  gas:       {{density: 1.225 kg/m^3, viscosity: 1.79e-5 Pa s}}
  particles: {{alumina: {{diameter: 1 mm, density: 1040 kg/m^3, count: 500}}}}
  bed:       {{fill: lattice}}
  patches:
    inlet:  {{face: bottom, velocity: 0.5 m/s}}
    outlet: {{face: top, pressure: 0 Pa}}
models:
  drag: gidaspow
  contact: {{id: linear_spring, stiffness: 500 N/m, restitution: 0.74, friction: 0.2}}
  fluid: vans
  effects: []
time: {{end: 1 s, dt: 1e-5 s, gas_dt: {GAS_DT} s}}
output: {{checkpoint: none, vtk: none, monitors: every 1 s}}
"""


def installed(folder, with_effects):
    """A copy of the installation, linked where nothing differs."""
    (folder / "bin").mkdir(parents=True)
    shutil.copy(PROGRAM, folder / "bin")
    build = PROGRAM.parent.parent
    plugins = folder / "lib/similitude/plugins"
    plugins.mkdir(parents=True)
    for library in (build / "lib").glob("*.so*"):
        shutil.copy(library, folder / "lib", follow_symlinks=True)
    for plugin in (build / "lib/similitude/plugins").glob("*.so"):
        if with_effects or not plugin.name.startswith("effect_"):
            shutil.copy(plugin, plugins)
    return folder / "bin" / PROGRAM.name


class Footprint(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        root = pathlib.Path(self.folder.name)
        self.programs = {name: installed(root / name, name == "all") for name in ("all", "none")}
        self.case = root / "case.yaml"
        self.case.write_text(CASE)
        self.env = {}
        for name, program in self.programs.items():   # each with its own libsimilitude, beside which it looks for plugins
            self.env[program] = dict(os.environ, OMP_NUM_THREADS="1", OMP_WAIT_POLICY="passive", XDG_DATA_HOME=str(root), HOME=str(root),
                                     LD_LIBRARY_PATH=str(root / name / "lib"))
            self.env[program].pop("SIMILITUDE_PLUGIN_PATH", None)

    def tearDown(self):
        self.folder.cleanup()

    def said(self, program, *words):
        run = subprocess.run([program, *words], capture_output=True, text=True, env=self.env[program])
        self.assertEqual(run.returncode, 0, run.stdout + run.stderr)
        return run

    def ids(self, program):
        listed = json.loads(self.said(program, "plugins", "list", "--json").stdout)["plugins"]
        return {plugin["id"] for plugin in listed if plugin["kind"] == "effect"}

    def test_pipeline_fields_and_bytes_are_the_same(self):
        self.assertGreaterEqual(len(self.ids(self.programs["all"])), 5)
        self.assertEqual(self.ids(self.programs["none"]), set())
        pages = {name: json.loads(self.said(program, "check", self.case, "--json").stdout) for name, program in self.programs.items()}
        self.assertEqual(pages["all"]["pipeline"], pages["none"]["pipeline"])
        self.assertEqual(pages["all"]["fields"], pages["none"]["fields"])
        memory = {}
        for name, program in self.programs.items():
            said = self.said(program, "run", self.case, "-o", self.case.parent / f"out_{name}", "--until", f"{GAS_DT} s").stdout
            memory[name] = re.search(r"memory\s+(\d+) bytes per particle", said)[1]
            memory[name + " state"] = re.search(r"state (\w+)", said)[1]
        self.assertEqual(memory["all"], memory["none"])
        self.assertEqual(memory["all state"], memory["none state"])

    def instructions(self, program, steps, *keys):
        """Of a run, in the program, its library, its plugins and the mathematics library; not in the allocator, whose work
        depends on what the heap went through, and not for the copies that guards keep, which are taken by the clock."""
        out = self.case.parent / "counted"
        run = subprocess.run(["valgrind", "--tool=callgrind", f"--callgrind-out-file={out}.callgrind", program, "run", self.case, "-o", out,
                              "--force", "--until", f"{steps * GAS_DT} s", *keys], capture_output=True, text=True, env=self.env[program])
        self.assertEqual(run.returncode, 0, run.stdout + run.stderr + "valgrind knows no AVX-512: build with -DSIMILITUDE_MARCH=x86-64-v3")
        table = subprocess.run(["callgrind_annotate", "--threshold=100", f"{out}.callgrind"], capture_output=True, text=True, check=True).stdout
        own = str(program.parent.parent)
        return sum(int(count.replace(",", "")) for count, function, library in re.findall(r"^ *([\d,]+) \(.*?\) +(.*) \[(.*)\]$", table, re.M)
                   if (library.startswith(own) or "/libm.so" in library) and not any(name in function for name in BY_THE_CLOCK))

    def per_step(self, program, *keys):
        """Instructions of a gas step: the difference of a long and a short run, so that start-up drops out."""
        short, long = (self.instructions(program, steps, *keys) for steps in STEPS)
        return (long - short) / (STEPS[1] - STEPS[0])

    def test_instructions_per_step_are_the_same_within_a_thousandth(self):
        counted = {name: self.per_step(program) for name, program in self.programs.items()}
        counted["one configured"] = self.per_step(self.programs["all"], "--set", "models.effects=[virtual_mass]")
        print(f"instructions per gas step: {counted}")
        self.assertGreater(counted["none"], 1e6)
        self.assertLess(abs(counted["all"] / counted["none"] - 1), 1e-3)
        self.assertGreater(counted["one configured"] / counted["none"], 1.01)   # what is asked for is seen


if __name__ == "__main__":
    unittest.main()
