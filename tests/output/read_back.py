"""Reads what vtk_writer_test wrote with VTK's own readers, and compares every array with the real bed's values.

The simulated bed is a quarter of the real one: lengths by 4, velocities and times by 2, spins by 1/2, pressures by 4.
"""
import sys
import xml.etree.ElementTree as tree

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOXML import vtkXMLImageDataReader, vtkXMLPolyDataReader

folder, what = sys.argv[1:3]


def read(reader, file):
    reader.SetFileName(f"{folder}/{file}")
    reader.Update()
    assert reader.GetErrorCode() == 0, file
    return reader.GetOutput()


def columns(data):
    return {data.GetArrayName(k): vtk_to_numpy(data.GetArray(k)) for k in range(data.GetNumberOfArrays())}


def close(values, expected, relative=1e-7):   # float32 has 24 bits: 6e-8
    np.testing.assert_allclose(values, expected, rtol=relative, atol=0)


def frames(pvd):
    return [(float(d.get("timestep")), d.get("file")) for d in tree.parse(f"{folder}/{pvd}").iter("DataSet")]


def field(data, name):
    return data.GetFieldData().GetAbstractArray(name).GetValue(0)


def check_description(data, time):
    assert field(data, "TimeValue") == time
    assert field(data, "scaling_law") == "test_law"
    assert "dynamic pressures are off by the jet ratio J* = 2" in field(data, "map_back")
    ratios = {"length": 0.25, "diameter": 0.5, "time": 0.5, "velocity": 0.5, "angular_velocity": 2, "pressure": 0.25,
              "force": 1, "mass": 1 / 64}
    for name, ratio in ratios.items():
        assert field(data, "ratio_" + name) == ratio, name
    assert field(data, "jet_ratio") == 2


def check_particles(data):
    k = np.arange(5)
    assert data.GetNumberOfVerts() == 5
    points = vtk_to_numpy(data.GetPoints().GetData())
    assert points.dtype == np.float64
    close(points, np.column_stack([0.008 * (k + 1), np.full(5, 0.02), 0.016 * (k + 1)]), 1e-15)
    c = columns(data.GetPointData())
    velocity = np.column_stack([0.5 * k, np.full(5, -1.0), np.full(5, 3.0)])
    close(c.pop("velocity [m/s]"), velocity)
    close(c.pop("speed [m/s]"), np.linalg.norm(velocity, axis=1))
    close(c.pop("diameter [m]"), 4e-3 * (1 + 0.5 * k))             # 2 * 0.5 mm / (1/4)
    close(c.pop("material_diameter [m]"), 2e-3 * (1 + 0.5 * k))    # 2 * 0.5 mm / (1/2)
    assert (c.pop("id") == k).all()
    assert (c.pop("class") == k % 2).all()
    if what == "rotation":
        close(c.pop("angular_velocity [rad/s]"), np.column_stack([5 * k, 0 * k, np.full(5, -2.0)]))
    assert not c, f"not asked for: {list(c)}"
    names = data.GetFieldData().GetAbstractArray("class_names")
    assert [names.GetValue(i) for i in range(2)] == ["glass", "alumina"]


def check_fluid(data):
    close(data.GetSpacing(), [0.02] * 3, 1e-15)
    assert data.GetOrigin() == (0, 0, 0)
    assert data.GetDimensions() == (5, 4, 9)
    cell = np.arange(4 * 3 * 8)
    close(data.GetBounds(), [0, 0.08, 0, 0.06, 0, 0.16], 1e-15)
    c = columns(data.GetCellData())
    velocity = np.column_stack([np.full(96, 0.25), np.zeros(96), 1.0 * cell])
    close(c.pop("gas_velocity [m/s]"), velocity)
    close(c.pop("gas_speed [m/s]"), np.linalg.norm(velocity, axis=1))
    close(c.pop("pressure [Pa]"), 4 * (100.0 - cell))
    close(c.pop("gas_fraction [1]"), 0.4 + 0.001 * cell)
    assert not c, f"not asked for: {list(c)}"


if what == "empty":
    assert read(vtkXMLPolyDataReader(), "particles/particles_000000.vtp").GetNumberOfPoints() == 0
else:
    for pvd, reader, check in (("particles.pvd", vtkXMLPolyDataReader, check_particles),
                               ("fluid.pvd", vtkXMLImageDataReader, check_fluid)):
        listed = frames(pvd)
        assert [time for time, _ in listed] == [0.0, 0.2, 0.5], listed
        for time, file in listed:
            data = read(reader(), file)
            check_description(data, time)
            check(data)
