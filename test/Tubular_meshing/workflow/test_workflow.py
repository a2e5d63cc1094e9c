#!/usr/bin/env python3
# Copyright (c) 2026 The Tubular_meshing authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Tests of the workflow for cohorts, with surfaces that are generated.

    test_workflow.py Scripts|Cohort --workflow DIR --tool PROGRAM --generator PROGRAM --folder SCRATCH

Scripts: what needs no Snakemake. Cohort: 12 surfaces, one of them broken, by Snakemake.
"""
import argparse
import csv
import html.parser
import json
import os
import shutil
import signal
import stat
import subprocess
import sys
import time
import unittest

GIVEN = None # the arguments of the command line

# A program in place of the mesher, which does what its options say.
STAND_IN = """#!%s
import os, signal, sys, time
out = sys.argv[sys.argv.index("-o") + 1]
open(out, "w").write("half a mesh")
print("    0.10 s  centerlines", file=sys.stderr, flush=True)
if "--sleep" in sys.argv:
    open(os.environ["STARTED"], "w").close()
    time.sleep(60)
if "--kill" in sys.argv:
    os.kill(os.getpid(), signal.SIGKILL)
if "--nothing" in sys.argv:
    os.remove(out)
sys.exit(9 if "--nine" in sys.argv else 0)
""" % sys.executable


def generate(path, *options):
    os.makedirs(os.path.dirname(os.path.abspath(path)), exist_ok=True)
    subprocess.run([GIVEN.generator, *options, "-o", path], check=True, stdout=subprocess.DEVNULL)


def write(path, content):
    os.makedirs(os.path.dirname(os.path.abspath(path)), exist_ok=True)
    with open(path, "wb") as file:
        file.write(content if isinstance(content, bytes) else content.encode())


def read(path):
    with open(path, encoding="utf-8") as file:
        return file.read()


def index_of(folder):
    """The rows of index.csv, in their order."""
    with open(os.path.join(folder, "index.csv"), encoding="utf-8", newline="") as file:
        return list(csv.DictReader(file))


class Page(html.parser.HTMLParser):
    """The cells of the page's rows by their labels, its links, and the tags that are not closed."""

    def __init__(self, folder):
        super().__init__()
        self.rows, self.links, self.open, self.label = [], [], [], None
        self.tags = set()
        self.feed(read(os.path.join(folder, "index.html")))

    def handle_starttag(self, tag, attributes):
        attributes = dict(attributes)
        self.tags.add(tag)
        if tag not in ("meta", "img"):
            self.open.append(tag)
        if tag == "tr":
            self.rows.append({"class": attributes.get("class")})
        if tag == "td":
            self.label = attributes["data-label"]
            self.rows[-1][self.label] = ""
        if tag == "a":
            self.links.append(attributes["href"])

    def handle_endtag(self, tag):
        assert self.open.pop() == tag, tag
        if tag == "td":
            self.label = None

    def handle_data(self, data):
        if self.label:
            self.rows[-1][self.label] += data


class Test(unittest.TestCase):
    """Each in a folder of its own, which is the current one."""

    def setUp(self):
        self.folder = os.path.join(GIVEN.folder, self._testMethodName)
        shutil.rmtree(self.folder, ignore_errors=True)
        os.makedirs(self.folder)
        os.chdir(self.folder)


class Scripts(Test):
    def settings(self, **config):
        import cohort
        return cohort.Settings(dict({"surfaces": "table.csv", "tool": GIVEN.tool}, **config), self.folder)

    def rows(self, content, **config):
        import cohort
        write("table.csv", content)
        return cohort.read_rows(self.settings(**config))

    def request(self, content, **config):
        import cohort
        row, = self.rows(content, **config)
        return cohort.Request(self.settings(**config), row)

    def refusal(self, function, *arguments, **keywords):
        import cohort
        with self.assertRaises(cohort.Usage_error) as caught:
            function(*arguments, **keywords)
        return str(caught.exception)

    def test_Tables_are_read_with_any_separator(self):
        for separator in ",;\t":
            text = 'surface,name,options,age\r\na.stl,One,-n 8,40\r\n\r\n"b c.stl",,,\r\n'.replace(",", separator)
            for content in (text, text.replace("\r", ""), b"\xef\xbb\xbf" + text.encode()):
                rows = self.rows(content)
                self.assertEqual([(r.name, r.given, r.options, r.columns) for r in rows],
                                 [("One", "a.stl", "-n 8", {"age": "40"}), ("b c", "b c.stl", "", {"age": ""})])
                self.assertEqual(rows[1].surface, os.path.join(self.folder, "b c.stl"))

    def test_Tables_that_cannot_be_used_are_refused_in_a_sentence(self):
        for content, sentence in (("file,name\na.stl,A\n", "has no column surface; its first line is: file,name"),
                                  ("", "its first line is: empty"), ("surface\n", "has no rows"),
                                  ("surface,a,a\nx.stl,,\n", "two columns a"),
                                  ("surface,a\nx.stl,1,2\n", "line 2 of the table"),
                                  ("surface,name\nx.stl,A\n,B\n", "line 3 of the table"),
                                  ("surface\na.stl\nb.stl\na.stl\n", "line 2 and line 4 have the same name, a;"),
                                  ("surface,name\na.stl,B\nb.stl,B\n", "line 2 and line 3 have the same name, B;"),
                                  (b"surface\n\xe4.stl\n", "is not in UTF-8")):
            self.assertIn(sentence, self.refusal(self.rows, content))
        os.remove("table.csv")
        import cohort
        self.assertIn("No such file", self.refusal(cohort.read_rows, self.settings()))

    def test_Folders_are_searched_but_not_the_results(self):
        import cohort
        for name in ("s/a.stl", "s/b/a.STL", "s/b/notes.txt", "s/.hidden/c.stl", "s/out/meshes/a/a.stl", "s/two.stl",
                     "s/two.off", "s/old/.status/a/x.json", "s/old/meshes/a/a.vtu"):
            write(name, "")
        settings = self.settings(surfaces="s", output="s/out")
        self.assertEqual([r.name for r in cohort.read_rows(settings)], ["a", "b/a", "two.off", "two.stl"])
        settings.pattern = "b/*"
        self.assertEqual([r.name for r in cohort.read_rows(settings)], ["b/a"])
        settings.pattern = "*.ply"
        self.assertIn("no surfaces of the pattern *.ply", self.refusal(cohort.read_rows, settings))
        self.assertIn("among the surfaces", self.refusal(cohort.read_rows, self.settings(surfaces="s", output="s/.")))
        os.mkdir("empty")
        self.assertIn("has no surfaces", self.refusal(cohort.read_rows, self.settings(surfaces="empty")))

    def test_Names_of_files_are_plain_and_distinct(self):
        import cohort
        names = ["a", "a b", "a_b", "a/b", "ä", "ö", "", "..", "-o", ".x", "x'\"", "{a}", "$(a)", "n" * 300, "n" * 301,
                 os.fsdecode(b"\xff")]
        ids = [cohort.id_of(name) for name in names]
        self.assertEqual(len(set(ids)), len(names))
        for id in ids:
            self.assertRegex(id, r"^[A-Za-z0-9][A-Za-z0-9._-]{0,99}$")
        self.assertEqual(ids[0], "a")

    def test_Options_of_a_row_replace_those_of_all(self):
        both = 'surface,options\na.stl,"-n12 --inlet -1,2,3 --seeds p.txt"\n'
        common = "-t hexahedral --points-per-circumference=20 --smooth"
        request = self.request(both, options=common)
        self.assertEqual(request.data["options"], ["-t", "hexahedral", "--smooth", "-n", "12", "--inlet", "-1,2,3",
                                                   "--seeds", os.path.join(self.folder, "p.txt")])
        self.assertEqual(request.data["problem"], "")
        for options, sentence in (("'x", "cannot be split into words"), ("12", "an option is wanted where there is 12"),
                                  ("-o a.vtu", "--output is set by the workflow"),
                                  ("--report=x", "--report is set by the workflow")):
            self.assertIn(sentence, self.request("surface,options\na.stl,%s\n" % options).data["problem"])
            self.assertIn(sentence, self.refusal(self.settings, options=options))

    def test_Settings_that_cannot_be_used_are_refused_in_a_sentence(self):
        for config, sentence in (({"surface": "x"}, "there is no setting surface"), ({"surfaces": ""}, "name a folder"),
                                 ({"surfaces": ["x"]}, "text is wanted"), ({"retry": "all"}, "retry: all"),
                                 ({"threads": 0}, "threads: 0"), ({"timeout": "x"}, "timeout: x"),
                                 ({"format": "foam"}, "format: foam"), ({"limit_memory": "x"}, "limit_memory: x"),
                                 ({"tool": "/nowhere"}, "no program /nowhere"),
                                 ({"tool": sys.executable}, "is not tubular_mesh")):
            self.assertIn(sentence, self.refusal(self.settings, **config))

    def test_What_is_asked_for_changes_with_all_that_matters(self):
        write("a.stl", "x")
        write("lines.vtp", "x")
        table = "surface,options\na.stl,-c lines.vtp\n"
        seen = {self.request(table).digest}

        def is_new(*arguments, **config):
            digest = self.request(*arguments, **config).digest
            was_there = digest in seen
            seen.add(digest)
            return not was_there
        self.assertFalse(is_new(table))
        self.assertFalse(is_new(table, timeout=9, threads=2, mem_mb=100))
        self.assertFalse(is_new("surface,options,age\na.stl,-c lines.vtp,40\n"))
        self.assertTrue(is_new(table, options="--smooth"))
        self.assertTrue(is_new(table, format="gmsh"))
        self.assertTrue(is_new(table, page_mb=0))
        self.assertTrue(is_new("surface,options\na.stl,-c lines.vtp -n 9\n"))
        for name in ("a.stl", "lines.vtp"):
            os.utime(name, ns=(0, os.stat(name).st_mtime_ns + 1000000))
            self.assertTrue(is_new(table))
        os.remove("a.stl")
        self.assertTrue(is_new(table))

    def mesh(self, request, *options, tool=None):
        command = [sys.executable, os.path.join(GIVEN.workflow, "scripts", "mesh_surface.py"), "--tool",
                   tool or GIVEN.tool, *options, request.json(), request.status_file()]
        run = subprocess.run(command, stdout=subprocess.PIPE, universal_newlines=True)
        self.assertEqual(run.returncode, 0)
        self.assertEqual(os.listdir(".work"), [])
        self.assertEqual(os.listdir(os.path.dirname(request.status_file())), [os.path.basename(request.status_file())])
        return json.loads(read(request.status_file()))

    def stand_in(self):
        write("stand_in", STAND_IN)
        os.chmod("stand_in", stat.S_IRWXU)
        return os.path.abspath("stand_in")

    def test_A_surface_is_meshed_and_its_mesh_removed_when_it_fails(self):
        generate("a.stl", "y", "--resolution", "16")
        table = "surface,options\na.stl,-n 8 --write-surface closed.stl\n"
        result = self.mesh(self.request(table))
        self.assertEqual((result["status"], result["sentence"]), (0, ""))
        self.assertEqual(result["files"], ["a.html", "a.json", "a.png", "a.vtu", "closed.stl"])
        self.assertEqual(sorted(os.listdir("meshes/a")), result["files"])
        self.assertEqual(json.loads(read("meshes/a/a.json"))["output"], "a.vtu")
        self.assertIn("quality", read("logs/a.txt"))
        self.assertGreater(result["peak_memory_mb"], 5)

        result = self.mesh(self.request(table, format="openfoam"))
        self.assertTrue(os.path.exists("meshes/a/case/constant/polyMesh/faces"))
        self.assertFalse(os.path.exists("meshes/a/a.vtu"))

        write("a.stl", open("a.stl", "rb").read()[:500])
        result = self.mesh(self.request(table))
        self.assertEqual(result["status"], 3)
        self.assertIn("truncated", result["sentence"])
        self.assertEqual(os.listdir("meshes"), [])

    def test_What_ends_a_run_is_said_in_a_sentence(self):
        generate("a.stl", "y", "--resolution", "16")
        table = "surface,options\na.stl,%s\n"
        for options, arguments, status, sentence in (
                ("--sleep", ["--timeout", "1"], 124, "ended after 1 s, the limit of time, in the stage centerlines"),
                ("--kill", [], 137, "killed, as the system does where memory runs out, in the stage centerlines"),
                ("--nothing", [], 4, "wrote no mesh"), ("--nine", [], 9, "centerlines")):
            os.environ["STARTED"] = "started"
            result = self.mesh(self.request(table % options), *arguments, tool=self.stand_in())
            self.assertEqual(result["status"], status)
            self.assertIn(sentence, result["sentence"])
            self.assertFalse(os.path.exists("meshes/a"))
        result = self.mesh(self.request(table % "--bogus"))
        self.assertEqual(result["status"], 2)
        self.assertIn("--bogus", result["sentence"])
        result = self.mesh(self.request(table % "'x"))
        self.assertIn("cannot be split", result["sentence"])
        result = self.mesh(self.request(table % "-n 60"), "--memory", "16")
        self.assertEqual((result["status"], result["sentence"]),
                         (4, "There is not enough memory; make the result coarser."))
        result = self.mesh(self.request("surface\nnowhere.stl\n"))
        self.assertEqual(result["status"], 3)
        self.assertIn("No such file", result["sentence"])

    def test_An_interrupted_run_leaves_nothing(self):
        write("a.stl", "")
        request = self.request("surface,options\na.stl,--sleep\n")
        started = os.path.abspath("started")
        for number in (signal.SIGINT, signal.SIGTERM):
            process = subprocess.Popen(
                [sys.executable, os.path.join(GIVEN.workflow, "scripts", "mesh_surface.py"), "--tool", self.stand_in(),
                 request.json(), request.status_file()], env=dict(os.environ, STARTED=started))
            end = time.monotonic() + 30
            while not os.path.exists(started) and time.monotonic() < end:
                time.sleep(0.02)
            process.send_signal(number)
            self.assertEqual(process.wait(30), 128 + number)
            os.remove(started)
            self.assertEqual(os.listdir(".work"), [])
            self.assertFalse(os.path.exists("meshes") or os.path.exists(request.status_file()))

    def test_The_page_has_failures_first_and_is_escaped(self):
        generate("p10.stl", "tube", "--resolution", "12")
        shutil.copy("p10.stl", "p2.stl")
        write("table.csv", "surface,name,options,<i>\np10.stl,,-n 8,&amp;\np2.stl,,-n 8,\n"
                           "no.stl,<b>\"'</b>,,<script>\nlater.stl,,,\n")
        import cohort
        settings = self.settings()
        requests = cohort.requests(settings, cohort.read_rows(settings))
        for request in list(requests.values())[:3]:
            self.mesh(request)
        subprocess.run([sys.executable, os.path.join(GIVEN.workflow, "scripts", "write_index.py"),
                        os.path.abspath("table.csv")], check=True, stdout=subprocess.DEVNULL)
        page = Page(self.folder)
        self.assertEqual(page.open, [])
        self.assertFalse(page.tags & {"script", "b", "i", "link"})
        pictures = [c for c in ("p2", "p10") if os.path.exists("meshes/%s/%s.png" % (c, c))]
        self.assertEqual(read("index.html").count("<img "), len(pictures))
        self.assertEqual(len(pictures), 2)
        rows = page.rows[1:]
        self.assertEqual([(r["surface"], r["status"], r["<i>"]) for r in rows],
                         [("<b>\"'</b>", "failed", "<script>"), ("later", "waiting", ""), ("p2", "meshed", ""),
                          ("p10", "meshed", "&amp;")])
        self.assertIn("1 failed, 1 not done", read("index.html"))
        self.assertEqual([r["name"] for r in index_of(".")], [r["surface"] for r in rows])


class Cohort(Test):
    """12 surfaces, whose names are awkward; the seventh is broken."""

    SURFACES = (("tube.stl", "tube"), ("curved.off", "curved"), ("y.stl", "y"), ("p 1/aorta.stl", "tube --noise 0.01"),
                ("p 2/aorta.stl", "y --capped"), ("it's \"quoted\" {x}.stl", "tube --capped"),
                ("broken.stl", "y"), ("Gefäß.ply", "curved --capped"), ("<i>&amp;.obj", "tube --sag 0.05"),
                ("$HOME.vtp", "y --noise 0.01 --seed 2"), ("-n.stl", "curved --noise 0.01"), ("arch.stl", "arch"))

    OUT = "the 'meshes' {out} $x"

    def setUp(self):
        super().setUp()
        for name, options in self.SURFACES:
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

    def made(self):
        """When what is known of each surface was written."""
        times = {}
        for id in os.listdir(os.path.join(self.OUT, ".status")):
            for name in os.listdir(os.path.join(self.OUT, ".status", id)):
                path = os.path.join(self.OUT, ".status", id, name)
                if not name.endswith(".json"):
                    continue # being written
                times[json.loads(read(path))["name"]] = os.stat(path).st_mtime_ns
        return times

    def made_by(self, *config):
        """The surfaces that a run makes again."""
        before = self.made()
        self.run_workflow(*config)
        return {name for name, age in self.made().items() if before.get(name) != age}

    def test_Cohort(self):
        self.run_workflow()
        rows = index_of(self.OUT)
        self.assertEqual(len(rows), 12)
        self.assertEqual([(r["name"], r["status"]) for r in rows if r["status"] != "meshed"], [("broken", "failed")])
        self.assertEqual(rows[0]["name"], "broken")
        self.assertIn("truncated", rows[0]["sentence"])
        self.assertEqual(rows[0]["mesh"], "")
        self.assertEqual({r["surface"] for r in rows}, {name for name, options in self.SURFACES})
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
        while time.monotonic() < end and (not os.path.isdir(self.OUT + "/.status") or len(self.made()) < 3):
            time.sleep(0.02)
        os.killpg(process.pid, signal.SIGINT)
        self.assertNotEqual(process.wait(60), 0)
        before = self.made()
        self.assertLess(len(before), 12)
        for id in os.listdir(self.OUT + "/meshes"):
            self.assertIn(id + ".json", os.listdir(os.path.join(self.OUT, "meshes", id)))
            self.assertEqual(len(os.listdir(os.path.join(self.OUT, "meshes", id))), 4)
        self.run_workflow()
        self.assertEqual([r["status"] for r in index_of(self.OUT)], ["failed"] + 11 * ["meshed"])
        after = self.made()
        self.assertEqual({name: after[name] for name in before}, before)

    def test_Table(self):
        write("study {1}.csv", 'surface;name;options;age\nin/y.stl;fine;-n 10;40\nin/y.stl;coarse;;41\n'
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
        self.assertIn("has no column surface; its first line is: file",
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
    parser.add_argument("suite", choices=("Scripts", "Cohort"))
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
    sys.path.append(os.path.join(GIVEN.workflow, "scripts"))
    tests = unittest.defaultTestLoader.loadTestsFromTestCase(globals()[GIVEN.suite])
    return 0 if unittest.TextTestRunner(verbosity=2).run(tests).wasSuccessful() else 1


if __name__ == "__main__":
    sys.exit(main())
