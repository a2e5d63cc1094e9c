#!/usr/bin/env python3
# Copyright (c) 2026 The Tubular_meshing authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Reads a mesh in parts by VTK and compares it, without its ghosts, with the whole mesh: read_partitions.py MESH.pvtu
MESH.vtu PARTS. Exit status 77: VTK is not here."""

import sys

try:
    from vtkmodules.vtkIOXML import vtkXMLPUnstructuredGridReader, vtkXMLUnstructuredGridReader
except ImportError:
    sys.exit(77)


def read(reader, file):
    reader.SetFileName(file)
    reader.Update()
    return reader.GetOutput()


def cell(grid, ids, i):
    """The type of a cell and its points, by the numbers that they have in the whole mesh."""
    points = grid.GetCell(i).GetPointIds()
    return grid.GetCellType(i), tuple(ids(points.GetId(k)) for k in range(points.GetNumberOfIds()))


def fields(grid):
    data = grid.GetFieldData()
    arrays = [data.GetArray(i) for i in range(data.GetNumberOfArrays())]
    return {a.GetName(): [a.GetValue(k) for k in range(a.GetNumberOfValues())] for a in arrays}


def main():
    whole = read(vtkXMLUnstructuredGridReader(), sys.argv[2])
    reader = vtkXMLPUnstructuredGridReader()
    parts = read(reader, sys.argv[1])
    assert reader.GetNumberOfPieces() == int(sys.argv[3]), reader.GetNumberOfPieces()
    assert fields(parts) == fields(whole), (fields(parts), fields(whole))

    points = parts.GetPointData()
    assert points.GetGlobalIds() is not None and points.GetGlobalIds().GetName() == "GlobalPointIds"
    assert parts.GetCellData().GetGlobalIds().GetName() == "GlobalCellIds"
    point_id = points.GetGlobalIds().GetValue
    ghost = points.GetArray("vtkGhostType").GetValue
    own = [i for i in range(parts.GetNumberOfPoints()) if ghost(i) == 0]
    assert sorted(map(point_id, own)) == list(range(whole.GetNumberOfPoints()))
    for i in range(parts.GetNumberOfPoints()):
        assert parts.GetPoint(i) == whole.GetPoint(point_id(i))
        for k in range(whole.GetPointData().GetNumberOfArrays()):
            array = whole.GetPointData().GetArray(k)
            assert points.GetArray(array.GetName()).GetTuple(i) == array.GetTuple(point_id(i))

    cells = parts.GetCellData()
    cell_id = cells.GetGlobalIds().GetValue
    for i in range(parts.GetNumberOfCells()):
        assert cell(parts, point_id, i) == cell(whole, lambda v: v, cell_id(i))
        for name in ("region", "patch"):
            assert cells.GetArray(name).GetValue(i) == whole.GetCellData().GetArray(name).GetValue(cell_id(i))

    parts.RemoveGhostCells()
    cell_id = parts.GetCellData().GetArray("GlobalCellIds").GetValue
    assert sorted(cell_id(i) for i in range(parts.GetNumberOfCells())) == list(range(whole.GetNumberOfCells()))


if __name__ == "__main__":
    main()
