"""Every guard, tripped on purpose: what it says, and that the last good state can be seen and gone on from."""
import json
import os
import re
import unittest

from command import SMALL, CommandTest

TRIPWIRES = os.environ["SIMILITUDE_TRIPWIRES"]
ADVICE_OF_STATE = r"\n  The last good state, at t = ([0-9.e-]+) s, is the last frame of (\S+/particles\.pvd) and (\S+/fluid\.pvd), and (\S+\.h5)\.\n"


class Guards(CommandTest):
    def trip(self, text, message, *arguments):
        """The case stops with `message` (a pattern), and leaves frame and checkpoint of the step before."""
        stopped = self.run_case(text, *arguments, SIMILITUDE_PLUGIN_PATH=TRIPWIRES)
        self.assertEqual(stopped.returncode, 1, stopped.stderr)
        said = stopped.stderr[stopped.stderr.index("error: "):]
        self.assertRegex(said, "^error: " + message + ADVICE_OF_STATE + "$")
        time, particles, fluid, checkpoint = re.search(ADVICE_OF_STATE, said).groups()
        with open(self.path("out/manifest.json"), encoding="utf-8") as file:
            manifest = json.load(file)
        self.assertEqual(manifest["status"], "stopped")
        self.assertAlmostEqual(manifest["simulated_s"], float(time), delta=1e-5 * float(time))
        self.assertTrue(os.path.exists(checkpoint))
        for series in (particles, fluid):
            with open(series, encoding="utf-8") as file:
                frames = re.findall(r'timestep="([^"]+)" part="0" file="([^"]+)"', file.read())
            self.assertAlmostEqual(float(frames[-1][0]), float(time), delta=1e-5 * float(time) + 1e-12)
            self.assertTrue(os.path.getsize(self.path("out/" + frames[-1][1])) > 0)

        # The same step fails again in a run that goes on from there, and so in the same words; the state is as it was.
        again = self.run_case(text, *arguments, "--resume", SIMILITUDE_PLUGIN_PATH=TRIPWIRES)
        self.assertEqual(again.returncode, 1, again.stderr)
        self.assertEqual(again.stderr[again.stderr.index("error: "):], said)
        with open(self.path("out/manifest.json"), encoding="utf-8") as file:
            self.assertEqual(json.load(file)["state_hash"], manifest["state_hash"])
        return stopped, manifest

    def fluid(self, trip, steps=5):
        return SMALL.replace("fluid: vans", f"fluid: {{id: tripwire, trip: {trip}, steps: {steps}}}")

    def contact(self, trip):
        return SMALL.replace("{id: linear_spring, stiffness: 100 N/m, restitution: 0.74, friction: 0.2}",
                             f"{{id: tripwire, trip: {trip}}}")

    def test_overlap(self):
        _, manifest = self.trip(
            SMALL.replace("stiffness: 100 N/m", "stiffness: 0.02 N/m"),
            r"particle \d+ overlaps (a wall|particle \d+) by 3\d\.\d % of its diameter at \(.*\) mm, t = .* s: spheres no longer "
            r"mean anything there\.\n  The spring is too soft for these speeds or the step too long: raise models\.contact\.stiffness "
            r"\(the overlap falls with its square root\) or use time\.dt: auto\.", "--until", "1 s")
        self.assertGreater(manifest["simulated_s"], 0)

    def test_a_contact_law_that_complains(self):
        self.trip(self.contact("complaint"),
                  r"The contact law tripwire stopped the run for a contact in sub-step \d+: a contact is deeper than this tripwire",
                  "--until", "100 ms")

    def test_a_force_that_is_not_a_number(self):
        self.trip(self.contact("poison"),
                  r"Particle \d+ has a position or velocity that is not a finite number after sub-step \d+; it was last listed at "
                  r"\(.*\) m\.\n  Usually the time step is too long for the contact stiffness, or particles overlap at the start: "
                  r"compare time\.dt with the limits that `similitude check` prints\.", "--until", "100 ms")

    def test_a_drag_law_that_fails(self):
        self.trip(SMALL.replace("drag: gidaspow", "drag: {id: tripwire, slip: 0.2 m/s}"),
                  r'the drag law "tripwire" failed at .*: its K is -?nan kg/s where the gas fraction is .* and the slip .* m/s\.\n'
                  r"  Lengths are the simulated bed's\. Is the gas step too long, or the bed denser than the law allows\?", "--until", "100 ms")

    def test_a_gas_solver_that_fails(self):
        _, manifest = self.trip(self.fluid("failure"), r"the gas solver stopped at t = .* s: this gas has had enough\.\n  Give it a rest\.")
        self.assertGreater(manifest["simulated_s"], 0)

    def test_a_gas_solver_that_fails_in_the_first_step(self):
        _, manifest = self.trip(self.fluid("failure", 0), r"the gas solver stopped at t = .* s: this gas has had enough\.\n  Give it a rest\.")
        self.assertEqual(manifest["simulated_s"], 0)

    def test_a_pressure_equation_that_does_not_converge(self):
        self.trip(SMALL.replace("fluid: vans", "fluid: {id: vans, iterations: 1}"),
                  r"the gas solver stopped at t = .* s: the pressure equation did not converge: a cell's mass balance is off by .* of "
                  r"the throughput after 1 iterations \(wanted: 1e-07\)\. Usually the gas step is too long for the drag or the bed "
                  r"changed too much in it\.\n  Use a smaller time\.gas_dt, or raise models\.fluid\.iterations\.")

    def test_a_gas_that_is_not_finite(self):
        self.trip(self.fluid("not_finite"), r"the gas is not finite at t = .* s\.\n  Lower time\.gas_dt; if that does not help, look at "
                                            r"fluid\.pvd just before\.")

    def test_a_gas_step_beyond_a_cell(self):
        self.trip(self.fluid("courant"), r"the gas moves 1\.50 cells in one gas step \(CFL\) at t = .* s; more than 1 is unstable\.\n"
                                         r"  Lower time\.gas_dt by a factor 3\.0 or more\.")

    def test_gas_that_is_lost_on_the_way(self):
        self.trip(self.fluid("drift"), r"the gas in the bed and what flowed in and out differ by .* of what flowed or was there at t = .* s; "
                                       r"more than 0\.01 makes every gas flow doubtful\.\n  Lower the gas solver's tolerance or "
                                       r"time\.gas_dt\.", "--until", "50 ms")

    def test_mass_residual_of_a_step_warns_once(self):
        done = self.run_case(self.fluid("mass"), SIMILITUDE_PLUGIN_PATH=TRIPWIRES)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(done.stderr.count("warning: gas mass balance is off by 0.001 of the throughput in one step at t = "), 1)
        again = self.run_case(self.fluid("mass"), "--resume", "--until", "15 ms", SIMILITUDE_PLUGIN_PATH=TRIPWIRES)
        self.assertEqual(again.returncode, 0, again.stderr)
        self.assertNotIn("warning", again.stderr)

    def test_of_a_state_that_cannot_be_found_again_nothing_is_shown(self):
        stopped = self.run_case(self.fluid("no_way_back"), SIMILITUDE_PLUGIN_PATH=TRIPWIRES)
        self.assertEqual(stopped.returncode, 1)
        self.assertTrue(stopped.stderr.endswith("Give it a rest.\n"), stopped.stderr)
        with open(self.path("out/manifest.json"), encoding="utf-8") as file:
            manifest = json.load(file)
        self.assertEqual(manifest["status"], "stopped")
        self.assertIsNone(manifest["state_hash"])
        self.assertFalse(os.path.exists(self.path("out/profiles.csv")))
        self.assertEqual(os.listdir(self.path("out/particles")), ["particles_000000.vtp"])   # of the start

    def test_without_frames_and_checkpoints_nothing_is_written_and_nothing_promised(self):
        text = self.fluid("failure").replace("vtk: every 5 ms", "vtk: none, checkpoint: none")
        stopped = self.run_case(text, SIMILITUDE_PLUGIN_PATH=TRIPWIRES)
        self.assertEqual(stopped.returncode, 1)
        self.assertTrue(stopped.stderr.endswith("Give it a rest.\n"), stopped.stderr)
        self.assertFalse(os.path.exists(self.path("out/checkpoints")))
        self.assertFalse(os.path.exists(self.path("out/particles.pvd")))


if __name__ == "__main__":
    unittest.main()
