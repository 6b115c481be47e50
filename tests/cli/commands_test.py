"""What each subcommand prints and writes."""
import csv
import glob
import json
import math
import os
import pathlib
import re
import shutil
import signal
import subprocess
import sys
import time
import unittest

from command import HUNG, SIMILITUDE, SMALL, SOURCE, CommandTest


def shipped_cases():
    """Paths of configs/**/*.yaml but for studies and data of another kind."""
    paths = sorted(pathlib.Path(SOURCE, "configs").rglob("*.yaml"))
    return [str(path) for path in paths if re.search("^similitude: ", path.read_text(encoding="utf-8"), re.MULTILINE)]


class Run(CommandTest):
    def test_writes_the_promised_files(self):
        done = self.run_case(SMALL)
        self.assertEqual(done.returncode, 0, done.stderr)
        for name in ("manifest.json", "particles.pvd", "fluid.pvd", "monitors.csv", "profiles.csv", "timing.json", "view.py"):
            self.assertTrue(os.path.getsize(self.path("out/" + name)) > 0, name)
        with open(self.path("out/manifest.json"), encoding="utf-8") as file:
            manifest = json.load(file)
        self.assertEqual(manifest["status"], "done")
        self.assertEqual(len(manifest["state_hash"]), 32)
        self.assertIn(manifest["state_hash"], done.stdout)
        with open(self.path("out/timing.json"), encoding="utf-8") as file:
            timing = json.load(file)
        self.assertEqual(set(timing), {"wall_s", "simulated_s", "particle_steps", "particle_steps_per_s", "stages"})
        self.assertAlmostEqual(sum(stage["share"] for stage in timing["stages"]), 1, places=6)
        with open(self.path("out/monitors.csv"), encoding="utf-8", newline="") as file:
            rows = list(csv.DictReader(file))
        self.assertGreaterEqual(len(rows), 10)

    def test_gives_the_same_state_for_any_number_of_threads_and_any_output(self):
        hashes = set()
        for threads, vtk in (("1", "every 5 ms"), ("2", "every 1 ms"), ("3", "none"), ("4", "every 5 ms")):
            case = self.write(SMALL.replace("vtk: every 5 ms", "vtk: " + vtk))
            done = self.command("run", case, "-o", "out" + threads, "--threads", threads)
            self.assertEqual(done.returncode, 0, done.stderr)
            with open(self.path(f"out{threads}/manifest.json"), encoding="utf-8") as file:
                hashes.add(json.load(file)["state_hash"])
        self.assertEqual(len(hashes), 1)

    def test_gives_the_same_state_whatever_is_sampled_and_wherever_plugins_are_found(self):
        plugins = os.path.join(os.path.dirname(os.path.dirname(SIMILITUDE)), "lib", "similitude", "plugins")
        os.mkdir(self.path("near"))
        for name in ("fluid_vans.so", "drag_gidaspow.so"):
            shutil.copy(os.path.join(plugins, name), self.path("near"))
        hashes = set()
        for folder, text, environment in (
                ("sampled", SMALL, {}),
                ("unsampled", SMALL.replace(", profiles: {z: [5 mm], from: 2 ms}", "").replace("monitors: every 1 ms", "monitors: every 1 s"), {}),
                ("from_the_environment", SMALL, {"SIMILITUDE_PLUGIN_PATH": self.path("near")}),
                ("from_the_case", "plugin_paths: [near]\n" + SMALL, {"SIMILITUDE_PLUGIN_PATH": plugins})):
            done = self.command("run", self.write(text), "-o", folder, **environment)
            self.assertEqual(done.returncode, 0, done.stderr)
            with open(self.path(folder + "/manifest.json"), encoding="utf-8") as file:
                hashes.add(json.load(file)["state_hash"])
        self.assertEqual(len(hashes), 1)

    def test_ends_cleanly_when_interrupted(self):
        case = self.write(SMALL.replace("end: 10 ms", "end: 100 s"))
        with subprocess.Popen([SIMILITUDE, "run", case, "-o", self.path("out")], stdout=subprocess.DEVNULL,
                              stderr=subprocess.DEVNULL) as process:
            deadline = time.monotonic() + 60
            while not os.path.exists(self.path("out/monitors.csv")) and time.monotonic() < deadline:
                time.sleep(0.05)
            time.sleep(0.5)
            process.send_signal(signal.SIGINT)
            self.assertEqual(process.wait(timeout=HUNG), 130)
        with open(self.path("out/manifest.json"), encoding="utf-8") as file:
            self.assertEqual(json.load(file)["status"], "interrupted")
        self.assertTrue(os.path.exists(self.path("out/profiles.csv")))


class Check(CommandTest):
    def test_json_has_the_promised_keys(self):
        done = self.command("check", self.write(SMALL), "--json")
        self.assertEqual(done.returncode, 0, done.stderr)
        page = json.loads(done.stdout)
        self.assertEqual(set(page), {"pipeline", "fields", "bed", "time_steps", "effects", "predicted"})
        self.assertEqual(set(page["fields"][0]), {"name", "bytes_per_item", "items", "because"})
        self.assertTrue(any(limit["binding"] for limit in page["time_steps"]["limits"]))
        self.assertGreater(page["predicted"]["particle_steps"], 0)

    def test_frictionless_spheres_have_neither_history_nor_rotation(self):
        page = json.loads(self.command("check", self.write(SMALL.replace("friction: 0.2", "friction: 0")), "--json").stdout)
        names = " ".join(field["name"] for field in page["fields"])
        self.assertNotIn("angular_velocity", names)
        self.assertNotIn("tangential", names)

    def test_pairs_of_materials_are_printed_where_they_differ(self):
        pairs = SMALL.replace("friction: 0.2}", "friction: 0.2, pair: {alumina-alumina: {}, alumina-wall: {friction: 0.4}}}")
        case = self.write(pairs)
        self.assertIn("  alumina-wall                    friction 0.4\n", self.command("check", case).stdout)
        override = ("--set", "models.contact.pair.alumina-wall.friction=0.3")
        page = json.loads(self.command("check", case, "--json", *override).stdout)
        self.assertEqual(page["contact_pairs"], {"alumina-alumina": {"friction": "0.2"}, "alumina-wall": {"friction": "0.3"}})

    def test_shipped_cases_are_right(self):
        cases = shipped_cases()
        self.assertGreaterEqual(len(cases), 4)
        for case in cases:
            with self.subTest(case=case):
                done = self.command("check", case)
                self.assertEqual(done.returncode, 0, done.stderr)
                self.assertIn("predicted", done.stdout)


# A ball thrown at the floor; its row is smaller than its class.
BALL = """\
similitude: 1
title: a small particle of a large class
scene:
  domain:    {size: [20 mm, 20 mm, 20 mm], cell: 5 mm}
  gas:       {density: 1.2e-6 kg/m^3, viscosity: 1.8e-12 Pa s}
  particles: {ball: {diameter: 1 mm, density: 2500 kg/m^3}}
  bed:       {fill: file, file: ball.csv}
models:
  drag: schiller_naumann
  contact: {id: linear_spring, stiffness: 500 N/m, restitution: 0.5, friction: 0}
  fluid: prescribed
  scaling: exact
  effects: []
time:   {end: 40 ms, dt: auto}
output: {vtk: none, monitors: every 2 ms, checkpoint: none}
"""


class BedFromAFile(CommandTest):
    def setUp(self):
        super().setUp()
        self.write("x,y,z,vz,diameter\n0.01,0.01,0.001,-0.1,0.00011\n", "ball.csv")

    # The bed's path is part of the resolved case, which check, manifest, checkpoints and report hold as JSON.
    def test_may_lie_in_a_folder_named_in_latin_1(self):
        folder = os.fsencode(self.path("caf")) + b"\xe9"
        os.mkdir(folder)
        shutil.copy(os.fsencode(self.path("ball.csv")), folder)
        case = os.fsdecode(folder + b"/case.yaml")
        shutil.copy(self.write(BALL.replace("checkpoint: none", "checkpoint: every 1 h")), case)
        for arguments in (("check", case, "--json"), ("scale", case, "--json"), ("run", case, "-o", self.path("out"), "--until", "1 ms"),
                          ("run", case, "-o", self.path("out"), "--until", "2 ms", "--resume")):
            done = self.command(*arguments)
            self.assertEqual(done.returncode, 0, done.stderr)

    def test_steps_follow_its_smallest_row(self):
        done = self.run_case(BALL)
        self.assertEqual(done.returncode, 0, done.stderr)
        with open(self.path("out/monitors.csv"), encoding="utf-8", newline="") as file:
            rows = list(csv.DictReader(file))
        # It lands with sqrt(0.1^2 + 2 g 0.945 mm) = 0.17 m/s and leaves with half of it.
        mass = 2500 * math.pi / 6 * 0.00011**3
        speeds = [math.sqrt(2 * float(row["kinetic_energy [J]"]) / mass) for row in rows]
        self.assertLess(max(speeds), 0.17)
        self.assertLess(max(speeds[8:]), 0.09)   # from 16 ms: after the landing at 7 ms

    def test_a_step_beyond_what_its_smallest_row_bears_is_refused(self):
        done = self.command("check", self.write(BALL), "--json")
        self.assertEqual(done.returncode, 0, done.stderr)
        contact = json.loads(done.stdout)["time_steps"]["limits"][0]
        self.assertEqual(contact["name"], "contact time")
        # As if the ball were of this size by its class.
        own = self.command("check", self.write(BALL.replace("diameter: 1 mm", "diameter: 0.11 mm")), "--json")
        self.assertAlmostEqual(json.loads(own.stdout)["time_steps"]["limits"][0]["hard"] / contact["hard"], 1, places=9)
        done = self.command("check", self.write(BALL), "--set", f"time.dt={1.01 * contact['hard']} s")
        self.assert_refused(done, 2, "is beyond the hard limit of", "(contact time: stability of the integrator in a packed bed, ")

    def test_is_counted_before_it_is_judged(self):
        self.write("x,y,z\n" + "".join(f"{(0.5 + i) / 1e3},{(0.5 + j) / 1e3},{(0.5 + k) / 1e3}\n"
                                       for i in range(10) for j in range(10) for k in range(10)), "ball.csv")
        case = BALL.replace("effects: []", "effects: [{id: rolling_friction, coefficient: 0.1}]").replace("end: 40 ms", "end: 1 ms").replace(
            "friction: 0}", "friction: 0.3}")
        done = self.command("check", self.write(case), "--json")
        self.assertEqual(done.returncode, 0, done.stderr)
        page = json.loads(done.stdout)
        self.assertGreater(page["predicted"]["particle_steps"], 1000)
        self.assertEqual({field["items"] for field in page["fields"] if field["name"].startswith("particle.")}, {1000})
        # As the same particles on a lattice.
        lattice = case.replace("fill: file, file: ball.csv", "fill: lattice").replace("2500 kg/m^3", "2500 kg/m^3, count: 1000")
        done = self.command("check", self.write(lattice), "--json")
        self.assertEqual(done.returncode, 0, done.stderr)
        for one, other in zip(page["effects"], json.loads(done.stdout)["effects"]):
            self.assertEqual((one["id"], one["value"], one["verdict"]), (other["id"], other["value"], other["verdict"]))

    def test_can_be_compared_under_scaling_laws(self):
        self.write("x,y,z\n0.01,0.01,0.001\n0.01,0.01,0.004\n", "ball.csv")
        done = self.command("scale", self.write(BALL), "--json")
        self.assertEqual(done.returncode, 0, done.stderr)
        for strategy in json.loads(done.stdout)["strategies"]:
            self.assertIn(strategy["particles"], (2, None))   # a file's rows are simulated one by one, whatever the law


class GasStep(CommandTest):
    def test_longer_than_the_run_and_its_outputs_is_said(self):
        self.write("x,y,z\n0.01,0.01,0.01\n", "ball.csv")
        case = BALL.replace("end: 40 ms", "end: 0.1 ms").replace("every 2 ms", "every 50 us")
        done = self.run_case(case)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertRegex(done.stderr, r"warning: time.gas_dt: the gas step of 0.000\d+ s is longer than time.end \(0.0001 s\), output.monitors "
                                      r"\(5e-05 s\); nothing is written within it, and the run ends after a whole one.\n"
                                      r"  Set time.gas_dt: 5e-05 s.\n")
        done = self.run_case(case.replace("dt: auto", "dt: auto, gas_dt: 5e-05 s"), "--force")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertNotIn("warning", done.stderr)
        with open(self.path("out/monitors.csv"), encoding="utf-8", newline="") as file:
            times = [float(row["time [s]"]) for row in csv.DictReader(file)]
        self.assertLess(times[-1], 0.15e-3)
        self.assertGreaterEqual(len(times), 3)


class ShippedBeds(CommandTest):
    def test_cases_of_one_bed_differ_in_models_scaling_alone(self):
        for folder in ("spouted_bed", "spouted_bed_glass", "small_bed"):
            beds = set()
            laws = set()
            for name in ("exact", "parcel", "link", "glicksman", "terminal_velocity"):
                with open(os.path.join(SOURCE, "configs", folder, name + ".yaml"), encoding="utf-8") as file:
                    lines = file.read().split("similitude: 1\n", 1)[1].splitlines()
                scaling = [line for line in lines if line.startswith("  scaling:")]
                self.assertEqual(len(scaling), 1)
                self.assertIn(name, scaling[0])
                laws.add(scaling[0])
                beds.add("\n".join(line for line in lines if line != scaling[0]))
            self.assertEqual(len(beds), 1, folder)
            self.assertEqual(len(laws), 5)

    def test_no_case_of_the_small_bed_is_too_shallow_or_narrow(self):
        for case in glob.glob(os.path.join(SOURCE, "configs", "small_bed", "*.yaml")):
            own = json.loads(self.command("scale", case, "--json").stdout)["strategies"][0]
            self.assertGreaterEqual(own["groups"]["depth/d"]["scaled"], 5, case)
            self.assertGreaterEqual(own["groups"]["gap/d"]["scaled"], 7, case)


class Scale(CommandTest):
    def strategies(self, *arguments):
        done = self.command("scale", os.path.join(SOURCE, "configs", "spouted_bed", "terminal_velocity.yaml"), "--json", *arguments)
        self.assertEqual(done.returncode, 0, done.stderr)
        return json.loads(done.stdout)["strategies"]

    def test_json_has_the_promised_keys(self):
        strategies = self.strategies()
        self.assertEqual(strategies[0]["id"], "terminal_velocity")   # the case's own law first
        self.assertLessEqual({"exact", "parcel", "link", "glicksman", "glicksman_full", "similarity", "coarse_grain", "bierwisch"},
                             {strategy["id"] for strategy in strategies})
        for strategy in strategies:
            self.assertEqual(set(strategy), {"id", "factors", "groups", "particles", "cost", "warnings"})
            self.assertEqual(set(strategy["cost"]), {"particle_steps", "wall_s"})
            self.assertLessEqual({"Re", "Ar", "Fr", "u0/u_mf", "u0/u_t", "St", "J", "L/d"}, set(strategy["groups"]))
            self.assertEqual(set(strategy["groups"]["Re"]), {"exact", "scaled", "ratio", "kept"})

    def test_says_what_the_terminal_velocity_law_keeps_and_loses(self):
        own = self.strategies()[0]
        self.assertEqual(own["particles"], 20308)
        kept = {name for name, group in own["groups"].items() if group["kept"]}
        self.assertLessEqual({"Fr", "Re", "Ar", "u0/u_mf", "u0/u_t", "u0/u_mf (drag law)", "u0/u_t (drag law)"}, kept)
        self.assertFalse({"St", "rho_p/rho_f", "L/d", "J"} & kept)
        self.assertTrue(any("jet" in warning for warning in own["warnings"]))
        self.assertTrue(any("inlet" in warning for warning in own["warnings"]))

    def test_takes_laws_by_hand(self):
        strategies = self.strategies("--law", "link:n=2", "--law", "similarity:geometry=0.5,n=1")
        self.assertEqual([strategy["id"] for strategy in strategies], ["link", "similarity"])
        self.assertAlmostEqual(strategies[0]["factors"]["gas_viscosity"], 2)

    def test_judges_a_law_by_the_minimum_fluidization_that_it_was_told(self):
        velocity, fraction = "glicksman:geometry=0.5,minimum_fluidization_velocity=0.36 m/s", \
            "glicksman:geometry=0.5,gas_fraction_at_minimum_fluidization=0.45"
        both = self.strategies("--law", velocity, "--law", fraction, "--law", "link:n=2")
        self.assertTrue(all(strategy["groups"]["u0/u_mf"]["kept"] for strategy in both))
        told = "its u0/u_mf is taken at the gas fraction that it was told, 0.45."
        self.assertEqual([told in strategy["warnings"] for strategy in both], [False, True, False])
        case = os.path.join(SOURCE, "configs", "small_bed", "exact.yaml")
        self.assertIn("u_mf at a gas fraction of 0.4328.\n", self.command("scale", case, "--law", velocity).stdout)
        self.assertIn("u_mf at a gas fraction of 0.42.\n", self.command("scale", case, "--law", "link:n=2").stdout)

    def test_proposes_laws_for_a_speed_up(self):
        exact, *proposals = self.strategies("--speedup", "20")
        self.assertEqual(exact["id"], "exact")
        reached = [proposal for proposal in proposals if proposal["factors"]]
        self.assertLessEqual({"link", "similarity", "terminal_velocity", "parcel"}, {proposal["id"] for proposal in reached})
        for proposal in reached:
            speedup = exact["cost"]["particle_steps"] / proposal["cost"]["particle_steps"]
            self.assertAlmostEqual(speedup / 20, 1, delta=0.01)
        full = [proposal for proposal in proposals if proposal["id"] == "glicksman_full"]
        self.assertIn("out of reach", full[0]["warnings"][0])

    def test_writes_markdown(self):
        done = self.command("scale", self.write(SMALL), "--markdown")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("| u0/u_t |", done.stdout)

    def test_refuses_what_cannot_be(self):
        case = self.write(SMALL)
        for law, words in (("link", "link needs the parameter n"), ("link:n=0.5", "0.5 is out of range"),
                           ("link:n", "not of the form parameter=value"),
                           ("parcel:n=3,restitution_correction=true", "nothing is left beyond 2.21 times")):
            self.assert_refused(self.command("scale", case, "--law", law), 2, words)
        self.assert_refused(self.command("scale", case, "--speedup", "0.5"), 2, "the real bed itself is that fast")
        self.assert_refused(self.command("scale", case, "--law", "nothing:n=2"), 3, "there is no scaling model")


class Plugins(CommandTest):
    def test_list_names_every_built_in_model(self):
        done = self.command("plugins", "list", "--json")
        self.assertEqual(done.returncode, 0, done.stderr)
        plugins = json.loads(done.stdout)["plugins"]
        self.assertEqual(set(plugins[0]), {"kind", "id", "version", "title", "file"})
        known = {(plugin["kind"], plugin["id"]) for plugin in plugins}
        shipped = {
            "drag": ("beetstra", "di_felice", "ergun", "gidaspow", "haider_levenspiel", "huilin_gidaspow", "koch_hill",
                     "koch_hill_ladd", "radl_filtered", "rong", "schiller_naumann", "syamlal_obrien", "tang", "tenneti", "wen_yu"),
            "contact": ("fluent_dem", "hertz_mindlin", "hertz_thornton", "linear_spring"),
            "fluid": ("porous", "prescribed", "vans"),
            "scaling": ("bierwisch", "coarse_grain", "custom", "exact", "glicksman", "glicksman_full", "link", "parcel",
                        "similarity", "terminal_velocity")}
        self.assertLessEqual({(kind, id) for kind, ids in shipped.items() for id in ids}, known)

    # A folder's name is bytes; JSON is UTF-8. What is not stands as the replacement character.
    def test_list_as_json_stands_a_folder_named_in_latin_1(self):
        plugins = os.path.join(os.path.dirname(os.path.dirname(SIMILITUDE)), "lib", "similitude", "plugins")
        folder = os.fsencode(self.path("caf")) + b"\xe9"
        os.mkdir(folder)
        shutil.copy(os.fsencode(os.path.join(plugins, "drag_gidaspow.so")), folder)
        done = self.command("plugins", "list", "--json", SIMILITUDE_PLUGIN_PATH=os.fsdecode(folder))
        self.assertEqual(done.returncode, 0, done.stderr)
        files = [plugin["file"] for plugin in json.loads(done.stdout)["plugins"]]
        self.assertIn(self.path("caf\ufffd/drag_gidaspow.so"), files)

    def test_info_gives_parameters_with_units(self):
        done = self.command("plugins", "info", "linear_spring")
        self.assertEqual(done.returncode, 0, done.stderr)
        for word in ("stiffness", "N/m", "restitution", "friction"):
            self.assertIn(word, done.stdout)

    def test_info_of_an_unknown_model_is_exit_3(self):
        self.assertEqual(self.command("plugins", "info", "nothing").returncode, 3)

    def test_failures_say_what_to_do(self):
        os.mkdir(self.path("plugins"))
        self.write("not a library", "plugins/broken.so")
        done = self.command("plugins", "failures", "--json", SIMILITUDE_PLUGIN_PATH=self.path("plugins"))
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertTrue(json.loads(done.stdout)["failures"][0]["file"].endswith("broken.so"))


if __name__ == "__main__":
    unittest.main()
