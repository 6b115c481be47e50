"""The bed of the paper at its full size: four scaling laws over the bed of every grain, a section of docs/validation.md from the runs'
profiles.csv. Intervals are 95 %, of block averages.
"""
import csv
import math
import pathlib
import sys

from runs import run_of, table, what_was_run

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))
from student_t import NORMAL, reach_95   # noqa: E402

CASES = ["terminal_velocity", "glicksman", "parcel", "link", "exact"]
SAMPLER = "vertical_velocity [m/s]"
FEW_BLOCKS = 5.0   # below, a standard error means nothing


def profiles_of(run):
    """Of each height [m]: places [m], means and half intervals [m/s]; empty before the window of averaging has begun."""
    file = run["folder"] / "profiles.csv"
    profiles = {}
    if not file.exists():
        return profiles
    with open(file, encoding="utf-8") as lines:
        for row in csv.DictReader(lines):
            mean, error = (float(row[name] or "nan") for name in ("mean", "standard error"))
            if row["sampler"] != SAMPLER or not math.isfinite(mean):
                continue
            blocks = float(row["blocks"])
            half = reach_95(blocks - 1) * error if math.isfinite(error) and blocks >= FEW_BLOCKS else math.nan
            profiles.setdefault(float(row["z"]), []).append((float(row["x"]), mean, half))
    return profiles


def draw(runs, heights, picture):
    import matplotlib

    matplotlib.use("Agg")
    import matplotlib.pyplot as plt

    figure, axes = plt.subplots(1, len(heights), figsize=(12, 4.2), constrained_layout=True, squeeze=False)
    for axis, height in zip(axes[0], heights):
        for number, (name, (_, profiles)) in enumerate(runs.items()):
            if height not in profiles:
                continue
            x, mean, half = ([column * scale for column in values] for values, scale in zip(zip(*profiles[height]), (1e3, 1, 1)))
            if name == "exact":
                axis.errorbar(x, mean, half, color="k", linewidth=1.6, label="every grain", zorder=5)
            else:
                axis.errorbar(x, mean, half, color=f"C{number}", linewidth=1, elinewidth=0.7, label=name)
        axis.set_title(f"{1e3 * height:.0f} mm above the floor", fontsize=10)
        axis.set_xlabel("x [mm]")
        axis.grid(alpha=0.3)
    axes[0][0].set_ylabel("vertical velocity of the grains [m/s]")
    axes[0][0].legend(fontsize=8)
    figure.savefig(picture, dpi=110)
    plt.close(figure)


def distance(profile, reference):
    """Root mean square difference over the bins that both have, and what noise alone would make of it, in shares of the reference's
    largest speed."""
    ours = {x: (mean, half) for x, mean, half in profile}
    both = [(ours[x], (mean, half)) for x, mean, half in reference if x in ours]
    if not both:
        return None
    largest = max(abs(mean) for _, (mean, _) in both)
    squares = sum((a[0] - b[0]) ** 2 for a, b in both) / len(both)
    noise = sum((a[1] ** 2 + b[1] ** 2) / NORMAL ** 2 for a, b in both) / len(both)
    return math.sqrt(squares) / largest, math.sqrt(noise) / largest if math.isfinite(noise) else math.nan


def deepest_overlap(run):
    """[% of d], of the whole run; None before its first row of monitors."""
    file = run["folder"] / "monitors.csv"
    if not file.exists():
        return None
    with open(file, encoding="utf-8") as lines:
        return max((float(row["largest_overlap [% of d]"]) for row in csv.DictReader(lines)), default=None)


def why_soft(runs):
    """The springs of the runs, and what they did."""
    text = ("The springs are of 200 N/m where the cases have 500: a contact lasts 1.6 times as long and so do the particles' steps, 5.4 for 3.4 us in the "
            "exact bed (`similitude check configs/spouted_bed/exact.yaml`, with `--set \"models.contact.stiffness=200 N/m\"` and without). ")
    deepest = {name: found for name, run in runs if run and (found := deepest_overlap(run)) is not None}
    if not deepest:
        return text + "How deep contacts go is told here once there is a run."
    return text + ("The price is deeper contacts; the deepest of each run, in shares of a diameter (above 5 % a run warns): " +
                   ", ".join(f"{name} {found:.1f} %" for name, found in deepest.items()) + ".")


def section(results, pictures):
    """Lines of the page."""
    runs, told = {}, []
    for name in CASES:
        run = run_of(results / "spouted_bed" / name)
        profiles = profiles_of(run) if run else {}
        told.append((name, run, bool(profiles)))
        if profiles:
            runs[name] = (run, profiles)
    lines = ["## The paper's spouted bed with draft plates, at full size", "",
             "461 000 grains of alumina ([configs/spouted_bed](../configs/spouted_bed)), with a spring of 200 N/m in all five cases. The paper "
             "compared the laws with a measurement whose bed it does not describe; here they are compared with the bed of every grain.", ""]
    lines += what_was_run(told)
    lines += ["", why_soft((name, run) for name, run, _ in told)]
    if not runs:
        return lines + ["", "No run has come to its window of averaging."]
    heights = sorted({height for _, profiles in runs.values() for height in profiles})
    picture = pictures / "spouted_bed.png"
    draw(runs, heights, picture)
    lines += ["", f"![vertical velocity of the grains over the width]({picture.parent.name}/{picture.name})"]
    if "exact" not in runs:
        return lines + ["", "The bed of every grain is missing: the laws can be seen beside each other, and none of them judged."]
    exact = runs["exact"][1]
    rows = []
    for name, (_, profiles) in runs.items():
        if name == "exact":
            continue
        cells = []
        for height in heights:
            found = distance(profiles[height], exact[height]) if height in profiles and height in exact else None
            noise = "" if found is None or math.isnan(found[1]) else f" (noise alone {100 * found[1]:.0f} %)"
            cells.append("-" if found is None else f"{100 * found[0]:.0f} %{noise}")
        rows.append([name] + cells)
    lines += ["", "Root mean square difference from the bed of every grain, in shares of its largest speed at that height:", ""]
    lines += table([""] + [f"{1e3 * height:.0f} mm" for height in heights], rows)
    return lines
