// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "report_tables.h"

#include "histogram.h"
#include "tubular_mesh/report/counts.h"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

using html::escaped_for_xml;
using html::Json;
using html::number;
using html::Table;
using html::value;

namespace {

// What the measures of the report are of, and are called.
struct Measure {
  const char *key, *title;
};
const Measure measures[] = {
    {"gamma_tau", "tetrahedra, γ_τ"}, {"Q_tau", "tetrahedra, Q_τ in the metric"},
    {"zeta_H", "hexahedra, ζ_H"},     {"scaled_jacobian", "hexahedra, scaled Jacobian"},
    {"gamma_T", "triangles, γ_T"},    {"eta_q", "quads, η_q"},
    {"aspect", "cells, aspect"},      {"non_orthogonality", "faces, non-orthogonality in degrees"},
    {"skewness", "faces, skewness"}};

std::string number_of(const Json& json, const char* key) {
  const auto found = json.find(key);
  return found == json.end() || found->is_null() ? "" : number(found->get<double>(), 4);
}

std::string list_of(const std::vector<std::string>& items) {
  std::string text;
  for (const std::string& item : items)
    text += "<li>" + item + "</li>\n";
  return text.empty() ? text : "<ul>\n" + text + "</ul>\n";
}

// Numbers of branches, as links to their rows.
std::string branches_of(const Json& numbers) {
  std::string text;
  for (const auto& n : numbers) {
    const std::string b = std::to_string(n.get<std::size_t>());
    text += (text.empty() ? "" : " ") + ("<a href=\"#branch-" + b + "\">" + b + "</a>");
  }
  return text;
}

std::string worst_cells(const Shown_mesh& mesh) {
  static const char* const kinds[] = {"tetrahedron", "pyramid", "prism", "hexahedron"};
  std::vector<std::size_t> order(mesh.cells().size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  const std::size_t n = (std::min)(order.size(), std::size_t(10));
  std::partial_sort(order.begin(), order.begin() + std::ptrdiff_t(n), order.end(), [&](std::size_t a, std::size_t b) {
    return std::make_pair(mesh.quality_of_cell(a), a) < std::make_pair(mesh.quality_of_cell(b), b);
  });
  Table table("Cells of the lowest quality", {"cell", "#quality", "#branch", "place", ""});
  for (std::size_t i = 0; i < n; ++i) {
    const auto p = mesh.center_of_cell(order[i]);
    const Json place = {p.x, p.y, p.z};
    const std::string kind = kinds[mesh.cells().kind(order[i])];
    table.row({kind, number(mesh.quality_of_cell(order[i]), 3), std::to_string(mesh.place_of_cell(order[i]).branch),
               html::point(place),
               html::show_place(place, mesh.size_of_face(mesh.cells().face(order[i], 0)), "this " + kind)});
  }
  return table.empty() ? "" : "<h3>Cells of the lowest quality</h3>\n" + table.text();
}

} // namespace

std::string summary_of(const Json& report) {
  std::string counts;
  for_each_count(report, [&](const Json& number, const std::string& kind) {
    counts += (counts.empty() ? "" : ", ") + value(number) + " " + kind;
  });
  std::string text = "<p class=\"counts\">" + value(report["points"]) + " points, " + counts + "; " +
                     value(Json(report["openings"].size())) + " openings, " + value(Json(report["branches"].size())) +
                     " branches. Volume " + number(report["volume"]["mesh"].get<double>()) + ", that of the surface " +
                     number(report["volume"]["input"].get<double>()) + ".</p>\n";
  std::vector<std::string> notes;
  if (!report["valid"].get<bool>())
    notes.push_back("<strong>The mesh is not valid.</strong>");
  for (const char* key : {"fallbacks", "notes"})
    if (report.contains(key))
      for (const auto& note : report[key])
        notes.push_back(value(note));
  for (const char* key : {"wall", "boundary_layer", "quadratic"})
    if (report.contains(key))
      notes.push_back(value(report[key]["sentence"]));
  return text + list_of(notes);
}

std::string quality_section(const Json& report, const Shown_mesh& mesh) {
  Table table("Quality", {"measure", "#count", "#min", "#1 %", "#mean", "#max"});
  std::string charts;
  for (const Measure& m : measures) {
    const auto found = report["quality"].find(m.key);
    if (found == report["quality"].end() || (*found)["count"] == 0)
      continue;
    table.row({m.title, value((*found)["count"]), number_of(*found, "min"), number_of(*found, "p1"),
               number_of(*found, "mean"), number_of(*found, "max")});
    if (found->contains("histogram"))
      charts += histogram((*found)["histogram"].get<std::vector<double>>(), m.title);
  }
  return html::section("quality", "Quality",
                       table.text() + "<div class=\"charts\">" + charts + "</div>\n" + worst_cells(mesh));
}

std::string openings_section(const Json& report) {
  Table table("Openings", {"name", "#patch", "#radius", "#area", "#in the mesh", "#facets", "#branch", "center", ""});
  for (const auto& o : report["openings"])
    table.row(
        {value(o["name"]), value(o["patch"]), number_of(o, "radius"), number_of(o, "area"), number_of(o, "mesh_area"),
         value(Json(o["triangles"].get<long>() + o["quads"].get<long>())),
         o["branch"].is_null() ? "" : branches_of(Json::array({o["branch"]})), html::point(o["center"]),
         html::show_place(o["center"], o["radius"].get<double>(), "the opening " + o["name"].get<std::string>())});
  return html::section("openings", "Openings", table.text());
}

std::string branches_section(const Json& report) {
  Table table("Branches",
              {"branch", "#length", "#least radius", "#largest", "#points round it", "after", "before", ""});
  std::size_t number = 0;
  for (const auto& b : report["branches"]) {
    const std::string n = std::to_string(number);
    table.row({"<span id=\"branch-" + n + "\">" + n + "</span>", number_of(b, "length"), number_of(b, "min_radius"),
               number_of(b, "max_radius"), number_of(b, "points_per_circumference"), branches_of(b["parents"]),
               branches_of(b["children"]), html::show_branch(number)});
    ++number;
  }
  return html::section("branches", "Branches", table.text());
}

std::string places_section(const Json& report) {
  Table table("What was repaired or gave way", {"what", "#number", "#size", "place", ""});
  const auto add = [&](const std::string& sentence, const std::string& count, double size, const Json& place) {
    table.row({escaped_for_xml(sentence), count, size > 0 ? html::number(size, 4) : "",
               place.is_array() ? html::point(place) : "", html::show_place(place, size, "the place: " + sentence)});
  };
  for (const auto& r : report["repairs"])
    add(r["sentence"].get<std::string>(), value(r["count"]), r["size"].get<double>(), r["place"]);
  if (report.contains("round_ends"))
    for (const auto& end : report["round_ends"])
      add(end["cut"].get<bool>() ? "A round end was cut open."
                                 : "A round end stays closed: " + end["reason"].get<std::string>() + ".",
          "1", end["radius"].get<double>(), end["center"]);
  if (report.contains("hexahedral"))
    for (const auto& p : report["hexahedral"]["places_without_blocks"])
      add("No blocks of hexahedra here: " + p["reason"].get<std::string>() + ".", "1", 0, p["place"]);
  for (const char* layers : {"wall", "boundary_layer"})
    if (report.contains(layers) && report[layers]["reduced_vertices"] > 0)
      add(report[layers]["sentence"].get<std::string>(), value(report[layers]["reduced_vertices"]), 0,
          report[layers]["worst_place"]);
  return html::section("places", "Repairs and places to look at",
                       table.empty() ? "<p>Nothing was repaired, and nothing gave way.</p>\n" : table.text());
}

std::string times_section(const Json& report) {
  Table table("Time by stage", {"stage", "#seconds", "share"});
  const double total = report["total_time"].get<double>();
  for (const auto& t : report["times"].items()) {
    const double share = total > 0 ? t.value().get<double>() / total : 0;
    table.row({escaped_for_xml(t.key()), number(t.value().get<double>(), 3),
               "<div class=\"bar\" style=\"width:" + number(200 * share, 4) + "px\"></div>"});
  }
  table.row({"total", number(total, 4), ""});
  return html::section("times", "Time",
                       table.text() + "<p>Peak memory: " + number(report["peak_memory_bytes"].get<double>() / 1e6, 4) +
                           " MB.</p>\n");
}

std::string command_section(const Json& report, const std::string& command) {
  std::string text =
      "<p>Made by " + value(report["program"]) + " from <code>" + value(report["input"]) + "</code>.</p>\n";
  if (!command.empty())
    text += "<pre tabindex=\"0\" id=\"command-line\">" + escaped_for_xml(command) + "</pre>\n";
  return html::section("command", "Command", text);
}
