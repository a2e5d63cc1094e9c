#!/usr/bin/env python3
# Copyright (c) 2026 The Tubular_meshing authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Reads files of quadratic meshes whose edges are straight by VTK, meshio and dolfinx, each as far as it is installed, and
checks that every node is in the middle of the corners between which its place in the list says that it lies.

usage: check_quadratic_files.py FOLDER"""

import pathlib
import re
import sys
import xml.etree.ElementTree

import numpy

# Which corners a node lies between, in the order of VTK, behind the corners.
EDGES = {
    "tetra": [(0, 1), (1, 2), (2, 0), (0, 3), (1, 3), (2, 3)],
    "pyramid": [(0, 1), (1, 2), (2, 3), (3, 0), (0, 4), (1, 4), (2, 4), (3, 4)],
    "wedge": [(0, 1), (1, 2), (2, 0), (3, 4), (4, 5), (5, 3), (0, 3), (1, 4), (2, 5)],
    "hexahedron": [(0, 1), (1, 2), (2, 3), (3, 0), (4, 5), (5, 6), (6, 7), (7, 4), (0, 4), (1, 5), (2, 6), (3, 7)],
    "triangle": [(0, 1), (1, 2), (2, 0)],
    "quad": [(0, 1), (1, 2), (2, 3), (3, 0)],
}
OTHERS = {
    "tetra": [],
    "pyramid": [(0, 1, 2, 3)],
    "wedge": [(0, 1, 4, 3), (1, 2, 5, 4), (2, 0, 3, 5)],
    "hexahedron": [(0, 3, 7, 4), (1, 2, 6, 5), (0, 1, 5, 4), (3, 2, 6, 7), (0, 1, 2, 3), (4, 5, 6, 7), tuple(range(8))],
    "triangle": [],
    "quad": [(0, 1, 2, 3)],
}
CORNERS = {"tetra": 4, "pyramid": 5, "wedge": 6, "hexahedron": 8, "triangle": 3, "quad": 4}
# The neighbors of corner 0 that make a right-handed frame.
FRAME = {"tetra": (1, 2, 3), "pyramid": (1, 3, 4), "wedge": (1, 2, 3), "hexahedron": (1, 3, 4)}


def table(kind, size):
    corners = CORNERS[kind]
    nodes = EDGES[kind] + OTHERS[kind]
    assert size in (corners + len(EDGES[kind]), corners + len(nodes)), (kind, size)
    return nodes[: size - corners]


def check(name, kind, points, cells, behind=None):
    """cells: a row of nodes each, in the order of VTK, or with the nodes behind the corners between those of `behind`."""
    cells = numpy.asarray(cells)
    assert len(cells) > 0, (name, kind)
    for i, corners in enumerate(behind or table(kind, cells.shape[1])):
        middle = sum(points[cells[:, c]] for c in corners) / len(corners)
        node = points[cells[:, CORNERS[kind] + i]]
        off = numpy.abs(middle - node).max()  # single precision in one reader; edges are longer than a tenth
        assert off < 1e-6, (name, kind, "node", i, "is off by", off)
    if kind in FRAME:
        u, v, w = (points[cells[:, k]] - points[cells[:, 0]] for k in FRAME[kind])
        assert (numpy.einsum("ij,ij->i", numpy.cross(u, v), w) > 0).all(), (name, kind, "is turned over")
    return len(cells)


VTK_KINDS = {24: "tetra", 27: "pyramid", 26: "wedge", 32: "wedge", 25: "hexahedron", 29: "hexahedron", 22: "triangle",
             23: "quad", 28: "quad"}


def check_vtk(name, data):
    from vtk.util.numpy_support import vtk_to_numpy

    points = vtk_to_numpy(data.GetPoints().GetData())
    cells = {}
    for i in range(data.GetNumberOfCells()):
        cell = data.GetCell(i)
        ids = [cell.GetPointId(k) for k in range(cell.GetNumberOfPoints())]
        cells.setdefault(data.GetCellType(i), []).append(ids)
    cells.pop(14, None)  # its reader of Exodus files takes pyramids of all orders for linear ones
    return sum(check(name, VTK_KINDS[t], points, c) for t, c in cells.items())


def check_vtu(path):
    import vtk

    reader = vtk.vtkXMLUnstructuredGridReader()
    reader.SetFileName(str(path))
    reader.Update()
    return check_vtk(path.name, reader.GetOutput())


def check_exodus(path):
    import vtk

    reader = vtk.vtkExodusIIReader()
    reader.SetFileName(str(path))
    reader.UpdateInformation()
    for i in range(reader.GetNumberOfSideSetArrays()):
        reader.SetSideSetArrayStatus(reader.GetSideSetArrayName(i), 1)
    reader.Update()
    found = 0
    blocks = reader.GetOutput().GetBlock(0)
    for i in range(blocks.GetNumberOfBlocks()):
        found += check_vtk(path.name, blocks.GetBlock(i))
    # the sides of cells, which the reader makes itself
    sides = reader.GetOutput().GetBlock(4)
    found_sides = sum(sides.GetBlock(i).GetNumberOfCells() for i in range(sides.GetNumberOfBlocks()) if sides.GetBlock(i))
    assert found_sides > 0
    return found


def check_meshio(path):
    import meshio

    for kind in ("pyramid13", "pyramid14", "wedge15", "wedge18"):  # that a version knows to read, but not what dimension they have
        meshio._mesh.topological_dimension.setdefault(kind, 3)
    mesh = meshio.read(path)
    found = 0
    for block in mesh.cells:
        kind = re.match("[a-z]+", block.type).group()
        if kind in ("vertex", "line"):
            continue
        cells, behind = block.data, None
        if block.type == "wedge18" and path.suffix == ".msh":  # Gmsh's order, which meshio does not turn into its own
            behind = [(0, 1), (0, 2), (0, 3), (1, 2), (1, 4), (2, 5), (3, 4), (3, 5), (4, 5), (0, 1, 3, 4), (0, 2, 3, 5),
                      (1, 2, 4, 5)]
        if block.type == "pyramid14" and path.suffix == ".msh":
            behind = [(0, 1), (0, 3), (0, 4), (1, 2), (1, 4), (2, 3), (2, 4), (3, 4), (0, 1, 2, 3)]
        found += check(path.name, kind, mesh.points, cells, behind)
    return found


# FEBio's faces of a hexahedron begin with those around it.
FEBIO_HEXAHEDRON = [(0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7), (0, 1, 2, 3), (4, 5, 6, 7), tuple(range(8))]
FEBIO_KINDS = {"tet": "tetra", "pyra": "pyramid", "penta": "wedge", "hex": "hexahedron", "tri": "triangle", "quad": "quad"}


def check_febio(path):
    root = xml.etree.ElementTree.parse(path).getroot()
    mesh = root.find("Mesh")
    points = numpy.array([[float(x) for x in n.text.split(",")] for n in mesh.find("Nodes")])
    found = 0
    for elements in list(mesh.findall("Elements")) + list(mesh.findall("Surface")):
        by_type = {}
        for e in elements:
            kind = elements.get("type") or e.tag
            by_type.setdefault(kind, []).append([int(i) - 1 for i in e.text.split(",")])
        for name, cells in by_type.items():
            kind = FEBIO_KINDS[re.match("[a-z]+", name).group()]
            behind = EDGES[kind] + FEBIO_HEXAHEDRON if name == "hex27" else None
            assert int(re.search("[0-9]+", name).group()) == len(cells[0])
            found += check(path.name, kind, points, cells, behind)
    return found


def check_folder(path):
    import vtk
    from vtk.util.numpy_support import vtk_to_numpy

    found = 0
    for file in path.rglob("*.vtu"):
        found += check_vtu(file)
    for file in path.rglob("*.vtp"):
        reader = vtk.vtkXMLPolyDataReader()
        reader.SetFileName(str(file))
        reader.Update()
        data = reader.GetOutput()
        points = vtk_to_numpy(data.GetPoints().GetData())
        cells = []
        for i in range(data.GetNumberOfCells()):
            cell = data.GetCell(i)
            cells.append([cell.GetPointId(k) for k in range(cell.GetNumberOfPoints())])
        found += check(file.name, {6: "triangle", 8: "quad", 9: "quad"}[len(cells[0])], points, cells)
    return found


def check_xdmf(path):
    import dolfinx
    from mpi4py import MPI

    with dolfinx.io.XDMFFile(MPI.COMM_WORLD, str(path), "r") as file:
        try:
            mesh = file.read_mesh(name="mesh")
        except RuntimeError as e:  # of versions that have no hexahedra of 27 nodes in files
            raise ImportError(str(e)) if "hexahedron_27" in str(e) else e
        mesh.topology.create_connectivity(2, 3)
        mesh.topology.create_connectivity(2, 0)
        tags = file.read_meshtags(mesh, name="facet_tags")
    import ufl

    assert len(tags.indices) > 0
    volume = dolfinx.fem.assemble_scalar(dolfinx.fem.form(1 * ufl.dx(domain=mesh)))
    expected = float((path.with_suffix(".volume")).read_text())
    assert abs(volume - expected) < 1e-9 * expected, (path.name, volume, expected)
    return len(tags.indices)


CHECKS = {".vtu": check_vtu, ".exo": check_exodus, ".msh": check_meshio, ".inp": check_meshio, ".feb": check_febio,
          ".xdmf": check_xdmf}


def main():
    checked, skipped = 0, set()
    for path in sorted(pathlib.Path(sys.argv[1]).iterdir()):
        run = check_folder if path.name.endswith("mesh-complete") else CHECKS.get(path.suffix)
        if run is None:
            continue
        try:
            run(path)
            checked += 1
        except ImportError as missing:
            skipped.add(str(missing))
    for s in skipped:
        print("skipped:", s)
    print(checked, "files are right")
    return 77 if checked == 0 else 0


if __name__ == "__main__":
    sys.exit(main())
