# BED=BED.data END=END.dump WARM=N STEPS=N yade -jTHREADS -n -x yade.py
import math
import os
import time

from yade import utils

DIAMETER, DENSITY, DT = 1e-3, 1040.0, 2.5e-6
MASS = DENSITY * math.pi / 6 * DIAMETER**3
STIFFNESS, TANGENTIAL = 1000.0, 2 / 7
PAIR_DAMPING = 11565.4 * MASS / 2   # [kg/s], e = 0.74
WALL_DAMPING = 8178.0 * MASS

# Springs and dashpots of the two partners stand in series.
def material(stiffness, damping):
    return O.materials.append(ViscElMat(density=DENSITY, kn=stiffness, ks=TANGENTIAL * stiffness, cn=damping, cs=damping / 2,
                                        frictionAngle=math.atan(0.3)))

grain = material(2 * STIFFNESS, 2 * PAIR_DAMPING)
wall = material(2 * STIFFNESS, 1 / (1 / WALL_DAMPING - 1 / (2 * PAIR_DAMPING)))


def read(file):
    section, places, speeds = '', {}, {}
    for line in open(file):
        words = line.split()
        if words and words[0] in ('Atoms', 'Velocities'):
            section = words[0]
        elif words and section == 'Atoms':
            places[int(words[0])] = tuple(map(float, words[4:7]))
        elif words and section == 'Velocities':
            speeds[int(words[0])] = tuple(map(float, words[1:4]))
    return places, speeds


for axis, position in ((0, 0.0), (0, 0.145), (1, 0.0), (1, 0.02), (2, 0.0)):
    O.bodies.append(utils.wall(position, axis, sense=0, material=wall))
places, speeds = read(os.environ['BED'])
rows = {}
for particle, place in places.items():
    body = utils.sphere(place, DIAMETER / 2, material=grain)
    body.state.vel = speeds[particle]
    rows[particle] = O.bodies.append(body)

O.engines = [
    ForceResetter(),
    InsertionSortCollider([Bo1_Sphere_Aabb(), Bo1_Wall_Aabb()], verletDist=0.05 * DIAMETER),
    InteractionLoop([Ig2_Sphere_Sphere_ScGeom(), Ig2_Wall_Sphere_ScGeom()], [Ip2_ViscElMat_ViscElMat_ViscElPhys()],
                    [Law2_ScGeom_ViscElPhys_Basic()]),
    NewtonIntegrator(damping=0, gravity=(0, 0, -9.81)),
]
O.dt = DT
steps = int(os.environ['STEPS'])
O.run(int(os.environ['WARM']), True)
began = time.time()
O.run(steps, True)
print('Loop time of %.6f on %d threads for %d steps with %d atoms' % (time.time() - began, O.numThreads, steps, len(rows)), flush=True)
with open(os.environ['END'], 'w') as out:
    out.write('ITEM: ATOMS id x y z vx vy vz\n')
    for particle, row in sorted(rows.items()):
        state = O.bodies[row].state
        out.write('%d %.12g %.12g %.12g %.12g %.12g %.12g\n' % ((particle,) + tuple(state.pos) + tuple(state.vel)))
