#!/usr/bin/python3
"""Makes the runs behind docs/validation.md, the cheap ones first, and the page anew after each.

    docs/validation/run_all.py [RESULTS] [--only BED/CASE …] [--threads N] [--until SECONDS] [--set KEY=VALUE]… [--page PAGE]

RESULTS: default results/validation. Break it off as you like, by Ctrl-C or worse, and call it again: what is done is passed over and what
was begun goes on from its last checkpoint. Two runs of an eighth of the spheres took 90 and 98 minutes on one thread beside
other work; the two exact beds take many times that: `similitude check CASE` foretells it for the machine as it is.
--until, --set and --page are for trying it out. What a run says goes to RESULTS/BED/CASE.log. SIMILITUDE names another program than build/bin/similitude.
"""
import argparse
import os
import pathlib
import signal
import subprocess
import sys

from runs import run_of

HERE = pathlib.Path(__file__).resolve().parent
SOURCE = HERE.parent.parent
SOFT = ["models.contact.stiffness=200 N/m"]   # the paper's bed: longer steps than with the case's 500 N/m
# Folder under RESULTS and under configs/, settings, end in real time [s].
RUNS = [(f"yue2020/{case}", [], 6.0) for case in ("parcel", "link", "coarse_grain", "similarity")]
RUNS += [(f"spouted_bed/{case}", SOFT, 5.0) for case in ("terminal_velocity", "glicksman", "parcel", "link")]
RUNS += [("yue2020/exact", [], 6.0), ("spouted_bed/exact", SOFT, 3.0)]
PART = 0.5    # [s], real time after which a run pauses for the page to be made
SPARE = 0.1   # [s], more than a checkpoint can be ahead of the last frame of a run that was killed


def make_page(results, page):
    subprocess.run([sys.executable, HERE / "make_page.py", results] + ([page] if page else []), check=True)


def run_to_its_end(command, log):
    """Of a run that is interrupted: after its checkpoint. Returns its exit status, 128 and the signal's number if it was killed."""
    child = subprocess.Popen(command, stdout=log, stderr=log)
    before = [signal.signal(signal.SIGINT, lambda *_: None),   # Ctrl-C reaches the run itself
              signal.signal(signal.SIGTERM, lambda *_: child.terminate())]
    status = child.wait()
    for number, handler in zip((signal.SIGINT, signal.SIGTERM), before):
        signal.signal(number, handler)
    return status if status >= 0 else 128 - status


def advance(folder, name, settings, threads, end, after_part):
    """Runs to `end` from wherever it is, in parts. Returns the exit status of the part that failed, or 0."""
    program = os.environ.get("SIMILITUDE", SOURCE / "build" / "bin" / "similitude")
    while True:
        run = run_of(folder)
        reached = run["reached"] if run else 0.0
        if run and run["status"] == "done" and reached >= end * (1 - 1e-6):
            return 0
        part = PART
        while part <= reached + SPARE:
            part += PART
        command = [program, "run", SOURCE / "configs" / f"{name}.yaml", "-o", folder, "--until", f"{min(part, end):.6g} s"]
        if threads:
            command += ["--threads", str(threads)]
        for setting in settings:
            command += ["--set", setting]
        if any((folder / "checkpoints").glob("*.h5")):
            command.append("--resume")
        elif folder.exists():
            command.append("--force")   # killed while the bed was settled: there is nothing to go on from
        print(f"== {name} to {min(part, end):.6g} s", flush=True)
        with open(folder.parent / f"{folder.name}.log", "a", encoding="utf-8") as log:
            status = run_to_its_end(command, log)
        if status != 0:
            print(f"{name} ended with exit status {status}: see {folder}.log", file=sys.stderr)
            return status
        after_part()


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("results", nargs="?", type=pathlib.Path, default=SOURCE / "results" / "validation")
    parser.add_argument("--only", nargs="+", metavar="BED/CASE", choices=[name for name, _, _ in RUNS])
    parser.add_argument("--threads", type=int, help="of each run; default: all. With 1 and --only several of these go side by side")
    parser.add_argument("--until", type=float, metavar="SECONDS", help="of the real bed; no later than each run's own end")
    parser.add_argument("--set", action="append", default=[], metavar="KEY=VALUE")
    parser.add_argument("--page", type=pathlib.Path, help="default: docs/validation.md")
    given = parser.parse_args()
    failed = 0
    for name, settings, end in RUNS:
        if given.only and name not in given.only:
            continue
        folder = given.results / name
        folder.parent.mkdir(parents=True, exist_ok=True)
        status = advance(folder, name, settings + given.set, given.threads, min(end, given.until or end), lambda: make_page(given.results, given.page))
        if status >= 128:   # interrupted
            return status
        failed = failed or status
    make_page(given.results, given.page)
    return failed


if __name__ == "__main__":
    sys.exit(main())
