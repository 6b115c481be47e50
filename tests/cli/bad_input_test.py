"""Bad input gets a clear error, the right exit status, and leaves nothing half-written."""
import os
import unittest

from command import SMALL, CommandTest


class BadInput(CommandTest):
    def refuse(self, old, new, status, *words):
        """The small case with `old` replaced by `new` is refused, and no folder of results appears."""
        self.assertIn(old, SMALL)
        self.assert_refused(self.run_case(SMALL.replace(old, new)), status, *words)
        self.assertFalse(os.path.exists(self.path("out")))

    def test_unknown_key_names_the_nearest(self):
        self.refuse("density: 1.225", "densty: 1.225", 2, "case.yaml:5:", "densty", "density")

    def test_wrong_unit_says_which_dimension_is_wanted(self):
        self.refuse("velocity: 3 m/s", "velocity: 3 mm", 2, "case.yaml:9:", "velocity")

    def test_missing_unit(self):
        self.refuse("velocity: 3 m/s", "velocity: 3", 2, "case.yaml:9:", "unit")

    def test_a_value_that_no_step_can_follow(self):
        self.refuse("velocity: 3 m/s", "velocity: 1e308 m/s", 2, "case.yaml:", "time.dt: steps of 0 s never come to the end at", "gas CFL",
                    "A value of the case is far from what can be meant: is its unit right?")
        self.refuse("dt: auto", "dt: 1e-300 s", 2, "case.yaml:", "time.dt: steps of 1e-300 s never come to the end at")

    def test_missing_case_file(self):
        self.assert_refused(self.command("run", "nowhere.yaml"), 2, "nowhere.yaml")

    def test_missing_particle_file(self):
        self.refuse("{fill: lattice}", "{fill: file, file: nowhere.csv}", 2, "nowhere.csv")

    def test_negative_diameter(self):
        self.refuse("diameter: 1 mm", "diameter: -1 mm", 2, "case.yaml:6:", "diameter")

    def test_patch_outside_its_face(self):
        self.refuse("x: [7.5 mm, 12.5 mm]", "x: [7.5 mm, 22.5 mm]", 2, "case.yaml:9:", "spout")

    def test_patch_off_the_cell_faces_names_the_nearest(self):
        self.refuse("x: [7.5 mm, 12.5 mm]", "x: [7 mm, 12.5 mm]", 2, "case.yaml:9:", "7 mm is not on a cell face", "7.5 mm")

    def test_overlapping_patches(self):
        self.refuse("    outlet:", "    second: {face: bottom, x: [10 mm, 15 mm], velocity: 1 m/s}\n    outlet:", 2, "spout", "second")

    def test_bed_higher_than_the_domain(self):
        self.refuse("count: 300", "count: 300000", 2, "higher than the domain")

    def test_time_step_beyond_the_hard_limit_says_what_fits(self):
        self.refuse("dt: auto", "dt: 1 ms", 2, "case.yaml:", "time.dt", "beyond the hard limit", "auto")

    def test_contact_times_without_an_impact_speed(self):
        case = SMALL.replace("  bed:       {fill: lattice}", "  bed:       {fill: lattice}\n  gravity:   0 m/s^2")
        case = case.replace("linear_spring, stiffness: 100 N/m,", "hertz_mindlin, youngs_modulus: 1 MPa, poisson_ratio: 0.25,")
        self.assert_refused(self.run_case(case), 2, "time.dt: contact times of this law depend on the impact speed",
                            "Give time.dt, e.g. time.dt: 1e-7 s.")

    def test_unknown_model_names_the_nearest(self):
        self.refuse("drag: gidaspow", "drag: gidaspo", 3, "gidaspo", "Did you mean", "gidaspow")

    def test_unknown_parameter_of_a_model(self):
        self.refuse("friction: 0.2", "fricton: 0.2", 2, "fricton", "friction")

    def test_parameter_outside_its_range(self):
        self.refuse("restitution: 0.74", "restitution: 1.4", 2, "restitution")

    def test_output_folder_already_used(self):
        case = self.write(SMALL)
        self.assertEqual(self.command("run", case, "-o", "out", "--until", "1 ms").returncode, 0)
        again = self.command("run", case, "-o", "out", "--until", "1 ms")
        self.assert_refused(again, 2, "--force")
        self.assertEqual(self.command("run", case, "-o", "out", "--until", "1 ms", "--force").returncode, 0)

    def test_output_folder_not_writable(self):
        self.write("", "plain_file")
        self.assert_refused(self.command("run", self.write(SMALL), "-o", "plain_file/out"), 2, "plain_file")

    def test_plugin_of_another_abi_is_named_under_the_missing_model(self):
        os.mkdir(self.path("plugins"))
        self.write("not a library", "plugins/drag_mine.so")
        done = self.run_case(SMALL.replace("drag: gidaspow", "drag: mine"), SIMILITUDE_PLUGIN_PATH=self.path("plugins"))
        self.assert_refused(done, 3, "mine", "drag_mine.so", "plugins failures")

    def test_unknown_option_and_no_subcommand(self):
        self.assertEqual(self.command("run", "--nonsense").returncode, 2)
        self.assertEqual(self.command().returncode, 2)


if __name__ == "__main__":
    unittest.main()
