"""Heat and an oxygen carrier in a whole run: budgets, files, restart, and what a case must not ask for."""
import csv
import glob
import os
import re
import unittest

from command import SMALL, CommandTest

HOT = (SMALL.replace("output: {", "output: {checkpoint: every 1 us, ").replace("viscosity: 1.79e-5 Pa s}", "viscosity: 1.79e-5 Pa s, temperature: 300 K}")
       .replace("count: 300}", "count: 300, temperature: 500 K, heat_capacity: 880 J/(kg K), conductivity: 20 W/(m K)}")
       .replace("velocity: 3 m/s}", "velocity: 3 m/s, temperature: 600 K}")
       .replace("  scaling: exact", "  scaling: exact\n  effects: [heat]")
       .replace("  patches:", "  walls:     {temperature: 400 K}\n  patches:"))
CARRIER = (SMALL.replace("viscosity: 1.79e-5 Pa s}", "viscosity: 1.79e-5 Pa s, fuel: 0}")
           .replace("count: 300}", "count: 300, conversion: 0, oxygen_capacity: 0.084}")
           .replace("velocity: 3 m/s}", "velocity: 3 m/s, fuel: 0.3}")
           .replace("  scaling: exact", "  scaling: exact\n  effects: [{id: oxygen_carrier, gas: CH4, temperature: 1173 K}]"))
METHANE_PER_OXYGEN = 16.043 / (4 * 15.999)


class Scalars(CommandTest):
    def rows(self, carrier, folder="out"):
        with open(self.path(folder + "/scalars.csv"), encoding="utf-8") as file:
            return [{key: float(value) if re.match(r"^[-+0-9.e]+$|^$", value or "x") and value else value for key, value in row.items()}
                    for row in csv.DictReader(file) if row["carrier"] == carrier]

    def run_well(self, text, *arguments):
        done = self.run_case(text, *arguments)
        self.assertEqual(done.returncode, 0, done.stderr + done.stdout)
        return re.search(r"state (\w+)", done.stdout)[1]

    # What crossed the inlet and the outlet, the walls and the particles adds up, to 1e-8 of what was exchanged.
    def test_a_hot_bed_closes_its_energy_budget(self):
        self.run_well(HOT)
        gas, solids = self.rows("gas")[-1], self.rows("particles")[-1]
        throughput = gas["in"] + abs(gas["from_particles"]) + abs(gas["from_walls"])
        self.assertGreater(throughput, 0)
        self.assertAlmostEqual(gas["gained"], gas["in"] - gas["out"] + gas["from_walls"] + gas["from_particles"], delta=1e-8 * throughput)
        self.assertAlmostEqual(solids["gained"], solids["from_walls"] - gas["from_particles"], delta=1e-8 * throughput)
        self.assertGreaterEqual(gas["lowest"], 300 - 1e-9)
        self.assertLessEqual(gas["highest"], 600 + 1e-9)
        frame = sorted(glob.glob(self.path("out/fluid/*.vti")))[-1]
        with open(frame, "rb") as file:
            self.assertIn(b"gas_temperature [K]", file.read())
        with open(sorted(glob.glob(self.path("out/particles/*.vtp")))[-1], "rb") as file:
            self.assertIn(b"temperature [K]", file.read())

    def test_the_methane_that_is_gone_has_taken_its_oxygen(self):
        self.run_well(CARRIER)
        gas, solids = self.rows("gas")[-1], self.rows("particles")[-1]
        self.assertGreater(solids["gained"], 0)
        self.assertAlmostEqual(-gas["from_particles"], solids["gained"] * METHANE_PER_OXYGEN, delta=1e-8 * gas["in"])
        self.assertAlmostEqual(gas["gained"], gas["in"] - gas["out"] + gas["from_particles"], delta=1e-8 * gas["in"])

    def test_a_resumed_hot_bed_ends_in_the_same_state(self):
        whole = self.run_well(HOT)
        with open(self.path("out/scalars.csv"), encoding="utf-8") as file:
            written = file.read()
        self.run_well(HOT, "--force", "--until", "5 ms")
        self.assertEqual(self.resume(), whole)
        with open(self.path("out/scalars.csv"), encoding="utf-8") as file:
            self.assertEqual(file.read(), written)

    # Whatever a run can write, the next one in its place finds and takes away.
    def test_force_leaves_no_file_of_the_earlier_run(self):
        self.run_well(HOT.replace("output: {", "output: {probes: {tap: {at: [10 mm, 5 mm, 20 mm]}}, "))
        everything = self.files("out")
        self.assertTrue({"scalars.csv", "probes.csv", "profiles.csv"} <= everything, everything)
        bare = re.sub("output: .*", "output: {vtk: none, monitors: every 1 ms, checkpoint: none}", SMALL)
        self.run_well(bare, "--force")
        self.assertEqual(self.command("run", self.path("case.yaml"), "-o", self.path("fresh")).returncode, 0)
        self.assertEqual(self.files("out"), self.files("fresh"))

    def files(self, folder):
        return {os.path.relpath(os.path.join(place, name), self.path(folder))
                for place, _, names in os.walk(self.path(folder)) for name in names}

    def resume(self):
        done = self.command("run", self.path("case.yaml"), "-o", self.path("out"), "--resume")
        self.assertEqual(done.returncode, 0, done.stderr + done.stdout)
        return re.search(r"state (\w+)", done.stdout)[1]

    def test_a_parcel_run_carries_heat_and_a_scaled_one_is_refused(self):
        self.assert_refused(self.run_case(HOT.replace("scaling: exact", "scaling: {id: terminal_velocity, geometry: 0.5}")), 2,
                            "models.scaling: terminal_velocity changes the gas, lengths or times, and heat does not keep pace",
                            "Use exact, parcel, bierwisch or coarse_grain")

    def test_a_temperature_without_heat_is_refused_with_the_effect_to_add(self):
        self.assert_refused(self.run_case(HOT.replace("effects: [heat]", "effects: []")), 2,
                            "scene.gas.temperature: no effect of this case has a temperature; heat has.",
                            "Add heat to models.effects, or remove this key.")

    def test_a_missing_heat_capacity_is_named(self):
        self.assert_refused(self.run_case(HOT.replace(", heat_capacity: 880 J/(kg K)", "")), 2,
                            "heat needs scene.particles.alumina.heat_capacity", "Add scene.particles.alumina.heat_capacity, in J/(kg K).")

    def test_the_porous_gas_has_no_viscosity_to_add_to(self):
        text = SMALL.replace("fluid: vans", "fluid: porous").replace("scaling: exact", "scaling: exact\n  effects: [subgrid_turbulence]")
        self.assert_refused(self.run_case(text), 2, "models.fluid: porous has no viscosity that subgrid_turbulence could add to.")


if __name__ == "__main__":
    unittest.main()
