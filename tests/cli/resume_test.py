"""A run that is broken off goes on as if nothing had been: state hash, tables and frames, byte by byte."""
import filecmp
import json
import os
import random
import shutil
import signal
import subprocess
import time
import unittest

from command import HUNG, SIMILITUDE, CommandTest
from command import SMALL as BED

KILLS = int(os.environ.get("SIMILITUDE_KILLS", "5"))
# With every table that a run writes row by row, but for scalars.csv (scalars_test.py).
SMALL = BED.replace("output: {", "output: {probes: {tap: {at: [10 mm, 5 mm, 20 mm]}}, ")
# As often as the program looks at the clock: after every gas step.
OFTEN = SMALL.replace("output: {", "output: {checkpoint: every 1 us, ")
# A run of a second or two, so that a kill finds it at work.
LONGER = OFTEN.replace("end: 10 ms", "end: 200 ms").replace("vtk: every 5 ms", "vtk: every 20 ms")


def plugin_folder():
    return os.path.join(os.path.dirname(os.path.dirname(SIMILITUDE)), "lib", "similitude", "plugins")


class ResumeTest(CommandTest):
    def run_in(self, folder, text, *arguments, **environment):
        return self.command("run", self.write(text), "-o", self.path(folder), *arguments, **environment)

    def done(self, folder, text, *arguments, **environment):
        finished = self.run_in(folder, text, *arguments, **environment)
        self.assertEqual(finished.returncode, 0, finished.stderr)
        return finished

    def manifest(self, folder):
        with open(self.path(folder + "/manifest.json"), encoding="utf-8") as file:
            return json.load(file)

    def checkpoints(self, folder):
        return sorted(name for name in os.listdir(self.path(folder + "/checkpoints")) if name.endswith(".h5"))

    def newest(self, folder):
        return self.path(folder + "/checkpoints/" + self.checkpoints(folder)[-1])

    def results(self, folder):
        """Every file but those that hold wall-clock times, commands or paths."""
        found = set()
        for place, _, names in os.walk(self.path(folder)):
            for name in names:
                relative = os.path.relpath(os.path.join(place, name), self.path(folder))
                if not relative.startswith("checkpoints") and name not in ("manifest.json", "timing.json", "view.py", "report.html"):
                    found.add(relative)
        return found

    def assert_same_results(self, one, other):
        self.assertEqual(self.manifest(one)["state_hash"], self.manifest(other)["state_hash"])
        self.assertEqual(self.results(one), self.results(other))
        for name in self.results(one):
            self.assertTrue(filecmp.cmp(self.path(f"{one}/{name}"), self.path(f"{other}/{name}"), shallow=False), name)


class Resume(ResumeTest):
    def assert_goes_on(self, text, *until):
        self.done("whole", text)
        self.done("broken", text, "--until", until[0], "--threads", "2")
        for end in until[1:]:
            self.done("broken", text, "--resume", "--until", end, "--threads", "1")
        self.done("broken", text, "--resume", "--threads", "3")
        self.assert_same_results("whole", "broken")

    def test_goes_on_with_the_same_bits_from_anywhere_and_with_any_number_of_threads(self):
        self.assert_goes_on(SMALL, "0.3 ms", "3.3 ms", "5 ms", "7.7 ms")

    def test_without_history_and_rotation(self):
        self.assert_goes_on(SMALL.replace("friction: 0.2", "friction: 0"), "4.3 ms")

    def test_with_the_other_contact_law(self):
        self.assert_goes_on(SMALL.replace("linear_spring", "fluent_dem").replace(", friction: 0.2", ""), "4.3 ms")

    def test_in_a_given_gas(self):
        self.assert_goes_on(SMALL.replace("fluid: vans", "fluid: {id: prescribed, velocity_z: 1.5 m/s}"), "4.3 ms")

    def test_of_a_scaled_bed(self):
        self.assert_goes_on(SMALL.replace("scaling: exact", "scaling: {id: terminal_velocity, geometry: 0.5}"), "4.3 ms")

    def test_writing_checkpoints_changes_nothing(self):
        self.done("none", SMALL.replace("output: {", "output: {checkpoint: none, "))
        self.done("often", OFTEN)
        self.assert_same_results("none", "often")
        self.assertFalse(os.path.exists(self.path("none/checkpoints")))
        self.assertEqual(len(self.checkpoints("often")), 2)

    def test_a_finished_run_goes_on_to_a_later_end(self):
        self.done("whole", SMALL.replace("end: 10 ms", "end: 16 ms"))
        self.done("later", SMALL)
        self.done("later", SMALL.replace("end: 10 ms", "end: 16 ms"), "--resume")
        self.assert_same_results("whole", "later")
        # Once more: nothing is left to do, and nothing changes.
        self.done("later", SMALL.replace("end: 10 ms", "end: 16 ms"), "--resume")
        self.assert_same_results("whole", "later")
        self.assertEqual(len(self.manifest("later")["resumed"]), 2)

    def test_intervals_and_title_may_change(self):
        self.done("out", SMALL, "--until", "4.3 ms")
        self.done("out", SMALL.replace("vtk: every 5 ms", "vtk: every 1 ms").replace("a small bed", "renamed"), "--resume")
        self.done("whole", SMALL)
        self.assertEqual(self.manifest("out")["state_hash"], self.manifest("whole")["state_hash"])
        with open(self.path("out/particles.pvd"), encoding="utf-8") as file:
            self.assertEqual(file.read().count("<DataSet"), 1 + 6)   # 0, then 5 ... 10 ms

    def test_timing_counts_every_start(self):
        self.done("out", SMALL, "--until", "4.3 ms")
        with open(self.path("out/timing.json"), encoding="utf-8") as file:
            before = json.load(file)
        self.done("out", SMALL, "--resume")
        with open(self.path("out/timing.json"), encoding="utf-8") as file:
            after = json.load(file)
        self.assertGreater(after["wall_s"], before["wall_s"] * 0.9)
        self.assertGreater(after["particle_steps"], 2 * before["particle_steps"])
        self.assertAlmostEqual(sum(stage["share"] for stage in after["stages"]), 1, places=6)

    def test_a_signal_leaves_a_checkpoint(self):
        for out, number, status in (("terminated", signal.SIGTERM, 143), ("interrupted", signal.SIGINT, 130)):
            case = self.write(SMALL.replace("end: 10 ms", "end: 100 s"))
            with subprocess.Popen([SIMILITUDE, "run", case, "-o", self.path(out)], stdout=subprocess.PIPE,
                                  stderr=subprocess.DEVNULL, text=True, cwd=self.folder.name) as process:
                deadline = time.monotonic() + 60
                while not os.path.exists(self.path(out + "/monitors.csv")) and time.monotonic() < deadline:
                    time.sleep(0.05)
                time.sleep(0.5)
                process.send_signal(number)
                time.sleep(0.02)
                process.send_signal(number)   # as timeout(1) does: to the program, then to its group
                said, _ = process.communicate(timeout=HUNG)
                self.assertEqual(process.returncode, status)
            self.assertEqual(len(self.checkpoints(out)), 1)
            self.assertIn(self.newest(out), said)
            reached = self.manifest(out)["simulated_s"]
            self.done("whole", SMALL.replace("end: 10 ms", "end: 100 s"), "--until", f"{reached + 2e-3} s", "--force")
            self.done(out, SMALL.replace("end: 10 ms", "end: 100 s"), "--until", f"{reached + 2e-3} s", "--resume")
            self.assert_same_results("whole", out)

    def test_a_signal_while_the_bed_settles_leaves_nothing(self):
        case = self.write(SMALL.replace("{fill: lattice}", "{fill: settle, cache: false}").replace("count: 300", "count: 3000"))
        with subprocess.Popen([SIMILITUDE, "run", case, "-o", self.path("out")], stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                              text=True, cwd=self.folder.name) as process:
            self.assertTrue(any(line == "parting neighbours …\n" for line in process.stderr))   # the first of five stages
            process.send_signal(signal.SIGTERM)
            said, _ = process.communicate(timeout=HUNG)
        self.assertEqual(process.returncode, 143)
        self.assertEqual(said, "\ninterrupted while the bed settled: nothing is kept of it\n")
        self.assertEqual(os.listdir(self.path("out")), [])

    def test_the_manifest_names_the_file_that_was_read(self):
        for name in ("bed.yml", "case.json"):
            self.write(SMALL, name)
            finished = self.command("run", name, "-o", self.path(name + ".out"), "--until", "0.1 ms")
            self.assertEqual(finished.returncode, 0, finished.stderr)
            self.assertTrue(os.path.samefile(self.manifest(name + ".out")["case_file"], self.path(name)))


class Refusals(ResumeTest):
    def setUp(self):
        super().setUp()
        self.done("out", OFTEN)

    def refused(self, text, status, *words, **environment):
        self.assert_refused(self.run_in("out", text, "--resume", **environment), status, *words)
        self.assertEqual(self.manifest("out")["status"], "done")

    def test_another_case_names_every_difference(self):
        self.refused(OFTEN.replace("density: 1.225", "density: 1.3").replace("friction: 0.2", "friction: 0.3"), 2,
                     "the earlier run was of another case:\n"
                     "    scene.gas.density: was 1.225 kg/m^3, is 1.3 kg/m^3\n"
                     "    models.contact.friction: was 0.2, is 0.3\n"
                     "  Undo these changes to go on with that run, or start a new one in another folder with -o.")

    def test_another_profile_is_another_case(self):
        self.refused(OFTEN.replace("from: 2 ms", "from: 3 ms"), 2, "output.profiles.from: was 0.002 s, is 0.003 s")

    def test_another_plugin_file_is_exit_3(self):
        os.mkdir(self.path("plugins"))
        with open(os.path.join(plugin_folder(), "drag_gidaspow.so"), "rb") as file:
            library = file.read()
        with open(self.path("plugins/drag_gidaspow.so"), "wb") as file:
            file.write(library + b"\0")
        self.refused(OFTEN, 3, "the earlier run used other plugins:\n    drag gidaspow: the file is another (SHA-256 was ",
                     "Put those back to go on with that run", SIMILITUDE_PLUGIN_PATH=self.path("plugins"))

    def test_one_cut_short_is_told_and_the_one_before_is_used(self):
        newest = self.newest("out")
        with open(newest, "r+b") as file:
            file.truncate(os.path.getsize(newest) // 2)
        finished = self.done("out", OFTEN, "--resume")
        self.assertIn(newest + " is cut short or altered", finished.stderr)
        self.assertIn(os.path.basename(newest) + ".damaged, and the checkpoint before it is used.", finished.stderr)
        self.done("whole", SMALL)
        self.assert_same_results("whole", "out")

    def test_an_altered_one_is_told_and_the_one_before_is_used(self):
        newest = self.newest("out")
        with open(newest, "r+b") as file:
            file.seek(os.path.getsize(newest) // 2)
            byte = file.read(1)
            file.seek(-1, os.SEEK_CUR)
            file.write(bytes([byte[0] ^ 16]))
        self.assertIn(newest + " is cut short or altered", self.done("out", OFTEN, "--resume").stderr)
        self.done("whole", SMALL)
        self.assert_same_results("whole", "out")

    def test_none_that_can_be_read(self):
        for name in self.checkpoints("out"):
            with open(self.path("out/checkpoints/" + name), "wb"):
                pass
        self.refused(OFTEN, 2, f"none of the checkpoints in {self.path('out')} can be read.\n"
                               "  Start the run anew with --force, or in another folder with -o.")

    def test_one_out_of_reach_is_not_taken_for_damaged(self):
        newest = self.newest("out")
        os.rename(newest, self.path("moved.h5"))
        os.symlink(self.path("nowhere.h5"), newest)
        self.refused(OFTEN, 2, newest + " cannot be opened: No such file or directory.\n"
                               "  Make it readable and resume again; if it is taken away, the checkpoint before it is used.")
        os.replace(self.path("moved.h5"), newest)
        self.done("out", OFTEN, "--resume")

    def test_none_at_all(self):
        shutil.rmtree(self.path("out/checkpoints"))
        self.refused(OFTEN, 2, "holds no checkpoint.\n  Start the run anew with --force")

    def test_rows_that_went_missing(self):
        with open(self.path("out/monitors.csv"), "r+b") as file:
            file.truncate(1000)
        self.refused(OFTEN, 2, "monitors.csv has 1000 bytes, but had ", "rows are missing")

    def test_no_run_to_go_on_with(self):
        self.assert_refused(self.run_in("nowhere", OFTEN, "--resume"), 2, "nowhere holds no earlier run.\n  Leave --resume out")
        self.assertFalse(os.path.exists(self.path("nowhere")))

    def test_a_run_in_the_way_mentions_resume(self):
        self.assert_refused(self.run_in("out", OFTEN), 2, "holds an earlier run", "--resume to go on with that run")

    def test_force_and_resume_exclude_each_other(self):
        self.assertEqual(self.run_in("out", OFTEN, "--resume", "--force").returncode, 2)

    def test_force_removes_the_checkpoints(self):
        self.done("out", SMALL.replace("output: {", "output: {checkpoint: none, "), "--force")
        self.assertEqual(self.checkpoints("out"), [])


class FullDisk(ResumeTest):
    def limited(self, text, *arguments, most=100_000):
        """No file may grow beyond 100 kB: less than a checkpoint of this bed, more than any other file."""
        return self.command("run", self.write(text), "-o", self.path("out"), *arguments, largest_file=most)

    def test_the_run_goes_on_and_says_it_once(self):
        finished = self.limited(OFTEN)
        self.assertEqual(finished.returncode, 0, finished.stderr)
        self.assertEqual(finished.stderr.count("no checkpoint was written; the run goes on without one."), 1)
        self.assertIn("File too large", finished.stderr)
        self.assertEqual(os.listdir(self.path("out/checkpoints")), [])
        self.done("whole", SMALL)
        self.assert_same_results("whole", "out")

    def test_the_last_good_one_stays(self):
        self.done("out", OFTEN, "--until", "5 ms")
        newest = self.newest("out")
        finished = self.limited(OFTEN, "--resume")
        self.assertEqual(finished.returncode, 0, finished.stderr)
        self.assertEqual(finished.stderr.count("the last good one is " + newest), 1)
        self.assertEqual(self.newest("out"), newest)
        self.done("out", OFTEN, "--resume")
        self.done("whole", SMALL)
        self.assert_same_results("whole", "out")

    def test_a_table_that_can_grow_no_further_ends_the_run_where_it_can_be_gone_on_from(self):
        growing = LONGER.replace("monitors: every 1 ms", "monitors: every 50 us").replace("vtk: every 20 ms", "vtk: none")
        self.done("whole", growing)
        checkpoint, table = os.path.getsize(self.newest("whole")), os.path.getsize(self.path("whole/monitors.csv"))
        self.assertGreater(table, 1.5 * checkpoint)
        finished = self.limited(growing, most=(checkpoint + table) // 2)
        self.assertEqual(finished.returncode, 2, finished.stderr)
        reason = self.path("out/monitors.csv") + ": cannot be written: File too large."
        self.assertIn("error: " + reason, finished.stderr)
        manifest = self.manifest("out")
        self.assertEqual(manifest["status"], "failed")
        self.assertEqual(manifest["exit_reason"].split("\n")[0], reason)
        self.assertIsNotNone(manifest["ended"])
        self.assertIsNone(manifest["state_hash"])
        self.done("out", growing, "--resume")
        self.assert_same_results("whole", "out")


class Killed(ResumeTest):
    def test_at_any_moment_a_run_goes_on_to_the_same_end(self):
        self.done("whole", LONGER)
        with open(self.path("whole/timing.json"), encoding="utf-8") as file:
            duration = json.load(file)["wall_s"]
        chance = random.Random(20260301)
        case = self.write(LONGER)
        killed = 0
        while killed < KILLS:
            more = ["--force"]   # a run from the start, killed again and again until it comes through
            while killed < KILLS:
                with open(self.path("log"), "w+", encoding="utf-8") as log, \
                        subprocess.Popen([SIMILITUDE, "run", case, "-o", self.path("out"), *more], stdout=subprocess.DEVNULL,
                                         stderr=log, cwd=self.folder.name) as process:
                    try:
                        process.wait(timeout=chance.uniform(0, 0.7 * duration))
                        log.seek(0)
                        self.assertEqual(process.returncode, 0, log.read())
                        break
                    except subprocess.TimeoutExpired:
                        process.kill()
                        killed += 1
                there = os.path.isdir(self.path("out/checkpoints")) and self.checkpoints("out")
                more = ["--resume"] if there else ["--force"]
            self.done("out", LONGER, *more)
            self.assert_same_results("whole", "out")


if __name__ == "__main__":
    unittest.main()
