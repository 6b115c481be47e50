"""Profiles of the runs of configs/yue2020 over those that Yue et al. (2020) measured: a section of docs/validation.md.

Speeds are means of |v| of the particles whose centres lie within 5 mm of a height, over the whole depth as in Lethe's comparison with the same
data, or over the front sixth of it, which is what a camera sees. All frames from the case's `output.profiles.from` on; intervals
are 95 % from ten blocks of time.
"""
import csv
import pathlib

import numpy as np

from runs import frames_of, run_of, table, what_was_run

PIV = pathlib.Path(__file__).resolve().parent.parent.parent / "configs" / "yue2020" / "piv"
HEIGHTS = {30: "015", 60: "030", 90: "045", 120: "060", 150: "075", 160: "080"}   # mm: file of the measurement
CASES = ["parcel", "link", "coarse_grain", "similarity", "exact"]
WIDTH, DEPTH, BIN, BAND, BLOCKS = 280.0, 40.0, 7.0, 5.0, 10   # mm, mm, mm, mm, -
AXIS = 30.0         # mm, peaks are looked for within
STUDENT = 2.262     # 95 %, nine degrees of freedom
POINTS_APART = 7.0  # mm, of the measurement


def measured(height):
    with open(PIV / f"spouted_bed_data_{HEIGHTS[height]}.csv", encoding="utf-8") as file:
        rows = [(float(x), float(v)) for x, v in list(csv.reader(file))[1:]]
    return np.array(rows).T


def peak_of(x, v):
    """The number of the bin with the largest speed near the axis; nothing if no particle was seen there."""
    near = np.where((np.abs(x) < AXIS) & np.isfinite(v), v, -1.0)
    return int(np.argmax(near)) if near.max() >= 0 else None


def width_of(x, v, top):
    """Distance between the places on the two sides of a peak where half of it is reached; nothing where a side does not fall that far."""
    edges = []
    for side in (-1, 1):
        n = top
        while 0 < n < len(v) - 1 and v[n] > v[top] / 2:
            n += side
        inner, outer = n - side, n
        if not v[outer] <= v[top] / 2:
            return None
        edges.append(x[inner] + (x[outer] - x[inner]) * (v[inner] - v[top] / 2) / (v[inner] - v[outer]))
    return edges[1] - edges[0]


def profiles_of(frames):
    """Of each layer and height: places [mm], means and half intervals [m/s]."""
    from vtkmodules.util.numpy_support import vtk_to_numpy
    from vtkmodules.vtkIOXML import vtkXMLPolyDataReader

    layers = {"whole": DEPTH, "front": DEPTH / 6}
    bins = int(WIDTH // BIN)
    sums = {layer: np.zeros((len(frames), len(HEIGHTS), bins)) for layer in layers}
    counts = {layer: np.zeros((len(frames), len(HEIGHTS), bins)) for layer in layers}
    for f, frame in enumerate(frames):
        reader = vtkXMLPolyDataReader()
        reader.SetFileName(str(frame))
        reader.Update()
        data = reader.GetOutput()
        place = 1e3 * vtk_to_numpy(data.GetPoints().GetData())
        speed = np.linalg.norm(vtk_to_numpy(data.GetPointData().GetArray("velocity [m/s]")), axis=1)
        column = np.clip((place[:, 0] / BIN).astype(int), 0, bins - 1)
        for h, height in enumerate(HEIGHTS):
            for layer, depth in layers.items():
                there = (np.abs(place[:, 2] - height) < BAND) & (place[:, 1] < depth)
                counts[layer][f, h] = np.bincount(column[there], minlength=bins)
                sums[layer][f, h] = np.bincount(column[there], weights=speed[there], minlength=bins)
    x = (np.arange(bins) + 0.5) * BIN - WIDTH / 2
    profiles = {}
    for layer in layers:
        for h, height in enumerate(HEIGHTS):
            with np.errstate(invalid="ignore", divide="ignore"):
                mean = sums[layer][:, h].sum(0) / counts[layer][:, h].sum(0)
                blocks = np.array([part.sum(0) / number.sum(0) for part, number in
                                   zip(np.array_split(sums[layer][:, h], BLOCKS), np.array_split(counts[layer][:, h], BLOCKS))])
                seen = np.isfinite(blocks).all(0)
                half = np.where(seen, STUDENT * np.std(blocks, axis=0, ddof=1) / np.sqrt(BLOCKS), np.nan)
            profiles[layer, height] = (x, mean, half)
    return profiles


def draw(runs, picture):
    import matplotlib

    matplotlib.use("Agg")
    import matplotlib.pyplot as plt

    figure, axes = plt.subplots(2, 3, figsize=(12, 6.8), sharex=True, sharey=True, constrained_layout=True)
    for axis, height in zip(axes.flat, HEIGHTS):
        x, v = measured(height)
        for number, (name, (_, profiles)) in enumerate(runs.items()):
            places, mean, half = profiles["whole", height]
            seen, told = np.isfinite(mean), np.isfinite(half)
            axis.plot(places[seen], mean[seen], color=f"C{number}", linewidth=1, label=name)
            axis.errorbar(places[told], mean[told], half[told], color=f"C{number}", linewidth=0, elinewidth=0.8)
        axis.plot(x, v, "ko", markersize=3.5, label="measured", zorder=5)
        axis.set_title(f"{height} mm above the floor", fontsize=10)
        axis.grid(alpha=0.3)
    for axis in axes[:, 0]:
        axis.set_ylabel("particle speed [m/s]")
    for axis in axes[1]:
        axis.set_xlabel("distance from the axis [mm]")
    axes[0, 0].legend(fontsize=8)
    figure.savefig(picture, dpi=110)
    plt.close(figure)


class Comparison:
    """Of one run with the measurement at one height."""

    def __init__(self, profiles, height):
        self.height = height
        x, v = measured(height)
        top = peak_of(x, v)
        self.peak, self.width = v[top], width_of(x, v, top)
        places, mean, half = profiles["whole", height]
        ours = peak_of(places, mean)
        self.our_peak = self.our_half = self.our_width = self.front = self.distance = None
        if ours is None:
            return
        self.our_peak, self.our_half, self.our_width = mean[ours], half[ours], width_of(places, mean, ours)
        front = peak_of(places, profiles["front", height][1])
        self.front = None if front is None else profiles["front", height][1][front]
        seen = np.isfinite(mean)
        difference = np.interp(x, places[seen], mean[seen]) - v
        self.distance = np.sqrt(np.mean(difference ** 2)) / self.peak

    def beyond(self):
        """Whether the peaks differ by more than the run's interval."""
        return self.our_peak is not None and abs(self.our_peak - self.peak) > self.our_half

    def words(self):
        if self.our_peak is None:
            return "no particles"
        interval = f" ± {self.our_half:.2f}" if np.isfinite(self.our_half) else ""
        width = f"{self.our_width:.0f} mm" if self.our_width else "not half"
        return f"{self.our_peak:.2f}{interval} m/s, {width}"


def judged(name, comparisons):
    """What a reader wants to know about a run, good or bad."""
    seen = [c for c in comparisons if c.our_peak is not None]
    if not seen:
        return f"* **{name}**: no particles at any of the heights."
    share = [c.our_peak / c.peak - 1 for c in seen]
    text = (f"* **{name}**: peaks from {100 * min(share):+.0f} % to {100 * max(share):+.0f} % beside the measured; over the whole width "
            f"{100 * np.mean([c.distance for c in seen]):.0f} % of the peak away (root mean square, mean of the heights).")
    far = [c for c in seen if c.beyond()]
    if far:
        text += " Beyond its interval at " + ", ".join(f"{c.height} mm ({c.our_peak:.2f} for {c.peak:.2f} m/s)" for c in far) + "."
    wide = [c for c in seen if c.our_width and abs(c.our_width - c.width) > POINTS_APART]
    if wide:
        text += " The spout's width is off by more than the measurement's spacing at " + ", ".join(
            f"{c.height} mm ({c.our_width:.0f} for {c.width:.0f} mm)" for c in wide) + "."
    return text


def section(results, pictures):
    """Lines of the page."""
    runs, told = {}, []
    for name in CASES:
        run = run_of(results / "yue2020" / name)
        frames = frames_of(run) if run else []
        compared = len(frames) >= 2 * BLOCKS
        told.append((name, run, compared))
        if compared:
            runs[name] = (run, profiles_of(frames))
    picture = pictures / "yue2020.png"
    draw(runs, picture)
    lines = ["## The rectangular spouted bed of Yue et al. (2020)", "",
             "Set-up, assumptions and the origin of the measurements: [configs/yue2020](../configs/yue2020/README.md). Circles are "
             "measured; lines are runs, averaged over the whole depth, with 95 % intervals. Wall times hold whatever else the machine did meanwhile.", "",
             f"![particle speed over the width at six heights]({picture.parent.name}/{picture.name})", ""]
    lines += what_was_run(told)
    if not runs:
        return lines + ["", "No run has come far enough to be compared: the picture shows the measurement alone."]
    comparisons = {name: [Comparison(profiles, height) for height in HEIGHTS] for name, (_, profiles) in runs.items()}
    first = next(iter(comparisons.values()))
    rows = [["measured"] + [f"{c.peak:.2f} m/s, {c.width:.0f} mm" for c in first]]
    for name, compared in comparisons.items():
        rows.append([name] + [c.words() for c in compared])
        rows.append([f"{name}, front sixth of the depth"] + ["-" if c.front is None else f"{c.front:.2f} m/s" for c in compared])
    lines += ["", "Peak of the mean particle speed near the axis, and the width of what is faster than half of it:", ""]
    lines += table([""] + [f"{height} mm" for height in HEIGHTS], rows)
    lines += ["", "Where they agree and where they do not:", ""] + [judged(name, compared) for name, compared in comparisons.items()]
    lines += ["", "What the comparison cannot tell: the measured points lie 7 mm apart, so a width is good to 4 mm at best; the measured profiles are "
              "not symmetric, so left and right are not compared; the camera saw the spheres at the front wall, and how deep is not known; "
              "the number of spheres and the height of the bed at rest that are published do not fit each other, and the number was kept."]
    return lines
