"""What each subcommand prints and writes."""
import csv
import json
import os
import shutil
import signal
import subprocess
import time
import unittest

from command import SIMILITUDE, SMALL, SOURCE, CommandTest


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
            self.assertEqual(process.wait(timeout=60), 130)
        with open(self.path("out/manifest.json"), encoding="utf-8") as file:
            self.assertEqual(json.load(file)["status"], "interrupted")
        self.assertTrue(os.path.exists(self.path("out/profiles.csv")))


class Check(CommandTest):
    def test_json_has_the_promised_keys(self):
        done = self.command("check", self.write(SMALL), "--json")
        self.assertEqual(done.returncode, 0, done.stderr)
        page = json.loads(done.stdout)
        self.assertEqual(set(page), {"pipeline", "fields", "time_steps", "effects", "predicted"})
        self.assertEqual(set(page["fields"][0]), {"name", "bytes_per_item", "items", "because"})
        self.assertTrue(any(limit["binding"] for limit in page["time_steps"]["limits"]))
        self.assertGreater(page["predicted"]["particle_steps"], 0)

    def test_frictionless_spheres_have_neither_history_nor_rotation(self):
        page = json.loads(self.command("check", self.write(SMALL.replace("friction: 0.2", "friction: 0")), "--json").stdout)
        names = " ".join(field["name"] for field in page["fields"])
        self.assertNotIn("angular_velocity", names)
        self.assertNotIn("tangential", names)

    def test_shipped_cases_are_right(self):
        for case in ("quickstart.yaml", "spouted_bed/exact.yaml", "spouted_bed/terminal_velocity.yaml"):
            done = self.command("check", os.path.join(SOURCE, "configs", case))
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertIn("predicted", done.stdout)


class Plugins(CommandTest):
    def test_list_names_every_built_in_model(self):
        done = self.command("plugins", "list", "--json")
        self.assertEqual(done.returncode, 0, done.stderr)
        plugins = json.loads(done.stdout)["plugins"]
        self.assertEqual(set(plugins[0]), {"kind", "id", "version", "title", "file"})
        known = {(plugin["kind"], plugin["id"]) for plugin in plugins}
        self.assertLessEqual({("drag", "syamlal_obrien"), ("drag", "gidaspow"), ("drag", "schiller_naumann"),
                              ("contact", "linear_spring"), ("contact", "fluent_dem"), ("fluid", "vans"),
                              ("fluid", "prescribed"), ("scaling", "exact"), ("scaling", "terminal_velocity")}, known)

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


class Schema(CommandTest):
    def test_is_json_and_knows_the_plugins(self):
        done = self.command("schema")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("syamlal_obrien", json.dumps(json.loads(done.stdout)))


if __name__ == "__main__":
    unittest.main()
