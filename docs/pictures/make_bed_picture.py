#!/usr/bin/env python3
"""Draws the last frame of a run as a picture: particles coloured by speed, plates, the gas speed behind them.

    /usr/bin/python3 docs/pictures/make_bed_picture.py results/spout bed.png [--frame N] [--height 1200]

Needs Debian's python3-vtk9 and python3-matplotlib, no screen: the particles are drawn from back to front as shaded
discs, so that the same files give the same picture anywhere. Reads particles.pvd, fluid.pvd, and the bed from view.py.
"""
import argparse
import json
import os
import xml.etree.ElementTree as tree

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.collections import EllipseCollection
from matplotlib.patches import Rectangle
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOXML import vtkXMLImageDataReader, vtkXMLPolyDataReader


GREYS_USED = 0.625   # of the grey scale, so that the fastest gas does not hide particles


def particle_colours(share):
    """Turbo without its almost black ends."""
    return plt.get_cmap("turbo")(0.08 + 0.87 * share)


def frame_of(folder, pvd, number):
    """Time [s] and file of a frame, or (None, None) where the run wrote no such series."""
    file = os.path.join(folder, pvd)
    if not os.path.exists(file):
        return None, None
    frames = [(float(d.get("timestep")), d.get("file")) for d in tree.parse(file).iter("DataSet")]
    time, name = frames[number]
    return time, os.path.join(folder, name)


def read(reader, file):
    reader.SetFileName(file)
    reader.Update()
    return reader.GetOutput()


def column(data, name):
    return vtk_to_numpy(data.GetArray(name))


def draw_gas(axes, file):
    gas = read(vtkXMLImageDataReader(), file)
    nx, ny, nz = (n - 1 for n in gas.GetDimensions())
    speed = column(gas.GetCellData(), "gas_speed [m/s]").reshape(nz, ny, nx)
    plane = speed[:, (ny - 1) // 2:ny // 2 + 1, :].mean(axis=1)   # the central plane, or two layers about it
    x0, x1, _, _, z0, z1 = gas.GetBounds()
    axes.imshow(plane, origin="lower", extent=(x0, x1, z0, z1), cmap="Greys", vmin=0,
                vmax=plane.max() / GREYS_USED, interpolation="bilinear", zorder=0)
    return plane.max()


def draw_particles(axes, file):
    bed = read(vtkXMLPolyDataReader(), file)
    points = vtk_to_numpy(bed.GetPoints().GetData())
    diameter = column(bed.GetPointData(), "diameter [m]")
    speed = column(bed.GetPointData(), "speed [m/s]")
    order = np.argsort(-points[:, 1], kind="stable")                 # the viewer stands in front, at y = 0
    points, diameter, speed = points[order], diameter[order], speed[order]
    fastest = np.quantile(speed, 0.999) if len(speed) else 0.0       # one thrown particle must not bleach all others
    colours = particle_colours(np.clip(speed / fastest, 0, 1) if fastest > 0 else 0 * speed)

    # A dark rim, the colour and a highlight make a sphere of a disc. Drawn particle by particle from the back, so that
    # a nearer one hides a farther one with its rim and highlight.
    layers = ((1.0, 0.0, 0.45), (0.86, 0.03, 1.0), (0.35, 0.16, 1.35))   # size, shift to the upper left, brightness
    sizes, places, fills = [], [], []
    for size, shift, brightness in layers:
        sizes.append(size * diameter)
        places.append(points[:, [0, 2]] + diameter[:, None] * shift * np.array([-1, 1]))
        fill = colours.copy()
        fill[:, :3] = np.clip(fill[:, :3] * brightness + max(0, brightness - 1), 0, 1)
        fills.append(fill)
    interleave = lambda parts: np.stack(parts, axis=1).reshape(len(layers) * len(speed), -1)
    size = interleave(sizes).ravel()
    axes.add_collection(EllipseCollection(size, size, np.zeros_like(size), units="xy", offsets=interleave(places),
                                          transOffset=axes.transData, facecolors=interleave(fills), linewidths=0,
                                          zorder=2))
    return fastest


def bed_of(folder):
    """Size of the bed and its plates [m], as view.py draws them."""
    with open(os.path.join(folder, "view.py"), encoding="utf-8") as script:
        lines = script.readlines()

    def value(name):
        line = next(line for line in lines if line.startswith(name + " = "))
        return json.loads(line.split(" = ", 1)[1].rsplit("   #", 1)[0])

    return value("SIZE"), value("PLATES")


def colour_bar(figure, axes, place, cmap, top, title):
    bar = axes.inset_axes(place)
    figure.colorbar(matplotlib.cm.ScalarMappable(matplotlib.colors.Normalize(0, top), cmap), cax=bar)
    bar.set_ylabel(title)


def main():
    parser = argparse.ArgumentParser(description="Draws a frame of a run of Similitude.")
    parser.add_argument("folder", help="results folder of a run")
    parser.add_argument("picture", help="PNG file to write")
    parser.add_argument("--frame", type=int, default=-1, help="number of the frame; the last one if left out")
    parser.add_argument("--height", type=int, default=1200, help="[pixels]")
    args = parser.parse_args()

    time, bed_file = frame_of(args.folder, "particles.pvd", args.frame)
    if bed_file is None:
        parser.error(f"there is no particles.pvd in {args.folder}: run the case with output.vtk")
    _, gas_file = frame_of(args.folder, "fluid.pvd", args.frame)

    figure, axes = plt.subplots()
    fastest = draw_particles(axes, bed_file)
    (width, _, height), plates = bed_of(args.folder)
    for plate in plates:
        (x0, _, z0), (x1, _, z1) = plate["low"], plate["high"]
        axes.add_patch(Rectangle((x0, z0), x1 - x0, z1 - z0, facecolor="0.15", zorder=3))
    if gas_file is not None:
        fastest_gas = draw_gas(axes, gas_file)
    axes.set(xlim=(0, width), ylim=(0, height), aspect="equal", xlabel="x [m]", ylabel="z [m]", title=f"t = {time:.4g} s")

    inches = args.height / 150
    figure.set_size_inches(max(0.62 * inches, inches * width / height + 0.3 * inches), inches)
    turbo = matplotlib.colors.ListedColormap(particle_colours(np.linspace(0, 1, 256)))
    colour_bar(figure, axes, [1.08, 0.02, 0.07, 0.42], turbo, fastest, "particle speed [m/s]")
    if gas_file is not None:
        grey = matplotlib.colors.ListedColormap(plt.get_cmap("Greys")(np.linspace(0, GREYS_USED, 256)))
        colour_bar(figure, axes, [1.08, 0.56, 0.07, 0.42], grey, fastest_gas, "gas speed, central plane [m/s]")
    figure.savefig(args.picture, dpi=150, bbox_inches="tight")


main()
