"""Runs the command under test in a scratch folder."""
import os
import resource
import signal
import subprocess
import tempfile
import unittest

SIMILITUDE = os.environ["SIMILITUDE"]
SOURCE = os.environ["SIMILITUDE_SOURCE"]

# [s] A command under sanitizers beside another test on a shared machine takes minutes; one that takes this long hangs.
HUNG = 900

# A bed of a few hundred particles that runs in a second.
SMALL = """\
similitude: 1
title: a small bed
scene:
  domain:    {size: [20 mm, 10 mm, 40 mm], cell: 2.5 mm}
  gas:       {density: 1.225 kg/m^3, viscosity: 1.79e-5 Pa s}
  particles: {alumina: {diameter: 1 mm, density: 1040 kg/m^3, count: 300}}
  bed:       {fill: lattice}
  patches:
    spout:  {face: bottom, x: [7.5 mm, 12.5 mm], velocity: 3 m/s}
    outlet: {face: top, pressure: 0 Pa}
models:
  drag: gidaspow
  contact: {id: linear_spring, stiffness: 100 N/m, restitution: 0.74, friction: 0.2}
  fluid: vans
  scaling: exact
time: {end: 10 ms, dt: auto}
output: {vtk: every 5 ms, monitors: every 1 ms, profiles: {z: [5 mm], from: 2 ms}}
"""


class CommandTest(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory(prefix="similitude_cli_")
        self.addCleanup(self.folder.cleanup)

    def path(self, name):
        return os.path.join(self.folder.name, name)

    def write(self, text, name="case.yaml"):
        with open(self.path(name), "w", encoding="utf-8") as file:
            file.write(text)
        return self.path(name)

    def command(self, *arguments, largest_file=None, **environment):
        """Runs `similitude arguments…` in the scratch folder; no file may grow beyond `largest_file` bytes, as on a full disk."""
        def limit():
            resource.setrlimit(resource.RLIMIT_FSIZE, (largest_file, largest_file))
            signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
        return subprocess.run(
            [SIMILITUDE, *arguments], cwd=self.folder.name, capture_output=True, text=True, timeout=HUNG,
            env={**os.environ, "XDG_CACHE_HOME": self.path("cache"), "OMP_NUM_THREADS": "2", **environment}, check=False,
            preexec_fn=limit if largest_file else None, restore_signals=largest_file is None)

    def run_case(self, text, *arguments, **environment):
        return self.command("run", self.write(text), "-o", self.path("out"), *arguments, **environment)

    def assert_refused(self, done, status, *words):
        self.assertEqual(done.returncode, status, done.stderr + done.stdout)
        for word in words:
            self.assertIn(word, done.stderr)
