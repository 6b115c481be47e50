"""Runs the case for several stiffnesses and compares every sphere with the hard-sphere law; prints a table.

    python3 configs/hard_sphere_limit/compare.py [--program build/bin/similitude] [stiffness in N/m …]

Debian's python3 with python3-vtk9, as for the tests."""
import argparse
import csv
import json
import math
import os
import subprocess
import tempfile
import xml.etree.ElementTree

import numpy
import vtk
from vtk.util.numpy_support import vtk_to_numpy

HERE = os.path.dirname(os.path.abspath(__file__))
CASE = os.path.join(HERE, "hard_sphere_limit.yaml")
RADIUS, RESTITUTION, FRICTION = 1.5e-3, 0.8, 0.3   # of the case
WALLS = 3                                         # the last spheres of the file meet the bottom, the others each other in pairs
STEPS_PER_CONTACT = 1500                          # so fine that what is left is the spring's
LONG_ENOUGH = 1.5                                 # contact times; all contacts begin with the run


def spheres():
    with open(os.path.join(HERE, "spheres.csv"), encoding="utf-8", newline="") as file:
        rows = [[float(value) for value in row.values()] for row in csv.DictReader(file)]
    table = numpy.array(rows)
    return table[:, :3], table[:, 3:]


def hard_sphere():
    """Velocities [m/s] and spins [rad/s] after one collision each: J_n = -(1 + e) m* v_n, against the slip
    J_t = min(mu J_n, 2/7 (1 + beta0) m* v_ct) with beta0 = e. Whether each contact slides."""
    place, before = spheres()
    after, spin = before.copy(), numpy.zeros_like(before)
    slides = numpy.zeros(len(place), dtype=bool)
    for i in range(len(place)):
        wall = i >= len(place) - WALLS
        j = i ^ 1
        normal = numpy.array([0.0, 0.0, 1.0]) if wall else (place[i] - place[j]) / numpy.linalg.norm(place[i] - place[j])
        relative = before[i] - (0 if wall else before[j])
        share = 1.0 if wall else 0.5   # m* / m
        approach = relative @ normal
        slip = relative - approach * normal
        push = -(1 + RESTITUTION) * share * approach                    # J_n / m
        stick = 2 / 7 * (1 + RESTITUTION) * share * numpy.linalg.norm(slip)
        slides[i] = FRICTION * push < stick
        against = -slip / numpy.linalg.norm(slip) if slip.any() else slip
        tangential = min(FRICTION * push, stick) * against              # J_t / m
        after[i] = before[i] + push * normal + tangential
        spin[i] = numpy.cross(-RADIUS * normal, tangential) / (0.4 * RADIUS**2)
    return after, spin, slides


def last_frame(folder):
    entry = list(xml.etree.ElementTree.parse(os.path.join(folder, "particles.pvd")).getroot().iter("DataSet"))[-1]
    reader = vtk.vtkXMLPolyDataReader()
    reader.SetFileName(os.path.join(folder, entry.get("file")))
    reader.Update()
    arrays = reader.GetOutput().GetPointData()
    order = numpy.argsort(vtk_to_numpy(arrays.GetArray("id")))
    return [vtk_to_numpy(arrays.GetArray(name))[order].astype(float) for name in ("velocity [m/s]", "angular_velocity [rad/s]")]


def contact_time(program, stiffness):
    """[s], of a pair: the time step advised is a twentieth of it."""
    done = subprocess.run([program, "check", CASE, "--json", "--set", f"models.contact.stiffness={stiffness!r} N/m"],
                          capture_output=True, text=True, check=True)
    limits = json.loads(done.stdout)["time_steps"]["limits"]
    return 20 * next(limit["advised"] for limit in limits if limit["name"] == "contact time")


def simulated(program, stiffness, duration):
    wall_duration = math.sqrt(2) * duration   # a wall is a partner of infinite mass
    dt, end = duration / STEPS_PER_CONTACT, LONG_ENOUGH * wall_duration
    with tempfile.TemporaryDirectory(prefix="similitude_hard_sphere_") as folder:
        out = os.path.join(folder, "out")
        settings = {"models.contact.stiffness": f"{stiffness!r} N/m", "time.dt": f"{dt!r} s", "time.gas_dt": f"{dt!r} s",
                    "time.end": f"{end!r} s", "output.vtk": f"every {end!r} s", "output.monitors": f"every {end!r} s"}
        sets = [word for name, value in settings.items() for word in ("--set", f"{name}={value}")]
        subprocess.run([program, "run", CASE, "-o", out, *sets], capture_output=True, text=True, check=True,
                       env={**os.environ, "OMP_NUM_THREADS": "1"})
        return last_frame(out)


def angle_between(a, b):
    return math.degrees(math.atan2(numpy.linalg.norm(numpy.cross(a, b)), a @ b))


def compare(program, stiffnesses):
    """A row per stiffness: contact time [s]; of the head-on pair the restitution; largest angle [deg] between simulated and hard-sphere
    velocity and largest spin error over the spin, of sticking and of sliding pairs and at the wall."""
    place, before = spheres()
    after, spin, slides = hard_sphere()
    pairs = numpy.arange(len(place)) < len(place) - WALLS
    spins = numpy.linalg.norm(spin, axis=1) > 0
    rows = []
    for stiffness in stiffnesses:
        duration = contact_time(program, stiffness)
        velocity, angular = simulated(program, stiffness, duration)
        angle = numpy.array([angle_between(a, b) for a, b in zip(velocity, after)])
        spin_error = numpy.zeros(len(place))
        spin_error[spins] = numpy.linalg.norm(angular - spin, axis=1)[spins] / numpy.linalg.norm(spin, axis=1)[spins]
        rows.append({"stiffness": stiffness, "contact_time": duration,
                     "restitution": (velocity[1, 0] - velocity[0, 0]) / (before[0, 0] - before[1, 0]),
                     "sticking_angle": angle[pairs & spins & ~slides].max(), "sliding_angle": angle[pairs & slides].max(),
                     "sticking_spin": spin_error[pairs & spins & ~slides].max(), "sliding_spin": spin_error[pairs & slides].max(),
                     "wall_angle": angle[~pairs].max(), "wall_spin": spin_error[~pairs].max()})
    return rows


def orders(rows, name):
    """d log(error) / d log(stiffness) between neighbouring rows."""
    return [math.log(b[name] / a[name]) / math.log(b["stiffness"] / a["stiffness"]) for a, b in zip(rows, rows[1:])]


ERRORS = ("sticking_angle", "sliding_angle", "sticking_spin", "sliding_spin", "wall_spin")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", default="similitude")
    parser.add_argument("stiffness", nargs="*", type=float, default=[1e4, 1e5, 1e6, 1e7])
    given = parser.parse_args()
    rows = compare(given.program, given.stiffness)
    print("stiffness  contact time  restitution  angle off [deg]      spin off [%]              wall: angle  spin")
    print("    [N/m]          [us]     head-on  sticking  sliding   sticking  sliding            [deg]   [%]")
    for row in rows:
        print(f"{row['stiffness']:9.0e} {1e6 * row['contact_time']:13.3f} {row['restitution']:12.5f} {row['sticking_angle']:9.4f}"
              f" {row['sliding_angle']:8.4f} {100 * row['sticking_spin']:10.4f} {100 * row['sliding_spin']:8.4f}"
              f" {row['wall_angle']:16.4f} {100 * row['wall_spin']:7.4f}")
    if len(rows) > 1:
        for name in ("contact_time", *ERRORS):
            print(f"order in the stiffness of {name:15}" + " ".join(f"{order:6.2f}" for order in orders(rows, name)))


if __name__ == "__main__":
    main()
