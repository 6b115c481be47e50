#!/usr/bin/env python3
"""Runs one small fluidised bed under every model in turn and writes the tables of docs/reference/choosing.md.

  docs/reference/measure_models.py build/bin/similitude build/tests/model_prices     some ten minutes on one core

The bed: 2 000 spheres of 1 mm alumina (1040 kg/m^3), 12 x 12 mm, in air at 0.6 m/s, 1.7 times what lifts it; 1 s, of which the
last 0.7 s are averaged. A standard error comes from seven blocks of 0.1 s. Every run is a run of the program with a case
file; --keep FOLDER keeps them, and runs that are there already are not repeated. Prices are given as shares and in
processor time, which other work on the machine moves little."""

import argparse
import csv
import json
import math
import os
import pathlib
import re
import subprocess
import sys
import tempfile

PAGE = pathlib.Path(__file__).resolve().parent / "choosing.md"
FROM, BLOCK, END = 0.3, 0.1, 1.0   # [s]

CASE = """similitude: 1
title: a small fluidised bed
scene:
  domain:    {{size: [12 mm, 12 mm, 80 mm], cell: 2 mm}}
  periodic:  [x, y]
  gas:       {{density: 1.225 kg/m^3, viscosity: 1.79e-5 Pa s}}
  particles: {{alumina: {{diameter: 1 mm, density: 1040 kg/m^3, count: 2000}}}}
  patches:
    inlet:  {{face: bottom, velocity: 0.6 m/s}}
    outlet: {{face: top, pressure: 0 Pa}}
models:
  drag: {drag}
  contact: {contact}
  fluid: {fluid}
  scaling: {scaling}
time: {{end: 1 s}}
output: {{vtk: none, monitors: every 2 ms}}
"""
USUAL = {"drag": "gidaspow", "fluid": "vans", "scaling": "exact",
         "contact": "{id: linear_spring, stiffness: 200 N/m, restitution: 0.8, friction: 0.3}"}
PARAMETERS = {
    "haider_levenspiel": "sphericity: 0.8",
    "linear_spring": "stiffness: 200 N/m, restitution: 0.8, friction: 0.3",
    "fluent_dem": "stiffness: 200 N/m, restitution: 0.8",
    "hertz_mindlin": "youngs_modulus: 2 MPa, poisson_ratio: 0.25, restitution: 0.8, friction: 0.3",
    "hertz_thornton": "youngs_modulus: 2 MPa, poisson_ratio: 0.25, restitution: 0.8, friction: 0.3",
}


def is_done(results):
    manifest = results / "manifest.json"
    return manifest.exists() and json.loads(manifest.read_text())["status"] == "done"


class Run:
    """One case, run; means over the window with their standard errors, and where the time went."""

    def __init__(self, program, folder, name, **models):
        case = folder / f"{name}.yaml"
        case.write_text(CASE.format(**(USUAL | models)))
        results = folder / name
        self.failed = None
        if not is_done(results):
            said = subprocess.run([program, "run", case, "-o", results, "--force", "--threads", "1"], capture_output=True, text=True)
            self.failed = said.stderr.strip().splitlines()[-2:] if said.returncode else None
        if self.failed:
            return
        with open(results / "monitors.csv") as file:
            rows = [{k: float(v) if v else math.nan for k, v in row.items()} for row in csv.DictReader(file)]
        self.blocks = [[r for r in rows if FROM + n * BLOCK <= r["time [s]"] < FROM + (n + 1) * BLOCK]
                       for n in range(round((END - FROM) / BLOCK))]
        timing = json.loads((results / "timing.json").read_text())
        self.wall = timing["wall_s"]
        self.particle_steps = timing["particle_steps"]
        self.share = {s["name"]: s["seconds"] for s in timing["stages"]}

    def mean(self, column):
        means = [sum(r[column] for r in block) / len(block) for block in self.blocks]
        mean = sum(means) / len(means)
        error = math.sqrt(sum((m - mean) ** 2 for m in means) / (len(means) - 1) / len(means))
        return mean, error

    def seconds(self, start):
        return sum(seconds for name, seconds in self.share.items() if name.startswith(start))


def with_parameters(model):
    return f"{{id: {model}, {PARAMETERS[model]}}}" if model in PARAMETERS else model


def pair(value, scale=1.0, digits=1):
    mean, error = value
    return f"{scale * mean:.{digits}f} ± {scale * error:.{digits}f}"


def prices(benchmark):
    if not benchmark:
        return {}
    said = subprocess.run([benchmark, "--benchmark_format=json", "--benchmark_min_time=0.5"], check=True, capture_output=True,
                          text=True, env=os.environ | {"OMP_NUM_THREADS": "1"})
    out = {}
    for row in json.loads(said.stdout)["benchmarks"]:
        out[row["name"]] = 1e9 * row.get("per_particle", row.get("per_contact"))
    return out


def table(head, runs, row):
    """A line per (name, run, cost); a run that failed says so. `row` makes the cells between the name and the cost."""
    columns = head.count("|") - 1
    lines = [head, "|---" * columns + "|"]
    for name, r, cost in runs:
        cells = [f"did not end: {' '.join(r.failed)}"] + [""] * (columns - 2 - len(cost)) if r.failed else row(r)
        lines.append("| " + " | ".join([name, *cells, *cost]) + " |")
    return lines


def priced(run, kind, ids, price, digits):
    """Runs of every model of a kind with what model_prices says of it."""
    for model in ids:
        name = f"{kind}/{model}"
        yield model, run(f"{kind}_{model}", **{kind: with_parameters(model)}), [f"{price[name]:.{digits}f}" if name in price else ""]


def drag_table(run, ids, price):
    return table("| drag | bed height [mm] | pressure drop [Pa] | smallest gas fraction | ns per particle |",
                 priced(run, "drag", ids, price, 0),
                 lambda r: [pair(r.mean("bed_height [m]"), 1e3), pair(r.mean("pressure_drop [Pa]")),
                            pair(r.mean("smallest_gas_fraction [1]"), 1, 3)])


def contact_table(run, ids, price):
    return table("| contact | bed height [mm] | largest overlap [% of d] | sub-steps | ns per contact |",
                 priced(run, "contact", ids, price, 1),
                 lambda r: [pair(r.mean("bed_height [m]"), 1e3),
                            f"{max(row['largest_overlap [% of d]'] for block in r.blocks for row in block):.1f}",
                            f"{r.particle_steps / 2000:.0f}"])


def fluid_table(run, ids):
    choices = {model: model for model in ids if model != "prescribed"}
    choices |= {"vans, model_b": "{id: vans, momentum: model_b}", "vans, as_printed": "{id: vans, momentum: as_printed}",
                "vans, upwind": "{id: vans, advection: upwind}"}
    runs = ((name, run("fluid_" + re.sub(r"\W+", "_", name), fluid=text), []) for name, text in choices.items())
    return table("| fluid | bed height [mm] | pressure drop [Pa] | the gas's share of the run |", runs,
                 lambda r: [pair(r.mean("bed_height [m]"), 1e3), pair(r.mean("pressure_drop [Pa]")),
                            f"{100 * r.seconds('fluid: ') / r.wall:.0f} %"])


def replace_table(page, name, lines):
    begin, end = f"<!-- {name}: made by measure_models.py -->", f"<!-- end of {name} -->"
    before, rest = page.split(begin)
    return before + begin + "\n" + "\n".join(lines) + "\n" + end + rest.split(end)[1]


def main():
    words = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    words.add_argument("similitude", help="the program")
    words.add_argument("prices", nargs="?", help="model_prices, for the nanoseconds")
    words.add_argument("--keep", type=pathlib.Path, help="folder for cases and results")
    given = words.parse_args()
    listed = json.loads(subprocess.run([given.similitude, "plugins", "list", "--json"], check=True, capture_output=True).stdout)
    ids = {kind: [p["id"] for p in listed["plugins"] if p["kind"] == kind] for kind in ("drag", "contact", "fluid")}
    price = prices(given.prices)
    with tempfile.TemporaryDirectory() as scratch:
        folder = given.keep or pathlib.Path(scratch)
        folder.mkdir(parents=True, exist_ok=True)

        def run(name, **models):
            print(name, flush=True)
            return Run(given.similitude, folder, name, **models)

        for name, table in (("drag", lambda: drag_table(run, ids["drag"], price)),
                            ("contact", lambda: contact_table(run, ids["contact"], price)),
                            ("fluid", lambda: fluid_table(run, ids["fluid"]))):
            PAGE.write_text(replace_table(PAGE.read_text(), name, table()))
    return 0


if __name__ == "__main__":
    sys.exit(main())
