#!/usr/bin/python3
"""Draws the accuracy-cost frontiers of the shipped studies and tells them in tables, between the markers of docs/performance.md.

  configs/studies/run_all [RESULTS]     makes the studies (default: results/studies)
  docs/draw_studies.py [RESULTS]        pictures into docs/pictures/, tables and advice into docs/performance.md

A study that RESULTS does not hold is named as missing. Nothing is drawn but what stands in study.json.
"""
import json
import sys
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt   # noqa: E402
from matplotlib.ticker import FixedLocator, FuncFormatter   # noqa: E402

ROOT = Path(__file__).resolve().parent.parent
STUDIES = ["impact", "slab", "time_step", "mesh", "stiffness", "smoothing", "contact", "drag", "fluid", "scaling"]
BEGIN, END = "<!-- studies: begin -->", "<!-- studies: end -->"
COLOURS = ["#0072b2", "#d55e00", "#009e73", "#cc79a7", "#a6761d", "#3aa0dc", "#6a3d9a", "#555555"]   # Okabe & Ito (2008)
MARKS = "os^DvPX*"


def known(value):
    return isinstance(value, (int, float))


def seconds(value):
    if value < 120:
        return f"{value:.3g} s"
    return f"{value / 60:.3g} min" if value < 7200 else f"{value / 3600:.3g} h"


def two_digits(value):
    """170, not 1.7e+02."""
    rounded = float(f"{value:.2g}")
    return f"{rounded:.0f}" if abs(rounded) >= 100 else f"{value:.2g}"


def error_words(error):
    """As the command says it: 6 ± 4 %, 0 to 5 %."""
    if not known(error.get("value")):
        return "none"
    at_least = "at least " if error["lower_bound"] else ""
    if error["low"] <= 0 < error["high"]:
        return f"0 to {at_least}{two_digits(100 * error['high'])} %"
    if error["high"] == error["low"]:
        return f"{two_digits(100 * error['value'])} %"
    return f"{two_digits(100 * error['value'])} ± {at_least}{two_digits(50 * (error['high'] - error['low']))} %"


def shown_cases(study):
    metric = study["frontier"]["metric"]
    return [case for case in study["cases"] if known(case["wall_s"]) and known(case["error"].get(metric, {}).get("value"))]


def draw(study, picture):
    metric = study["frontier"]["metric"]
    figure, axes = plt.subplots(figsize=(7, 3.9), layout="constrained")
    cases = shown_cases(study)
    for k, case in enumerate(cases):
        error = case["error"][metric]
        value, low, high = (100 * error[end] for end in ("value", "low", "high"))
        low = max(0.0, low)
        axes.errorbar(case["wall_s"], value, yerr=[[max(0, value - low)], [max(0, high - value)]], fmt=MARKS[k % len(MARKS)],
                      color=COLOURS[k % len(COLOURS)], markersize=8 if case["reference"] else 6, capsize=3, linewidth=1.4,
                      markerfacecolor="white" if case["reference"] else None, markeredgewidth=1.6, label=case["name"])
    front = sorted((case for case in cases if case["pareto"]), key=lambda case: case["wall_s"])
    axes.step([case["wall_s"] for case in front], [100 * case["error"][metric]["value"] for case in front], where="post",
              color="#777777", linewidth=1, zorder=0)
    walls = [case["wall_s"] for case in cases]
    axes.set_xscale("log")
    axes.set_xlim(min(walls) / 1.3, max(walls) * 1.3)
    subs = (1, 2, 5) if max(walls) > 5 * min(walls) else (1, 1.5, 2, 3, 4, 5, 6, 8)
    unit = 60 if min(walls) >= 120 else 1   # as seconds() writes them
    axes.xaxis.set_major_locator(FixedLocator([unit * sub * 10.0 ** power for power in range(-5, 5) for sub in subs]))
    axes.xaxis.set_minor_locator(matplotlib.ticker.NullLocator())
    axes.xaxis.set_major_formatter(FuncFormatter(lambda value, _: seconds(value)))
    axes.set_ylim(bottom=0)
    axes.set_xlabel("wall time")
    axes.set_ylabel(metric.replace("_", " ") + " error [%]")
    axes.set_title(study["title"], fontsize=11, loc="left")
    axes.grid(color="#e6e8ea")
    axes.set_axisbelow(True)
    axes.legend(fontsize=8, frameon=False, loc="center left", bbox_to_anchor=(1, 0.5))
    for side in ("top", "right"):
        axes.spines[side].set_visible(False)
    figure.savefig(picture, dpi=110, metadata={"Software": None})
    plt.close(figure)


def predicted_words(case):
    predicted = case.get("predicted") or {}
    return f"{seconds(predicted['wall_s'])}" if known(predicted.get("wall_s")) else "none"


def table(study):
    metrics = [metric["name"] for metric in study["metrics"]]
    lines = ["| case | wall time | foretold | " + " | ".join(name.replace("_", " ") + " error" for name in metrics) + " |",
             "|---|---:|---:|" + "---:|" * len(metrics)]
    for case in study["cases"]:
        name = case["name"] + (" (reference)" if case["reference"] else "") + (" \\*" if case["pareto"] else "")
        if case["status"] != "done":
            lines.append(f"| {name} | {case['status']} |" + " |" * (len(metrics) + 1))
            continue
        errors = ["" if case["reference"] and case["error"][m].get("value") == 0 else error_words(case["error"][m]) for m in metrics]
        wall = seconds(case["wall_s"]) if known(case["wall_s"]) else "none"
        lines.append(f"| {name} | {wall} | {predicted_words(case)} | " + " | ".join(errors) + " |")
    return "\n".join(lines)


def orders(study):
    lines = []
    for order in study["orders"]:
        value = order["order"]
        what = f"{order['metric'].replace('_', ' ')} along {order['axis']}"
        if not known(value.get("value")):
            lines.append(f"* {what}: {value['gap']}.")
        elif known(value.get("low")) and value["high"] > value["low"]:
            lines.append(f"* {what}: order {value['value']:.2f} ({value['low']:.2f} to {value['high']:.2f}).")
        else:
            lines.append(f"* {what}: order {value['value']:.2f}.")
    return "\n".join(lines)


def predictions(studies):
    ratios = sorted(case["predicted"]["wall_s"] / case["wall_s"] for study in studies for case in study["cases"]
                    if known(case["wall_s"]) and known((case.get("predicted") or {}).get("wall_s")))
    if not ratios:
        return ""
    off = sorted(abs(ratio - 1) for ratio in ratios)
    return (f"Foretold wall times of these {len(ratios)} runs: {100 * off[len(off) // 2]:.0f} % off in the median, between "
            f"{ratios[0]:.2f} and {ratios[-1]:.2f} of what was measured.\n\n")


def chapter(results):
    parts, found = [], []
    for name in STUDIES:
        file = results / name / "study.json"
        if not file.exists():
            parts.append(f"### {name}\n\nNo results of this study are kept here yet.\n")
            continue
        study = json.loads(file.read_text(encoding="utf-8"))
        found.append(study)
        title = f"### {study['title']}\n\n`similitude study configs/studies/{name}.yaml`\n\n{study['advice']}\n\n"
        if shown_cases(study):
            draw(study, ROOT / "docs/pictures" / f"study_{name}.png")
            title += f"![wall time against error: {name}](pictures/study_{name}.png)\n\n"
        parts.append(title + table(study) + "\n" + ("\n" + orders(study) + "\n" if study["orders"] else ""))
    machines = sorted({f"{study['machine']['processor']}, {study['threads']} threads" for study in found})
    head = f"Made on {'; '.join(machines)}. \\* no other case beats it in both time and the first error.\n\n" if found else ""
    return head + predictions(found) + "\n".join(parts)


def main():
    if len(sys.argv) > 2 or (len(sys.argv) == 2 and sys.argv[1].startswith("-")):
        sys.exit(__doc__)
    results = Path(sys.argv[1]) if len(sys.argv) == 2 else ROOT / "results/studies"
    page = ROOT / "docs/performance.md"
    text = page.read_text(encoding="utf-8")
    if BEGIN not in text or END not in text:
        sys.exit(f"{page}: the markers {BEGIN} and {END} are missing.")
    before, rest = text.split(BEGIN, 1)
    page.write_text(before + BEGIN + "\n" + chapter(results) + "\n" + END + rest.split(END, 1)[1], encoding="utf-8")


if __name__ == "__main__":
    main()
