#!/usr/bin/env python3
# Copyright (c) 2026 The Tubular_meshing authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Steady laminar flow through a vessel, by OpenFOAM's simpleFoam.

    openfoam_flow.py CASE [--reynolds RE] [--viscosity NU] [--density RHO] [--poiseuille] ...

CASE is a folder whose constant/polyMesh was written by

    tubular_mesh SURFACE --format openfoam -o CASE/constant/polyMesh

with lengths in metres (transformPoints -scale '(.001 .001 .001)' changes a mesh in millimetres). Patches are taken by
their names: inlet... has a given velocity, outlet... the pressure 0, and all others are walls at rest. The velocity is
normal to the inlet and a parabola along each line from its center to its rim; the volume flow is that of the Reynolds
number, by the diameter of the circle of the inlet's area. All schemes are of second order. The script writes the
case, runs simpleFoam until the residuals of the velocity are below 1e-6 and that of the pressure below 1e-5, and prints
the pressure drop, the flow through each outlet and the mean shear stress at the wall; the case then has the field
wallShearStress, divided by the density as the pressure is.

With --poiseuille the vessel is known to be a straight tube, and its wall shear stress and pressure drop are compared
with those of the exact solution.

Exit status: 0 all is well, 1 no convergence, or not the exact solution, 2 the mesh cannot be used or OpenFOAM failed, 77 there is no OpenFOAM
(Debian: openfoam).
"""
import argparse
import math
import os
import re
import shutil
import subprocess
import sys


def sub(a, b):
    return tuple(x - y for x, y in zip(a, b))


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def add_scaled(a, b, s):
    return tuple(x + s * y for x, y in zip(a, b))


def unit(a):
    return tuple(x / math.sqrt(dot(a, a)) for x in a)


def entries(name):
    """The lines of a list of OpenFOAM's, one entry a line, without header, count and brackets."""
    with open(name, 'rb') as file:
        head = file.read(1000)
        if re.search(rb'format\s+binary', head):
            raise ValueError('%s is binary: write the mesh with --format openfoam' % name)
    with open(name) as file:
        for line in file:
            if line.strip() == '(':
                break
        for line in file:
            if line.strip() == ')':
                return
            yield line


def read_patches(folder):
    """Of each patch its name, its number of faces and its first one, in their order."""
    with open(os.path.join(folder, 'boundary')) as file:
        text = file.read()
    return [(m.group(1), int(m.group(2)), int(m.group(3)))
            for m in re.finditer(r'(\S+)\s*\{[^}]*?nFaces\s+(\d+);\s*startFace\s+(\d+);[^}]*\}', text)]


def read_faces(folder, count, start):
    """A patch's faces, as lists of points."""
    faces = []
    for k, line in enumerate(entries(os.path.join(folder, 'faces'))):
        if k >= start + count:
            break
        if k >= start:
            faces.append([int(v) for v in line[line.index('(') + 1:line.index(')')].split()])
    wanted = {v for f in faces for v in f}
    points = {}
    for k, line in enumerate(entries(os.path.join(folder, 'points'))):
        if k in wanted:
            points[k] = tuple(float(x) for x in line.strip().strip('()').split())
    return faces, points


def area_and_center(face, points):
    """The area vector of a face and its center, from triangles round the mean of its corners."""
    corners = [points[v] for v in face]
    middle = tuple(sum(c[k] for c in corners) / len(corners) for k in range(3))
    area, center, total = (0., 0., 0.), (0., 0., 0.), 0.
    for a, b in zip(corners, corners[1:] + corners[:1]):
        half = tuple(x / 2 for x in cross(sub(a, middle), sub(b, middle)))
        size = math.sqrt(dot(half, half))
        area = add_scaled(area, half, 1)
        center = add_scaled(center, tuple(x + y + z for x, y, z in zip(a, b, middle)), size / 3)
        total += size
    return area, tuple(x / total for x in center)


def parabola(faces, points, reynolds, viscosity):
    """The velocity at each face of the inlet, and the volume flow."""
    areas, centers = zip(*(area_and_center(f, points) for f in faces))
    sizes = [math.sqrt(dot(a, a)) for a in areas]
    total = sum(sizes)
    inward = unit(tuple(-sum(a[k] for a in areas) for k in range(3)))
    origin = tuple(sum(s * c[k] for s, c in zip(sizes, centers)) / total for k in range(3))
    e1 = unit(cross(inward, (1, 0, 0) if abs(inward[0]) < .7 else (0, 1, 0)))
    e2 = cross(inward, e1)

    def flat(p):
        d = sub(p, origin)
        return dot(d, e1), dot(d, e2)

    seen = {}
    for face in faces:
        for a, b in zip(face, face[1:] + face[:1]):
            seen.setdefault((min(a, b), max(a, b)), []).append((a, b))
    rim = [(flat(points[uses[0][0]]), flat(points[uses[0][1]])) for uses in seen.values() if len(uses) == 1]

    def relative_radius(p):
        """How far from the center, where 1 is at the rim: the ray from the center to p goes on to the rim."""
        x, y = flat(p)
        farthest = 0.
        for (ax, ay), (bx, by) in rim:
            d = x * (by - ay) - y * (bx - ax)
            if d == 0:
                continue
            t = (ax * (by - ay) - ay * (bx - ax)) / d   # the rim is at t p
            s = (ax * y - ay * x) / d                   # and there a + s (b - a)
            if t > 0 and -1e-9 <= s <= 1 + 1e-9:
                farthest = max(farthest, t)
        return 1 / farthest if farthest > 0 else 0.

    shape = [max(0., 1 - relative_radius(c) ** 2) for c in centers]
    diameter = 2 * math.sqrt(total / math.pi)
    flow = reynolds * viscosity / diameter * total
    # By the areas' components along the mean normal: the flow is the same however the inlet's facets lie.
    through = -sum(h * dot(a, inward) for h, a in zip(shape, areas))
    if through <= 0:
        raise ValueError('The inlet has too few faces for a parabola of the velocity.')
    return [tuple(h * flow / through * x for x in inward) for h in shape], flow, diameter


HEADER = 'FoamFile\n{\n    version 2.0;\n    format ascii;\n    class %s;\n    object %s;\n}\n\n'


def write(case, name, kind, text):
    path = os.path.join(case, name)
    os.makedirs(os.path.dirname(path), exist_ok=True)
    with open(path, 'w') as file:
        file.write(HEADER % (kind, os.path.basename(name)) + text)


def kind_of(patch):
    return next((k for k in ('inlet', 'outlet') if patch.startswith(k)), 'wall')


def write_case(case, patches, velocity, viscosity, iterations, gradient, relaxation):
    u, p = '', ''
    for name, count, _ in patches:
        kind = kind_of(name)
        if kind == 'inlet':
            values = '\n'.join('(%.9g %.9g %.9g)' % v for v in velocity[name])
            u += '    %s\n    {\n        type fixedValue;\n        value nonuniform List<vector>\n%d\n(\n%s\n);\n    }\n' % (
                name, count, values)
            p += '    %s { type zeroGradient; }\n' % name
        elif kind == 'outlet':
            u += '    %s { type zeroGradient; }\n' % name
            p += '    %s { type fixedValue; value uniform 0; }\n' % name
        else:
            u += '    %s { type noSlip; }\n' % name
            p += '    %s { type zeroGradient; }\n' % name
    write(case, '0/U', 'volVectorField', 'dimensions [0 1 -1 0 0 0 0];\ninternalField uniform (0 0 0);\n'
          'boundaryField\n{\n%s}\n' % u)
    write(case, '0/p', 'volScalarField', 'dimensions [0 2 -2 0 0 0 0];\ninternalField uniform 0;\n'
          'boundaryField\n{\n%s}\n' % p)
    write(case, 'constant/transportProperties', 'dictionary',
          'transportModel Newtonian;\nnu [0 2 -1 0 0 0 0] %.9g;\n' % viscosity)
    write(case, 'constant/turbulenceProperties', 'dictionary', 'simulationType laminar;\n')
    write(case, 'system/fvSchemes', 'dictionary', '''ddtSchemes { default steadyState; }
gradSchemes { default %s; }
divSchemes
{
    default none;
    div(phi,U) bounded Gauss linearUpwind grad(U);
    div((nuEff*dev2(T(grad(U))))) Gauss linear;
}
laplacianSchemes { default Gauss linear corrected; }
interpolationSchemes { default linear; }
snGradSchemes { default corrected; }
''' % gradient)
    write(case, 'system/fvSolution', 'dictionary', '''solvers
{
    p { solver GAMG; smoother GaussSeidel; tolerance 1e-10; relTol 0.05; }
    U { solver smoothSolver; smoother symGaussSeidel; tolerance 1e-12; relTol 0.05; }
}
SIMPLE
{
    consistent yes;
    nNonOrthogonalCorrectors 0;
    residualControl { p 1e-5; U 1e-6; }
}
relaxationFactors { equations { U %g; } }
''' % relaxation)
    functions = '    wallShearStress { type wallShearStress; libs ("libfieldFunctionObjects.so"); writeControl writeTime; }\n'
    for name, _, _ in patches:
        if kind_of(name) == 'wall':
            continue
        for field, operation in (('p', 'areaAverage'), ('phi', 'sum')):
            functions += ('    %s_%s { type surfaceFieldValue; libs ("libfieldFunctionObjects.so"); regionType patch; '
                          'name %s; operation %s; fields (%s); writeFields no; log no; writeControl writeTime; }\n'
                          % (field, name, name, operation, field))
    write(case, 'system/controlDict', 'dictionary', '''application simpleFoam;
startFrom startTime;
startTime 0;
stopAt endTime;
endTime %d;
deltaT 1;
writeControl timeStep;
writeInterval %d;
writePrecision 9;
runTimeModifiable no;
functions
{
%s}
''' % (iterations, iterations, functions))


def last_value(case, function):
    """What a function object has written, at the last time."""
    folder = os.path.join(case, 'postProcessing', function)
    for time in sorted(os.listdir(folder), key=float):
        with open(os.path.join(folder, time, 'surfaceFieldValue.dat')) as file:
            lines = [line for line in file if not line.startswith('#')]
    return float(lines[-1].split()[1])


def results(case):
    """What a run leaves in the folder of a case."""
    return [d for d in os.listdir(case) if (d.isdigit() and d != '0') or d == 'postProcessing']


def make_way(case, overwrite):
    """A case that is there already is replaced only if that is wanted, and results of earlier runs are removed then."""
    present = [d for d in ('0', 'system') if os.path.exists(os.path.join(case, d))] + results(case)
    if present and not overwrite:
        raise ValueError('There is a case in %s already (%s); give another folder, or --overwrite.' %
                         (case, ', '.join(sorted(present))))
    for d in results(case):
        shutil.rmtree(os.path.join(case, d))


def wall_shear_stress(case, patch, faces):
    """The vectors at a patch's faces, at the last time."""
    times = [d for d in results(case) if d.isdigit()]
    with open(os.path.join(case, max(times, key=int), 'wallShearStress')) as file:
        text = file.read()
    patch_entry = re.search(r'\n\s*%s\s*\{[^}]*?nonuniform List<vector>\s*\d+\s*\(\n(.*?)\n\)' % re.escape(patch),
                            text[text.index('boundaryField'):], re.S)
    lines = patch_entry.group(1).split('\n') if patch_entry else []
    if len(lines) != faces:
        raise ValueError('%s has no list of the shear stress at %d faces of %s.' % (file.name, faces, patch))
    return [tuple(float(x) for x in line.strip('()').split()) for line in lines]


def wall_faces(case, patches):
    """Of all walls' faces the area, the center and the shear stress over the density."""
    mesh = os.path.join(case, 'constant', 'polyMesh')
    for name, count, start in patches:
        if kind_of(name) == 'wall':
            faces, points = read_faces(mesh, count, start)
            for face, stress in zip(faces, wall_shear_stress(case, name, count)):
                area, center = area_and_center(face, points)
                yield math.sqrt(dot(area, area)), center, math.sqrt(dot(stress, stress))


def compare_with_poiseuille(case, patches, walls, viscosity, flow):
    """Shear stress, half way between the ends, and pressure drop over those of a straight round tube."""
    mesh = os.path.join(case, 'constant', 'polyMesh')
    ends, areas = [], []
    for kind in ('inlet', 'outlet'):
        name, count, start = next(p for p in patches if kind_of(p[0]) == kind)
        faces, points = read_faces(mesh, count, start)
        parts = [area_and_center(f, points) for f in faces]
        sizes = [math.sqrt(dot(a, a)) for a, _ in parts]
        areas.append(sum(sizes))
        ends.append(tuple(sum(s * c[k] for s, (_, c) in zip(sizes, parts)) / areas[-1] for k in range(3)))
        if kind == 'inlet':
            inlet = name
    length = math.sqrt(dot(sub(ends[1], ends[0]), sub(ends[1], ends[0])))
    axis = unit(sub(ends[1], ends[0]))
    radius = math.sqrt(sum(areas) / 2 / math.pi)
    exact = 4 * viscosity * flow / (math.pi * radius ** 3)
    middle = [(s, t) for s, c, t in walls if .4 * length < dot(sub(c, ends[0]), axis) < .6 * length]
    if not middle:
        raise ValueError('The tube is too short to compare its middle.')
    size = sum(s for s, _ in middle)
    mean = sum(s * t for s, t in middle) / size
    deviation = math.sqrt(sum(s * (t - exact) ** 2 for s, t in middle) / size)
    drop = 2 * exact * length / radius
    return mean / exact, deviation / exact, last_value(case, 'p_' + inlet) / drop


def report(a, text, patches, flow):
    """Prints what has come out; returns the status of the program."""
    converged = re.search(r'SIMPLE solution converged in (\d+) iterations', text)
    seconds = re.findall(r'ExecutionTime = (\S+) s', text)
    print('%s, %s s of processor time' % ('%s iterations' % converged.group(1) if converged else
                                            'not converged after %d iterations' % a.iterations, seconds[-1] if seconds else 'some'))
    for name, _, _ in patches:
        if kind_of(name) == 'inlet':
            print('%s: pressure %.5g Pa' % (name, a.density * last_value(a.case, 'p_' + name)))
        elif kind_of(name) == 'outlet':
            print('%s: %.2f %% of the flow' % (name, 100 * last_value(a.case, 'phi_' + name) / flow))
    walls = list(wall_faces(a.case, patches))
    print('wall shear stress: %.5g Pa on average' % (a.density * sum(s * t for s, _, t in walls) / sum(s for s, _, _ in walls)))
    if a.poiseuille:
        mean, deviation, drop = compare_with_poiseuille(a.case, patches, walls, a.viscosity, flow)
        print('of that of a straight tube: %.4f, with a deviation of %.4f; of its pressure drop: %.4f' % (mean, deviation, drop))
        if abs(mean - 1) > 0.03 or abs(drop - 1) > 0.03:
            return 1
    return 0 if converged else 1


def main():
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument('case')
    arguments.add_argument('--reynolds', type=float, default=200.)
    arguments.add_argument('--viscosity', type=float, default=0.0035 / 1060, help='kinematic, m2/s')
    arguments.add_argument('--density', type=float, default=1060.)
    arguments.add_argument('--iterations', type=int, default=1000, help='at most')
    arguments.add_argument('--gradient', default='Gauss linear', help="OpenFOAM's scheme")
    arguments.add_argument('--relaxation', type=float, default=0.9, help='of the velocity')
    arguments.add_argument('--poiseuille', action='store_true')
    arguments.add_argument('--dry', action='store_true', help='write the case and do not run it')
    arguments.add_argument('--overwrite', action='store_true', help='a case that is there, and its results')
    a = arguments.parse_args()
    mesh = os.path.join(a.case, 'constant', 'polyMesh')
    try:
        patches = read_patches(mesh)
        make_way(a.case, a.overwrite)
        velocity, flow = {}, 0.
        for name, count, start in patches:
            if kind_of(name) == 'inlet':
                faces, points = read_faces(mesh, count, start)
                velocity[name], part, diameter = parabola(faces, points, a.reynolds, a.viscosity)
                flow += part
                print('%s: diameter %.4g m, %.4g m3/s, %.4g m/s on average' %
                      (name, diameter, part, part / (math.pi * diameter * diameter / 4)))
        if not velocity or not any(kind_of(name) == 'outlet' for name, _, _ in patches):
            raise ValueError('%s has no patches inlet and outlet' % mesh)
        write_case(a.case, patches, velocity, a.viscosity, a.iterations, a.gradient, a.relaxation)
    except (OSError, ValueError) as error:
        print(error)
        return 2
    if a.dry:
        return 0
    if not shutil.which('simpleFoam'):
        print('There is no OpenFOAM here: install simpleFoam (Debian: openfoam).')
        return 77
    environment = dict(os.environ)
    if 'WM_PROJECT_DIR' not in environment and os.path.isdir('/usr/share/openfoam'):
        environment['WM_PROJECT_DIR'] = '/usr/share/openfoam'
    with open(os.path.join(a.case, 'log.simpleFoam'), 'w') as log:
        run = subprocess.run(['simpleFoam', '-case', a.case], stdout=log, stderr=subprocess.STDOUT, env=environment)
    with open(os.path.join(a.case, 'log.simpleFoam')) as log:
        text = log.read()
    if run.returncode != 0:
        print('simpleFoam failed:\n' + '\n'.join(text.splitlines()[-12:]))
        return 2
    try:
        return report(a, text, patches, flow)
    except (OSError, ValueError) as error:
        print(error)
        return 2


if __name__ == '__main__':
    sys.exit(main())
