#!/usr/bin/env python3
# Copyright (c) 2026 The Tubular_meshing authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""The wall of a vessel under the pressure of the blood, by CalculiX.

    calculix_wall.py WALL.inp [--pressure P] [--young E] [--poisson NU] [--lame] [--folder DIR]

WALL.inp is a mesh of the wall alone, as calculix_wall makes it. The wall is clamped at its rings, the pressure acts on
its inside, the patch `wall`; small deformations, linear elasticity. Units are those of the mesh: with lengths in
millimetres, pressures and Young's modulus are in MPa.

With --lame the vessel is known to be a straight tube, and its radial displacement, half way between the rings, is
compared with that of Lame's thick-walled tube held at its ends.

Exit status: 0 all is well, 1 the result is not plausible, 2 the mesh cannot be used or CalculiX failed, 77 there is no
CalculiX (Debian: calculix-ccx).
"""
import argparse
import math
import os
import shutil
import subprocess
import sys


class Mesh:
    """Nodes and node sets of an input deck; its elements and surfaces are CalculiX's business."""

    def __init__(self, name):
        self.nodes, self.sets, self.surfaces, self.element_sets = {}, {}, set(), set()
        keyword, current = '', ''
        with open(name) as deck:
            for line in deck:
                if line.startswith('**'):
                    continue
                fields = [f.strip() for f in line.split(',')]
                if line.startswith('*'):
                    keyword = fields[0].upper()
                    options = dict(f.upper().split('=', 1) for f in fields[1:] if '=' in f)
                    current = options.get('NSET') or options.get('NAME') or options.get('ELSET') or ''
                    if keyword == '*SURFACE':
                        self.surfaces.add(current)
                    if keyword == '*ELEMENT':
                        self.element_sets.add(current)
                elif keyword == '*NODE':
                    self.nodes[int(fields[0])] = tuple(float(x) for x in fields[1:4])
                elif keyword == '*NSET':
                    self.sets.setdefault(current, []).extend(int(f) for f in fields if f)


def deck(mesh_name, mesh, pressure, young, poisson):
    """Clamped rings, a pressure on the inside, and the displacements of the inside to be printed."""
    rings = sorted(s for s in mesh.sets if s.endswith('_RING') or '_RING_' in s)
    if 'WALL' not in mesh.surfaces or not rings or 'REGION_WALL' not in mesh.element_sets:
        raise ValueError('the mesh has no wall with rings: make it by calculix_wall')
    walls = sorted(s for s in mesh.element_sets if s.endswith('WALL'))
    if set(walls) != mesh.element_sets:
        raise ValueError('the mesh has cells that are not of the wall; make one of the wall alone, by calculix_wall')
    lines = ['*INCLUDE, INPUT=' + mesh_name, '*MATERIAL, NAME=TISSUE', '*ELASTIC', '%g, %g' % (young, poisson)]
    lines += ['*SOLID SECTION, ELSET=%s, MATERIAL=TISSUE' % w for w in walls]
    lines += ['*BOUNDARY'] + [r + ', 1, 3' for r in rings]
    lines += ['*STEP', '*STATIC', '*DSLOAD', 'WALL, P, %g' % pressure, '*NODE PRINT, NSET=WALL', 'U', '*NODE FILE', 'U',
              '*EL FILE', 'S', '*END STEP']
    return '\n'.join(lines) + '\n'


def displacements(name):
    result = {}
    with open(name) as printed:
        for line in printed:
            fields = line.split()
            if len(fields) == 4 and fields[0].isdigit():
                result[int(fields[0])] = tuple(float(x) for x in fields[1:])
    return result


def sub(a, b):
    return tuple(x - y for x, y in zip(a, b))


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def mean(points):
    points = list(points)
    return tuple(sum(p[k] for p in points) / len(points) for k in range(3))


def radial(mesh, axis, origin, node):
    """Of a node: the unit vector away from the axis, the distance from it, and the abscissa."""
    d = sub(mesh.nodes[node], origin)
    z = dot(d, axis)
    away = sub(d, tuple(z * a for a in axis))
    r = math.sqrt(dot(away, away))
    return tuple(x / r for x in away), r, z


def compare_with_lame(mesh, u, pressure, young, poisson):
    """The radial displacement of the inside, half way between the ends, over that of Lame's tube in plane strain."""
    ends = [mean(mesh.nodes[n] for n in mesh.sets[s]) for s in sorted(mesh.sets) if '_RING' in s]
    length = math.sqrt(dot(sub(ends[1], ends[0]), sub(ends[1], ends[0])))
    axis = tuple(x / length for x in sub(ends[1], ends[0]))
    measured, inner = [], []
    for node in mesh.sets['WALL']:
        out, r, z = radial(mesh, axis, ends[0], node)
        if 0.4 * length < z < 0.6 * length:
            measured.append(dot(u[node], out))
            inner.append(r)
    outer = [radial(mesh, axis, ends[0], n)[1] for n in mesh.sets['OUTER_WALL']]
    a, b = sum(inner) / len(inner), sum(outer) / len(outer)
    lame = (1 + poisson) / young * pressure * a * a / (b * b - a * a) * ((1 - 2 * poisson) * a + b * b / a)
    return sum(measured) / len(measured) / lame, a, b


def main():
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument('mesh')
    arguments.add_argument('--pressure', type=float, default=0.013)  # MPa: 100 mmHg
    arguments.add_argument('--young', type=float, default=1.)
    arguments.add_argument('--poisson', type=float, default=0.3)
    arguments.add_argument('--lame', action='store_true')
    arguments.add_argument('--folder', default='.')
    a = arguments.parse_args()
    ccx = shutil.which('ccx') or shutil.which('ccx_2.20')
    if not ccx:
        print('There is no CalculiX here: install ccx (Debian: calculix-ccx).')
        return 77
    try:
        mesh = Mesh(a.mesh)
        text = deck('calculix_wall_mesh.inp', mesh, a.pressure, a.young, a.poisson)
        os.makedirs(a.folder, exist_ok=True)
        copy = os.path.join(a.folder, 'calculix_wall_mesh.inp')  # CalculiX looks for it beside the deck
        if os.path.abspath(a.mesh) != os.path.abspath(copy):
            shutil.copyfile(a.mesh, copy)
        with open(os.path.join(a.folder, 'calculix_wall.inp'), 'w') as file:
            file.write(text)
    except (OSError, ValueError) as error:
        print('%s: %s' % (a.mesh, error))
        return 2
    run = subprocess.run([ccx, 'calculix_wall'], cwd=a.folder, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    complaints = [line for line in run.stdout.splitlines() if '*ERROR' in line or 'nonpositive' in line]
    if run.returncode != 0 or complaints:
        print('CalculiX does not take this mesh:\n' + '\n'.join(complaints or run.stdout.splitlines()[-5:]))
        return 2
    u = displacements(os.path.join(a.folder, 'calculix_wall.dat'))
    if sorted(u) != sorted(mesh.sets['WALL']) or not all(math.isfinite(x) for d in u.values() for x in d):
        print('CalculiX has no displacement of %d nodes.' % (len(mesh.sets['WALL']) - len(u)))
        return 1
    largest = max(math.sqrt(dot(d, d)) for d in u.values())
    extent = max(max(p[k] for p in mesh.nodes.values()) - min(p[k] for p in mesh.nodes.values()) for k in range(3))
    print('%d nodes; the inside moves by %.4g at most, %.2g of the extent' % (len(mesh.nodes), largest, largest / extent))
    if not 0 < largest < 0.2 * extent:
        print('That is not plausible.')
        return 1
    if a.lame:
        ratio, inner, outer = compare_with_lame(mesh, u, a.pressure, a.young, a.poisson)
        print('Radii %.4g and %.4g; the wall moves outward %.4f times as far as by Lame' % (inner, outer, ratio))
        if abs(ratio - 1) > 0.05:
            return 1
    return 0


if __name__ == '__main__':
    sys.exit(main())
