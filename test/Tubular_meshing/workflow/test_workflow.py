#!/usr/bin/env python3
# Copyright (c) 2026 The Tubular_meshing authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Tests of the workflow for clusters, with surfaces that are generated. What it has the program do is tested with that.

    test_workflow.py Settings|Cohort --workflow DIR --tool PROGRAM --generator PROGRAM --folder SCRATCH

Settings: what needs no Snakemake. Cohort: 12 surfaces, one of them broken, by Snakemake.
"""
import argparse
import json
import os
import shutil
import signal
import subprocess
import sys
import time
import unittest

sys.path.append(os.path.join(os.path.dirname(os.path.abspath(__file__)), os.pardir, "program"))
from index_page import COHORT, Page, index_of, made, read

GIVEN = None # the arguments of the command line


def generate(path, *options):
    os.makedirs(os.path.dirname(os.path.abspath(path)), exist_ok=True)
    subprocess.run([GIVEN.generator, *options, "-o", path], check=True, stdout=subprocess.DEVNULL)


def write(path, content):
    os.makedirs(os.path.dirname(os.path.abspath(path)), exist_ok=True)
    with open(path, "wb") as file:
        file.write(content if isinstance(content, bytes) else content.encode())


class Test(unittest.TestCase):
    """Each in a folder of its own, which is the current one."""

    def setUp(self):
        self.folder = os.path.join(GIVEN.folder, self._testMethodName)
        shutil.rmtree(self.folder, ignore_errors=True)
        os.makedirs(self.folder)
        os.chdir(self.folder)


class Settings(Test):
    def batch(self, **config):
        import batch
        return batch.Batch(dict({"surfaces": "table.csv", "tool": GIVEN.tool}, **config), self.folder)

    def refusal(self, **config):
        import batch
        with self.assertRaises(batch.Usage_error) as caught:
            self.batch(**config)
        return str(caught.exception)

    def test_Settings_are_options_of_the_program(self):
        write("table.csv", "surface\na.stl\n")
        plain = self.batch().status_files
        self.assertEqual(list(plain), ["a"])
        for config in ({"threads": 2}, {"timeout": 9}, {"mem_mb": 100, "limit_memory": True}, {"format": "vtu"}):
            self.assertEqual(self.batch(**config).status_files, plain)
        for config in ({"options": "-n 24"}, {"options": "--inlet '1, 2, 3'"}, {"page_mb": 0}, {"format": "gmsh"}):
            self.assertNotEqual(self.batch(**config).status_files, plain)
        self.assertEqual(self.batch(timeout=120).minutes(), 7)

    def test_Settings_that_cannot_be_used_are_refused_in_a_sentence(self):
        write("table.csv", "surface\na.stl\n")
        for config, sentence in (({"surface": "x"}, "there is no setting surface"), ({"surfaces": ""}, "name a folder"),
                                 ({"surfaces": ["x"]}, "text is wanted"), ({"retry": "all"}, "retry: all"),
                                 ({"threads": 0}, "threads: 0"), ({"timeout": "x"}, "timeout: x"),
                                 ({"format": "foam"}, "foam"), ({"limit_memory": "x"}, "limit_memory: x"),
                                 ({"options": "'x"}, "no closing quotation"), ({"options": "-o x"}, "--output"),
                                 ({"surfaces": "absent.csv"}, "There is no folder or table"),
                                 ({"tool": "/nowhere"}, "no program /nowhere"),
                                 ({"tool": "/bin/false"}, "ended with status 1")):
            with self.subTest(config):
                self.assertIn(sentence, self.refusal(**config))


class Cohort(Test):
    """12 surfaces, whose names are awkward; the seventh is broken."""

    OUT = "the 'meshes' {out} $x"

    def setUp(self):
        super().setUp()
        for name, options in COHORT:
            generate(os.path.join(self.folder, "in", name), *options.split(), "--resolution", "12")
        self.good = read_bytes("in/broken.stl")
        write("in/broken.stl", self.good[:-100])

    def command(self, *config):
        return [GIVEN.snakemake, "-s", os.path.join(GIVEN.workflow, "Snakefile"), "-c2", "--nocolor", "--config",
                "surfaces=in", "output=" + self.OUT, "tool=" + GIVEN.tool, "options=-n 8", *config]

    def environment(self):
        return dict(os.environ, XDG_CACHE_HOME=os.path.join(self.folder, "cache"), HOME=self.folder)

    def run_workflow(self, *config, status=0):
        run = subprocess.run(self.command(*config), stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                             universal_newlines=True, env=self.environment(), encoding="utf-8")
        self.assertEqual(run.returncode, status, run.stdout)
        return run.stdout

    def made_by(self, *config):
        """The surfaces that a run makes again."""
        before = made(self.OUT)
        self.run_workflow(*config)
        return {name for name, age in made(self.OUT).items() if before.get(name) != age}

    def test_Cohort(self):
        self.run_workflow()
        rows = index_of(self.OUT)
        self.assertEqual(len(rows), 12)
        self.assertEqual([(r["name"], r["status"]) for r in rows if r["status"] != "meshed"], [("broken", "failed")])
        self.assertEqual(rows[0]["name"], "broken")
        self.assertIn("truncated", rows[0]["sentence"])
        self.assertEqual(rows[0]["mesh"], "")
        self.assertEqual({r["surface"] for r in rows}, {name for name, options in COHORT})
        for row in rows[1:]:
            self.assertIn(b"VTKFile", read_bytes(os.path.join(self.OUT, row["mesh"]))[:200])
            report = json.loads(read(os.path.join(self.OUT, row["report"])))
            self.assertEqual(int(row["tetrahedra"]), report["cells"]["tetrahedra"])
            self.assertEqual(float(row["min γ_τ"]), report["quality"]["gamma_tau"]["min"])
            self.assertGreater(float(row["seconds"]), 0)
        self.assertEqual(len(os.listdir(self.OUT + "/meshes")), 11)
        page = Page(self.OUT)
        self.assertEqual(page.open, [])
        self.assertFalse(page.tags & {"script", "i"})
        self.assertEqual([r["surface"] for r in page.rows[1:]], [r["name"] for r in rows])
        self.assertIn("12 surfaces: 11 meshed, 1 failed", read(self.OUT + "/index.html"))
        for target in page.links:
            self.assertTrue(os.path.exists(os.path.join(self.OUT, target)), target)

        self.assertIn("Nothing to be done", self.run_workflow())
        os.remove(os.path.join(self.OUT, next(r["mesh"] for r in rows if r["name"] == "p 2/aorta")))
        self.assertEqual(self.made_by(), {"p 2/aorta"})
        os.utime("in/Gefäß.ply")
        self.assertEqual(self.made_by(), {"Gefäß"})
        self.assertEqual(self.made_by("retry=failed"), {"broken"})
        self.assertIn("Nothing to be done", self.run_workflow())
        write("in/broken.stl", self.good)
        self.assertEqual(self.made_by(), {"broken"})
        self.assertEqual({r["status"] for r in index_of(self.OUT)}, {"meshed"})
        os.remove("in/arch.stl")
        generate("in/new.stl", "tube", "--resolution", "12")
        self.assertEqual(self.made_by(), {"new"})
        self.assertEqual({r["name"] for r in index_of(self.OUT)} ^ {r["name"] for r in rows}, {"new", "arch"})

    def test_Interrupted(self):
        process = subprocess.Popen(self.command(), stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                                   env=self.environment(), start_new_session=True)
        end = time.monotonic() + 60
        while time.monotonic() < end and (not os.path.isdir(self.OUT + "/.status") or len(made(self.OUT)) < 3):
            time.sleep(0.02)
        os.killpg(process.pid, signal.SIGINT)
        self.assertNotEqual(process.wait(60), 0)
        before = made(self.OUT)
        self.assertLess(len(before), 12)
        for id in os.listdir(self.OUT + "/meshes"):
            self.assertIn(id + ".json", os.listdir(os.path.join(self.OUT, "meshes", id)))
            self.assertEqual(len(os.listdir(os.path.join(self.OUT, "meshes", id))), 4)
        self.run_workflow()
        self.assertEqual([r["status"] for r in index_of(self.OUT)], ["failed"] + 11 * ["meshed"])
        after = made(self.OUT)
        self.assertEqual({name: after[name] for name in before}, before)

    def test_Table(self):
        write("study {1}.csv", 'surface;name;options;#age\nin/y.stl;fine;-n 10;40\nin/y.stl;coarse;;41\n'
                           'in/nowhere.stl;;;42\nin/tube.stl;hexahedra;-t hexahedral;\n"in/p 1/aorta.stl";;--bogus;\n')
        table = ("surfaces=study {1}.csv", "format=gmsh")
        self.run_workflow(*table)
        rows = {r["name"]: r for r in index_of(self.OUT)}
        self.assertEqual({name: r["status"] for name, r in rows.items()},
                         {"fine": "meshed", "coarse": "meshed", "in/nowhere": "failed", "hexahedra": "meshed",
                          "in/p 1/aorta": "failed"})
        self.assertEqual(rows["fine"]["mesh"], "meshes/fine/fine.msh")
        self.assertGreater(int(rows["fine"]["tetrahedra"]), int(rows["coarse"]["tetrahedra"]))
        self.assertEqual(rows["hexahedra"]["tetrahedra"], "")
        self.assertGreater(int(rows["hexahedra"]["hexahedra"]), 0)
        self.assertEqual(rows["coarse"]["age"], "41")
        self.assertIn("No such file", rows["in/nowhere"]["sentence"])
        self.assertIn("--bogus", rows["in/p 1/aorta"]["sentence"])

        write("study {1}.csv", read("study {1}.csv").replace("--bogus", "").replace(";41", ";43"))
        self.assertEqual(self.made_by(*table), {"in/p 1/aorta"})
        self.assertEqual({r["name"]: r["age"] for r in index_of(self.OUT)}["coarse"], "43")

        write("study {1}.csv", "file\nin/y.stl\n")
        self.assertIn('has no column "surface"; its first line is "file"',
                      self.run_workflow("surfaces=study {1}.csv", "output=other", status=1))
        os.mkdir("empty")
        self.assertIn("has no surfaces", self.run_workflow("surfaces=empty", "output=other", status=1))
        self.assertFalse(os.path.exists("other"))


def read_bytes(path):
    with open(path, "rb") as file:
        return file.read()


def main():
    global GIVEN
    parser = argparse.ArgumentParser()
    parser.add_argument("suite", choices=("Settings", "Cohort"))
    for name in ("workflow", "tool", "generator", "folder"):
        parser.add_argument("--" + name, required=True, type=os.path.abspath)
    GIVEN = parser.parse_args()
    GIVEN.folder = os.path.realpath(GIVEN.folder)
    GIVEN.snakemake = shutil.which("snakemake")
    if GIVEN.suite == "Cohort" and not GIVEN.snakemake:
        print("Skipped: there is no Snakemake (Debian: snakemake)")
        return 0
    sys.dont_write_bytecode = True
    os.environ["PYTHONDONTWRITEBYTECODE"] = "1"
    sys.path.append(GIVEN.workflow)
    tests = unittest.defaultTestLoader.loadTestsFromTestCase(globals()[GIVEN.suite])
    return 0 if unittest.TextTestRunner(verbosity=2).run(tests).wasSuccessful() else 1


if __name__ == "__main__":
    sys.exit(main())
