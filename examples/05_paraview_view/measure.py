#!/usr/bin/env python3
"""Measures what the pictures show, with VTK's readers: python3 measure.py results/case [measured.csv]

Runs in ParaView's pvpython as in Debian's python3 with python3-vtk9. Per frame: how much solid the gas sees over what the
particles fill (1: the two views are of one bed), the pressure below the bed over the bed's weight, and where the bed ends.
Ends with an error where the views differ.
"""
import csv
import os
import sys
import xml.etree.ElementTree as tree

from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOXML import vtkXMLImageDataReader, vtkXMLPolyDataReader

DENSITY = 1040.0      # [kg/m^3], of alumina
GAS_DENSITY = 1.225   # [kg/m^3]
GRAVITY = 9.81        # [m/s^2]
PI = 3.141592653589793


def frames(folder, series):
    """Time [s] and file of every frame."""
    for data_set in tree.parse(os.path.join(folder, series)).iter("DataSet"):
        yield float(data_set.get("timestep")), os.path.join(folder, data_set.get("file"))


def read(reader, file):
    reader.SetFileName(file)
    reader.Update()
    return reader.GetOutput()


def measure(particle_file, gas_file):
    particles = read(vtkXMLPolyDataReader(), particle_file)
    gas = read(vtkXMLImageDataReader(), gas_file)
    diameter = vtk_to_numpy(particles.GetPointData().GetArray("diameter [m]")).astype(float)
    height = vtk_to_numpy(particles.GetPoints().GetData())[:, 2].astype(float)
    solid = PI / 6 * (diameter**3).sum()                                  # [m^3]

    spacing, (nx, ny, nz) = gas.GetSpacing(), (n - 1 for n in gas.GetDimensions())
    fraction = vtk_to_numpy(gas.GetCellData().GetArray("gas_fraction [1]")).astype(float)
    seen = (1 - fraction).sum() * spacing[0] * spacing[1] * spacing[2]    # [m^3]
    pressure = vtk_to_numpy(gas.GetCellData().GetArray("pressure [Pa]")).astype(float).reshape(nz, ny, nx)
    area = nx * ny * spacing[0] * spacing[1]                              # [m^2]
    weight = (DENSITY - GAS_DENSITY) * GRAVITY * solid / area             # [Pa]
    return seen / solid, pressure[0].mean() / weight, sorted(height)[int(0.99 * len(height))]


def main():
    folder = sys.argv[1]
    table = csv.writer(open(sys.argv[2], "w") if len(sys.argv) > 2 else sys.stdout, lineterminator="\n")
    table.writerow(["time [s]", "solids of gas over particles [1]", "pressure over weight [1]", "height of 99 % [m]"])
    for (time, particles), (_, gas) in zip(frames(folder, "particles.pvd"), frames(folder, "fluid.pvd")):
        solids, pressure, height = measure(particles, gas)
        table.writerow([f"{time:.3f}", f"{solids:.5f}", f"{pressure:.3f}", f"{height:.4f}"])
        # Deposit and smoothing conserve solids to rounding; files hold single precision.
        if abs(solids - 1) > 1e-5:
            raise SystemExit(f"measure.py: at {time} s the gas sees {solids} of the particles' solid")


main()
