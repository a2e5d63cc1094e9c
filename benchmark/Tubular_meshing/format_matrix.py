#!/usr/bin/env python3
# Copyright (c) 2026 The Tubular_meshing authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Meshes of each type, written in each format, read back by other programs' readers and by those below, and compared:
points, cells with their regions, facets with their patches. Then the solvers that are installed are given the files:
checkMesh, CalculiX, FreeFEM, Gmsh, cgnscheck, dolfinx. Prints a table.

    format_matrix.py TUBULAR_MESH BENCHMARK_WRITERS SCRATCH SURFACE... [--types TYPE...] [--formats FORMAT...] [-n N]

A surface may have its centerlines behind a comma. Meshes that are in SCRATCH from an earlier run are used again. Needs
numpy, SciPy, VTK, meshio, h5py and netCDF4. Exit status 1: something is not equal."""

import argparse
import contextlib
import itertools
import os
import pathlib
import re
import shutil
import subprocess
import sys
import xml.etree.ElementTree

import numpy as np

TYPES = {
    "tetrahedra": [],
    "anisotropic": ["-t", "anisotropic"],
    "anisotropic, layer": ["-t", "anisotropic", "--first-height", "0.02"],
    "prisms, wall": ["--boundary-layer-prisms", "3", "--wall", "0.2"],
    "tetrahedral wall": ["--wall", "0.2", "--wall-elements", "tetrahedra"],
    "mixed": ["-t", "mixed"],
    "mixed, layers, wall": ["-t", "mixed", "--boundary-layer-prisms", "3", "--wall", "0.2"],
    "hexahedra": ["-t", "hexahedral"],
    "hexahedra, wall": ["-t", "hexahedral", "--wall", "0.2"],
}
KIND_OF = {4: "tetra", 5: "pyramid", 6: "wedge", 8: "hexahedron"}
CORNERS = {"tetra": 4, "pyramid": 5, "wedge": 6, "hexahedron": 8, "triangle": 3, "quad": 4}
FACETS = ("triangle", "quad")
# The neighbors of corner 0 that make a right-handed frame; a left-handed one of prisms in VTK's order.
FRAME = {"tetra": (1, 2, 3), "pyramid": (1, 3, 4), "wedge": (1, 2, 3), "hexahedron": (1, 3, 4)}
BETWEEN = "between regions"


class Different(Exception):
    """Says what is not as it is in the mesh."""


class Mesh:
    """Points; of each kind of element blocks (corners, names), a row and the name of its region or patch each."""

    def __init__(self, points):
        self.points = np.asarray(points, float).reshape(-1, 3)
        self.blocks = {}

    def add(self, kind, corners, names):
        corners = np.asarray(corners, np.int64).reshape(-1, CORNERS[kind])
        if len(corners) == 0:
            return
        if isinstance(names, str):
            names = np.full(len(corners), names, object)
        self.blocks.setdefault(kind, []).append((corners, np.asarray(names, object)))

    def elements(self, kind):
        blocks = self.blocks.get(kind, [])
        if not blocks:
            return np.zeros((0, CORNERS[kind]), np.int64), np.zeros(0, object)
        return np.concatenate([b[0] for b in blocks]), np.concatenate([b[1] for b in blocks])

    def merge(self, other):
        """Adds another mesh, with points of its own."""
        first = len(self.points)
        self.points = np.concatenate([self.points, other.points])
        for kind, blocks in other.blocks.items():
            for corners, names in blocks:
                self.add(kind, corners + first, names)

    def between_regions(self):
        """Of each kind of facet, which of them have a cell of another region on each side."""
        local = {"tetra": ((0, 1, 2), (0, 1, 3), (1, 2, 3), (0, 2, 3)),
                 "pyramid": ((0, 1, 2, 3), (0, 1, 4), (1, 2, 4), (2, 3, 4), (3, 0, 4)),
                 "wedge": ((0, 1, 2), (3, 4, 5), (0, 1, 4, 3), (1, 2, 5, 4), (2, 0, 3, 5)),
                 "hexahedron": ((0, 1, 2, 3), (4, 5, 6, 7), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7))}
        rows = {k: [np.zeros((0, CORNERS[k] + 1), np.int64)] for k in FACETS}
        for kind, tables in local.items():
            corners, names = self.elements(kind)
            region = np.searchsorted(self.region_names(), names.astype(str)) if len(names) else np.zeros(0, int)
            for t in tables:
                f = np.sort(corners[:, list(t)], axis=1)
                rows["quad" if len(t) == 4 else "triangle"].append(np.column_stack([f, region]))
        result = {}
        for kind in FACETS:
            all_rows = np.unique(np.concatenate(rows[kind]), axis=0)
            unique, count = np.unique(all_rows[:, :-1], axis=0, return_counts=True)
            shared = as_bytes(unique[count > 1])
            result[kind] = np.isin(as_bytes(np.sort(self.elements(kind)[0], axis=1)), shared)
        return result

    def region_names(self):
        return np.unique(np.concatenate([self.elements(k)[1].astype(str) for k in FRAME]))


def as_bytes(rows):
    rows = np.ascontiguousarray(rows)
    return rows.view("V%d" % (rows.dtype.itemsize * rows.shape[1])).ravel() if len(rows) else np.zeros(0, "V8")


def numbers_of(points, among, exact):
    """Which of some points each point is."""
    if exact:
        keys = as_bytes(among + 0.0)  # no -0
        order = np.argsort(keys)
        found = order[np.minimum(np.searchsorted(keys, as_bytes(points + 0.0), sorter=order), len(order) - 1)]
        off = (among[found] != points).any(axis=1)
    else:
        from scipy.spatial import cKDTree

        distance, found = cKDTree(among).query(points)
        off = distance > 1e-11 * np.ptp(among, axis=0).max()
    if off.any():
        raise Different("%d points are not the mesh's" % off.sum())
    return found


def canonical(corners, names, table):
    label = np.array([table.setdefault(n, len(table)) for n in names], np.int64)
    rows = np.column_stack([np.sort(corners, axis=1), label])
    return np.unique(rows, axis=0)


def rename_between(read, mesh):
    """Facets of a patch that lies between regions, which formats of a mesh a region have in each, get one name."""
    between = mesh.between_regions()
    shared = [n for k in FACETS for n in set(mesh.elements(k)[1][between[k]])]
    for kind in FACETS:
        read.blocks[kind] = [(corners, np.where(np.isin(names.astype(str), shared), BETWEEN, names))
                             for corners, names in read.blocks.get(kind, [])]


def compare(mesh, read, exact=True, oriented=True, split=False, prisms=1):
    """Raises Different, or returns. split: what lies between regions is in both, see rename_between(); prisms: -1 where
    they are in VTK's order."""
    used = np.unique(np.concatenate([mesh.elements(k)[0].ravel() for k in FRAME]))
    number = numbers_of(read.points, mesh.points, exact)
    if len(np.setdiff1d(used, number)):
        raise Different("points are missing")
    if not split and len(np.unique(number)) != len(number):
        raise Different("points are there twice")
    between = mesh.between_regions() if split else None
    for kind in CORNERS:
        table = {}
        expected, expected_names = mesh.elements(kind)
        found, found_names = read.elements(kind)
        if not split and len(found) != len(expected):
            raise Different("%d of kind %s, not %d" % (len(found), kind, len(expected)))
        if kind in FACETS and split:
            expected_names = np.where(between[kind], BETWEEN, expected_names)
        a, b = canonical(expected, expected_names, table), canonical(number[found], found_names, table)
        if not np.array_equal(a, b):
            names = (set(map(str, expected_names)) ^ set(map(str, found_names))) or "their places"
            raise Different("elements of kind %s: %s" % (kind, names))
        if kind in FRAME and oriented and len(found):
            x = [read.points[found[:, i]] for i in (0,) + FRAME[kind]]
            side = np.einsum("ij,ij->i", np.cross(x[1] - x[0], x[2] - x[0]), x[3] - x[0])
            if not ((prisms if kind == "wedge" else 1) * side > 0).all():
                raise Different("cells of kind %s are turned over" % kind)


# --- readers ---


def vtk_grid(path):
    import vtk

    reader = vtk.vtkXMLUnstructuredGridReader() if str(path).endswith(".vtu") else vtk.vtkXMLPolyDataReader()
    reader.SetFileName(str(path))
    reader.Update()
    return reader.GetOutput()


def read_vtu(path):
    from vtk.util.numpy_support import vtk_to_numpy

    grid = vtk_grid(path)
    mesh = Mesh(vtk_to_numpy(grid.GetPoints().GetData()))
    nodes = vtk_to_numpy(grid.GetCells().GetConnectivityArray())
    first = vtk_to_numpy(grid.GetCells().GetOffsetsArray())
    types = vtk_to_numpy(grid.GetCellTypesArray())
    label = {name: vtk_to_numpy(grid.GetCellData().GetArray(name)) for name in ("region", "patch")}
    names = {2: {}, 3: {}}
    fields = grid.GetFieldData()
    for i in range(fields.GetNumberOfArrays()):
        pairs = vtk_to_numpy(fields.GetArray(i)).reshape(-1, 2)
        for number, dimension in pairs:
            names[dimension][number] = fields.GetArrayName(i)
    for kind, vtk_type in (("tetra", 10), ("pyramid", 14), ("wedge", 13), ("hexahedron", 12), ("triangle", 5), ("quad", 9)):
        at = np.flatnonzero(types == vtk_type)
        is_facet = kind in FACETS
        of = label["patch" if is_facet else "region"][at]
        mesh.add(kind, nodes[first[at][:, None] + np.arange(CORNERS[kind])],
                 np.array([names[2 if is_facet else 3][n] for n in of], object))
    mesh.labels = names
    return mesh


def read_meshio(path, key, names):
    import meshio

    with contextlib.redirect_stdout(sys.stderr):  # it prints
        data = meshio.read(path)
    mesh = Mesh(data.points)
    for block, labels in zip(data.cells, data.cell_data[key]):
        if block.type in CORNERS:
            of = names[2 if block.type in FACETS else 3]
            mesh.add(block.type, block.data, np.array([of.get(n, str(n)) for n in labels], object))
    return mesh


def read_msh(folder, reference):
    path = folder / "mesh.msh"
    head = path.read_bytes()[:200000].decode(errors="replace")
    told = {2: {}, 3: {}}
    for dimension, number, name in re.findall(r'^(\d) (\d+) "(.*)"$', head, re.M):
        told[int(dimension)][int(number)] = name
    if told != {d: dict(n) for d, n in reference.labels.items()}:
        raise Different("names of physical groups")
    return read_meshio(path, "gmsh:physical", told)


def read_medit(folder, reference):
    told = {2: {}, 3: {}}
    with open(folder / "mesh.mesh") as file:
        for line in itertools.islice(file, 1000):
            found = re.match(r"# (region|patch) (\d+) (.*)", line)
            if found:
                told[3 if found.group(1) == "region" else 2][int(found.group(2))] = found.group(3)
    if told != {d: dict(n) for d, n in reference.labels.items()}:
        raise Different("names in comments")
    return read_meshio(folder / "mesh.mesh", "medit:ref", told)


def numbers(text, kind=np.int64):
    return np.array(text.replace(",", " ").split(), kind)


# Which corners a face of an element of an input deck has, from 1.
INP_FACES = {4: {1: (1, 2, 3), 2: (1, 4, 2), 3: (2, 4, 3), 4: (3, 4, 1)},
             6: {1: (1, 2, 3), 2: (4, 5, 6), 3: (1, 2, 5, 4), 4: (2, 3, 6, 5), 5: (3, 1, 4, 6)},
             8: {1: (1, 2, 3, 4), 2: (5, 8, 7, 6), 3: (1, 5, 6, 2), 4: (2, 6, 7, 3), 5: (3, 7, 8, 4), 6: (4, 8, 5, 1)}}


def read_inp(folder, reference):
    keywords = re.split(r"^\*(?=[A-Z])", (folder / "mesh.inp").read_text(), flags=re.M)[1:]
    mesh, element = None, {}
    for keyword in keywords:
        head, body = keyword.split("\n", 1)
        words = [w.strip() for w in head.split(",")]
        option = dict(w.split("=") for w in words[1:])
        if words[0] == "NODE":
            table = numbers(body, float).reshape(-1, 4)
            mesh = Mesh(table[:, 1:])
        elif words[0] == "ELEMENT":
            size = int(option["TYPE"][3:])
            table = numbers(body).reshape(-1, size + 1)
            region = option["ELSET"][len("region_"):]
            for row in table:
                element[row[0]] = row[1:]
            collapsed = (table[:, -1] == table[:, -4]) if size == 8 else np.zeros(len(table), bool)
            mesh.add("pyramid", table[collapsed][:, 1:6] - 1, region)
            mesh.add(KIND_OF[size], table[~collapsed][:, 1:] - 1, region)
        elif words[0] == "SURFACE":
            sides = {3: [], 4: []}
            for line in body.splitlines():
                if line.startswith("**"):
                    continue
                number, face = line.split(",")
                e = element[int(number)]
                side = list(dict.fromkeys(e[c - 1] for c in INP_FACES[len(e)][int(face.strip()[1:])]))
                sides[len(side)].append(side)
            mesh.add("triangle", np.array(sides[3]).reshape(-1, 3) - 1, option["NAME"])
            mesh.add("quad", np.array(sides[4]).reshape(-1, 4) - 1, option["NAME"])
    return mesh


def polyhedral(points, faces, first, owner, neighbour, region_of, patches):
    """faces: the corners of all, one behind the other; first: where each begins; patches: (name, numbers of faces)."""
    mesh = Mesh(points)
    size = np.diff(first)
    face_of = np.repeat(np.arange(len(size)), size)
    pairs = [np.column_stack([owner[face_of], faces])]
    inner = face_of < len(neighbour)
    pairs.append(np.column_stack([neighbour[face_of[inner]], faces[inner]]))
    pairs = np.unique(np.concatenate(pairs), axis=0)
    begin = np.concatenate([[0], np.cumsum(np.bincount(pairs[:, 0]))])
    count = np.diff(begin)
    for corners, kind in KIND_OF.items():
        at = np.flatnonzero(count == corners)
        mesh.add(kind, pairs[begin[at][:, None] + np.arange(corners), 1], region_of[at])
    if not np.isin(count, list(KIND_OF)).all():
        raise Different("polyhedra of other numbers of corners")
    for name, number in patches:
        for corners, kind in ((3, "triangle"), (4, "quad")):
            at = number[size[number] == corners]
            mesh.add(kind, faces[first[at][:, None] + np.arange(corners)], name)
    return mesh


def foam_body(path):
    data = path.read_bytes()
    return data[data.index(b"}") + 1:], b"binary" in data[:300]


def foam_numbers(path, kind, columns=1):
    body, binary = foam_body(path)
    found = re.search(rb"(\d+)\s*\(", body)
    count = int(found.group(1)) * columns
    if binary:
        return np.frombuffer(body, np.int32 if kind is np.int64 else kind, count, found.end())
    return np.array(body[found.end():].replace(b"(", b" ").replace(b")", b" ").split()[:count], kind)


def foam_faces(path):
    body, binary = foam_body(path)
    if binary:
        found = re.search(rb"(\d+)\s*\(", body)
        count = int(found.group(1))
        first = np.frombuffer(body, np.int32, count, found.end())
        rest = body[found.end() + 4 * count:]
        found = re.search(rb"(\d+)\s*\(", rest)
        return np.frombuffer(rest, np.int32, int(found.group(1)), found.end()).astype(np.int64), first.astype(np.int64)
    found = re.search(rb"(\d+)\s*\(", body)
    words = np.array(body[found.end():].replace(b"(", b" ").replace(b")", b" ").split(), np.int64)
    sizes, at = [], 0
    for _ in range(int(found.group(1))):
        sizes.append(words[at])
        at += words[at] + 1
    first = np.concatenate([[0], np.cumsum(sizes)])
    keep = np.ones(at, bool)
    keep[first[:-1] + np.arange(len(sizes))] = False
    return words[:at][keep], first


def foam_zones(path, list_name):
    """(name, numbers) of cellZones or faceZones."""
    if not path.exists():
        return []
    text = path.read_bytes().decode("latin-1")
    return [(name, np.array(labels.split(), np.int64)) for name, labels in
            re.findall(r"\n\s*([^\s{}()]+)\s*\n?\s*\{[^}]*?%s\s+List<label>\s*\d+\s*\(([^)]*)\)" % list_name, text)]


def read_poly_mesh(folder, region="lumen", between=False):
    faces, first = foam_faces(folder / "faces")
    owner, neighbour = (foam_numbers(folder / n, np.int64).astype(np.int64) for n in ("owner", "neighbour"))
    regions = np.full(max(owner.max(), neighbour.max(initial=0)) + 1, region, object)
    for name, cells in foam_zones(folder / "cellZones", "cellLabels"):
        regions[cells] = name
    patches = []
    for name, text in re.findall(r"\n\s*([^\s{}()]+)\s*\n\s*\{([^}]*)\}", foam_body(folder / "boundary")[0].decode()):
        size, begin = (int(re.search(k + r"\s+(\d+);", text).group(1)) for k in ("nFaces", "startFace"))
        patches.append((BETWEEN if between and "_to_" in name else name, np.arange(begin, begin + size)))
    patches += foam_zones(folder / "faceZones", "faceLabels")
    points = foam_numbers(folder / "points", float, 3).reshape(-1, 3)
    return polyhedral(points, faces, first, owner, neighbour, regions, patches)


def read_openfoam(folder, reference, name="openfoam"):
    return read_poly_mesh(folder / name / "constant" / "polyMesh")


def read_openfoam_regions(folder, reference, name="openfoam-regions"):
    mesh = Mesh(np.zeros((0, 3)))
    for region, label in (("fluid", "lumen"), ("solid", "wall")):
        if (folder / name / "constant" / region).exists():
            mesh.merge(read_poly_mesh(folder / name / "constant" / region / "polyMesh", label, True))
    return mesh


def read_fluent(folder, reference):
    text = (folder / "mesh.cas").read_text()
    points, faces, sizes, cells, patches, regions = None, [], [], [], [], {}
    names = {int(i): (kind, name) for i, kind, name in re.findall(r"^\((?:39|45) \((\d+) (\S+) ([^\s()]+)\)", text, re.M)}
    zones = {}
    for section in re.finditer(r"^\((10|12|13) \(([0-9a-f ]+)\)(?:\(\n(.*?)\n?\)\))?\)?$", text, re.M | re.S):
        index, head, body = section.group(1), [int(x, 16) for x in section.group(2).split()], section.group(3)
        if head[0] == 0:
            continue
        if index == "10":
            points = np.array(body.split(), float).reshape(-1, 3)
        elif index == "12":
            regions[head[0]] = (head[1] - 1, head[2])
        else:
            lines = body.split("\n")
            begin = len(sizes)
            rows = [[int(x, 16) for x in line.split()] for line in lines]
            for row in rows:
                if head[4] == 0:
                    row = row[1:]
                sizes.append(len(row) - 2)
                faces.extend(row[:-2])
                cells.append(row[-2:])
            zones[head[0]] = np.arange(begin, len(sizes))
    first = np.concatenate([[0], np.cumsum(sizes)])
    faces, cells = np.array(faces, np.int64) - 1, np.array(cells, np.int64) - 1
    # those with a cell on both sides first, as polyhedral() wants them
    order = np.argsort(cells.min(axis=1) < 0, kind="stable")
    place = np.empty(len(order), np.int64)
    place[order] = np.arange(len(order))
    sizes = np.array(sizes)[order]
    faces = np.concatenate([faces[first[k]:first[k + 1]] for k in order])
    first = np.concatenate([[0], np.cumsum(sizes)])
    cells = cells[order]
    region_of = np.full(cells.max() + 1, "", object)
    for zone, (begin, end) in regions.items():
        name = names[zone][1]  # where a patch has that of the region, another one
        region_of[begin:end] = name if name in reference.labels[3].values() else re.sub("-cells$", "", name)
    inner = int((cells.min(axis=1) >= 0).sum())
    patches = [(names[z][1], place[n]) for z, n in zones.items() if z in names and names[z][0] != "interior"]
    return polyhedral(points, faces, first, cells.max(axis=1), cells.min(axis=1)[:inner], region_of, patches)


VTK_NUMBERS = {10: "tetra", 14: "pyramid", 13: "wedge", 12: "hexahedron", 5: "triangle", 9: "quad"}


def read_su2(folder, reference):
    lines = iter((folder / "mesh.su2").read_text().split("\n"))
    regions = [reference.labels[3][k] for k in sorted(reference.labels[3])]
    mesh, zone_number = Mesh(np.zeros((0, 3))), 0

    def rows(count):
        return [next(lines).split() for _ in range(count)]

    def end_zone(points, cells, markers):
        part = Mesh(points)
        region = regions[zone_number]
        for kind, corners in cells.items():
            part.add(kind, corners, region)
        for name, kind, corners in markers:
            inner = zone_number and any(name == n + "_" + region for n in reference.labels[2].values())
            part.add(kind, corners, BETWEEN if inner else name)
        mesh.merge(part)

    points, cells, markers, name = None, None, [], ""
    for line in lines:
        key, _, value = line.partition("=")
        if key == "NELEM":
            if cells is not None:
                end_zone(points, cells, markers)
                zone_number, markers = zone_number + 1, []
            cells = {}
            for row in rows(int(value)):
                kind = VTK_NUMBERS[int(row[0])]
                cells.setdefault(kind, []).append([int(x) for x in row[1:1 + CORNERS[kind]]])
        elif key == "NPOIN":
            points = np.array(rows(int(value.split()[0])), float)[:, :3]
        elif key == "MARKER_TAG":
            name = value.strip()
        elif key == "MARKER_ELEMS":
            by_kind = {}
            for row in rows(int(value)):
                kind = VTK_NUMBERS[int(row[0])]
                by_kind.setdefault(kind, []).append([int(x) for x in row[1:1 + CORNERS[kind]]])
            markers += [(name, kind, corners) for kind, corners in by_kind.items()]
    end_zone(points, cells, markers)
    return mesh


def region_of_block(name, regions):
    """Of a block whose name is that of its region, or that with the kind of cell behind it."""
    return max((r for r in regions if name == r or name.startswith(r + "_")), key=len)


def read_febio(folder, reference):
    root = xml.etree.ElementTree.parse(folder / "mesh.feb").getroot().find("Mesh")
    mesh = Mesh([n.text.split(",") for n in root.find("Nodes")])
    kinds = {"tet4": "tetra", "pyra5": "pyramid", "penta6": "wedge", "hex8": "hexahedron", "tri3": "triangle",
             "quad4": "quad"}
    for block in root.findall("Elements"):
        mesh.add(kinds[block.get("type")], np.array([e.text.split(",") for e in block], np.int64) - 1,
                 region_of_block(block.get("name"), reference.labels[3].values()))
    for surface in root.findall("Surface"):
        for tag in ("tri3", "quad4"):
            rows = [e.text.split(",") for e in surface if e.tag == tag]
            if rows:
                mesh.add(kinds[tag], np.array(rows, np.int64) - 1, surface.get("name"))
    return mesh


def read_xdmf(folder, reference):
    import h5py

    root = xml.etree.ElementTree.parse(folder / "mesh.xdmf").getroot()
    told = {}
    for grid, dimension in (("cell_tags", 3), ("facet_tags", 2)):
        for entry in root.findall(".//Grid[@Name='%s']/Information" % grid):
            told.setdefault(dimension, {})[int(entry.get("Value"))] = entry.get("Name")
    with h5py.File(folder / "mesh.h5", "r") as file:
        mesh = Mesh(file["geometry"][...])
        for cells, tags, dimension in (("cells", "regions", 3), ("facets", "patches", 2)):
            corners = file[cells][...]
            kind = {3: "triangle", 4: "quad" if dimension == 2 else "tetra", 8: "hexahedron"}[corners.shape[1]]
            mesh.add(kind, corners, np.array([told[dimension][t] for t in file[tags][...]], object))
    return mesh


def read_cgns(folder, reference):
    import h5py

    kinds = {10: "tetra", 12: "pyramid", 14: "wedge", 17: "hexahedron", 5: "triangle", 7: "quad"}
    with h5py.File(folder / "mesh.cgns", "r") as file:
        zone = file["Base/Zone"]
        mesh = Mesh(np.column_stack([zone["GridCoordinates/Coordinate%s/ data" % c][...] for c in "XYZ"]))
        total = 0
        for name, section in zone.items():
            if not isinstance(section, h5py.Group) or "ElementConnectivity" not in section:
                continue
            kind, corners = int(section[" data"][0]), section["ElementConnectivity/ data"][...]
            begin, end = section["ElementRange/ data"][...]
            total += end - begin + 1
            if kind == 20:  # mixed
                at, by_kind = 0, {}
                while at < len(corners):
                    k = kinds[int(corners[at])]
                    by_kind.setdefault(k, []).append(corners[at + 1:at + 1 + CORNERS[k]])
                    at += 1 + CORNERS[k]
            else:
                by_kind = {kinds[kind]: corners}
            for k, rows in by_kind.items():
                rows = np.asarray(rows).reshape(-1, CORNERS[k]) - 1
                is_facet = k in FACETS
                if is_facet and list(zone["ZoneBC/%s/PointRange/ data" % name][...].ravel()) != [begin, end]:
                    raise Different("the boundary condition of " + name)
                own = name[:-len("_cells")] if name.endswith("_cells") else name
                own = own.replace("_cells_", "_")
                mesh.add(k, rows, name if is_facet else region_of_block(own, reference.labels[3].values()))
        if total != zone[" data"][1, 0] + sum(len(mesh.elements(k)[0]) for k in FACETS):
            raise Different("numbers of elements")
    return mesh


# Which corners a side of a block of Exodus II has, from 1.
EXODUS_SIDES = {"tetra": ((1, 2, 4), (2, 3, 4), (1, 4, 3), (1, 3, 2)),
                "pyramid": ((1, 2, 5), (2, 3, 5), (3, 4, 5), (4, 1, 5), (1, 4, 3, 2)),
                "wedge": ((1, 2, 5, 4), (2, 3, 6, 5), (1, 4, 6, 3), (1, 3, 2), (4, 5, 6)),
                "hexahedron": ((1, 2, 6, 5), (2, 3, 7, 6), (3, 4, 8, 7), (1, 5, 8, 4), (1, 4, 3, 2), (5, 6, 7, 8))}


def read_exodus(folder, reference):
    import netCDF4

    data = netCDF4.Dataset(folder / "mesh.exo")
    data.set_auto_mask(False)

    def names(variable):
        return [b"".join(row).decode().strip("\0") for row in data[variable][:]]

    mesh = Mesh(np.column_stack([data["coord" + c][:] for c in "xyz"]))
    kinds = {"TETRA4": "tetra", "PYRAMID5": "pyramid", "WEDGE6": "wedge", "HEX8": "hexahedron"}
    begin, cells = [0], []
    for i, name in enumerate(names("eb_names"), 1):
        block = data["connect%d" % i]
        kind = kinds[block.elem_type]
        corners = block[:].astype(np.int64) - 1
        mesh.add(kind, corners, region_of_block(name, reference.labels[3].values()))
        begin.append(begin[-1] + len(corners))
        cells.append((kind, corners))
    for i, name in enumerate(names("ss_names"), 1):
        element, side = data["elem_ss%d" % i][:] - 1, data["side_ss%d" % i][:] - 1
        if reference.labels[2].get(int(data["ss_prop1"][i - 1])) != name:
            raise Different("the number of side set " + name)
        block = np.searchsorted(begin, element, side="right") - 1
        for b, (kind, corners) in enumerate(cells):
            for s, table in enumerate(EXODUS_SIDES[kind]):
                at = element[(block == b) & (side == s)] - begin[b]
                mesh.add("triangle" if len(table) == 3 else "quad", corners[at][:, np.array(table) - 1], name)
    data.close()
    return mesh


def read_svmultiphysics(folder, reference):
    from vtk.util.numpy_support import vtk_to_numpy

    top = folder / "mesh-complete"
    parts = [(top / p, r) for p, r in (("fluid", "lumen"), ("solid", "wall")) if (top / p).exists()]
    result = Mesh(np.zeros((0, 3)))
    for part, region in parts or [(top, "lumen")]:
        grid = vtk_grid(part / "mesh-complete.mesh.vtu")
        mesh = Mesh(vtk_to_numpy(grid.GetPoints().GetData()))
        kind = VTK_NUMBERS[grid.GetCellType(0)]
        corners = vtk_to_numpy(grid.GetCells().GetConnectivityArray()).reshape(-1, CORNERS[kind]).astype(np.int64)
        mesh.add(kind, corners, region)
        if list(vtk_to_numpy(grid.GetCellData().GetArray("GlobalElementID"))) != list(range(1, len(corners) + 1)):
            raise Different("GlobalElementID")
        for file in sorted((part / "mesh-surfaces").glob("*.vtp")):
            surface = vtk_grid(file)
            node = vtk_to_numpy(surface.GetPointData().GetArray("GlobalNodeID")) - 1
            if not np.array_equal(vtk_to_numpy(surface.GetPoints().GetData()), mesh.points[node]):
                raise Different("points of " + file.name)
            cells = surface.GetPolys()
            size = cells.GetMaxCellSize()
            facets = node[vtk_to_numpy(cells.GetConnectivityArray()).reshape(-1, size)]
            behind = vtk_to_numpy(surface.GetCellData().GetArray("GlobalElementID")) - 1
            if not (facets[:, :, None] == corners[behind][:, None, :]).any(axis=2).all():
                raise Different("GlobalElementID of " + file.name)
            names = np.full(len(facets), file.stem, object)
            mesh.add("triangle" if size == 3 else "quad", facets, names)
        result.merge(mesh)
    return result


# --- solvers: each says "" where it takes the file, else why not; None where it is not installed ---


def run(command, timeout=900, **options):
    try:
        return subprocess.run([str(c) for c in command], stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                              universal_newlines=True, timeout=timeout, **options)
    except subprocess.TimeoutExpired:
        return subprocess.CompletedProcess(command, 124, "took more than %d s" % timeout)


CONTROL = """FoamFile { version 2.0; format ascii; class dictionary; object controlDict; }
application simpleFoam; startFrom startTime; startTime 0; stopAt endTime; endTime 1; deltaT 1; writeControl timeStep;
writeInterval 1;
"""


def check_mesh(case, *options):
    if not shutil.which("checkMesh"):
        return None
    (case / "system").mkdir(exist_ok=True)
    (case / "system" / "controlDict").write_text(CONTROL)
    header = "FoamFile { version 2.0; format ascii; class dictionary; object %s; }\n"
    (case / "system" / "fvSolution").write_text(header % "fvSolution")
    (case / "system" / "fvSchemes").write_text(header % "fvSchemes" + "".join(
        "%sSchemes { default none; }\n" % k for k in ("ddt", "grad", "div", "laplacian", "interpolation", "snGrad")))
    if options:  # of the region
        shutil.copytree(case / "system", case / "system" / options[1], dirs_exist_ok=True)
    environment = dict(os.environ)
    if "WM_PROJECT_DIR" not in environment and os.path.isdir("/usr/share/openfoam"):
        environment["WM_PROJECT_DIR"] = "/usr/share/openfoam"  # Debian's, which needs no more than this
    out = run(["checkMesh", "-case", case, *options], env=environment).stdout
    if "Mesh OK." in out:
        return ""
    problems = re.findall(r"^ \*+\s*(.*)$", out, re.M)
    return "; ".join(dict.fromkeys(p.strip() for p in problems)) or out[-300:]


def check_openfoam(folder, mesh, name="openfoam"):
    return check_mesh(folder / name)


def check_regions(folder, mesh, name="openfoam-regions"):
    regions = [p.name for p in (folder / name / "constant").iterdir() if (p / "polyMesh").exists()]
    said = [(r, check_mesh(folder / name, "-region", r)) for r in sorted(regions)]
    return None if None in dict(said).values() else "; ".join("%s: %s" % s for s in said if s[1])


def check_ccx(folder, mesh):
    if not shutil.which("ccx"):
        return None
    deck = "*INCLUDE, INPUT=mesh.inp\n*MATERIAL, NAME=stuff\n*ELASTIC\n1e6, 0.3\n"
    for region in mesh.region_names():
        deck += "*SOLID SECTION, ELSET=region_%s, MATERIAL=stuff\n" % region
    deck += "*BOUNDARY\ninlet, 1, 3\n*STEP\n*NO ANALYSIS\n*END STEP\n"
    (folder / "deck.inp").write_text(deck)
    done = run(["ccx", "deck"], cwd=folder)
    problems = re.findall(r"\*ERROR.*", done.stdout)
    return problems[0].strip() if problems else "" if "number of equations" in done.stdout else done.stdout[-200:].strip()


FREEFEM = """load "msh3"
mesh3 Th = readmesh3("mesh.mesh");
cout.precision(15);
cout << "volume " << int3d(Th)(1.) << endl;
fespace V(Th, P1); V u, v;
"""
POISSON = "solve P(u, v) = int3d(Th)(dx(u)*dx(v) + dy(u)*dy(v) + dz(u)*dz(v)) - int3d(Th)(v) + on(%s, u = 0);\n"


def check_freefem(folder, mesh):
    if not shutil.which("FreeFem++"):
        return None
    if set(mesh.blocks) - {"tetra", "triangle"}:
        return "FreeFEM has tetrahedra alone"
    script = FREEFEM + "".join('cout << "area %d " << int2d(Th, %d)(1.) << endl;\n' % (k, k) for k in mesh.labels[2])
    script += POISSON % ", ".join(map(str, mesh.labels[2]))
    (folder / "check.edp").write_text(script)
    environment = dict(os.environ)
    if "FF_LOADPATH" not in environment and os.path.isdir("/usr/lib/freefem++"):
        environment["FF_LOADPATH"] = "/usr/lib/freefem++"  # where Debian has its modules, and does not look for them
    done = run(["FreeFem++", "-nw", "check.edp"], cwd=folder, env=environment)
    if done.returncode != 0:
        return done.stdout[-200:]
    volume, areas = measures(mesh)
    told = {k: float(v) for k, v in re.findall(r"^(volume|area \d+) ([-+.e\d]+)$", done.stdout, re.M)}
    if abs(told["volume"] / volume - 1) > 1e-9:
        return "volume %g, not %g" % (told["volume"], volume)
    off = [n for k, n in mesh.labels[2].items() if abs(told["area %d" % k] / areas[n] - 1) > 1e-9]
    return "areas of " + ", ".join(off) if off else ""


def measures(mesh):
    corners, _ = mesh.elements("tetra")
    x = mesh.points[corners]
    volume = np.einsum("ij,ij->i", np.cross(x[:, 1] - x[:, 0], x[:, 2] - x[:, 0]), x[:, 3] - x[:, 0]).sum() / 6
    facets, names = mesh.elements("triangle")
    y = mesh.points[facets]
    area = np.linalg.norm(np.cross(y[:, 1] - y[:, 0], y[:, 2] - y[:, 0]), axis=1) / 2
    return volume, {n: area[names == n].sum() for n in set(names)}


def check_gmsh(folder, mesh):
    if not shutil.which("gmsh"):
        return None
    done = run(["gmsh", "-check", "-nopopup", "-nt", "1", "mesh.msh"], cwd=folder)
    problems = re.findall(r"^(?:Error|Warning)\s*:.*", done.stdout, re.M)
    return "" if done.returncode == 0 and not problems else (problems or [done.stdout[-200:]])[0].strip()


def check_cgnscheck(folder, mesh):
    if not shutil.which("cgnscheck"):
        return None
    done = run(["cgnscheck", "-w1", "mesh.cgns"], cwd=folder)
    problems = re.findall(r"^.*(?:ERROR|WARNING).*", done.stdout, re.M)
    return "" if done.returncode == 0 and not problems else (problems or [done.stdout[-200:]])[0].strip()


def dolfinx_inside(path):
    """Prints the volume, and the area of the facets of each tag."""
    import dolfinx
    import ufl
    from mpi4py import MPI

    with dolfinx.io.XDMFFile(MPI.COMM_WORLD, path, "r") as file:
        domain = file.read_mesh(name="mesh")
        domain.topology.create_connectivity(2, 3)
        domain.topology.create_connectivity(2, 0)
        tags = file.read_meshtags(domain, name="facet_tags")
        cells = file.read_meshtags(domain, name="cell_tags")
    one = dolfinx.fem.Constant(domain, 1.0)
    dx = ufl.Measure("dx", domain=domain, subdomain_data=cells)
    print("volume %.15g" % dolfinx.fem.assemble_scalar(dolfinx.fem.form(one * dx)))
    for tag in np.unique(tags.values):
        print("tag %d %d" % (tag, (tags.values == tag).sum()))


def check_dolfinx(folder, mesh):
    done = run([sys.executable, __file__, "inside", folder / "mesh.xdmf"])
    if done.returncode == 77:
        return None
    if done.returncode != 0:
        return done.stdout.strip().split("\n")[-1]
    told = dict(re.findall(r"^(volume|tag \d+) ([-+.e\d]+)$", done.stdout, re.M))
    for kind in FACETS:
        _, names = mesh.elements(kind)
        for label, name in mesh.labels[2].items():
            n = int((names == name).sum())
            if n and int(told.get("tag %d" % label, 0)) != n:
                return "%s facets of %s, not %d" % (told.get("tag %d" % label), name, n)
    if "tetra" in mesh.blocks and abs(float(told["volume"]) / measures(mesh)[0] - 1) > 1e-9:
        return "volume " + told["volume"]
    return ""


FORMATS = {
    "vtu": (lambda folder, r: read_vtu(folder / "mesh.vtu"), {"prisms": -1}, None, ""),
    "gmsh": (read_msh, {}, check_gmsh, "gmsh -check"),
    "medit": (read_medit, {}, check_freefem, "FreeFEM"),
    "abaqus": (read_inp, {"exact": False}, check_ccx, "ccx"),
    "openfoam": (read_openfoam, {"oriented": False}, check_openfoam, "checkMesh"),
    "openfoam-binary": (lambda f, r: read_openfoam(f, r, "openfoam-binary"), {"oriented": False},
                        lambda f, m: check_openfoam(f, m, "openfoam-binary"), "checkMesh"),
    "openfoam-regions": (read_openfoam_regions, {"oriented": False, "split": True}, check_regions, "checkMesh"),
    "openfoam-regions-binary": (lambda f, r: read_openfoam_regions(f, r, "openfoam-regions-binary"),
                                {"oriented": False, "split": True},
                                lambda f, m: check_regions(f, m, "openfoam-regions-binary"), "checkMesh"),
    "svmultiphysics": (read_svmultiphysics, {"split": True, "oriented": False}, None, ""),
    "su2": (read_su2, {"split": True, "prisms": -1}, None, ""),
    "febio": (read_febio, {}, None, ""),
    "fluent": (read_fluent, {"oriented": False}, None, ""),
    "xdmf": (read_xdmf, {}, check_dolfinx, "dolfinx"),
    "cgns": (read_cgns, {}, check_cgnscheck, "cgnscheck"),
    "exodus": (read_exodus, {}, None, ""),
}


def outcome(folder, name, mesh):
    read, options, check, solver = FORMATS[name]
    try:
        found = read(folder, mesh)
        if options.get("split"):
            rename_between(found, mesh)
        compare(mesh, found, **options)
    except Different as difference:
        return False, "NOT EQUAL: %s" % difference
    said = check(folder, mesh) if check else None
    if check is None:
        return True, "equal"
    return True, "equal, " + ("%s is not here" % solver if said is None else "%s: %s" % (solver, said or "takes it"))


def make_mesh(a, surface, kind, file):
    if file.exists():
        return ""
    path, _, lines = surface.partition(",")
    command = [a.tool, path, "-q", "-n", a.n, "-o", file] + TYPES[kind] + (["-c", lines] if lines else [])
    done = run(command)
    if done.returncode in (0, 4) and file.exists():
        return ""
    return "status %d: %s" % (done.returncode, " ".join(done.stdout.split())[-300:])


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("tool")
    parser.add_argument("writers")
    parser.add_argument("scratch", type=pathlib.Path)
    parser.add_argument("surfaces", nargs="+")
    parser.add_argument("--types", nargs="*", choices=list(TYPES), default=list(TYPES))
    parser.add_argument("--formats", nargs="*", choices=list(FORMATS), default=list(FORMATS))
    parser.add_argument("-n", default="12")
    a = parser.parse_args()
    all_equal = True
    print("| surface | mesh | cells | format | outcome |\n|---|---|---|---|---|", flush=True)
    for surface, kind in itertools.product(a.surfaces, a.types):
        name = pathlib.Path(surface.partition(",")[0]).stem
        folder = a.scratch / name / re.sub("[^a-z]+", "_", kind)
        folder.mkdir(parents=True, exist_ok=True)
        why = make_mesh(a, surface, kind, folder / "made.vtu")
        if why:
            print("| %s | %s | | | %s |" % (name, kind, why), flush=True)
            continue
        mesh = read_vtu(folder / "made.vtu")
        cells = format(sum(len(mesh.elements(k)[0]) for k in FRAME), ",")
        for form in a.formats:
            files = folder / form
            shutil.rmtree(files, ignore_errors=True)
            written = run([a.writers, files, folder / "made.vtu", "--keep", "--only", form]).stdout
            refusal = re.search(r"\| %s \| ([^|]*[a-z][^|]*) \|" % re.escape(form), written)
            if refusal:
                reason = re.sub(r'^The (?:file|folder) "[^"]*" cannot be written: ', "", refusal.group(1))
                equal, said = True, "refused: " + reason
            else:
                equal, said = outcome(files, form, mesh)
            all_equal = all_equal and equal
            print("| %s | %s | %s | %s | %s |" % (name, kind, cells, form, " ".join(said.split())), flush=True)
            shutil.rmtree(files, ignore_errors=True)
    return 0 if all_equal else 1


if __name__ == "__main__":
    if len(sys.argv) == 3 and sys.argv[1] == "inside":
        try:
            dolfinx_inside(sys.argv[2])
        except ImportError:
            sys.exit(77)
        sys.exit(0)
    sys.exit(main())
