# Copyright (c) 2026 The Tubular_meshing authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes the packages of the build directory, and uses what is in them: unpacked, not installed.

    test_packages.py BUILD_DIRECTORY CPACK SAMPLE SCRATCH KIND      KIND: deb or archive

Prints "Skipped: " and why, where something is missing that makes them."""

import os
import pathlib
import re
import shutil
import subprocess
import sys
import tarfile

BUILD, CPACK, SAMPLE, SCRATCH, KIND = (pathlib.Path(a) if "/" in a else a for a in sys.argv[1:])
FOREIGN = {"libc6", "libgcc-s1", "libstdc++6"}  # of every system


def run(*command, **options):
    done = subprocess.run([str(c) for c in command], stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                          universal_newlines=True, **options)
    if done.returncode != 0:
        sys.exit("%s ended with %d:\n%s" % (" ".join(map(str, command)), done.returncode, done.stdout[-3000:]))
    return done.stdout


def check(condition, what):
    if not condition:
        sys.exit(what)


def skip(why):
    print("Skipped: " + why)
    sys.exit(0)


def make(generator):
    folder = SCRATCH / "packages"
    run(CPACK, "--config", BUILD / "CPackConfig.cmake", "-G", generator, "-B", folder, cwd=BUILD)
    return folder


def libraries_of(program):
    """The shared libraries that a program finds, by their names."""
    found = {}
    for line in run("ldd", program).splitlines():
        check("not found" not in line, "%s lacks a library: %s" % (program, line))
        match = re.match(r"\s*(\S+) => (.+) \(0x", line)
        if match:
            found[match.group(1)] = os.path.realpath(match.group(2))
    return found


def use_program(root, prefix):
    """The program meshes, the page is a page, the completion completes."""
    program = root / prefix / "bin/tubular_mesh"
    mesh = SCRATCH / "mesh.vtu"
    run(program, SAMPLE, "-o", mesh, "-n", "8", "-q")
    check(mesh.stat().st_size > 10000, "There is no mesh.")
    for link in run("readelf", "-d", program).splitlines():
        check("NEEDED" not in link or "/" not in link, "The program has the path of a library in it: " + link)
        check("RUNPATH" not in link and "RPATH" not in link or "$ORIGIN" in link, "It looks for libraries here: " + link)
    share = root / prefix / "share"
    page = next(share.glob("man/man1/tubular_mesh.1*"))
    if shutil.which("man"):
        text = run("man", "--warnings", "-l", page, env=dict(os.environ, MANWIDTH="100", MANPAGER="cat"))
        check("--points-per-circumference" in text.replace("\u2010", "-"), "The manual page lacks an option.")
        check("warning" not in text, text)
    completion = share / "bash-completion/completions/tubular_mesh"
    completed = lambda words: run("bash", "-c", 'source "$1"; shift; COMP_WORDS=("$@"); COMP_CWORD=$(($# - 1)); '  # noqa: E731
                                  '_tubular_mesh; printf "%s\\n" "${COMPREPLY[@]}"', "bash", completion, *words).split()
    check(completed(["tubular_mesh", "--points"]) == ["--points-per-circumference"], "An option is not completed.")
    check("hexahedral" in completed(["tubular_mesh", "--type", "hex"]), "A value is not completed.")
    check("openfoam" in completed(["tubular_mesh", "--case", "open"]), "A solver is not completed.")


EXAMPLE = """
import sys, time
start = time.process_time()
import tubular_meshing as tm
seconds = time.process_time() - start

surface = tm.read_surface(sys.argv[1])
surface, repairs = tm.repair(surface)
model = tm.Model(surface)
mesh = tm.mesh(model, type="hexahedral", points_per_circumference=16, boundary_layer=0.3)
assert len(mesh.points) > 1000 and mesh.cells["hexahedron"].shape[1] == 8, mesh
assert mesh.patches["inlet"].area > 0 and mesh.quality["scaled_jacobian"].min() > 0, mesh.quality
mesh.write("example.vtu")
for to_object, package in ((mesh.to_meshio, "meshio"), (mesh.to_vtk, "vtk"), (mesh.to_pyvista, "pyvista")):
    try:
        to_object()
        raise SystemExit(package + " is there, and should not be.")
    except ImportError as e:
        assert package in str(e), e
print(seconds)
"""


def use_python_alone(modules, interpreter="/usr/bin/python3"):
    """The example of the manual with NumPy, and no other package: as on a fresh system. It is imported in little time."""
    numpy = run(interpreter, "-c", "import numpy, pathlib; print(pathlib.Path(numpy.__file__).parents[0])").strip()
    alone = SCRATCH / "alone"
    alone.mkdir()
    for folder in (pathlib.Path(numpy), pathlib.Path(numpy + ".libs")):
        if folder.exists():
            (alone / folder.name).symlink_to(folder)
    said = [run(interpreter, "-S", "-B", "-c", EXAMPLE, SAMPLE, cwd=SCRATCH,
                env={"PYTHONPATH": "%s:%s" % (modules, alone), "PATH": os.environ["PATH"]}) for _ in range(2)]
    check(min(map(float, said)) < 0.2, "The package is imported in %s s." % " and ".join(map(str.strip, said)))


def use_python(modules, interpreter="/usr/bin/python3"):
    """The module is imported from where it is unpacked, and meshes."""
    code = ("import sys, tubular_meshing as tm; assert tm.__file__.startswith(sys.argv[1]), tm.__file__; "
            "mesh = tm.mesh(sys.argv[2], points_per_circumference=8); print(len(mesh.cells['tetra']), mesh.patches['inlet'].area)")
    said = run(interpreter, "-B", "-c", code, modules, SAMPLE, env={"PYTHONPATH": str(modules), "PATH": os.environ["PATH"]},
               cwd=SCRATCH)
    check(int(said.split()[0]) > 1000, "There is no mesh.")


def names(relations):
    """The packages of a field of dependencies."""
    return {re.match(r"\s*([^ (|]+)", r).group(1) for r in relations.split(",")}


def test_deb():
    folder = make("DEB")
    packages = {}
    for file in folder.glob("*.deb"):
        field = lambda name: run("dpkg-deb", "-f", file, name).strip()  # noqa: E731
        packages[field("Package")] = {"file": file, "depends": names(field("Depends"))}
        check(re.match(r"\d+\.\d+\.\d+$", field("Version")), "The version is no version.")
        check(field("Section") and field("Description"), "A field is missing.")
    check({"tubular-meshing", "libtubular-meshing-dev"} <= set(packages), "Packages are missing: %s" % sorted(packages))
    root = SCRATCH / "root"
    for package in packages.values():
        run("dpkg-deb", "-x", package["file"], root)
    for path in root.rglob("*"):
        check(path.is_dir() or str(path).startswith(str(root / "usr")), "A file is outside of /usr: %s" % path)
    for package in packages:
        text = (root / "usr/share/doc" / package / "copyright").read_text()
        check("GPL-3+" in text, "The licence is missing.")
    for name, package in packages.items():  # each exists under this name, but for this program's own
        for other in package["depends"] - set(packages):
            known = subprocess.run(["apt-cache", "show", other], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
            installed = subprocess.run(["dpkg-query", "-W", other], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
            check(known.returncode == 0 or installed.returncode == 0, "%s needs %s, which is no package" % (name, other))
    modules = root / "usr/lib/python3/dist-packages"
    programs = [("tubular-meshing", root / "usr/bin/tubular_mesh")]
    if "python3-tubular-meshing" in packages:
        programs.append(("python3-tubular-meshing", next((modules / "tubular_meshing").glob("_core*.so"))))
    for name, program in programs:  # each library that it is linked with comes from a package that it depends on
        found = libraries_of(program)
        for library in re.findall(r"NEEDED.*\[(.*)\]", run("readelf", "-d", program)):
            if library not in found:
                continue  # the loader
            path = found[library].replace("/usr/lib", "*/lib")
            owner = subprocess.run(["dpkg-query", "-S", path], stdout=subprocess.PIPE, stderr=subprocess.DEVNULL,
                                   universal_newlines=True).stdout.split(":")[0]
            check(not owner or owner in packages[name]["depends"],
                  "%s needs %s, of %s, and does not say so: %s" % (name, library, owner, packages[name]["depends"]))
    check(FOREIGN <= packages["tubular-meshing"]["depends"], "The C library is missing among what is needed.")
    check("libcgal-dev" in packages["libtubular-meshing-dev"]["depends"], "The headers need CGAL.")
    check((root / "usr/include/CGAL/tubular_meshing.h").exists(), "The headers are missing.")
    check(list(root.glob("usr/lib/**/cmake/Tubular_meshing/Tubular_meshingConfig.cmake")), "The CMake package is missing.")
    use_program(root, "usr")
    if "python3-tubular-meshing" in packages:
        control = SCRATCH / "control"
        run("dpkg-deb", "-e", packages["python3-tubular-meshing"]["file"], control)
        for script in ("postinst", "prerm"):
            run("sh", "-n", control / script)
            check(os.access(control / script, os.X_OK), script + " cannot be run.")
        use_python(modules)
        use_python_alone(modules)


def test_archive():
    folder = make("TGZ")
    archives = list(folder.glob("*.tar.gz"))
    check(len(archives) == 1, "There is not one archive: %s" % archives)
    root = SCRATCH / "some where"  # that is not where it was made
    with tarfile.open(archives[0]) as archive:
        archive.extractall(root)
    top = [d for d in root.iterdir()]
    check(len(top) == 1 and top[0].is_dir(), "The archive has not one folder: %s" % top)
    use_program(top[0], "")
    bundled = top[0] / "lib"
    for name, library in libraries_of(top[0] / "bin/tubular_mesh").items():
        if not re.match(r"lib(c|m|dl|rt|pthread|resolv|gcc_s|stdc\+\+)\.so", name):
            check(library.startswith(str(bundled)), "%s is taken from the system: %s" % (name, library))
    modules = top[0] / "lib/python3/dist-packages"
    if modules.exists():
        use_python(modules)


def main():
    if not shutil.which("ldd") or not shutil.which("readelf"):
        skip("there is no ldd or readelf")
    if KIND == "deb" and not (shutil.which("dpkg-deb") and shutil.which("dpkg-shlibdeps")):
        skip("there is no dpkg-dev")
    shutil.rmtree(SCRATCH, ignore_errors=True)
    SCRATCH.mkdir(parents=True)
    test_deb() if KIND == "deb" else test_archive()
    shutil.rmtree(SCRATCH)


main()
