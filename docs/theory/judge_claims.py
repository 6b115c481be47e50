#!/usr/bin/python3
"""What was claimed of the scaling laws, held against the grain-by-grain bed: a table and a picture for docs/theory/scaling.md.

  similitude study configs/studies/scaling.yaml -o results/studies/scaling
  docs/theory/judge_claims.py [results/studies/scaling]

Everything is taken from study.json. An interval is 95 %, Student's t with the blocks of a bin less one; of a mean over bins, the mean of theirs, as if
the bins moved together. It is a lower bound, "at least", where the study says so of the case's profile: then a difference must be twice as large as its
interval to count.
"""
import json
import math
import sys
from dataclasses import dataclass
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt   # noqa: E402

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent))
from student_t import reach_95   # noqa: E402

PAGE, PICTURE = HERE / "scaling.md", HERE.parent / "pictures/scaling_profiles.png"
BEGIN, END = "<!-- claims: begin -->", "<!-- claims: end -->"
SAMPLER = "vertical_velocity [m/s]"
PLATES = (0.030, 0.045)   # [m], x of the draft plates, configs/small_bed
LOW, HIGH = 0.05, 0.15    # [m], heights; 10 and 30 cm of the bed of full size, which the claims are about
STILL = 0.05              # of the spout's speed: what "no motion" may mean
COLOURS = ["#0072b2", "#d55e00", "#009e73", "#cc79a7", "#a6761d", "#3aa0dc", "#000000"]


@dataclass
class Mean:
    """A mean over bins with the half width of its interval."""
    value: float
    reach: float
    at_least: bool   # the interval is a lower bound

    def minus(self, other):
        return Mean(self.value - other.value, math.hypot(self.reach, other.reach), self.at_least or other.at_least)

    def over(self, scale):
        return Mean(self.value / scale, self.reach / abs(scale), self.at_least)

    def stands_out(self):
        return abs(self.value) > (2 if self.at_least else 1) * self.reach

    def told(self, scale, form, unit):
        return f"{scale * self.value:{form}} ± {'at least ' if self.at_least else ''}{scale * self.reach:{form.lstrip('+')}} {unit}"

    def percent(self):
        return self.told(100, "+.1f", "%")

    def speed(self):
        return self.told(1, ".3f", "m/s")


def reach(b):
    """Of a bin, 95 %."""
    return reach_95(b["blocks"] - 1) * b["standard_error"]


def bins(case, z):
    return [b for p in case["profiles"] if p["sampler"] == SAMPLER for b in p["bins"] if abs(b["z"] - z) < 1e-9]


def mean_where(case, z, wanted):
    seen = [b for b in bins(case, z) if wanted(b["x"]) and b["mean"] is not None and b["standard_error"] is not None]
    return Mean(sum(b["mean"] for b in seen) / len(seen), sum(map(reach, seen)) / len(seen), case["at_least"])


def between_plates(case, z):
    return mean_where(case, z, lambda x: PLATES[0] < x < PLATES[1])


def outside(case, z):
    """The annulus, two bins off the plates: what moves up beside them belongs to the spout."""
    apart = PLATES[1] - PLATES[0]
    return mean_where(case, z, lambda x: x < PLATES[0] - apart / 2 or x > PLATES[1] + apart / 2)


def rising(case, z):
    """Width over which the solids rise [m]."""
    along = [b for b in bins(case, z) if b["mean"] is not None]
    return (along[1]["x"] - along[0]["x"]) * sum(b["mean"] > 0 for b in along)


def judge_shape(exact):
    spout, above = between_plates(exact, LOW), between_plates(exact, HIGH)
    still, falls = outside(exact, LOW), outside(exact, HIGH)
    narrow, wide = rising(exact, LOW), rising(exact, HIGH)
    lower = above.minus(spout)
    yield ("i: at 5 cm one narrow peak between the plates",
           "seen" if narrow <= PLATES[1] - PLATES[0] + 1e-9 and spout.value > spout.reach else "not seen",
           f"{spout.speed()}, {1e3 * narrow:.0f} mm wide")
    yield ("i: … and no motion outside them", "seen" if abs(still.value) + still.reach < STILL * spout.value else "not seen",
           f"{still.speed()}, {abs(still.value) / spout.value:.0%} of the spout: the annulus sinks")
    yield ("ii: at 15 cm the peak is lower",
           "not told: within error" if not lower.stands_out() else "seen" if lower.value < 0 else "not seen: it is higher", f"{above.speed()}: {lower.over(spout.value).percent()}")
    yield "ii: … and wider", "seen" if wide > narrow else "not seen", f"{1e3 * wide:.0f} mm"
    yield "ii: … with downflow at the sides", "seen" if falls.value < -falls.reach else "not seen", falls.speed()


def judge_laws(cases, exact):
    for name, claimed in (("link", "close"), ("terminal_velocity", "close"), ("parcel", "low"), ("glicksman", "low")):
        def difference(of, z):
            return of(cases[name], z).minus(of(exact, z)).over(of(exact, z).value)

        spout, above, sinks = difference(between_plates, LOW), difference(between_plates, HIGH), difference(outside, LOW)
        low = any(d.stands_out() and d.value < 0 for d in (spout, above))
        differs = spout.stands_out() or above.stands_out()
        if claimed == "low":
            verdict = "seen" if low else "not seen" if differs else "not seen: no difference beyond the error"
        else:
            verdict = "seen, within error" if not differs else f"not quite: {'low' if low else 'high'} by more than the error"
        yield f"iii: {name} is {claimed}", verdict, f"spout {spout.percent()} at 5 cm, {above.percent()} at 15 cm; annulus at 5 cm {sinks.percent()}"


def draw(cases):
    figure, axes = plt.subplots(1, 2, figsize=(9.5, 3.8), layout="constrained", sharey=True)
    for axis, z in zip(axes, (LOW, HIGH)):
        for colour, (name, case) in zip(COLOURS, cases.items()):
            shown = [b for b in bins(case, z) if b["mean"] is not None]
            error = [reach(b) if b["standard_error"] else 0 for b in shown]
            axis.errorbar([1e3 * b["x"] for b in shown], [b["mean"] for b in shown], error, label=name.replace("small_bed_", ""), color=colour, lw=1.2,
                          capsize=2, marker="o", ms=3, zorder=3 if case["reference"] else 2)
        for plate in PLATES:
            axis.axvline(1e3 * plate, color="0.7", lw=0.8, ls=":")
        axis.axhline(0, color="0.7", lw=0.8)
        axis.set_title(f"z = {1e3 * z:.0f} mm ({2e2 * z:.0f} cm of the full bed)", fontsize=10)
        axis.set_xlabel("x [mm]")
    axes[0].set_ylabel("vertical velocity of the solids [m/s]")
    axes[0].legend(fontsize=7.5, frameon=False, loc="upper left")
    figure.savefig(PICTURE, dpi=110)


def main():
    study = json.loads((Path(sys.argv[1] if len(sys.argv) > 1 else "results/studies/scaling") / "study.json").read_text())
    cases = {case["name"]: case for case in study["cases"]}
    exact = next(case for case in study["cases"] if case["reference"])
    others = [case for case in study["cases"] if case is not exact]
    for case in study["cases"]:   # of the reference the study does not say: as its worst partner
        case["at_least"] = any(one["error"]["velocity_profile"]["lower_bound"] for one in (others if case is exact else [case]))
    draw(cases)
    lines = [BEGIN, "| claim | verdict | measured |", "|---|---|---|"]
    for row in [*judge_shape(exact), *judge_laws(cases, exact)]:
        lines.append("| " + " | ".join(row) + " |")
    page = PAGE.read_text()
    PAGE.write_text(page[:page.index(BEGIN)] + "\n".join(lines) + "\n" + page[page.index(END):])
    print("\n".join(lines[1:]))


if __name__ == "__main__":
    main()
