#!/usr/bin/env python3
# Copyright (c) 2026 The Tubular_meshing authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Whole runs of tubular_mesh on one folder of surfaces: time, memory, growth, threads, and the same bytes again.

    jobs.py DATA [-b BUILD] [--beside BUILD] [--only NAME...] [--runs K] [--growth] [--threads] [--same] [--large]
                 [--json FILE] [--compare FILE]

DATA holds paper/ and trees/ with the surfaces that are named in JOBS. Each job is a run from its files to its files; the
fastest of K runs counts. With --beside the program of another build does each run right after this one's, so that both
see the same machine, and the table shows the ratio. The other questions are asked of each job that is chosen:

  --growth   at four sizes, each of twice the cells: the exponent of time over cells (1 is linear), and bytes a cell
  --threads  on one thread and on all: the ratio of each stage of a second or more
  --same     twice on one thread and twice on all: whether the files are the same
  --large    also the job of twenty million tetrahedra, which takes minutes and gigabytes

--json keeps the figures; --compare prints them beside those of an earlier file. Standard library only.
"""

import argparse
import hashlib
import json
import math
import os
import pathlib
import sys
import tempfile

from whole_runs import ROOT, Run


class Job:
    """stage: the one that is measured; none stands for the whole run."""

    def __init__(self, name, surface, arguments, n=None, stage=None, centerlines=None, large=False):
        self.name, self.surface, self.arguments, self.n = name, surface, arguments, n
        self.stage, self.centerlines, self.large = stage, centerlines, large
        self.file = "job.vtp" if "surface" in arguments else "job.vtu"

    def command(self, tool, data, mesh, report, n, threads):
        command = [tool, data / self.surface, "-o", mesh, "--report", report, "--threads", threads, *self.arguments]
        if self.centerlines:
            command += ["-c", data / self.centerlines]
        return command + (["-n", n] if n else [])


CEREBRAL = {"surface": "paper/cerebral.stl", "centerlines": "paper/centerlinesCEREBRAL.vtk"}
AORTA = {"surface": "paper/aorta.stl", "centerlines": "paper/centerlinesAORTA.vtk"}
AIRWAYS = "trees/airway_lf_open.vtp"
JOBS = [
    Job("centerlines, aorta", "paper/aorta.stl", ["-t", "surface"], 12, "centerlines"),
    Job("centerlines, cerebral", "paper/cerebral.stl", ["-t", "surface"], 12, "centerlines"),
    Job("centerlines, airways", AIRWAYS, ["-t", "surface"], 12, "centerlines"),
    Job("tetrahedra, airways", AIRWAYS, [], 14),
    Job("tetrahedra, cerebral", arguments=[], n=25, **CEREBRAL),
    Job("mixed with wall, cerebral", arguments=["-t", "mixed", "--wall", "0.2"], n=22.5, **CEREBRAL),
    Job("anisotropic, aorta", arguments=["-t", "anisotropic"], n=20, stage="anisotropic remeshing", **AORTA),
    Job("anisotropic, cerebral", arguments=["-t", "anisotropic"], n=20, **CEREBRAL),
    Job("quads, cerebral", arguments=["-t", "surface", "--surface-elements", "quads"], n=22.5, stage="quads",
        **CEREBRAL),
    Job("hexahedra, cerebral", "paper/cerebral.stl",
        ["-t", "hexahedral", "--boundary-layer-prisms", "4", "--first-height", "0.0485"], 24),
    Job("20 million tetrahedra, airways", AIRWAYS, ["--elements", "20000000"], large=True),
]


# ---------------------------------------------------------------------------------------------------------------------
# running


class Figures:
    """Of one run: seconds of the stage and of the whole, those of all stages, bytes at most, cells, hash of the file."""

    def __init__(self, job, run, mesh, report):
        self.failure = None if run.status == 0 and report.exists() else run.failure()
        if self.failure:
            return
        told = json.loads(report.read_text())
        self.stages = told["times"]
        self.seconds = self.stages.get(job.stage, math.nan) if job.stage else run.seconds
        self.memory = told.get("peak_memory_bytes") or run.memory
        cells = told["cells"]
        self.cells = sum(cells.values()) if isinstance(cells, dict) else cells
        if not self.cells:
            self.cells = sum(told["facets"].values()) if isinstance(told["facets"], dict) else told["facets"]
        self.quality = {name: (values["min"], values["mean"]) for name, values in told.get("quality", {}).items()
                        if isinstance(values, dict) and values.get("count") and "min" in values}
        self.hash = hashlib.sha256(mesh.read_bytes()).hexdigest()

    def as_json(self):
        return {key: value for key, value in vars(self).items() if key != "hash"}


def run_once(job, tool, options, work, n, threads):
    mesh, report = work / job.file, work / "job.json"
    for file in (mesh, report):
        file.unlink(missing_ok=True)
    command = job.command(tool, options.data, mesh, report, n, threads)
    return Figures(job, Run(command, work, options.limit), mesh, report)


def fastest(job, tools, options, work, n, threads=0):
    """The fastest run of each tool; they take turns."""
    best = [None] * len(tools)
    for _ in range(options.runs):
        for k, tool in enumerate(tools):
            figures = run_once(job, tool, options, work, n, threads)
            if figures.failure:
                best[k] = best[k] or figures
            elif best[k] is None or best[k].failure or figures.seconds < best[k].seconds:
                best[k] = figures
    return best


# ---------------------------------------------------------------------------------------------------------------------
# the questions


def slope(x, y):
    """Of the line of least squares through the logarithms."""
    x, y = [math.log(v) for v in x], [math.log(v) for v in y]
    mx, my = sum(x) / len(x), sum(y) / len(y)
    return sum((a - mx) * (b - my) for a, b in zip(x, y)) / sum((a - mx) ** 2 for a in x)


def growth(job, tool, options, work):
    sizes = []
    for k in range(4):  # down from the job's own
        figures = fastest(job, [tool], options, work, round(job.n / 2 ** (k / 3), 2))[0]
        if figures.failure:
            return figures.failure
        sizes.append(figures)
    cells, memory = [f.cells for f in sizes], [f.memory for f in sizes]
    per_cell = (memory[0] - memory[-1]) / (cells[0] - cells[-1])
    return f"cells {cells[-1]} to {cells[0]}: time ~ cells^{slope(cells, [f.seconds for f in sizes]):.2f}, " \
           f"{per_cell:.0f} bytes a cell"


def threads(job, tool, options, work):
    one, all_cores = (fastest(job, [tool], options, work, job.n, t)[0] for t in (1, 0))
    if one.failure or all_cores.failure:
        return one.failure or all_cores.failure
    ratios = [f"{stage} {seconds:.1f} / {all_cores.stages[stage]:.1f} = {seconds / all_cores.stages[stage]:.2f}"
              for stage, seconds in one.stages.items() if seconds >= 1 and all_cores.stages.get(stage, 0) > 0]
    return f"{os.cpu_count()} cores: " + (", ".join(ratios) or "no stage of a second")


def same(job, tool, options, work):
    hashes = []
    for t in (1, 1, 0, 0):
        figures = run_once(job, tool, options, work, job.n, t)
        if figures.failure:
            return figures.failure
        hashes.append(figures.hash)
    return "the same bytes on any number of threads" if len(set(hashes)) == 1 else \
        f"one thread twice: {'same' if hashes[0] == hashes[1] else 'DIFFERENT'}; " \
        f"all twice: {'same' if hashes[2] == hashes[3] else 'DIFFERENT'}; one and all: " \
        f"{'same' if hashes[0] == hashes[2] else 'DIFFERENT'}"


# ---------------------------------------------------------------------------------------------------------------------
# the table


def row(job, figures, other, earlier):
    if figures.failure:
        return [job.name, figures.failure]
    quality = "; ".join(f"{name} {least:.2f}, {mean:.2f}" for name, (least, mean) in list(figures.quality.items())[:2])
    cells = [job.name, f"{figures.cells}", f"{figures.seconds:.2f}", f"{figures.memory / 1e6:.0f}",
             f"{figures.cells / figures.seconds:.0f}", quality]
    if other is not None:
        cells.append(other.failure or f"{other.seconds:.2f} ({other.seconds / figures.seconds:.2f})")
    if earlier is not None:
        before = earlier.get(job.name)
        cells.append(f"{before['seconds']:.2f} ({before['seconds'] / figures.seconds:.2f})"
                     if before and "seconds" in before else "-")
    return cells


def parse_options():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("data", type=pathlib.Path)
    parser.add_argument("-b", "--build", type=pathlib.Path, default=ROOT / "build", help="build directory")
    parser.add_argument("--beside", type=pathlib.Path, help="the build directory of another version")
    parser.add_argument("--only", nargs="+", default=[], metavar="NAME", help="jobs whose name contains one of these")
    parser.add_argument("--runs", type=int, default=1, help="of each program; the fastest counts (1)")
    parser.add_argument("--limit", type=int, default=1800, help="seconds one run may take (1800)")
    for question in ("growth", "threads", "same", "large"):
        parser.add_argument(f"--{question}", action="store_true")
    parser.add_argument("--json", type=pathlib.Path, help="write the figures to this file")
    parser.add_argument("--compare", type=pathlib.Path, help="a file that --json has written earlier")
    options = parser.parse_args()
    options.data = options.data.resolve()
    options.tools = [build.resolve() / "examples" / "Tubular_meshing" / "tubular_mesh"
                     for build in (options.build, options.beside) if build]
    for tool in options.tools:
        if not tool.exists():
            parser.error(f"there is no {tool}: build it first (scripts/run.sh does)")
    return options


def main():
    options = parse_options()
    jobs = [j for j in JOBS if not j.large or options.large]
    jobs = [j for j in jobs if not options.only or any(name in j.name for name in options.only)]
    jobs = [j for j in jobs if (options.data / j.surface).exists()]
    if not jobs:
        print(f"none of the jobs has its surface in {options.data}", file=sys.stderr)
        return 1
    earlier = json.loads(options.compare.read_text()) if options.compare else None
    title = ["job", "cells", "seconds", "MB", "cells/s", "least, mean quality"]
    title += (["the other's seconds (ratio)"] if options.beside else []) + (["earlier (ratio)"] if earlier else [])
    print("| " + " | ".join(title) + " |\n|" + "---|" * len(title), flush=True)
    answers, kept, failed = [], {}, False
    with tempfile.TemporaryDirectory() as temporary:
        work = pathlib.Path(temporary)
        for job in jobs:
            figures = fastest(job, options.tools, options, work, job.n)
            failed = failed or bool(figures[0].failure)
            print("| " + " | ".join(row(job, figures[0], figures[1] if options.beside else None, earlier)) + " |",
                  flush=True)
            kept[job.name] = figures[0].as_json()
            for question in (growth, threads, same):
                if getattr(options, question.__name__) and not figures[0].failure and not job.large:
                    answers.append(f"{job.name}, {question.__name__}: {question(job, options.tools[0], options, work)}")
    if answers:
        print("\n" + "\n".join(answers))
    if options.json:
        options.json.write_text(json.dumps(kept, indent=1) + "\n")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
