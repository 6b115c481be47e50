"""What each subcommand prints and writes."""
import csv
import json
import os
import pathlib
import re
import signal
import subprocess
import sys
import time
import unittest

from command import SIMILITUDE, SMALL, SOURCE, CommandTest


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
        for threads, vtk in (("1", "every 5 ms"), ("2", "every 1 ms"), ("3", "none")):
            case = self.write(SMALL.replace("vtk: every 5 ms", "vtk: " + vtk))
            done = self.command("run", case, "-o", "out" + threads, "--threads", threads)
            self.assertEqual(done.returncode, 0, done.stderr)
            with open(self.path(f"out{threads}/manifest.json"), encoding="utf-8") as file:
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

    def test_takes_every_shipped_case(self):
        schema = self.write(self.command("schema").stdout, "schema.json")
        cases = shipped_cases()
        done = subprocess.run([sys.executable, os.path.join(SOURCE, "tests", "scene", "validate_cases.py"), schema, *cases],
                              capture_output=True, text=True, check=True)
        self.assertEqual(done.stdout.splitlines(), ["valid " + case for case in cases])


if __name__ == "__main__":
    unittest.main()
