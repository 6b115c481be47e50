#!/usr/bin/env python3
"""Pictures show a bed: pictures.py PNG…. Left of the colour bars, where the bed is drawn, spheres are coloured and all else is grey."""
import sys

import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGReader

BARS_BEGIN = 0.85     # of the width
LEAST_SHARE = 0.02    # of the pixels left of the bars; a bed on the ground takes more
COLOURED = 60         # between the strongest and the weakest of red, green and blue, of 255

for name in sys.argv[1:]:
    reader = vtkPNGReader()
    reader.SetFileName(name)
    reader.Update()
    width, height, _ = reader.GetOutput().GetDimensions()
    pixels = vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars()).astype(int)[:, :3].reshape(height, width, 3)
    bed = pixels[:, : int(BARS_BEGIN * width)]
    share = float(numpy.mean(bed.max(axis=2) - bed.min(axis=2) > COLOURED))
    print(f"{name}: {100 * share:.1f} % of the picture are spheres")
    if share < LEAST_SHARE:
        sys.exit(f"pictures.py: {name} shows no bed")
