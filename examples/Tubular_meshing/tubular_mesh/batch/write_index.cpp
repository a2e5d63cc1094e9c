// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "write_index.h"

#include "../../command_line/words.h"
#include "../page/html.h"
#include "index_style.h"

#include <CGAL/Tubular_meshing/IO/Output_file.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace tubular = CGAL::Tubular_meshing;
namespace fs = std::filesystem;

namespace {

typedef std::vector<Indexed_row> Rows;

const std::vector<std::string> kinds_of_cells = {"tetrahedra", "pyramids", "prisms", "hexahedra"};
const std::vector<std::string> kinds_of_facets = {"triangles", "quads"};

// Of a measure of quality, the value that is worst, and what the page calls it.
struct Worst {
  const char *measure, *value, *name;
};
const std::array<Worst, 9> worst_values = {{{"gamma_tau", "min", "γ_τ"},
                                            {"gamma_T", "min", "γ_T"},
                                            {"eta_q", "min", "η_q"},
                                            {"zeta_H", "min", "ζ_H"},
                                            {"scaled_jacobian", "min", "scaled Jacobian"},
                                            {"aspect", "max", "aspect"},
                                            {"non_orthogonality", "max", "non-orthogonality"},
                                            {"skewness", "max", "skewness"},
                                            {"Q_tau", "max", "Q_τ in the metric"}}};
std::string name_of(const Worst& w) {
  return std::string(w.value) + " " + w.name;
}

const char* name_of(const Indexed_row& row) {
  return row.outcome == Indexed_row::failed ? "failed" : row.outcome == Indexed_row::waiting ? "waiting" : "meshed";
}

Json values_of(const Json& report, const Job_result& result) {
  Json values = {{"seconds", result.json.value("seconds", 0.)}, {"memory MB", result.json.value("peak_memory_mb", 0.)}};
  if (!report.is_object())
    return values;
  const auto add_counts = [&](const char* group, const std::vector<std::string>& kinds) {
    for (const std::string& kind : kinds)
      if (report.contains(group) && report[group].value(kind, 0L) > 0)
        values[kind] = report[group][kind];
  };
  add_counts("cells", kinds_of_cells);
  add_counts("facets", kinds_of_facets);
  for (const char* list : {"openings", "branches"})
    if (report.contains(list))
      values[list] = report[list].size();
  if (report.contains("points"))
    values["points"] = report["points"];
  const Json difference = report.value(Json::json_pointer("/volume/relative_difference"), Json());
  if (difference.is_number())
    values["volume, %"] = 100 * difference.get<double>();
  for (const Worst& w : worst_values) {
    const Json of_measure = report.value(Json::json_pointer(std::string("/quality/") + w.measure), Json::object());
    if (of_measure.is_object() && of_measure.contains(w.value) && of_measure[w.value].is_number() &&
        of_measure.value("count", 0L) > 0)
      values[name_of(w)] = of_measure[w.value];
  }
  return values;
}

// What the report of a mesh says in sentences.
std::string notes_of(const Json& report) {
  std::string text;
  const auto add = [&](const Json& sentence) {
    if (!sentence.is_string() || sentence.get<std::string>().empty())
      return;
    const std::string s = sentence.get<std::string>();
    text += (text.empty() ? "" : " ") + s + (s.back() == '.' ? "" : ".");
  };
  if (!report.is_object())
    return text;
  for (const char* list : {"fallbacks", "notes"})
    for (const Json& sentence : report.value(list, Json::array()))
      add(sentence);
  for (const Json& repair : report.value("repairs", Json::array()))
    add(repair.value("sentence", Json()));
  for (const char* layers : {"wall", "boundary_layer"})
    if (report.contains(layers) && report[layers].is_object() && report[layers].value("reduced_vertices", 0L) > 0)
      add(report[layers].value("sentence", Json()));
  return text;
}

// Of the mesh, the report, the page, the picture or the log, relative to the index; empty where there is none.
std::string path_of(const std::string& results, const Indexed_row& row, const std::string& kind) {
  if (!row.result)
    return "";
  const std::string &id = row.row.id, home = batch_paths::home(id) + "/";
  const std::string path = kind == "log"      ? batch_paths::log(id)
                           : kind == "mesh"   ? home + row.result->json.value("output", "")
                           : kind == "report" ? home + id + ".json"
                           : kind == "page"   ? home + id + ".html"
                                              : home + id + ".png";
  std::error_code ignored;
  return (kind == "log" || row.outcome == Indexed_row::meshed) && fs::exists(fs::path(results) / path, ignored) ? path
                                                                                                                : "";
}

// Sorts p2 before p10: numbers are made as long as they can be.
std::string natural(const std::string& text) {
  const std::size_t digits = 20;
  std::string key, number;
  const auto add_number = [&] {
    if (!number.empty())
      key += std::string(digits - (std::min)(number.size(), digits), '0') + number;
    number.clear();
  };
  for (unsigned char c : text)
    if (std::isdigit(c))
      number += char(c);
    else {
      add_number();
      key += char(std::tolower(c));
    }
  add_number();
  return key;
}

/* The columns of the index: those that any row has a value of. */
struct Columns {
  std::vector<std::string> numbers, shown; // the latter are the table's

  explicit Columns(const Rows& rows) {
    std::vector<std::string> all = {"openings", "branches", "points"};
    all.insert(all.end(), kinds_of_cells.begin(), kinds_of_cells.end());
    all.insert(all.end(), kinds_of_facets.begin(), kinds_of_facets.end());
    for (const Worst& w : worst_values)
      all.push_back(name_of(w));
    all.insert(all.end(), {"volume, %", "seconds", "memory MB"});
    for (const std::string& name : all)
      if (std::any_of(rows.begin(), rows.end(), [&](const Indexed_row& r) { return r.values.contains(name); }))
        numbers.push_back(name);
    if (!rows.empty())
      for (const auto& column : rows.front().row.shown)
        shown.push_back(column.first);
  }
};

std::string shown_value(const std::string& column, const Json& value) {
  char text[40];
  const char* const format = column == "volume, %"   ? "%+.2f"
                             : column == "seconds"   ? "%.1f"
                             : column == "memory MB" ? "%.0f"
                                                     : nullptr;
  if (!format)
    return html::value(value);
  std::snprintf(text, sizeof text, format, value.get<double>());
  return text;
}

std::string link(const std::string& path, const std::string& content) {
  static const std::string plain = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-._~/";
  std::string address;
  for (unsigned char c : path) {
    char text[4] = {char(c), 0, 0, 0};
    if (plain.find(char(c)) == plain.npos)
      std::snprintf(text, sizeof text, "%%%02X", c);
    address += text;
  }
  return path.empty() ? "" : "<a href=\"" + address + "\">" + content + "</a>";
}

class Page {
public:
  Page(const std::string& results, const std::string& source, const Rows& rows)
      : results_(results)
      , source_(fs::path(source).lexically_normal().string())
      , rows_(rows)
      , columns_(rows) {
    while (source_.size() > 1 && source_.back() == '/')
      source_.pop_back();
  }

  std::string text() const {
    std::set<std::string> programs;
    for (const Indexed_row& row : rows_)
      if (row.result)
        programs.insert(row.result->json.value("program", ""));
    std::string made_by;
    for (const std::string& program : programs)
      made_by += (made_by.empty() ? "" : ", ") + program;
    char time[32];
    const std::time_t now = std::time(nullptr);
    std::tm local = {};
    std::strftime(time, sizeof time, "%Y-%m-%d %H:%M", localtime_r(&now, &local));
    const std::string title = html::escaped_for_xml(fs::path(source_).filename().string());
    std::string page = "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<meta name=\"viewport\" "
                       "content=\"width=device-width, initial-scale=1\">\n<title>" +
                       title + "</title>\n<style>" + index_style + "</style>\n</head>\n<body>\n<h1>" + title +
                       "</h1>\n<p>" + summary(rows_) + ". " +
                       html::escaped_for_xml(made_by.empty() ? "Nothing done" : made_by) + ", " + time +
                       ". Of each measure of quality the worst value is given; \"volume\" is the mesh's difference "
                       "from the surface.\n<a href=\"index.csv\">index.csv</a> has the same.</p>\n<table>\n<thead><tr>";
    std::vector<std::string> headings = {"picture", "surface", "status", "files", "sentence"};
    headings.insert(headings.end(), columns_.numbers.begin(), columns_.numbers.end());
    headings.insert(headings.end(), columns_.shown.begin(), columns_.shown.end());
    headings.push_back("options");
    for (const std::string& heading : headings)
      page += "<th scope=\"col\">" + html::escaped_for_xml(heading) + "</th>";
    page += "</tr></thead>\n<tbody>\n";
    for (const Indexed_row& row : rows_)
      page += text_of(row) + "\n";
    return page + "</tbody>\n</table>\n</body>\n</html>\n";
  }

private:
  static std::string cell(const std::string& label, const std::string& content, const std::string& kind = "") {
    return "<td" + (kind.empty() ? "" : " class=\"" + kind + "\"") + " data-label=\"" + html::escaped_for_xml(label) +
           "\">" + content + "</td>";
  }

  // A picture that leads to the mesh's page, or to itself.
  std::string thumbnail(const Indexed_row& row) const {
    const std::string picture = path_of(results_, row, "picture"), page = path_of(results_, row, "page");
    if (picture.empty())
      return "";
    const std::string image = "<img src=\"" + picture + "\" alt=\"" + html::escaped_for_xml(row.row.name) +
                              "\" width=\"160\" height=\"120\" loading=\"lazy\">"; // the path of an id is plain
    return link(page.empty() ? picture : page, image);
  }

  std::string text_of(const Indexed_row& row) const {
    std::string files;
    for (const char* kind : {"page", "mesh", "report", "log"}) {
      const std::string leads = link(path_of(results_, row, kind), kind);
      files += (files.empty() || leads.empty() ? "" : " ") + leads;
    }
    const std::string status =
        row.outcome == Indexed_row::failed ? "failed, " + std::to_string(row.result->status()) : name_of(row);
    std::string cells = cell("picture", thumbnail(row), "picture") +
                        cell("surface", html::escaped_for_xml(row.row.name), "name") +
                        cell("status", status, "status") + cell("files", files, "files") +
                        cell("sentence", html::escaped_for_xml(row.sentence()), "sentence");
    for (const std::string& column : columns_.numbers)
      cells += cell(column, row.values.contains(column) ? shown_value(column, row.values[column]) : "", "number");
    for (const auto& column : row.row.shown)
      cells += cell(column.first, html::escaped_for_xml(column.second));
    cells += cell("options", html::escaped_for_xml(command_line::text_of(row.row.options)));
    return "<tr class=\"" + std::string(name_of(row)) + "\">" + cells + "</tr>";
  }

  std::string results_, source_;
  const Rows& rows_;
  Columns columns_;
};

std::string line_of_csv(const std::vector<std::string>& values) {
  std::string line;
  for (std::size_t i = 0; i < values.size(); ++i) {
    line += i > 0 ? "," : "";
    if (values[i].find_first_of(",\"\r\n") == std::string::npos) {
      line += values[i];
      continue;
    }
    line += '"';
    for (char c : values[i])
      line += c == '"' ? std::string("\"\"") : std::string(1, c);
    line += '"';
  }
  return line + "\n";
}

std::string table_of(const std::string& results, const Rows& rows) {
  const Columns columns(rows);
  std::vector<std::string> head = {"name",    "status", "exit status", "sentence", "surface",
                                   "options", "mesh",   "report",      "page",     "log"};
  head.insert(head.end(), columns.numbers.begin(), columns.numbers.end());
  head.insert(head.end(), columns.shown.begin(), columns.shown.end());
  std::string text = line_of_csv(head);
  for (const Indexed_row& row : rows) {
    std::vector<std::string> values = {
        row.row.name,   name_of(row),  row.result ? std::to_string(row.result->status()) : "",
        row.sentence(), row.row.given, command_line::text_of(row.row.options)};
    for (const char* kind : {"mesh", "report", "page", "log"})
      values.push_back(path_of(results, row, kind));
    for (const std::string& column : columns.numbers)
      values.push_back(row.values.contains(column) ? row.values[column].dump() : "");
    for (const auto& column : row.row.shown)
      values.push_back(column.second);
    text += line_of_csv(values);
  }
  return text;
}

} // namespace

Indexed_row indexed_row(const std::string& results, const Batch_row& row, std::optional<Job_result> result) {
  Indexed_row indexed{row, std::move(result), Json::object(), "", Indexed_row::waiting};
  if (!indexed.result)
    return indexed;
  indexed.outcome = indexed.result->status() == 0 ? Indexed_row::meshed : Indexed_row::failed;
  Json report;
  if (indexed.outcome == Indexed_row::meshed) { // where it has been lost, the next run makes it again
    std::ifstream file(fs::path(results) / batch_paths::home(row.id) / (row.id + ".json"));
    report = Json::parse(file, nullptr, false);
  }
  indexed.values = values_of(report, *indexed.result);
  indexed.notes = notes_of(report);
  return indexed;
}

std::string summary(const std::vector<Indexed_row>& rows) {
  const auto number = [&](int outcome) {
    return std::count_if(rows.begin(), rows.end(), [&](const Indexed_row& r) { return r.outcome == outcome; });
  };
  const auto waiting = number(Indexed_row::waiting);
  return std::to_string(rows.size()) + (rows.size() == 1 ? " surface: " : " surfaces: ") +
         std::to_string(number(Indexed_row::meshed)) + " meshed, " + std::to_string(number(Indexed_row::failed)) +
         " failed" + (waiting > 0 ? ", " + std::to_string(waiting) + " not done" : "");
}

void write_index(const std::string& results, const std::string& source, std::vector<Indexed_row> rows) {
  std::stable_sort(rows.begin(), rows.end(), [](const Indexed_row& a, const Indexed_row& b) {
    return std::make_pair(int(a.outcome), natural(a.row.name)) < std::make_pair(int(b.outcome), natural(b.row.name));
  });
  tubular::IO::Output_file page(results + "/" + batch_paths::index_page),
      table(results + "/" + batch_paths::index_table);
  page.write(Page(results, source, rows).text());
  table.write(table_of(results, rows));
  page.finish();
  table.finish();
  table.commit();
  page.commit();
}
