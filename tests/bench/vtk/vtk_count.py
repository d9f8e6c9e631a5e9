"""How many cells of a mesh a transfer function shows: those with a scalar of positive opacity in their range, where the
function is clear up to one scalar and shows all above it. Prints JSON."""
import json
import sys

import vtk_scene
from vtkmodules.vtkFiltersCore import vtkThreshold

mesh = vtk_scene.read_mesh(sys.argv[1], sys.argv[2])
above = vtkThreshold()
above.SetInputData(mesh)
above.SetInputArrayToProcess(0, 0, 0, 0, sys.argv[2])
above.SetThresholdFunction(vtkThreshold.THRESHOLD_UPPER)
above.SetUpperThreshold(float(sys.argv[3]))
above.AllScalarsOff()
above.Update()
print(json.dumps({"cells": mesh.GetNumberOfCells(), "shown": above.GetOutput().GetNumberOfCells()}))
