"""The quickstart spouts: a jet between the plates, a packed annulus beside them, nothing lost, nothing non-finite.

Run as a user runs it; judged on profiles.csv, monitors.csv and the VTK files it wrote."""
import csv
import json
import math
import os
import subprocess
import tempfile
import unittest
import xml.etree.ElementTree

import numpy
import vtk
from vtk.util.numpy_support import vtk_to_numpy

PLATES = (0.060, 0.090)   # [m], of the real bed
RUN_LIMIT_S = 600         # wall time, generous: what is tested is the regime


def read_csv(path):
    with open(path, encoding="utf-8", newline="") as file:
        return list(csv.DictReader(file))


class Quickstart(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory(prefix="similitude_quickstart_")
        cls.out = os.path.join(cls.folder.name, "out")
        case = os.path.join(os.environ["SIMILITUDE_SOURCE"], "configs", "quickstart.yaml")
        cls.done = subprocess.run([os.environ["SIMILITUDE"], "run", case, "-o", cls.out], capture_output=True, text=True,
                                  timeout=RUN_LIMIT_S, check=False)
        if cls.done.returncode != 0:
            raise AssertionError(cls.done.stdout[-2000:] + cls.done.stderr[-2000:])
        cls.profile = {}
        for row in read_csv(os.path.join(cls.out, "profiles.csv")):
            cls.profile.setdefault((row["sampler"], round(float(row["z"]), 4)), []).append(row)
        cls.monitors = read_csv(os.path.join(cls.out, "monitors.csv"))

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def last_frame(self, index, reader_type):
        entry = list(xml.etree.ElementTree.parse(os.path.join(self.out, index)).getroot().iter("DataSet"))[-1]
        reader = reader_type()
        reader.SetFileName(os.path.join(self.out, entry.get("file")))
        reader.Update()
        return reader.GetOutput()

    def means(self, sampler, z, low, high):
        """Means of the bins whose centres lie between low and high; empty bins are left out."""
        rows = self.profile[(sampler, z)]
        return [float(row["mean"]) for row in rows if low < float(row["x"]) < high and row["mean"]]

    def test_the_spout_rises_between_the_plates(self):
        self.assertGreater(max(self.means("vertical_velocity [m/s]", 0.1, *PLATES)), 0.5)

    def test_the_annulus_between_plate_and_wall_is_packed_and_slow_at_the_end(self):
        # Not the mean over the window: its first half still holds the bubble that the starting jet blew into the annulus.
        particles = self.last_frame("particles.pvd", vtk.vtkXMLPolyDataReader)
        place = vtk_to_numpy(particles.GetPoints().GetData())
        speed = numpy.linalg.norm(vtk_to_numpy(particles.GetPointData().GetArray("velocity [m/s]")), axis=1)
        diameter = vtk_to_numpy(particles.GetPointData().GetArray("diameter [m]"))
        bottom, top, depth = 0.04, 0.10, 0.02   # [m]
        for low, high in ((0.0, PLATES[0] - 0.001), (PLATES[1] + 0.001, 0.150)):
            inside = (place[:, 0] > low) & (place[:, 0] < high) & (place[:, 2] > bottom) & (place[:, 2] < top)
            solids = (math.pi / 6 * diameter[inside] ** 3).sum() / ((high - low) * depth * (top - bottom))
            self.assertGreater(solids, 0.5)
            self.assertLess(speed[inside].mean(), 0.1)

    def test_no_particle_is_lost(self):
        last = self.monitors[-1]
        self.assertEqual(float(last["particles [1]"]) + float(last["removed_particles [1]"]),
                         float(self.monitors[0]["particles [1]"]))
        # Mean superficial velocity is below the terminal velocity: nothing is carried over.
        self.assertEqual(float(last["removed_particles [1]"]), 0)

    def test_everything_is_finite_and_the_gas_balance_closes(self):
        for row in self.monitors:
            for name, value in row.items():
                if value:
                    self.assertTrue(math.isfinite(float(value)), name)
            self.assertLess(float(row["gas_mass_residual [1]"]), 1e-6)
            self.assertLess(float(row["largest_overlap [% of d]"]), 5)

    def test_the_window_is_told(self):
        self.assertRegex(self.done.stdout, r"vertical_velocity \[m/s\] at z = 0\.1 m, mean over 0\.400\d \.\.\. 0\.800\d s")   # to the gas step

    def test_timing_adds_up(self):
        with open(os.path.join(self.out, "timing.json"), encoding="utf-8") as file:
            timing = json.load(file)
        self.assertAlmostEqual(timing["simulated_s"], 0.8, delta=2e-4)
        self.assertAlmostEqual(timing["particle_steps_per_s"], timing["particle_steps"] / timing["wall_s"], delta=1e-6 * timing["particle_steps_per_s"])
        told = sum(stage["seconds"] for stage in timing["stages"])
        self.assertAlmostEqual(told, timing["wall_s"], delta=1e-9 * timing["wall_s"])
        for stage in timing["stages"]:
            self.assertGreaterEqual(stage["seconds"], 0, stage["name"])
            self.assertAlmostEqual(stage["share"], stage["seconds"] / timing["wall_s"], delta=1e-9, msg=stage["name"])

    def test_every_frame_reads_back_with_units_in_the_names(self):
        wanted = {"particles.pvd": (vtk.vtkXMLPolyDataReader, "GetPointData", {"velocity [m/s]", "diameter [m]", "material_diameter [m]"}),
                  "fluid.pvd": (vtk.vtkXMLImageDataReader, "GetCellData", {"gas_velocity [m/s]", "pressure [Pa]", "gas_fraction [1]"})}
        for index, (reader_type, data, names) in wanted.items():
            sets = xml.etree.ElementTree.parse(os.path.join(self.out, index)).getroot().iter("DataSet")
            times = []
            for entry in sets:
                times.append(float(entry.get("timestep")))
                reader = reader_type()
                reader.SetFileName(os.path.join(self.out, entry.get("file")))
                reader.Update()
                arrays = getattr(reader.GetOutput(), data)()
                self.assertLessEqual(names, {arrays.GetArrayName(i) for i in range(arrays.GetNumberOfArrays())})
                for name in names:
                    values = vtk_to_numpy(arrays.GetArray(name))
                    self.assertTrue((abs(values) < 1e6).all(), name)   # finite and of sane size in SI units
            self.assertGreaterEqual(len(times), 40)
            self.assertEqual(times, sorted(times))
            self.assertAlmostEqual(times[-1], 0.8, delta=2e-4)


if __name__ == "__main__":
    unittest.main()
