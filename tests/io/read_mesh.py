#!/usr/bin/python3
"""Reads an .obj, .ply or .stl file with VTK and prints its points and polygons as JSON; with a second name,
writes them there, too."""
import json
import sys

from vtkmodules.vtkCommonCore import vtkIdList
from vtkmodules.vtkIOGeometry import vtkOBJReader, vtkOBJWriter, vtkSTLReader, vtkSTLWriter
from vtkmodules.vtkIOPLY import vtkPLYReader, vtkPLYWriter

readers = {"obj": vtkOBJReader, "ply": vtkPLYReader, "stl": vtkSTLReader}
writers = {"obj": vtkOBJWriter, "ply": vtkPLYWriter, "stl": vtkSTLWriter}

failed = []


def watched(algorithm, name):
    algorithm.AddObserver("ErrorEvent", lambda *_: failed.append(True))
    algorithm.SetFileName(name)
    return algorithm


reader = watched(readers[sys.argv[1][-3:]](), sys.argv[1])
reader.Update()
mesh = reader.GetOutput()
polygons, ids = [], vtkIdList()
for k in range(mesh.GetNumberOfCells()):
    mesh.GetCellPoints(k, ids)
    polygons.append([ids.GetId(i) for i in range(ids.GetNumberOfIds())])
for name in sys.argv[2:]:
    for kind in ("ASCII", "Binary"):
        writer = watched(writers[name[-3:]](), f"{kind}_{name}")
        writer.SetInputData(mesh)
        if hasattr(writer, "SetFileTypeToASCII"):
            getattr(writer, "SetFileTypeTo" + kind)()
        writer.Write()
print(json.dumps({
    "points": [mesh.GetPoint(i) for i in range(mesh.GetNumberOfPoints())],
    "polygons": polygons,
    "others": mesh.GetNumberOfVerts() + mesh.GetNumberOfLines() + mesh.GetNumberOfStrips(),
}))
sys.exit(1 if failed else 0)
