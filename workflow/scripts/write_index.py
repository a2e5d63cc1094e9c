#!/usr/bin/env python3
# Copyright (c) 2026 The Tubular_meshing authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes index.html and index.csv into the folder of the results, in which it is started.

    write_index.py SURFACES [--pattern PATTERN]

SURFACES is the folder or the table that the workflow was given. A row of which there is no result yet is shown as such.
"""
import argparse
import csv
import html
import io
import json
import os
import re
import sys
import time
import types
import urllib.parse

sys.path.append(os.path.dirname(os.path.abspath(__file__)))
import cohort
from mesh_surface import write_whole

CELLS = ("tetrahedra", "pyramids", "prisms", "hexahedra")
FACETS = ("triangles", "quads")

# Of each measure, the value that is worst, and what the page calls it.
WORST = (("gamma_tau", "min", "γ_τ"), ("gamma_T", "min", "γ_T"), ("eta_q", "min", "η_q"), ("zeta_H", "min", "ζ_H"),
         ("scaled_jacobian", "min", "scaled Jacobian"), ("aspect", "max", "aspect"),
         ("non_orthogonality", "max", "non-orthogonality"), ("skewness", "max", "skewness"),
         ("Q_tau", "max", "Q_τ in the metric"))

STYLE = """
:root { color-scheme: light dark; }
body { font: 15px/1.4 system-ui, sans-serif; margin: 1em; }
table { border-collapse: collapse; }
th, td { padding: .25em .6em; text-align: left; vertical-align: top; border-bottom: 1px solid #8886; }
th { position: sticky; top: 0; background: Canvas; font-weight: 600; }
td.number { text-align: right; font-variant-numeric: tabular-nums; white-space: nowrap; }
td.picture img { display: block; background: #fff; object-fit: contain; }
td.name { font-weight: 600; overflow-wrap: anywhere; }
td.sentence { min-width: 18em; max-width: 40em; overflow-wrap: anywhere; }
tr.failed td.status { color: #c22; font-weight: 600; }
tr.waiting td.status { color: #888; }
@media (max-width: 50em) {
  table, tbody, tr, td { display: block; }
  thead { display: none; }
  tr { border-bottom: 2px solid #8888; padding: .5em 0; }
  td, td.number { border: 0; padding: .1em 0; text-align: left; white-space: normal; }
  td.sentence { min-width: 0; max-width: none; }
  td:empty { display: none; }
  td[data-label]:not(.name)::before { content: attr(data-label) ": "; color: #888; font-weight: 400; }
}
"""


class Result:
    """What is known of a row: its outcome, and the values of its columns by their names."""

    def __init__(self, row):
        self.row = row
        known = cohort.read_status(".", row.id)
        self.status = known[2] if known else None
        self.outcome = "waiting" if known is None else "meshed" if self.status["status"] == 0 else "failed"
        self.report = self.read_report() if self.outcome == "meshed" else {}
        self.values = self.read_values() if known else {}

    def read_report(self):
        try:
            with open(os.path.join("meshes", self.row.id, self.row.id + ".json"), encoding="utf-8") as file:
                return json.load(file)
        except (OSError, ValueError):
            return {} # lost since; the next run makes it again

    def read_values(self):
        values = {"seconds": self.status["seconds"], "memory MB": self.status["peak_memory_mb"]}
        report = self.report
        for kind, names in (("cells", CELLS), ("facets", FACETS)):
            values.update((n, report[kind][n]) for n in names if report.get(kind, {}).get(n))
        if report:
            values["openings"] = len(report["openings"])
            values["branches"] = len(report["branches"])
            values["points"] = report["points"]
            if report["volume"]["relative_difference"] is not None: # a number that is not finite
                values["volume, %"] = 100 * report["volume"]["relative_difference"]
        for measure, worst, name in WORST:
            statistics = report.get("quality", {}).get(measure)
            if statistics and statistics["count"] and statistics[worst] is not None:
                values[worst + " " + name] = statistics[worst]
        return values

    def sentence(self):
        """Why there is no mesh, or what the mesh's report notes."""
        if self.outcome != "meshed":
            return self.status["sentence"] if self.status else ""
        notes = self.report.get("fallbacks", []) + self.report.get("notes", [])
        notes += [r["sentence"] for r in self.report.get("repairs", [])]
        notes += [self.report[layers]["sentence"] for layers in ("wall", "boundary_layer")
                  if self.report.get(layers, {}).get("reduced_vertices")]
        return " ".join(note if note.endswith(".") else note + "." for note in notes)

    def path(self, kind):
        """Of the mesh, the report or the log, relative to the page; empty where there is none."""
        id = self.row.id
        path = {"mesh": "meshes/%s/%s" % (id, self.status.get("output") if self.status else ""),
                "report": "meshes/%s/%s.json" % (id, id), "page": "meshes/%s/%s.html" % (id, id),
                "picture": "meshes/%s/%s.png" % (id, id), "log": "logs/%s.txt" % id}[kind]
        is_there = self.status and (kind == "log" or self.outcome == "meshed") and os.path.exists(path)
        return path if is_there else ""


def natural(text):
    """A key that sorts p2 before p10."""
    return [(0, int(part), "") if part.isdigit() else (1, 0, part.lower())
            for part in re.findall(r"[0-9]+|[^0-9]+", text)] + [(2, 0, text)]


def columns_of(results):
    """The names of the values that any row has, in one order."""
    order = ["openings", "branches", "points", *CELLS, *FACETS, *(w + " " + n for _, w, n in WORST), "volume, %",
             "seconds", "memory MB"]
    return [name for name in order if any(name in r.values for r in results)]


def others_of(results):
    """The columns of the table that are not the workflow's own."""
    return list(dict.fromkeys(c for r in results for c in r.row.columns))


def shown(name, value):
    if value is None:
        return ""
    if name == "volume, %":
        return "%+.2f" % value
    if name in ("seconds", "memory MB"):
        return "%.1f" % value if name == "seconds" else "%.0f" % value
    return "{:,}".format(value).replace(",", "\u202f") if isinstance(value, int) else "%.4g" % value


def cell(label, content, kind=""):
    return '<td%s data-label="%s">%s</td>' % (' class="%s"' % kind if kind else "", html.escape(label), content)


def link(path, text):
    return '<a href="%s">%s</a>' % (html.escape(urllib.parse.quote(path)), text) if path else ""


def thumbnail(result):
    """A picture that leads to the mesh's page, or to itself."""
    picture = result.path("picture")
    if not picture:
        return ""
    image = '<img src="%s" alt="%s" width="160" height="120" loading="lazy">' % (
        html.escape(urllib.parse.quote(picture)), html.escape(result.row.name))
    return link(result.path("page") or picture, image)


def html_row(result, columns, others):
    text = html.escape
    cells = [cell("picture", thumbnail(result), "picture"), cell("surface", text(result.row.name), "name"),
             cell("status", result.outcome, "status"),
             cell("files", " ".join(filter(None, (link(result.path(k), k) for k in ("page", "mesh", "report", "log")))), "files"),
             cell("sentence", text(result.sentence()), "sentence")]
    cells += [cell(c, shown(c, result.values.get(c)), "number") for c in columns]
    cells += [cell(c, text(result.row.columns.get(c, ""))) for c in others]
    cells.append(cell("options", text(result.row.options)))
    return '<tr class="%s">%s</tr>' % (result.outcome, "".join(cells))


def summary(results):
    number = {outcome: sum(r.outcome == outcome for r in results) for outcome in ("meshed", "failed", "waiting")}
    text = "%d surface%s: %d meshed, %d failed" % (len(results), "" if len(results) == 1 else "s", number["meshed"],
                                                   number["failed"])
    return text + (", %d not done" % number["waiting"] if number["waiting"] else "")


def page(results, source):
    columns, others = columns_of(results), others_of(results)
    head = "".join("<th>%s</th>" % html.escape(c)
                   for c in ["picture", "surface", "status", "files", "sentence", *columns, *others, "options"])
    programs = sorted({r.status["program"] for r in results if r.status})
    return """<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>%s</title>
<style>%s</style>
</head>
<body>
<h1>%s</h1>
<p>%s. %s, %s. Of each measure of quality the worst value is given; "volume" is the mesh's difference from the surface.
<a href="index.csv">index.csv</a> has the same.</p>
<table>
<thead><tr>%s</tr></thead>
<tbody>
%s
</tbody>
</table>
</body>
</html>
""" % (html.escape(os.path.basename(source) or source), STYLE, html.escape(os.path.basename(source) or source),
       summary(results), html.escape(", ".join(programs) or "nothing done"), time.strftime("%Y-%m-%d %H:%M"), head,
       "\n".join(html_row(r, columns, others) for r in results))


def table(results):
    columns, others = columns_of(results), others_of(results)
    out = io.StringIO()
    writer = csv.writer(out, lineterminator="\n")
    writer.writerow(["name", "status", "sentence", "surface", "options", "mesh", "report", "page", "log", *columns, *others])
    for r in results:
        writer.writerow([r.row.name, r.outcome, r.sentence(), r.row.given, r.row.options, r.path("mesh"),
                         r.path("report"), r.path("page"), r.path("log"), *(r.values.get(c, "") for c in columns),
                         *(r.row.columns.get(c, "") for c in others)])
    return out.getvalue()


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("surfaces")
    parser.add_argument("--pattern", default="*")
    arguments = parser.parse_args()
    try:
        rows = cohort.read_rows(types.SimpleNamespace(surfaces=arguments.surfaces, pattern=arguments.pattern,
                                                      output=os.getcwd()))
    except cohort.Usage_error as error:
        return "error: %s" % error
    order = ("failed", "waiting", "meshed")
    results = sorted(map(Result, rows), key=lambda r: (order.index(r.outcome), natural(r.row.name)))
    write_whole(os.path.abspath("index.csv"), table(results))
    write_whole(os.path.abspath("index.html"), page(results, arguments.surfaces))
    print("%s; see %s" % (summary(results), os.path.abspath("index.html")))
    return 0


if __name__ == "__main__":
    sys.exit(main())
