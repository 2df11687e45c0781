#!/usr/bin/python3
"""Reads a .vtp file with VTK and prints all of it as JSON; numbers read back to the same bits."""
import json
import sys

from vtkmodules.vtkCommonCore import vtkIdList
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader


def arrays(data):
    out = {}
    for k in range(data.GetNumberOfArrays()):
        array = data.GetArray(k)
        values = [array.GetTuple(i) for i in range(array.GetNumberOfTuples())]
        out[array.GetName()] = {"type": array.GetDataTypeAsString(), "values": values}
    return out


reader = vtkXMLPolyDataReader()
failed = []
reader.AddObserver("ErrorEvent", lambda *_: failed.append(True))
reader.SetFileName(sys.argv[1])
reader.Update()
mesh = reader.GetOutput()
polygons, ids = [], vtkIdList()
for k in range(mesh.GetNumberOfCells()):
    mesh.GetCellPoints(k, ids)
    polygons.append([ids.GetId(i) for i in range(ids.GetNumberOfIds())])
print(json.dumps({
    "points": [mesh.GetPoint(i) for i in range(mesh.GetNumberOfPoints())],
    "polygons": polygons,
    "others": mesh.GetNumberOfVerts() + mesh.GetNumberOfLines() + mesh.GetNumberOfStrips(),
    "of_points": arrays(mesh.GetPointData()),
    "of_cells": arrays(mesh.GetCellData()),
    "of_all": arrays(mesh.GetFieldData()),
}))
sys.exit(1 if failed else 0)
