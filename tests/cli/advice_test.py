"""What the command says to somebody who typed something else than was meant: the whole text, and advice that works when obeyed."""
import json
import math
import os
import re
import unittest

from command import SMALL, SOURCE, CommandTest

STUDY = os.path.join(SOURCE, "configs", "studies", "drag.yaml")


FROM_FILE = SMALL.replace("{fill: lattice}", "{fill: file, file: grains.csv}").replace(", count: 300", "")   # of grains.csv


class CommandLine(CommandTest):
    def says(self, text, *words):
        done = self.command(*words)
        self.assertEqual(done.stderr, text)
        self.assertEqual(done.returncode, 2)

    def test_an_unknown_command_names_the_nearest(self):
        self.says('error: there is no command "rum". Did you mean "run"?\n', "rum", "case.yaml")
        self.says('error: there is no command "plugins infos". Did you mean "plugins info"?\n', "plugins", "infos")

    def test_a_command_like_no_other_lists_all(self):
        self.says('error: there is no command "xylophone".\n  Commands of similitude: run, check, scale, study, report, plugins, schema.\n', "xylophone")
        self.says("error: a command is missing.\n  Commands of similitude: run, check, scale, study, report, plugins, schema.\n")
        self.says("error: a command is missing.\n  Commands of similitude plugins: list, info, failures, new, doctor.\n", "plugins")

    def test_threads_are_counted_from_one(self):
        for command in ("run", "check", "scale"):
            self.says("error: --threads: 0 is not a number of threads. Write 1 or more.\n"
                      f"  similitude {command} --help says what it takes.\n", command, "case.yaml", "--threads", "0")
        self.says("error: --threads: two is not a number of threads. Write 1 or more.\n"
                  "  similitude run --help says what it takes.\n", "run", "case.yaml", "--threads", "two")

    def test_an_unknown_option_names_the_nearest(self):
        self.says("error: similitude run has no option --thread. Did you mean --threads?\n", "run", "case.yaml", "--thread", "1")
        self.says("error: similitude run has no option --thread. Did you mean --threads?\n", "run", "case.yaml", "--thread=1")

    def test_a_word_too_many_and_a_word_too_few(self):
        self.says('error: similitude check has no place for "b.yaml".\n  similitude check --help says what it takes.\n', "check", "a.yaml", "b.yaml")
        self.says("error: CASE is required.\n  similitude check --help says what it takes.\n", "check")


class Files(CommandTest):
    def test_a_folder_is_no_case(self):
        os.mkdir(self.path("configs"))
        text = "error: configs is a folder.\n  Give the case file in it.\n"
        for command in ("check", "run", "scale"):
            done = self.command(command, "configs")
            self.assertEqual((done.returncode, done.stderr), (2, text))
        self.write("similitude_study: 1\n", "configs/a_study.yaml")
        self.write(SMALL, "configs/quickstart.yaml")
        self.assertEqual(self.command("check", "configs").stderr,
                         "error: configs is a folder.\n  Give the case file in it, e.g. configs/quickstart.yaml.\n")

    def test_a_folder_is_no_study(self):
        os.mkdir(self.path("configs"))
        self.write(SMALL, "configs/a_case.yaml")
        self.write("similitude_study: 1\n", "configs/drag.yaml")
        done = self.command("study", "configs")
        self.assertEqual((done.returncode, done.stderr),
                         (2, "error: configs is a folder.\n  Give the study file in it, e.g. configs/drag.yaml.\n"))

    def test_a_folder_is_no_particle_file(self):
        os.mkdir(self.path("bed"))
        self.write("x,y,z\n", "bed/grains.csv")
        case = self.write(SMALL.replace("{fill: lattice}", "{fill: file, file: bed}"))
        folder = self.path("bed")
        done = self.command("check", case)
        self.assertEqual((done.returncode, done.stderr),
                         (2, f"error: {case}:7:33: scene.bed.file: {folder} is a folder.\n"
                             f"  Give the particle file in it, e.g. {folder}/grains.csv.\n"))

    def test_a_study_is_no_case(self):
        for command in ("check", "run", "scale"):
            done = self.command(command, STUDY)
            self.assertEqual(done.returncode, 2)
            self.assertTrue(done.stderr.endswith("\n  This looks like a study: similitude study runs it.\n"), done.stderr)

    def test_a_column_in_millimetres(self):
        self.write("x [mm],y,z\n1,2,3\n", "grains.csv")
        case = self.write(FROM_FILE)
        done = self.command("run", case, "-o", "out")
        self.assertEqual(done.returncode, 2)
        self.assertIn('column "x [mm]" is read in [m] only.\n  Write x [m], or x alone, with values in metres.\n', done.stderr)

    def test_a_file_of_grains_and_a_law_of_fewer(self):
        self.write("x,y,z\n0.002,0.005,0.002\n0.004,0.005,0.002\n", "grains.csv")
        for law in ("{id: link, n: 2}", "{id: parcel, n: 2}"):
            case = self.write(FROM_FILE.replace("scaling: exact", f"scaling: {law}"))
            done = self.command("check", case)
            self.assertEqual((done.returncode, done.stderr),
                             (2, f"error: {case}:7:14: scene.bed.file: {law[5:].split(',')[0]} simulates grains 2 times as large over the bed's size, "
                                 "and so 1 in place of the file's 2; a file says nothing of where they lie.\n"
                                 "  Write bed: {fill: settle} with a count or a height, or use models.scaling: exact.\n"))
        shrunk = self.write(FROM_FILE.replace("scaling: exact", "scaling: {id: glicksman_full, geometry: 0.25}"))
        self.assertEqual(self.command("check", shrunk).returncode, 0)

    def test_rows_of_other_densities_and_a_law_for_one(self):
        self.write("x,y,z,density\n0.002,0.005,0.002,1040\n0.004,0.005,0.002,2080\n", "grains.csv")
        case = self.write(FROM_FILE.replace("scaling: exact", "scaling: {id: glicksman_full, geometry: 0.25}"))
        self.assertEqual(self.command("check", case).stderr,
                         f"error: {case}:7:14: scene.bed.file: its grains of alumina have densities from 1040 to 2080 kg/m^3, but the scaling law "
                         "glicksman_full is for one particle density.\n  Give all rows one density, or use models.scaling: exact.\n")

    def test_a_row_lighter_than_the_gas(self):
        self.write("x,y,z,density\n0.002,0.005,0.002,1040\n0.004,0.005,0.002,950\n", "grains.csv")
        case = self.write(FROM_FILE.replace("1.225 kg/m^3, viscosity: 1.79e-5", "1000 kg/m^3, viscosity: 1e-3").replace("fluid: vans", "fluid: vans\n  effects: []"))
        self.assertIn("the simulated particles alumina, of 950 kg/m^3, are lighter than the gas of 1000 kg/m^3:", self.command("check", case).stderr)

    def test_a_stiffness_for_a_law_without_a_spring(self):
        case = self.write(SMALL.replace("{id: linear_spring, stiffness: 100 N/m, ", "{id: hertz_mindlin, youngs_modulus: 1 MPa, poisson_ratio: 0.3, ")
                          .replace("scaling: exact", "scaling: {id: link, n: 2, stiffness: 100 N/m}"))
        done = self.command("check", case)
        self.assertEqual((done.returncode, done.stderr),
                         (2, f"error: {case}:15:40: models.scaling.stiffness: the contact model hertz_mindlin has no spring stiffness that it could replace.\n"
                             "  Remove this key; a softer modulus is given to the contact model itself.\n"))


class Obeyed(CommandTest):
    """Advice is followed to the letter; what then comes is no complaint about the same thing."""

    def test_the_example_of_the_custom_law_works(self):
        case = self.write(SMALL)
        advice = re.search(r"custom: say its length, for example --law (\S+)", self.command("scale", case).stdout)
        self.assertEqual(advice.group(1), "custom:length=0.5,diameter=0.5")
        self.assertEqual(self.command("scale", case, "--law", advice.group(1)).returncode, 0)

    def test_the_example_of_a_law_is_not_the_real_bed(self):
        done = self.command("check", self.write(SMALL), "--set", "models.scaling=link")
        self.assertEqual(done.stderr, "error: --set: models.scaling: link needs the parameter n (Simulated over real particle diameter).\n"
                                      "  Write for example {id: link, n: 2}.\n")

    def test_the_example_of_a_contact_is_complete(self):
        done = self.command("check", self.write(SMALL), "--set", "models.contact=linear_spring")
        self.assertEqual(done.stderr, "error: --set: models.contact: linear_spring needs the parameter stiffness (Normal spring).\n"
                                      "  Write for example {id: linear_spring, stiffness: 500 N/m, restitution: 0.5, friction: 0.5}.\n")

    def test_no_cells_below_a_grain_are_advised(self):
        case = self.write(SMALL.replace("x: [7.5 mm, 12.5 mm]", "x: [7 mm, 12.5 mm]"))
        self.assertIn("\n  Use [5 mm, 12.5 mm] or [7.5 mm, 12.5 mm].\n", self.command("check", case, "--set", "scene.particles.alumina.diameter=2 mm").stderr)

    def test_one_friction_coefficient_in_fluent_dem(self):
        law = "models.contact={{id: fluent_dem, stiffness: 100 N/m, restitution: 0.74, mu_stick: 0.3, mu_glide: {}, v_glide: {} m/s}}"
        done = self.command("check", self.write(SMALL), "--set", law.format(0.2, 0))
        self.assertIn("v_glide: the friction must fall over some speed.\n  Give a v_glide above 0; for one friction coefficient set mu_glide "
                      "equal to mu_stick as well.\n", done.stderr)
        self.assertEqual(self.command("check", self.write(SMALL), "--set", law.format(0.3, 1)).returncode, 0)

    def test_what_chose_itself_is_printed_as_a_case_would_write_it(self):
        dense = ("scene.gas.density=150 kg/m^3", "scene.patches.spout.velocity=0.1 m/s")
        first = self.command("run", self.write(SMALL), "--until", "0.1 ms", *(word for setting in dense for word in ("--set", setting)))
        effects = re.search(r"\n  effects     auto took, with default parameters: (.*)\n", first.stdout).group(1)
        self.assertIn("{id: virtual_mass, coefficient: 0.5, crowding: single}", effects)
        again = self.command("run", self.write(SMALL), "--until", "0.1 ms", "--force", *(word for setting in (*dense, f"models.effects=[{effects}]")
                                                                                        for word in ("--set", setting)))
        self.assertEqual(re.search(r"\n  effects     (.*)\n", again.stdout).group(1), ", ".join(re.findall(r"id: (\w+)", effects)))
        self.assertEqual(re.search(r"\nstate .*", again.stdout).group(), re.search(r"\nstate .*", first.stdout).group())


class ImpossibleBeds(CommandTest):
    def check(self, *settings):
        arguments = [word for setting in settings for word in ("--set", setting)]
        done = self.command("check", self.write(SMALL), *arguments)
        self.assertEqual(done.returncode, 0, done.stderr)
        return done

    def pressed_in(self, *settings):
        """[-] of a diameter, as the warning says."""
        return float(re.search(r"presses .*in by about (\S+) % of a diameter; more than 5 % means little, and a run stops at 30 %\.",
                               self.check(*settings).stderr).group(1)) / 100

    def test_a_sound_bed_has_no_warnings(self):
        self.assertEqual(self.check().stderr, "")

    def test_an_inlet_near_the_speed_of_sound(self):
        self.assertIn("scene.patches.spout.velocity: 500 m/s is Mach 1.5; vans is incompressible, good to Mach 0.3 (100 m/s in air).\n"
                      "  Is the unit right?\n", self.check("scene.patches.spout.velocity=500 m/s").stderr)

    def test_sound_is_quick_in_a_light_gas_and_a_liquid_is_not_judged(self):
        for density in ("0.166 kg/m^3", "998 kg/m^3"):
            self.assertNotIn("Mach", self.check("scene.patches.spout.velocity=150 m/s", f"scene.gas.density={density}",
                                                "scene.particles.alumina.density=2500 kg/m^3").stderr)

    def test_an_inlet_that_sucks(self):
        self.assertIn("scene.patches.spout.velocity: -0.5 m/s sucks gas out of the bed.\n  Write it without the minus to blow in; where gas "
                      "only leaves, give the patch a pressure instead.\n", self.check("scene.patches.spout.velocity=-0.5 m/s").stderr)

    # The bed of 300 spheres of 1 mm on 20 x 10 mm, settled at a solids fraction of 0.58. Without damping, so that the formulas are
    # exact; two digits are printed.
    HEIGHT = 300 * math.pi / 6 * 1e-9 / (0.58 * 2e-4)
    MASS = 1040 * math.pi / 6 * 1e-9
    LOAD = 1040 * 9.81 * 0.58 * HEIGHT * 1e-6
    FALL = math.sqrt(2 * 9.81 * HEIGHT)

    def test_a_spring_that_a_fall_presses_in(self):
        seen = self.pressed_in("models.contact.stiffness=1 N/m", "models.contact.restitution=1")
        self.assertAlmostEqual(seen / (self.FALL * math.sqrt(self.MASS / 2 / 1) / 1e-3), 1, delta=0.05)

    def test_contacts_as_hard_as_advised_are_hard_enough(self):
        factor = re.search(r"\n  Take contacts (\S+) times as hard\.", self.check("models.contact.stiffness=2.5 N/m").stderr).group(1)
        self.assertEqual(self.check(f"models.contact.stiffness={2.5 * float(factor)} N/m").stderr, "")

    def test_a_spring_that_the_weight_presses_in(self):
        done = self.pressed_in("models.contact.stiffness=0.1 N/m", "models.contact.restitution=1")
        self.assertAlmostEqual(done / (self.LOAD / 0.1 / 1e-3), 1, delta=0.05)

    def test_hertzian_spheres_follow_their_own_law(self):
        modulus = 20e3   # [Pa], E; E* of two alike is E / (2 (1 - nu^2))
        effective, radius = modulus / (2 * (1 - 0.25 ** 2)), 0.25e-3
        law = f"{{id: hertz_mindlin, youngs_modulus: {modulus} Pa, poisson_ratio: 0.25, restitution: 1, friction: 0.2}}"
        deepest = (15 * self.MASS / 2 * self.FALL ** 2 / (16 * effective * math.sqrt(radius))) ** 0.4
        self.assertAlmostEqual(self.pressed_in(f"models.contact={law}") / (deepest / 1e-3), 1, delta=0.05)
        soft = law.replace(str(modulus), "200")
        at_rest = (0.75 * self.LOAD / (effective / 100 * math.sqrt(radius))) ** (2 / 3)
        self.assertAlmostEqual(self.pressed_in(f"models.contact={soft}") / (at_rest / 1e-3), 1, delta=0.05)


class Known(CommandTest):
    def test_both_reasons_of_a_limit_and_the_one_that_applies(self):
        hard = self.command("check", self.write(SMALL), "--set", "time.dt=1 ms").stderr
        self.assertIn("(contact time: stability of the integrator in a packed bed, (sqrt(1 + 4 zeta^2) - 2 zeta)/omega_0 of the lightest pair)", hard)
        advised = self.command("check", self.write(SMALL), "--set", "time.dt=20 us")
        self.assertIn("(contact time: 20 steps per contact of the lightest pair)", advised.stderr)
        gas = self.command("check", self.write(SMALL), "--set", "time.gas_dt=2 ms").stderr
        self.assertIn("(gas CFL: Courant number 1 at the fastest inlet's own speed)", gas)

    def test_gas_that_pressures_drive_has_a_step_that_the_run_survives(self):
        case = self.write(SMALL.replace("x: [7.5 mm, 12.5 mm], velocity: 3 m/s", "rest: true, pressure: 10 Pa").replace(", profiles: {z: [5 mm], from: 2 ms}", "")
                          .replace("  particles: {alumina: {diameter: 1 mm, density: 1040 kg/m^3, count: 300}}\n", "").replace("{fill: lattice}", "{fill: none}"))
        # Bernoulli's 4.04 m/s of 10 Pa in air: half a cell of 2.5 mm.
        self.assertIn("0.000309 s", self.command("check", case).stdout)
        self.assertEqual(self.command("run", case, "-o", "out").returncode, 0)

    def test_the_numbers_of_the_bed_and_the_threads_of_the_prediction(self):
        case = self.write(SMALL)
        text = self.command("check", case, "--threads", "1").stdout
        # u_mf and u_t as tests/similarity has them of the alumina bed, from tables.
        self.assertIn("\n  bed            300 x alumina, 8 Pa, about 1.4 mm settled, u_mf 0.333 m/s (Ergun), u_t 3.94 m/s (Schiller-Naumann), "
                      "cells of 2.5 diameters\n", text)
        self.assertIn("of wall time on this machine with 1 thread, of which\n", text)
        page = json.loads(self.command("check", case, "--threads", "2", "--json").stdout)
        self.assertEqual(page["predicted"]["threads"], 2)
        self.assertEqual(page["bed"]["classes"][0]["count"], 300)
        self.assertAlmostEqual(page["bed"]["weight_Pa"], 300 * (1040 - 1.225) * math.pi / 6 * 1e-9 * 9.81 / 2e-4)

    def test_a_prediction_is_of_the_threads_that_a_run_would_take(self):
        done = self.command("check", self.write(SMALL), "--json", OMP_NUM_THREADS="1")
        self.assertEqual(json.loads(done.stdout)["predicted"]["threads"], len(os.sched_getaffinity(0)))

    def test_scale_says_what_its_symbols_mean(self):
        text = self.command("scale", self.write(SMALL), "--law", "link:n=2", "--threads", "1").stdout
        self.assertIn("\nu0 = 0.75 m/s, mean superficial velocity; u_mf = ", text)
        self.assertIn("\nL = 20 mm, width; d = 1 mm, particle; depth = 10 mm, from front to back; slot = 5 mm, narrowest side of an inlet; "
                      "cell = 2.5 mm, smallest of the gas\n", text)
        for symbol in ("\nFr = ", "; St = ", "\nJ = ", "u_jet = 3 m/s, the fastest inlet\n", "\nsoftness = "):
            self.assertIn(symbol, text)
        self.assertIn("Wall times are for this machine with 1 thread: ", text)


if __name__ == "__main__":
    unittest.main()
