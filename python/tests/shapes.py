# Copyright (c) 2026 The Tubular_meshing authors.
# SPDX-License-Identifier: GPL-3.0-or-later
import numpy as np


def tube(length=8.0, radius=1.0, around=16, along=24, bend=0.0, ends="open"):
    """Points and triangles of a tube along z, bent aside; its ends are open, or capped flat round their center."""
    angle = 2 * np.pi * np.arange(around) / around
    z = length * np.arange(along + 1) / along
    ring = radius * np.stack([np.cos(angle), np.sin(angle), 0 * angle], axis=1)
    axis = np.stack([bend * np.sin(np.pi * z / length), 0 * z, z], axis=1)
    points = (axis[:, None, :] + ring[None, :, :]).reshape(-1, 3)
    i, j = np.meshgrid(np.arange(along), np.arange(around), indexing="ij")
    a, b = (i * around + j).ravel(), (i * around + (j + 1) % around).ravel()
    triangles = np.concatenate([np.stack([a, b, b + around], 1), np.stack([a, b + around, a + around], 1)])
    if ends == "capped":
        j = np.arange(around)
        last = along * around
        low, high = len(points), len(points) + 1
        points = np.concatenate([points, axis[[0, -1]]])
        cap = np.stack([np.full(around, low), (j + 1) % around, j], 1)
        other = np.stack([np.full(around, high), last + j, last + (j + 1) % around], 1)
        triangles = np.concatenate([triangles, cap, other])
    return points, triangles


def cap_labels(around=16, along=24):
    """Labels of a capped tube: 1 the wall, 2 and 3 the ends."""
    return np.repeat([1, 2, 3], [2 * around * along, around, around])


def volumes(mesh):
    """Of each tetrahedron."""
    a, b, c, d = (mesh.points[mesh.cells["tetra"][:, i]] for i in range(4))
    return np.einsum("ij,ij->i", np.cross(b - a, c - a), d - a) / 6
