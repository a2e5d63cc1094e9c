#!/usr/bin/env python3
# Copyright (c) 2026 The Tubular_meshing authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes a surface in all the ways that VTK and meshio know: write_by_programs.py FOLDER. Exit status 77: neither is here."""

import os
import sys

import math

folder = sys.argv[1]


def tube(sides=12, rings=10):
    """Points and triangles of a tube with quads across, and the label of each triangle."""
    points = [(math.cos(2 * math.pi * i / sides), math.sin(2 * math.pi * i / sides), 0.5 * k)
              for k in range(rings + 1) for i in range(sides)]
    triangles = []
    for k in range(rings):
        for i in range(sides):
            a, b = k * sides + i, k * sides + (i + 1) % sides
            triangles += [(a, b, b + sides), (a, b + sides, a + sides)]
    return points, triangles, [1 + (t < 4 * sides) for t in range(len(triangles))]


POINTS, TRIANGLES, LABELS = tube()


def write_by_vtk():
    import vtk

    def add(data, array, name, values):
        array.SetName(name)
        array.SetNumberOfComponents(len(values[0]) if isinstance(values[0], tuple) else 1)
        for v in values:
            array.InsertNextTuple(v) if isinstance(v, tuple) else array.InsertNextValue(v)
        data.AddArray(array)
        return array

    surface = vtk.vtkPolyData()
    points = vtk.vtkPoints()
    for p in POINTS:
        points.InsertNextPoint(p)
    cells = vtk.vtkCellArray()
    for t in TRIANGLES:
        cells.InsertNextCell(3, t)
    surface.SetPoints(points)
    surface.SetPolys(cells)
    n = len(POINTS)
    add(surface.GetCellData(), vtk.vtkIntArray(), "CellEntityIds", LABELS)
    add(surface.GetPointData(), vtk.vtkFloatArray(), "size", [0.5] * n)
    add(surface.GetPointData(), vtk.vtkDoubleArray(), "vectors", [(1.0, 2.0, 3.0)] * n)
    add(surface.GetPointData(), vtk.vtkBitArray(), "bits", [i % 2 for i in range(n)])
    names = vtk.vtkStringArray()
    names.SetName("names")
    for i in range(n):
        names.InsertNextValue("point %d" % i)
    surface.GetPointData().AddArray(names)
    components = add(surface.GetPointData(), vtk.vtkFloatArray(), "pairs", [(1.0, 2.0)] * n)
    components.SetComponentName(0, "a b")
    colours = add(surface.GetPointData(), vtk.vtkUnsignedCharArray(), "RGB", [(1, 2, 3)] * n)
    surface.GetPointData().SetScalars(colours)
    ids = vtk.vtkIdTypeArray()
    ids.SetName("ids")
    for i in range(n):
        ids.InsertNextValue(i)
    surface.GetPointData().SetGlobalIds(ids)
    add(surface.GetFieldData(), vtk.vtkDoubleArray(), "TimeValue", [3.5])

    def output(filter_, data):
        filter_.SetInputData(data)
        filter_.Update()
        return filter_.GetOutput()

    with_normals = output(vtk.vtkPolyDataNormals(), surface)
    strips = output(vtk.vtkStripper(), surface)
    line, mixed = vtk.vtkLineSource(), vtk.vtkAppendPolyData()
    line.Update()
    mixed.AddInputData(surface)
    mixed.AddInputData(line.GetOutput())
    mixed.Update()

    def write(name, writer, data, **settings):
        writer.SetFileName(os.path.join(folder, name))
        writer.SetInputData(data)
        for key, value in settings.items():
            getattr(writer, "Set" + key)(value)
        if writer.Write() == 0:
            sys.exit("VTK failed to write " + name)

    compressors = {"plain": None, "zlib": vtk.vtkZLibDataCompressor, "lz4": vtk.vtkLZ4DataCompressor,
                   "lzma": vtk.vtkLZMADataCompressor}
    datasets = {"surface": surface, "normals": with_normals, "strips": strips, "mixed": mixed.GetOutput()}
    for what, data in datasets.items():
        for mode, mode_name in enumerate(("ascii", "binary", "appended")):
            for name, compressor in compressors.items():
                write("%s_%s_%s.vtp" % (what, mode_name, name), vtk.vtkXMLPolyDataWriter(), data, DataMode=mode,
                      Compressor=compressor() if compressor else None)
        raw = vtk.vtkXMLPolyDataWriter()
        raw.EncodeAppendedDataOff()
        write(what + "_raw.vtp", raw, data)
        big = vtk.vtkXMLPolyDataWriter()
        big.SetByteOrderToBigEndian()
        write(what + "_big.vtp", big, data)
        for width in (32, 64):
            write("%s_%d.vtp" % (what, width), vtk.vtkXMLPolyDataWriter(), data, HeaderType=width, IdType=width)
        for version in (42, 51):
            for form in (1, 2):
                writer = vtk.vtkPolyDataWriter()
                if hasattr(writer, "SetFileVersion"):
                    writer.SetFileVersion(version)
                write("%s_%d_%d.vtk" % (what, version, form), writer, data, FileType=form)
        for form in (1, 2):
            write("%s_%d.stl" % (what, form), vtk.vtkSTLWriter(), data, FileType=form)
        if what != "strips":
            write(what + "_ascii.ply", vtk.vtkPLYWriter(), data, FileType=1)
            write(what + "_big.ply", vtk.vtkPLYWriter(), data, FileType=2, DataByteOrder=1, ArrayName="RGB")
        write(what + ".obj", vtk.vtkOBJWriter(), data)
    grid = vtk.vtkAppendFilter()
    grid.AddInputData(surface)
    grid.Update()
    for mode in range(3):
        write("grid_%d.vtu" % mode, vtk.vtkXMLUnstructuredGridWriter(), grid.GetOutput(), DataMode=mode)
    for form in (1, 2):
        write("grid_%d.vtk" % form, vtk.vtkUnstructuredGridWriter(), grid.GetOutput(), FileType=form)


def write_by_meshio():
    import meshio
    import numpy

    labels = numpy.array(LABELS, dtype=numpy.int32)
    mesh = meshio.Mesh(numpy.array(POINTS), [("triangle", numpy.array(TRIANGLES))])
    mesh.point_data = {"size": numpy.full(len(POINTS), 0.5)}
    names = {"CellEntityIds": ("vtu", "vtk", "ply"), "medit:ref": ("mesh",), "gmsh:physical": ("msh",)}
    for name, forms in names.items():
        mesh.cell_data = {name: [labels]}
        if name == "gmsh:physical":
            mesh.cell_data["gmsh:geometrical"] = [labels]
        for form in forms:
            if form != "msh":
                mesh.write(os.path.join(folder, "meshio." + form))
            else:
                for version in ("gmsh", "gmsh22"):
                    for binary in (False, True):
                        mesh.write(os.path.join(folder, "meshio_%s_%d.msh" % (version, binary)), file_format=version,
                                   binary=binary)
    mesh.cell_data = {"CellEntityIds": [labels]}
    mesh.write(os.path.join(folder, "meshio_lzma.vtu"), compression="lzma")
    mesh.write(os.path.join(folder, "meshio_42.vtk"), file_format="vtk42")
    mesh.write(os.path.join(folder, "meshio_ascii.ply"), binary=False)
    mesh.cell_data, mesh.point_data = {}, {}
    for form in ("obj", "off", "stl"):
        mesh.write(os.path.join(folder, "meshio." + form))
    mesh.write(os.path.join(folder, "meshio_binary.stl"), file_format="stl", binary=True)
    second = meshio.Mesh(numpy.array(POINTS), [("triangle", numpy.array(TRIANGLES)),
                                               ("line", numpy.array([(0, 1), (1, 2)])), ("vertex", numpy.array([(0,)]))])
    for form in ("vtu", "vtk", "mesh"):
        second.write(os.path.join(folder, "meshio_lines." + form))


written = 0
for write_all in (write_by_vtk, write_by_meshio):
    try:
        write_all()
        written += 1
    except ImportError:
        pass
sys.exit(0 if written else 77)
