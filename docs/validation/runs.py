"""What a run's folder tells about it, also while it goes on and after it was broken off."""
import json
import pathlib
import re
import xml.etree.ElementTree as xml


def seconds_of(text):
    """Of a duration of a resolved case: "2 s"."""
    number, unit = text.split()
    assert unit == "s", text
    return float(number)


def run_of(folder):
    """Its manifest with what a page needs; None if there is no run."""
    folder = pathlib.Path(folder)
    manifest = folder / "manifest.json"
    if not manifest.exists():
        return None
    run = json.loads(manifest.read_text(encoding="utf-8"))
    run["folder"] = folder
    times = [float(data.get("timestep")) for data in datasets_of(folder)]
    run["reached"] = max([run.get("simulated_s") or 0.0] + times)
    run["end"] = seconds_of(run["case"]["time"]["end"])
    run["from"] = seconds_of(run["case"]["output"]["profiles"]["from"])
    timing = folder / "timing.json"
    run["wall_s"] = json.loads(timing.read_text(encoding="utf-8"))["wall_s"] if timing.exists() else None
    return run


def datasets_of(folder):
    pvd = folder / "particles.pvd"
    return list(xml.parse(pvd).getroot().iter("DataSet")) if pvd.exists() else []


def frames_of(run):
    """Files of particles within the window of averaging."""
    return [run["folder"] / data.get("file") for data in datasets_of(run["folder"]) if float(data.get("timestep")) >= run["from"] * (1 - 1e-9)]


def duration(seconds):
    if seconds is None:
        return "not known"
    return f"{seconds:.0f} s" if seconds < 120 else f"{seconds / 60:.0f} min" if seconds < 7200 else f"{seconds / 3600:.1f} h"


def table(titles, rows):
    lines = ["| " + " | ".join(titles) + " |", "|---" * len(titles) + "|"]
    return lines + ["| " + " | ".join(row) + " |" for row in rows]


def changes(run):
    """What the command line set otherwise than the case."""
    return [" ".join(found.split()) for found in re.findall(r"--set (.+?)(?= --|$)", run["command"])]


def what_was_run(told):
    """A table of (name, run or None, whether it is compared): nobody has to guess how much stands behind a curve."""
    rows = []
    for name, run, compared in told:
        if run is None:
            rows.append([name, "-", "not run", "-", "-", "-", "-"])
            continue
        reached = f"{run['reached']:.3g} s of {run['end']:.3g} s"
        averaged = f"{run['from']:.3g} to {run['reached']:.3g} s" if compared else "too short to compare"
        machine = f"{run['machine']['processor']}, {run['threads']} thread{'s' if run['threads'] > 1 else ''}"
        rows.append([name, str(run["particles"]), reached, averaged, duration(run["wall_s"]), machine, "; ".join(changes(run)) or "-"])
    return table(["case", "simulated particles", "reached", "averaged over", "wall time", "on", "set otherwise than the case"], rows)
