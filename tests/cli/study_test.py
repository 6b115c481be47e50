"""`similitude study` as a user types it: a tiny study, its files, resuming, and what it refuses before anything runs."""
import csv
import json
import os
import shutil
import signal
import subprocess
import time
import unittest

from command import HUNG, SIMILITUDE, SMALL, SOURCE, CommandTest

CASE = SMALL.replace("{end: 10 ms, dt: auto}", "{end: 40 ms, dt: auto}").replace("vtk: every 5 ms", "vtk: none").replace("count: 300", "count: 900")
# Where it does not matter what the bed does.
SHORT = CASE.replace("{end: 40 ms", "{end: 12 ms")

STUDY = """\
similitude_study: 1
title: two drag laws
base: case.yaml
axes: {models.drag: [gidaspow, di_felice]}
reference: gidaspow
metrics: [gas_fraction_profile, velocity_profile, pressure_drop, bed_height, momentum_residual]
from: 5 ms
repeats: 1
"""

# What a clock decides.
TIMES = {"wall_s", "wall_s_repeats", "particle_steps_per_s", "peak_memory_bytes", "stages", "predicted", "pareto", "frontier", "advice"}


def without_times(page):
    if isinstance(page, dict):
        return {key: without_times(value) for key, value in page.items() if key not in TIMES}
    return [without_times(item) for item in page] if isinstance(page, list) else page


class Study(CommandTest):
    def setUp(self):
        super().setUp()
        self.write(CASE)

    def study(self, text, *arguments, **options):
        return self.command("study", self.write(text, "study.yaml"), "-o", "out", *arguments, **options)

    def killed_when(self, ready):
        """Starts the study anew and kills it, where it cannot help itself, once ready() says so. Was it at work then?"""
        shutil.rmtree(self.path("out"))
        reading, writing = os.pipe()
        running = subprocess.Popen([SIMILITUDE, "study", "study.yaml", "-o", "out"], cwd=self.folder.name, pass_fds=[writing],
                                   stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                                   env={**os.environ, "XDG_CACHE_HOME": self.path("cache"), "OMP_NUM_THREADS": "2"})
        os.close(writing)
        deadline = time.monotonic() + HUNG
        while running.poll() is None and not ready() and time.monotonic() < deadline:
            time.sleep(0.01)
        running.kill()
        with os.fdopen(reading, "rb") as pipe:
            pipe.read()   # to its end: when the study and its child are gone, which hold the other side
        return running.wait() == -signal.SIGKILL

    def manifest(self, folder):
        with open(self.path(folder + "/manifest.json"), encoding="utf-8") as file:
            return json.load(file)

    def change_manifest(self, folder, **changes):
        self.write(json.dumps({**self.manifest(folder), **changes}), folder + "/manifest.json")

    def checkpoints(self, folder):
        place = self.path(folder + "/checkpoints")
        return [name for name in os.listdir(place) if name.endswith(".h5")] if os.path.isdir(place) else []

    def page(self, folder="out"):
        with open(self.path(folder + "/study.json"), encoding="utf-8") as file:
            return json.load(file)

    def test_writes_what_the_contract_promises(self):
        done = self.study(STUDY.replace("repeats: 1", "repeats: 2\nshort: 1 h"))
        self.assertEqual(done.returncode, 0, done.stderr + done.stdout)
        self.assertIn("1/2 gidaspow: ", done.stdout)
        page = self.page()
        self.assertIn(page["advice"], done.stdout)
        self.assertEqual([case["name"] for case in page["cases"]], ["gidaspow", "di_felice"])
        reference, other = page["cases"]
        self.assertTrue(reference["reference"])
        self.assertEqual(reference["error"]["bed_height"]["value"], 0)
        for case in page["cases"]:
            self.assertEqual(case["status"], "done")
            self.assertEqual(case["particles"], 900)
            self.assertGreater(case["wall_s"], 0)
            self.assertEqual(len(case["wall_s_repeats"]), 2)
            self.assertFalse(os.path.exists(self.path("out/" + case["name"] + "/repeat")))
            self.assertGreater(case["peak_memory_bytes"], 5e6)
            self.assertGreater(case["particle_steps"], 0)
            self.assertAlmostEqual(sum(stage["share"] for stage in case["stages"]), 1, places=6)
            self.assertIsInstance(case["pareto"], bool)
            self.assertEqual(len(case["profiles"]), 2)
            for metric in ("gas_fraction_profile", "velocity_profile", "pressure_drop", "bed_height", "momentum_residual"):
                self.assertIn(metric, case["error"])
        error = other["error"]["gas_fraction_profile"]
        self.assertLessEqual(error["low"], error["value"])
        self.assertLessEqual(error["value"], error["high"])
        self.assertLess(other["error"]["momentum_residual"]["value"], 1e-9)
        # One smoothing length for all: three diameters.
        self.assertAlmostEqual(page["smoothing_m"], 0.003)
        with open(self.path("out/study.csv"), encoding="utf-8") as file:
            rows = list(csv.DictReader(file))
        self.assertEqual([row["case"] for row in rows], ["gidaspow", "di_felice"])
        self.assertEqual(float(rows[1]["bed_height error [1]"]), other["error"]["bed_height"]["value"])

    def test_a_finished_study_is_not_written_over_and_resuming_runs_nothing(self):
        self.assertEqual(self.study(STUDY).returncode, 0)
        self.assert_refused(self.study(STUDY), 2, "out holds an earlier study.",
                            "Give another folder with -o, or --resume to run only what is missing there.")
        before = self.page()
        again = self.study(STUDY, "--resume")
        self.assertEqual(again.returncode, 0, again.stderr)
        self.assertIn("2/2 di_felice: was done before", again.stdout)
        self.assertEqual(self.page(), before)

    def test_killed_and_resumed_it_says_the_same(self):
        self.write(SHORT)
        began = time.monotonic()
        self.assertEqual(self.study(STUDY).returncode, 0)
        duration = time.monotonic() - began
        whole = without_times(self.page())
        kills = 0
        for share in (0.1, 0.4, 0.7):   # of its life, which is not always as long
            end = time.monotonic() + share * duration
            kills += self.killed_when(lambda: time.monotonic() > end)
            done = self.study(STUDY, "--resume")
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertEqual(without_times(self.page()), whole)
        self.assertGreater(kills, 0)

    def test_killed_in_the_middle_of_a_run_it_goes_on_from_the_checkpoint(self):
        self.write(CASE.replace("vtk: none", "vtk: none, checkpoint: every 1 us"))   # as often as the program looks at the clock
        self.assertEqual(self.study(STUDY).returncode, 0)
        whole = without_times(self.page())
        for case in ("gidaspow", "di_felice"):
            self.assertTrue(self.killed_when(lambda: self.checkpoints("out/" + case)))
            done = self.study(STUDY, "--resume")
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertEqual(len(self.manifest("out/" + case)["resumed"]), 1)
            self.assertEqual(without_times(self.page()), whole)

    def test_a_full_disk_costs_a_case_nothing_but_time(self):
        self.write(SHORT)
        self.assertEqual(self.study(STUDY).returncode, 0)
        whole = without_times(self.page())
        self.change_manifest("out/gidaspow", status="interrupted")
        kept = self.checkpoints("out/gidaspow")
        self.assertEqual(len(kept), 1)
        # A manifest that tells of one start more is longer.
        failed = self.study(STUDY, "--resume", largest_file=os.path.getsize(self.path("out/gidaspow/manifest.json")))
        self.assertIn("1/2 gidaspow: failed with exit status 2: ", failed.stdout)
        self.assertIn(": cannot be written: File too large.\n", failed.stdout)
        self.assertEqual(self.checkpoints("out/gidaspow"), kept)
        done = self.study(STUDY, "--resume")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn(" s since it was resumed, ", done.stdout)
        self.assertEqual(without_times(self.page()), whole)

    def test_a_case_none_of_whose_checkpoints_can_be_read_is_run_anew(self):
        self.write(SHORT)
        self.assertEqual(self.study(STUDY).returncode, 0)
        whole = without_times(self.page())
        self.change_manifest("out/gidaspow", status="interrupted")
        for name in self.checkpoints("out/gidaspow"):
            self.write("", "out/gidaspow/checkpoints/" + name)
        done = self.study(STUDY, "--resume")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertNotIn("since it was resumed", done.stdout)
        self.assertEqual(self.manifest("out/gidaspow")["resumed"], [])
        self.assertEqual(without_times(self.page()), whole)

    def test_a_study_that_was_moved_and_renamed_is_the_same(self):
        os.makedirs(self.path("here/plugins"))
        case = SHORT.replace("similitude: 1\n", "similitude: 1\nplugin_paths: [plugins]\n")
        case = case.replace("{fill: lattice}", "{fill: file, file: bed.csv}").replace(", count: 900", "")
        grains = ["x,y,z"] + [f"{0.001 + 0.0012 * i},{0.001 + 0.0012 * j},{0.001 + 0.0012 * k}" for i in range(15) for j in range(7) for k in range(5)]
        self.write(case, "here/case.yaml")
        self.write("\n".join(grains), "here/bed.csv")
        self.write(STUDY, "here/study.yaml")
        done = self.command("study", "here/study.yaml", "-o", "here/out")
        self.assertEqual(done.returncode, 0, done.stderr)
        shutil.move(self.path("here"), self.path("there"))
        self.write(case.replace("a small bed", "renamed"), "there/case.yaml")

        def again():
            return self.command("study", "there/study.yaml", "-o", "there/out", "--resume")
        self.assertIn("1/2 gidaspow: was done before\n2/2 di_felice: was done before\n", again().stdout)
        self.change_manifest("there/out/di_felice", status="interrupted")
        self.assertRegex(again().stdout, r"1/2 gidaspow: was done before\n2/2 di_felice: \S+ s since it was resumed, ")

        before = self.manifest("there/out/gidaspow")
        self.write("\n".join(grains[:-1]), "there/bed.csv")
        self.assert_refused(again(), 2, "there/out/gidaspow holds a run of another case:\n    scene.bed.file: the file is another (SHA-256 was "
                            + before["bed_sha256"][:12] + "…, is ",
                            "\n  Give another folder with -o, or remove that one to have the case run anew.\n")
        self.assertEqual(self.manifest("there/out/gidaspow"), before)

    def test_results_of_another_case_are_not_written_over(self):
        self.write(SHORT)
        self.assertEqual(self.study(STUDY).returncode, 0)

        def refuse(*differences):
            self.assert_refused(self.study(STUDY, "--resume"), 2, "out/gidaspow holds a run of another case:\n    " + "\n    ".join(differences)
                                + "\n  Give another folder with -o, or remove that one to have the case run anew.\n")
            self.assertEqual([len(self.checkpoints("out/" + case)) for case in ("gidaspow", "di_felice")], [1, 1])
        self.write(SHORT.replace("density: 1.225", "density: 1.3").replace("end: 12 ms", "end: 11 ms"))
        differences = ["scene.gas.density: was 1.225 kg/m^3, is 1.3 kg/m^3", "time.end: was 0.012 s, is 0.011 s"]
        refuse(*differences)
        self.change_manifest("out/gidaspow", status="interrupted")
        refuse(*differences)
        shutil.rmtree(self.path("out/di_felice/checkpoints"))
        self.change_manifest("out/gidaspow", status="stopped")   # by a guard: nothing more comes of it
        self.assert_refused(self.study(STUDY, "--resume"), 2, "out/di_felice holds a run of another case:\n    " + differences[0])

    def test_a_later_end_is_gone_on_to(self):
        self.write(SHORT)
        self.assertEqual(self.study(STUDY).returncode, 0)
        shutil.rmtree(self.path("out/di_felice/checkpoints"))
        self.write(SHORT.replace("end: 12 ms", "end: 16 ms"))
        self.assert_refused(self.study(STUDY, "--resume"), 2, "out/di_felice holds a run of another case:\n"
                            "    time.end: was run to 0.012", " s without a checkpoint to go on from, is 0.016 s\n")
        shutil.rmtree(self.path("out/di_felice"))
        done = self.study(STUDY, "--resume")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertRegex(done.stdout, r"1/2 gidaspow: \S+ s since it was resumed, ")
        whole = without_times(self.page())
        shutil.rmtree(self.path("out"))
        self.assertEqual(self.study(STUDY).returncode, 0)
        self.assertEqual(without_times(self.page()), whole)

    def test_wall_time_is_foretold_and_held_against_what_it_took(self):
        self.assertEqual(self.study(STUDY).returncode, 0)
        for case in self.page()["cases"]:
            predicted = case["predicted"]
            self.assertAlmostEqual(predicted["particle_steps"] / case["particle_steps"], 1, delta=0.01)
            self.assertAlmostEqual(sum(stage["seconds"] for stage in predicted["stages"]) / predicted["wall_s"], 1, places=9)
            self.assertLessEqual({stage["name"] for stage in predicted["stages"]}, {stage["name"] for stage in case["stages"]})
            self.assertRegex(predicted["farthest_off"], r"^[a-z: ]+ [0-9.e-]+ s, measured [0-9.e-]+ s$")

    def test_a_signal_ends_child_and_study(self):
        case = CASE.replace("{end: 40 ms", "{end: 100 s")
        self.write(case)
        self.write(STUDY, "study.yaml")
        running = subprocess.Popen([SIMILITUDE, "study", "study.yaml", "-o", "out"], cwd=self.folder.name, text=True,
                                   stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                                   env={**os.environ, "XDG_CACHE_HOME": self.path("cache"), "OMP_NUM_THREADS": "2"})
        deadline = time.time() + HUNG
        while not os.path.exists(self.path("out/gidaspow/monitors.csv")) and time.time() < deadline:
            time.sleep(0.05)
        running.send_signal(signal.SIGTERM)
        out, _ = running.communicate(timeout=HUNG)
        self.assertEqual(running.returncode, 143, out)
        self.assertIn("1/2 gidaspow: interrupted", out)
        self.assertIn("go on with --resume", out)
        with open(self.path("out/gidaspow/manifest.json"), encoding="utf-8") as file:
            self.assertEqual(json.load(file)["status"], "interrupted")
        self.assertFalse(os.path.exists(self.path("out/di_felice")))

    def test_a_failed_case_does_not_stop_the_others(self):
        # So soft a spring breaks no rule of the input; its overlaps stop the run.
        study = STUDY.replace("axes: {models.drag: [gidaspow, di_felice]}",
                              "cases:\n  - {name: gidaspow}\n  - {name: soft, set: {models.contact.stiffness: 0.01 N/m}}\n"
                              "  - {name: di_felice, set: {models.drag: di_felice}}")
        done = self.study(study)
        self.assertEqual(done.returncode, 1, done.stdout + done.stderr)
        self.assertIn("2/3 soft: failed with exit status 1: ", done.stdout)
        page = self.page()
        self.assertEqual([case["status"] for case in page["cases"]], ["done", "stopped", "done"])
        self.assertIn("overlap", page["cases"][1]["reason"])
        self.assertIsNone(page["cases"][1]["wall_s"])
        self.assertFalse(page["cases"][1]["pareto"])

    def test_a_stored_run_is_a_reference_and_its_leg_times_it(self):
        self.assertEqual(self.command("run", "case.yaml", "-o", "stored", "--set", "output.profiles.from=5 ms").returncode, 0)
        study = STUDY.replace("reference: gidaspow", "reference: {run: stored}\nleg: 4 ms")
        done = self.study(study)
        self.assertEqual(done.returncode, 0, done.stderr + done.stdout)
        page = self.page()
        stored = page["cases"][-1]
        self.assertEqual(stored["name"], "stored")
        self.assertTrue(stored["reference"])
        self.assertAlmostEqual(stored["extrapolated_from_s"], 4e-3, delta=0.5e-3)   # whole gas steps
        self.assertGreater(stored["wall_s"], 0)
        self.assertGreater(stored["predicted"]["wall_s"], 0)
        # The same case as the study's first, so the same bits.
        self.assertEqual(page["cases"][0]["state_hash"], stored["state_hash"])
        self.assertEqual(page["cases"][0]["error"]["gas_fraction_profile"]["value"], 0)

    def test_a_run_made_elsewhere_is_taken_as_it_is_and_timed_here(self):
        self.assertEqual(self.study(STUDY).returncode, 0)
        whole = without_times(self.page())
        manifest = self.path("out/di_felice/manifest.json")
        with open(manifest, encoding="utf-8") as file:
            page = json.load(file)
        page["machine"]["processor"] = "Another"
        with open(manifest, "w", encoding="utf-8") as file:
            json.dump(page, file)
        os.remove(self.path("out/di_felice/cost.json"))
        done = self.study(STUDY, "--resume")
        self.assertIn("2/2 di_felice: was done elsewhere; its time on this machine is not known (leg: 10 ms would time it)\n", done.stdout)
        self.assertIsNone(self.page()["cases"][1]["wall_s"])
        self.assertEqual(without_times(self.page())["cases"][0], whole["cases"][0])

        done = self.study(STUDY + "leg: 4 ms\n", "--resume")
        self.assertRegex(done.stdout, r"2/2 di_felice: was done elsewhere; a short leg of it here: [0-9.e-]+ s for 0.004[0-9]* s of the bed's time after its end\n")
        there = self.page()["cases"][1]
        self.assertAlmostEqual(there["extrapolated_from_s"], 4e-3, delta=0.5e-3)   # whole gas steps
        self.assertAlmostEqual(there["wall_s"], sum(stage["seconds"] for stage in there["stages"]), delta=0.1 * there["wall_s"])
        self.assertGreater(there["predicted"]["wall_s"], 0)
        self.assertEqual(there["metrics"], whole["cases"][1]["metrics"])
        again = self.study(STUDY + "leg: 4 ms\n", "--resume")
        self.assertIn("2/2 di_felice: was done elsewhere; a short leg of it here: was timed before\n", again.stdout)

    def test_orders_are_observed_along_steps_and_cells(self):
        study = STUDY.replace("{models.drag: [gidaspow, di_felice]}", "{models.drag: [gidaspow, di_felice], time.dt: [8 us, 4 us, 2 us]}")
        done = self.study(study.replace("reference: gidaspow", "reference: gidaspow-dt_2us"))
        self.assertEqual(done.returncode, 0, done.stderr + done.stdout)
        orders = self.page()["orders"]
        # A line of steps for each drag law, and for each metric that has an order.
        self.assertEqual([order["metric"] for order in orders], 2 * ["gas_fraction_profile", "velocity_profile", "pressure_drop", "bed_height"])
        self.assertEqual(orders[0]["cases"], ["gidaspow-dt_8us", "gidaspow-dt_4us", "gidaspow-dt_2us"])
        self.assertEqual(orders[4]["cases"], ["di_felice-dt_8us", "di_felice-dt_4us", "di_felice-dt_2us"])

    def test_measured_data_are_a_reference(self):
        self.write("sampler,x,z,mean,standard error\nvertical_velocity [m/s],0.0075,0.005,0.1,0.01\nbed_height,,,0.01,\n", "data.csv")
        study = STUDY.replace("reference: gidaspow", "reference: {data: data.csv}")
        study = study.replace("[gas_fraction_profile, velocity_profile, pressure_drop, bed_height, momentum_residual]", "[bed_height, velocity_profile]")
        done = self.study(study)
        self.assertEqual(done.returncode, 0, done.stderr + done.stdout)
        height = self.page()["cases"][0]["metrics"]["bed_height"]["value"]
        self.assertAlmostEqual(self.page()["cases"][0]["error"]["bed_height"]["value"], abs(height - 0.01) / 0.01)

    def test_shipped_studies_fit_their_cases(self):
        # Everything is checked before a folder is looked at; a folder that is taken stops it there.
        os.mkdir(self.path("taken"))
        self.write("{}", "taken/study.json")
        folder = os.path.join(SOURCE, "configs/studies")
        studies = [name for name in sorted(os.listdir(folder)) if name.endswith(".yaml") and name != "bed.yaml"]
        self.assertEqual(len(studies), 11)
        for name in studies:
            done = self.command("study", os.path.join(folder, name), "-o", "taken")
            missing = name == "scaling.yaml" and not os.path.exists(os.path.join(SOURCE, "results/small_bed_exact"))
            self.assert_refused(done, 2, "reference.run: there is no run in" if missing else "taken holds an earlier study.")

    # ---------------------------------------------------------------------------------- refused before anything runs

    def refuse(self, text, status, message):
        done = self.study(text)
        self.assertEqual(done.returncode, status, done.stderr + done.stdout)
        self.assertEqual(done.stderr.replace(self.folder.name + "/", "").strip(), ("error: " + message).strip())
        self.assertFalse(os.path.exists(self.path("out")))

    def test_axis_that_names_no_case_path(self):
        self.refuse(STUDY.replace("axes: {models.drag", "axes: {models.drg"), 2,
                    "study.yaml:4:21: axes.models.drg: there is no such key.\n  Did you mean \"drag\"?\n"
                    "  Keys of models: drag, contact, fluid, scaling, effects.")

    def test_axis_whose_value_is_no_model(self):
        done = self.study(STUDY.replace("di_felice]", "di_felise]"))
        self.assert_refused(done, 3, "study.yaml:4:32: axes.models.drag", "di_felise", "Did you mean \"di_felice\"")
        self.assertFalse(os.path.exists(self.path("out")))

    def test_axis_whose_value_does_not_fit_the_others(self):
        done = self.study(STUDY.replace("models.drag: [gidaspow, di_felice]", "time.dt: [1 us, 1 ms]").replace("reference: gidaspow", "reference: dt_1us"))
        self.assert_refused(done, 2, "study.yaml:4:24: axes.time.dt: ", "beyond the hard limit")

    def test_unknown_reference(self):
        self.refuse(STUDY.replace("reference: gidaspow", "reference: gidaspw"), 2,
                    "study.yaml:5:12: reference: there is no case \"gidaspw\".\n  Did you mean \"gidaspow\"?\n  Cases: gidaspow, di_felice.\n"
                    "  A finished run is named by {run: folder}, measured data by {data: file}.")

    def test_reference_that_does_not_exist(self):
        self.refuse(STUDY.replace("reference: gidaspow", "reference: {run: nowhere}"), 2,
                    "study.yaml:5:12: reference.run: there is no run in nowhere.\n"
                    "  A relative path starts at the study's folder. Run the reference first: similitude run CASE -o FOLDER.")

    def test_reference_that_did_not_finish(self):
        self.assertEqual(self.command("run", "case.yaml", "-o", "stored", "--until", "2 ms").returncode, 0)
        with open(self.path("stored/manifest.json"), encoding="utf-8") as file:
            manifest = json.load(file)
        manifest.update(status="stopped", exit_reason="an overlap of 40 %")
        self.write(json.dumps(manifest), "stored/manifest.json")
        self.refuse(STUDY.replace("reference: gidaspow", "reference: {run: stored}"), 2,
                    "study.yaml:5:12: reference.run: the run in stored did not finish: it is stopped (an overlap of 40 %).\n"
                    "  Run it to its end, or take another reference.")

    def test_measured_data_with_wrong_columns(self):
        self.write("height,value\n1,2\n", "data.csv")
        self.refuse(STUDY.replace("reference: gidaspow", "reference: {data: data.csv}"), 2,
                    "data.csv: measured data need the columns sampler, x, z, mean and, if known, standard error, but these are height, value.\n"
                    "  Name them in the first row. x and z in metres; sampler as in profiles.csv of a run, e.g. vertical_velocity [m/s].")

    def test_measured_data_that_lack_a_metric(self):
        self.write("sampler,x,z,mean\nbed_height,,,0.01\n", "data.csv")
        self.refuse(STUDY.replace("reference: gidaspow", "reference: {data: data.csv}"), 2,
                    "study.yaml:5:12: reference.data: the measured data hold nothing for the metric gas_fraction_profile.\n"
                    "  Add rows with the sampler gas_fraction [1], or take the metric off the list.")

    def test_measured_data_outside_the_bed(self):
        self.write("sampler,x,z,mean\ngas_fraction [1],0.01,0.5,0.9\n", "data.csv")
        study = STUDY.replace("reference: gidaspow", "reference: {data: data.csv}")
        study = study[:study.index("metrics:")] + "metrics: [gas_fraction_profile]\n"
        self.refuse(study, 2, "study.yaml:5:12: reference.data: the data hold gas_fraction [1] at the height 500 mm, where the cases have no profile.\n"
                    "  Add this height to output.profiles.z.")

    def test_heights_outside_the_bed(self):
        done = self.study(STUDY.replace("from: 5 ms", "set: {output.profiles.z: [500 mm]}"))
        self.assert_refused(done, 2, "500 mm")
        self.assertFalse(os.path.exists(self.path("out")))

    def test_average_that_starts_after_the_end(self):
        self.refuse(STUDY.replace("from: 5 ms", "from: 1 s"), 2,
                    "study.yaml:7:7: from: averaging starts at 1 s, but the run ends at 0.04 s.\n"
                    "  Start earlier, or raise time.end.")

    def test_average_that_starts_after_the_end_of_a_case_without_profiles(self):
        self.write(CASE.replace(", profiles: {z: [5 mm], from: 2 ms}", ""))
        study = STUDY.replace("gas_fraction_profile, velocity_profile, ", "")
        self.refuse(study.replace("from: 5 ms", "from: 1 s"), 2,
                    "study.yaml:7:7: from: averages would start at 1 s, but the case gidaspow ends at 0.04 s.\n"
                    "  Start earlier (from), or run longer (set: {time.end: …}).")
        self.refuse(STUDY, 2, "study.yaml:6:10: metrics: profiles are compared at heights, but the case gidaspow has none.\n"
                    "  Add for example set: {output.profiles.z: [50 mm]}.")


if __name__ == "__main__":
    unittest.main()
