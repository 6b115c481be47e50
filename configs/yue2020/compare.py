"""Profiles of the runs of this folder over those that Yue et al. (2020) measured; writes docs/validation.md.

    /usr/bin/python3 configs/yue2020/compare.py [RESULTS [PAGE]]

RESULTS holds a folder per case, as README.md says. Speeds are means of |v| of the particles whose centres lie within 5 mm of a height
and in the middle third of the depth, over all frames from 2 s on; bars are 95 % from ten blocks of time.
"""
import csv
import json
import pathlib
import sys
import xml.etree.ElementTree as xml

import numpy as np

HERE = pathlib.Path(__file__).parent
HEIGHTS = {30: "015", 60: "030", 90: "045", 120: "060", 150: "075", 160: "080"}   # mm: file of the measurement
CASES = ["exact", "parcel", "link", "coarse_grain", "similarity"]
WIDTH, DEPTH, BIN, BAND, FROM, BLOCKS = 280.0, 40.0, 7.0, 5.0, 2.0, 10   # mm, mm, mm, mm, s, -
STUDENT = 2.262   # 95 %, nine degrees of freedom


def measured(height):
    with open(HERE / "piv" / f"spouted_bed_data_{HEIGHTS[height]}.csv", encoding="utf-8") as file:
        rows = [(float(x), float(v)) for x, v in list(csv.reader(file))[1:]]
    return np.array(rows).T


def peak_and_width(x, v):
    """The largest speed near the axis, and the distance between the places on its two sides where half of it is reached."""
    top = int(np.nanargmax(np.where(np.abs(x) < 30, v, np.nan)))
    edges = []
    for side in (-1, 1):
        n = top
        while 0 < n < len(v) - 1 and v[n] > v[top] / 2:
            n += side
        inner, outer = n - side, n
        edges.append(x[inner] + (x[outer] - x[inner]) * (v[inner] - v[top] / 2) / (v[inner] - v[outer]))
    return v[top], edges[1] - edges[0]


def frames_of(folder):
    for data in xml.parse(folder / "particles.pvd").getroot().iter("DataSet"):
        if float(data.get("timestep")) >= FROM:
            yield folder / data.get("file")


def profiles_of(folder):
    """Of each height: places [mm], means and half intervals [m/s]; nothing if the run is not done."""
    from vtkmodules.util.numpy_support import vtk_to_numpy
    from vtkmodules.vtkIOXML import vtkXMLPolyDataReader

    manifest = folder / "manifest.json"
    if not manifest.exists() or json.loads(manifest.read_text(encoding="utf-8")).get("status") != "done":
        return None
    frames = list(frames_of(folder))
    bins = int(WIDTH // BIN)
    sums, counts = np.zeros((len(frames), len(HEIGHTS), bins)), np.zeros((len(frames), len(HEIGHTS), bins))
    for f, frame in enumerate(frames):
        reader = vtkXMLPolyDataReader()
        reader.SetFileName(str(frame))
        reader.Update()
        data = reader.GetOutput()
        place = 1e3 * vtk_to_numpy(data.GetPoints().GetData())
        speed = np.linalg.norm(vtk_to_numpy(data.GetPointData().GetArray("velocity [m/s]")), axis=1)
        middle = np.abs(place[:, 1] - DEPTH / 2) < DEPTH / 6
        column = np.minimum((place[:, 0] / BIN).astype(int), bins - 1)
        for h, height in enumerate(HEIGHTS):
            there = middle & (np.abs(place[:, 2] - height) < BAND)
            counts[f, h] = np.bincount(column[there], minlength=bins)
            sums[f, h] = np.bincount(column[there], weights=speed[there], minlength=bins)
    x = (np.arange(bins) + 0.5) * BIN - WIDTH / 2
    profiles = {}
    for h, height in enumerate(HEIGHTS):
        with np.errstate(invalid="ignore", divide="ignore"):
            mean = sums[:, h].sum(0) / counts[:, h].sum(0)
            blocks = np.array([part.sum(0) / number.sum(0) for part, number in
                               zip(np.array_split(sums[:, h], BLOCKS), np.array_split(counts[:, h], BLOCKS))])
            half = STUDENT * np.nanstd(blocks, axis=0, ddof=1) / np.sqrt(BLOCKS)
        profiles[height] = (x, mean, half)
    return profiles


def draw(runs, picture):
    import matplotlib

    matplotlib.use("Agg")
    import matplotlib.pyplot as plt

    figure, axes = plt.subplots(2, 3, figsize=(12, 6.5), sharex=True, constrained_layout=True)
    for axis, height in zip(axes.flat, HEIGHTS):
        x, v = measured(height)
        axis.plot(x, v, "ko", markersize=3, label="measured")
        for number, (name, profiles) in enumerate(runs.items()):
            places, mean, half = profiles[height]
            axis.errorbar(places, mean, half, color=f"C{number}", linewidth=1, label=name)
        axis.set_title(f"{height} mm above the floor", fontsize=10)
        axis.grid(alpha=0.3)
    for axis in axes[:, 0]:
        axis.set_ylabel("particle speed [m/s]")
    for axis in axes[1]:
        axis.set_xlabel("distance from the axis [mm]")
    axes[0, 0].legend(fontsize=8)
    figure.savefig(picture, dpi=110)


def page_of(runs, picture):
    lines = ["# Validation", "", "Written by `/usr/bin/python3 configs/yue2020/compare.py` from finished runs.", "",
             "## The rectangular spouted bed of Yue et al. (2020)", "",
             "Set-up, assumptions and the origin of the measurements: [configs/yue2020](../configs/yue2020/README.md). Peak of the mean "
             "particle speed near the axis, and the width of what is faster than half of it.", "",
             f"![particle speed over the width at six heights]({picture.parent.name}/{picture.name})", "",
             "| | " + " | ".join(f"{height} mm" for height in HEIGHTS) + " |", "|---" * (len(HEIGHTS) + 1) + "|"]

    def row(name, profiles):
        cells = [peak_and_width(*profiles[height][:2]) for height in HEIGHTS]
        lines.append(f"| {name} | " + " | ".join(f"{peak:.2f} m/s, {width:.0f} mm" for peak, width in cells) + " |")

    row("measured", {height: measured(height) for height in HEIGHTS})
    for name, profiles in runs.items():
        row(name, profiles)
    missing = [name for name in CASES if name not in runs]
    if missing:
        lines += ["", "Not run, or not to its end: " + ", ".join(missing) + "."]
    lines += ["", "The measured points lie 7 mm apart: a width is good to 4 mm at best. The measured profiles are not symmetric; left and "
              "right are not compared in detail."]
    return "\n".join(lines) + "\n"


def main():
    results = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else "results/yue2020")
    page = pathlib.Path(sys.argv[2]) if len(sys.argv) > 2 else HERE.parent.parent / "docs" / "validation.md"
    runs = {name: profiles for name in CASES if (profiles := profiles_of(results / name)) is not None}
    picture = page.parent / "pictures" / "yue2020.png"
    picture.parent.mkdir(parents=True, exist_ok=True)
    draw(runs, picture)
    page.write_text(page_of(runs, picture), encoding="utf-8")
    print(f"{page}: {len(runs)} of {len(CASES)} runs")


if __name__ == "__main__":
    main()
