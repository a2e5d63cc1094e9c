# Copyright (c) 2026 The Tubular_meshing authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""--batch: folders and tables of surfaces, their index, restarts, failures and interruptions."""

import fcntl
import json
import os
import pathlib
import signal
import subprocess
import time
import unittest
import urllib.parse

from index_page import COHORT, Page, index_of, made, read
from program import GENERATOR, TOOL, ProgramTest, read_json

FEW = ["-n", "8"]


class BatchTest(ProgramTest):
    OUT = "the 'meshes' {out} $x"

    def setUp(self):
        super().setUp()
        self.results = self.out / self.OUT

    def generate(self, name, *options):
        file = self.out / name
        file.parent.mkdir(parents=True, exist_ok=True)
        subprocess.run([GENERATOR, *options, "-o", str(file)], check=True, stdout=subprocess.DEVNULL)

    def table(self, text, name="table.csv"):
        (self.out / name).write_bytes(text if isinstance(text, bytes) else text.encode())
        return name

    def batch(self, surfaces, *options, status=0):
        run = self.run_tool("--batch", surfaces, "-o", self.OUT, *FEW, *options)
        self.assertEqual(run.returncode, status, run.stderr)
        return run

    def rows(self):
        return {r["name"]: r for r in index_of(self.results)}

    def made_by(self, *arguments, status=0):
        """The surfaces that a run makes again."""
        before = made(self.results)
        self.batch(*arguments, status=status)
        return {name for name, age in made(self.results).items() if before.get(name) != age}

    def refused(self, surfaces, *options):
        """The sentence of a batch that is not begun; it leaves nothing."""
        before = self.files()
        run = self.run_tool("--batch", surfaces, "-o", self.OUT, *FEW, *options)
        self.assertIn(run.returncode, (2, 3), run.stderr)
        self.assertEqual(run.stdout, "")
        self.assertEqual(run.stderr.count("\n"), 1, run.stderr)
        self.assertEqual(self.files(), before)
        return run.stderr


class Cohort(BatchTest):
    def setUp(self):
        super().setUp()
        for name, options in COHORT:
            self.generate("in/" + name, *options.split(), "--resolution", "12")
        self.broken = self.out / "in" / "broken.stl"
        self.good = self.broken.read_bytes()
        self.broken.write_bytes(self.good[:-100])

    def test_a_folder(self):
        run = self.batch("in", status=5)
        self.assertIn("12 surfaces: 11 meshed, 1 failed; see ", run.stdout)
        self.assertIn("broken: failed. ", run.stderr)
        rows = index_of(self.results)
        self.assertEqual([(r["name"], r["status"], r["exit status"]) for r in rows if r["status"] != "meshed"],
                         [("broken", "failed", "3")])
        self.assertEqual(rows[0]["name"], "broken")
        self.assertIn("truncated", rows[0]["sentence"])
        self.assertEqual(rows[0]["mesh"], "")
        self.assertEqual({r["surface"] for r in rows}, {name for name, _ in COHORT})
        for row in rows[1:]:
            self.assertIn(b"VTKFile", (self.results / row["mesh"]).read_bytes()[:200])
            report = read_json(self.results / row["report"])
            self.assertEqual(int(row["tetrahedra"]), report["cells"]["tetrahedra"])
            self.assertEqual(float(row["min γ_τ"]), report["quality"]["gamma_tau"]["min"])
            self.assertGreater(float(row["seconds"]), 0)
            self.assertGreater(float(row["memory MB"]), 5)
        self.assertEqual(len(os.listdir(self.results / "meshes")), 11)
        self.assertEqual(sorted(os.listdir(self.results)), [".status", "index.csv", "index.html", "logs", "meshes"])
        page = Page(self.results)
        self.assertEqual(page.open, [])
        self.assertFalse(page.tags & {"script", "i"})
        self.assertEqual([r["surface"] for r in page.rows[1:]], [r["name"] for r in rows])
        self.assertEqual(page.rows[1]["status"], "failed, 3")
        self.assertEqual(len(page.pictures), 11)
        self.assertIn("12 surfaces: 11 meshed, 1 failed", read(self.results / "index.html"))
        for target in page.links + page.pictures:
            self.assertTrue((self.results / urllib.parse.unquote(target)).exists(), target)

        self.assertEqual(self.made_by("in", status=5), set())
        (self.results / next(r["mesh"] for r in rows if r["name"] == "p 2/aorta")).unlink()
        self.assertEqual(self.made_by("in", status=5), {"p 2/aorta"})
        os.utime(self.out / "in" / "Gefäß.ply")
        self.assertEqual(self.made_by("in", status=5), {"Gefäß"})
        self.assertEqual(self.made_by("in", "--retry-failed", status=5), {"broken"})
        self.broken.write_bytes(self.good)
        self.assertEqual(self.made_by("in"), {"broken"})
        self.assertEqual({r["status"] for r in index_of(self.results)}, {"meshed"})
        (self.out / "in" / "arch.stl").unlink()
        self.generate("in/new.stl", "tube", "--resolution", "12")
        self.assertEqual(self.made_by("in"), {"new"})
        self.assertEqual({r["name"] for r in index_of(self.results)} ^ {r["name"] for r in rows}, {"new", "arch"})
        self.assertEqual(len(self.made_by("in", "--smooth", "--no-pages")), 12)
        self.assertEqual([f.name for f in self.results.glob("meshes/*/*.html")], ["arch.html"]) # which is no row any more

    def test_an_interruption_leaves_nothing_partial_and_is_gone_on_from(self):
        for number in (signal.SIGINT, signal.SIGTERM):
            before = made(self.results)
            process = subprocess.Popen([TOOL, "--batch", "in", "-o", self.OUT, "-n", "14", "--jobs", "2"], cwd=self.out,
                                       stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, universal_newlines=True)
            end = time.monotonic() + 60
            while time.monotonic() < end and len(made(self.results)) < len(before) + 2:
                time.sleep(0.01)
            process.send_signal(number)
            said = process.communicate(timeout=30)[1]
            self.assertEqual(process.returncode, -number, said)
            done = made(self.results)
            self.assertLess(len(done), 12)
            self.assertEqual({name: done[name] for name in before}, before)
            self.assertFalse((self.results / ".work").exists())
            self.assertEqual([f for f in self.results.rglob("*") if ".part" in f.name or ".removed" in f.name], [])
            for folder in (self.results / "meshes").iterdir():
                self.assertEqual(len(list(folder.iterdir())), 4)
            self.assertEqual(sum(r["status"] == "waiting" for r in index_of(self.results)), 12 - len(done))
            self.assertEqual(self.processes_left(), [])
        self.batch("in", "-n", "14", status=2) # -n is given twice, by FEW as well
        run = self.run_tool("--batch", "in", "-o", self.OUT, "-n", "14")
        self.assertEqual(run.returncode, 5, run.stderr)
        self.assertEqual([r["status"] for r in index_of(self.results)], ["failed"] + 11 * ["meshed"])
        after = made(self.results)
        self.assertEqual({name: after[name] for name in done}, done)

    def processes_left(self):
        """That work in this test's folder; those that were killed may take a moment to end."""
        end = time.monotonic() + 10
        while self.processes_of_the_tool() and time.monotonic() < end:
            time.sleep(0.01)
        return self.processes_of_the_tool()

    def processes_of_the_tool(self):
        """That work in this test's folder."""
        found = []
        for folder in pathlib.Path("/proc").glob("[0-9]*"):
            try:
                if os.readlink(folder / "cwd").startswith(str(self.folder)):
                    found.append(folder.name)
            except OSError: # ended since, or somebody else's
                pass
        return found


class Tables(BatchTest):
    def setUp(self):
        super().setUp()
        self.generate("in/y.stl", "y", "--resolution", "12")
        self.generate("in/tube.stl", "tube", "--resolution", "12")

    def test_columns_are_options(self):
        self.table("surface;name;options;points_per_circumference;Type;smooth;#age;refine\n".replace("Type", "type") +
                   "in/y.stl;fine;-n 9;;;;40;0,0,0,1,1.5 1,0,0,1,1.5\n" + "in/y.stl;coarse;;;;yes;41;\n" +
                   "in/nowhere.stl;;;;;no;42;\n" + 'in/tube.stl;"hexa;hedra";;8;hexahedral;;;\n' +
                   "in/tube.stl;bogus;--bogus;;;;;\n" + "in/tube.stl;maybe;;;;maybe;;\n" + "in/tube.stl;öpen;'x;;;;;\n")
        self.batch("table.csv", "--format", "gmsh", status=5)
        rows = self.rows()
        self.assertEqual({name: (r["status"], r["exit status"]) for name, r in rows.items()},
                         {"fine": ("meshed", "0"), "coarse": ("meshed", "0"), "in/nowhere": ("failed", "3"),
                          "hexa;hedra": ("meshed", "0"), "bogus": ("failed", "2"), "maybe": ("failed", "2"),
                          "öpen": ("failed", "2")})
        self.assertEqual(rows["fine"]["mesh"], "meshes/fine/fine.msh")
        self.assertGreater(int(rows["fine"]["tetrahedra"]), 1.2 * int(rows["coarse"]["tetrahedra"]))
        self.assertEqual(rows["hexa;hedra"]["tetrahedra"], "")
        self.assertGreater(int(rows["hexa;hedra"]["hexahedra"]), 0)
        self.assertEqual([rows[n]["age"] for n in ("fine", "coarse", "bogus")], ["40", "41", ""])
        self.assertIn("No such file", rows["in/nowhere"]["sentence"])
        self.assertIn("There is no option --bogus", rows["bogus"]["sentence"])
        self.assertIn("neither yes nor no", rows["maybe"]["sentence"])
        self.assertIn("a quote is not closed", rows["öpen"]["sentence"])
        log = read(self.results / rows["coarse"]["log"])
        self.assertIn("--smooth", log)
        self.assertIn("--points-per-circumference=8", log)
        self.assertIn("--refine=1,0,0,1,1.5", read(self.results / rows["fine"]["log"]))

        again = ("table.csv", "--format", "gmsh")
        self.table(read(self.out / "table.csv").replace("--bogus", "").replace("41", "43").replace("maybe;\n", "maybe; \n"))
        self.assertEqual(self.made_by(*again, status=5), {"bogus"})
        self.assertEqual(self.rows()["coarse"]["age"], "43")

    def test_separators_quotes_and_marks(self):
        for separator in ",;\t":
            lines = 'surface,name,#n\r\n\r\n"in/y.stl","the ""y""\r\nof ä, b",1\r\nin/tube.stl,,\r\n'.replace(",", separator)
            lines = lines.replace("in/tube.stl" + 2 * separator, "in/tube.stl")
            for text in (lines, lines.replace("\r", ""), b"\xef\xbb\xbf" + lines.encode()):
                plan = self.plan(self.table(text))
                newline = "\n" if text == lines.replace("\r", "") else "\r\n"
                self.assertEqual([r["name"] for r in plan["rows"]], ['the "y"%sof ä%s b' % (newline, separator), "in/tube"])

    def plan(self, surfaces, *options):
        run = self.succeed("--batch", surfaces, "-o", self.OUT, *FEW, *options, "--batch-step", "plan")
        self.assertFalse(self.results.exists())
        return json.loads(run.stdout)

    def test_what_cannot_be_used_is_refused_in_a_sentence(self):
        for text, sentence in (("file,name\na.stl,A\n", 'no column "surface"; its first line is "file,name"'),
                               ("", "its first line is empty"), ("surface\n", "has no rows"),
                               ("surface,#a,#a\nx.stl,,\n", 'two columns "#a"'),
                               ("surface,age\nx.stl,1\n", 'column "age", which is no option'),
                               ("surface,points\nx.stl,1\n", 'call it "#points"'),
                               ("surface,output\nx.stl,1\n", 'column "output", which is no option that'),
                               ("surface,jobs\nx.stl,1\n", 'column "jobs"'),
                               ("surface,n\nx.stl,1,2\n", "Line 2 of the table"),
                               ("surface,name\nx.stl,A\n,B\n", "Line 3 of the table"),
                               ('surface,name\nx.stl,"A\n', "double quote that is not closed"),
                               ("surface\na.stl\nb.stl\na.stl\n", "line 2 and line 4 have the same name, a,"),
                               ("surface,name\na.stl,B\nb.stl,B\n", "line 2 and line 3 have the same name, B,"),
                               (b"surface\n\xe4.stl\n", "is not in UTF-8")):
            with self.subTest(sentence):
                self.assertIn(sentence, self.refused(self.table(text)))
        (self.out / "empty").mkdir()
        for surfaces, options, sentence in (("absent.csv", [], 'There is no folder or table "absent.csv"'),
                                            ("empty", [], 'The folder "empty" has no surfaces'),
                                            ("in", ["--pattern", "*.ply"], "of the pattern *.ply"),
                                            ("in", ["--type", "x", "--report", "r.json"], "--report is set by --batch"),
                                            ("in", ["--dry-run"], "--dry-run is for one surface"),
                                            ("in", ["--picture", "x.png"], "--picture is set by --batch"),
                                            ("in", ["--write-surface", "a/b.stl"], "a name without a folder"),
                                            ("in", ["--jobs", "0"], "--jobs"),
                                            ("in", ["--batch-step", "nothing"], "--batch-step"),
                                            ("in", ["surface.stl"], "cannot go with")):
            with self.subTest(sentence):
                self.assertIn(sentence, self.refused(surfaces, *options))
        for arguments, sentence in ((["--batch", "in"], "--batch needs --output"),
                                    (["--jobs", "2", "in/y.stl", "-o", "m.vtu"], "needs --batch"),
                                    (["--batch", "in", "-o", "in"], "among the surfaces"),
                                    (["-o", "m.vtu"], "Surface is required")):
            with self.subTest(sentence):
                run = self.run_tool(*arguments)
                self.assertEqual(run.returncode, 2)
                self.assertIn(sentence, run.stderr)

    def test_folders_are_searched_but_not_results(self):
        for name in ("s/a.stl", "s/b/a.STL", "s/b/notes.txt", "s/.hidden/c.stl", "s/two.stl", "s/two.off",
                     "s/old/.status/a/x.json", "s/old/meshes/a/a.vtu"):
            (self.out / name).parent.mkdir(parents=True, exist_ok=True)
            (self.out / name).touch()
        self.assertEqual([r["name"] for r in self.plan("s")["rows"]], ["a", "b/a", "two.off", "two.stl"])
        self.assertEqual([r["name"] for r in self.plan("s", "--pattern", "b/*")["rows"]], ["b/a"])

    def test_names_of_files_are_plain_and_distinct(self):
        names = ["a", "a b", "a_b", "a/b", "ä", "ö", "..", "-o", ".x", "x'", "{a}", "$(a)", "n" * 300, "n" * 301]
        rows = self.plan(self.table("surface,name\n" + "".join("in/y.stl,%s\n" % n for n in names)))["rows"]
        self.assertEqual([r["name"] for r in rows], names)
        self.assertEqual(len({r["id"] for r in rows}), len(names))
        for row in rows:
            self.assertRegex(row["id"], r"^[A-Za-z0-9][A-Za-z0-9._-]{0,99}$")
        self.assertEqual(rows[0]["id"], "a")

    def test_what_is_made_again_depends_on_all_that_matters_and_nothing_else(self):
        (self.out / "lines.vtp").touch()
        seen = set()

        def is_new(text, *options):
            file = self.plan(self.table(text), *options)["rows"][0]["status_file"]
            was_there = file in seen
            seen.add(file)
            return not was_there

        table = "surface,centerlines\nin/y.stl,lines.vtp\n"
        self.assertTrue(is_new(table))
        for text, options in ((table, ["--threads", "2"]), (table, ["--job-timeout", "9"]), (table, ["--jobs", "3"]),
                              ("surface,options,#a\nin/y.stl,-c lines.vtp,1\n", []), (table, ["-q"])):
            self.assertFalse(is_new(text, *options), (text, options))
        for text, options in ((table, ["--smooth"]), (table, ["--format", "gmsh"]), (table, ["--no-pages"]),
                              ("surface,centerlines,n\nin/y.stl,lines.vtp,9\n", [])):
            self.assertTrue(is_new(text, *options), (text, options))
        for name in ("in/y.stl", "lines.vtp"):
            os.utime(self.out / name, ns=(0, 10**18))
            self.assertTrue(is_new(table))

    def test_what_ends_a_run_is_said_in_a_sentence(self):
        self.table("surface,n\nin/y.stl,60\n")
        for options, status, sentence in ((["--job-timeout", "0.3"], "124", "ended after 0.3 s, the limit of time"),
                                          (["--job-memory", "16"], "4", "There is not enough memory")):
            run = self.run_tool("--batch", "table.csv", "-o", self.OUT, *options, "--retry-failed")
            self.assertEqual(run.returncode, 5, run.stderr)
            row = self.rows()["in/y"]
            self.assertEqual((row["status"], row["exit status"]), ("failed", status))
            self.assertIn(sentence, row["sentence"])
            self.assertFalse((self.results / "meshes" / "in_y").exists())

    def test_formats(self):
        table = "surface,name,options\nin/y.stl,foam,--format openfoam\nin/y.stl,faces,-t surface\n"
        table += "in/y.stl,off,-t surface --format off\nin/y.stl,wrong,--format off\n"
        table += "in/y.stl,case,--case openfoam --flow-rate 80\n"
        self.batch(self.table(table), status=5)
        rows = self.rows()
        self.assertEqual({name: r["mesh"] for name, r in rows.items()},
                         {"foam": "meshes/foam/case", "faces": "meshes/faces/faces.vtp", "off": "meshes/off/off.off",
                          "wrong": "", "case": "meshes/case/case"})
        self.assertTrue((self.results / "meshes/foam/case/constant/polyMesh/faces").exists())
        self.assertTrue((self.results / "meshes/case/case/Allrun").exists())
        self.assertIn("--format off is not for a mesh of type isotropic", rows["wrong"]["sentence"])

    def test_steps_make_the_same(self):
        command = ["--batch", "in", "-o", self.OUT, *FEW]
        plan = self.plan("in")
        for row in plan["rows"][:1]:
            self.succeed(*command, "--batch-step", row["status_file"])
            self.assertTrue((self.results / row["status_file"]).exists())
        self.succeed(*command, "--batch-step", "index")
        self.assertEqual([r["status"] for r in index_of(self.results)], ["waiting", "meshed"])
        self.assertEqual(self.made_by("in"), {plan["rows"][1]["name"]})

    def test_another_batch_in_the_same_folder_is_refused(self):
        self.results.mkdir()
        folder = os.open(self.results, os.O_RDONLY)
        fcntl.flock(folder, fcntl.LOCK_EX)
        self.assertIn("Another batch is at work", self.refused("in"))
        os.close(folder)
        self.batch("in")

    def test_tells_programs_and_is_quiet(self):
        run = self.batch("in", "--log-json", "log.json", "-q")
        self.assertEqual((run.stdout, run.stderr), ("", ""))
        events = [json.loads(line) for line in read(self.out / "log.json").splitlines()]
        self.assertEqual([e["event"] for e in events if e["event"] != "surface"], ["begin"] + 2 * ["surface_end"] + ["end"])
        self.assertEqual((events[0]["surfaces"], events[-1]["status"], events[-1]["meshed"]), (2, 0, 2))
        self.assertEqual({e["name"] for e in events if e["event"] == "surface"}, {"y", "tube"})

    def test_the_page_is_escaped_and_in_natural_order(self):
        self.table("surface,name,#<i>\nin/tube.stl,p10,&amp;\nin/tube.stl,p2,\nno.stl,<b>\"'</b>,<script>\n")
        self.batch("table.csv", status=5)
        page = Page(self.results)
        self.assertEqual(page.open, [])
        self.assertFalse(page.tags & {"script", "b", "i", "link"})
        self.assertEqual([(r["surface"], r["class"], r["<i>"]) for r in page.rows[1:]],
                         [("<b>\"'</b>", "failed", "<script>"), ("p2", "meshed", ""), ("p10", "meshed", "&amp;")])


if __name__ == "__main__":
    unittest.main()
