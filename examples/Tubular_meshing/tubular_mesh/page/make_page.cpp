// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "make_page.h"

#include "html.h"
#include "pack_scene.h"
#include "page_style.h"
#include "report_tables.h"
#include "stills.h"
#include "viewer_bundle.h"

#include <cstddef>
#include <string>

using html::Json;

namespace {

const char* const sections[][2] = {{"quality", "Quality"}, {"openings", "Openings"}, {"branches", "Branches"},
                                   {"places", "Repairs"},  {"times", "Time"},        {"command", "Command"}};

std::string links() {
  std::string text;
  for (const auto& s : sections)
    text += std::string("<a href=\"#") + s[0] + "\">" + s[1] + "</a>";
  return "<nav aria-label=\"Sections\">" + text + "</nav>\n";
}

std::string head_of(const Json& report) {
  const std::string title = html::value(report["output"]).empty() ? "Mesh" : html::value(report["output"]);
  return "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
         "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
         "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; script-src 'unsafe-inline'; "
         "style-src "
         "'unsafe-inline'; img-src data: blob:\">\n<title>" +
         title + "</title>\n<style>" + page_style +
         "</style>\n</head>\n<body>\n<a class=\"skip\" href=\"#tables\">To the tables</a>\n"
         "<header><h1>" +
         title + "</h1>\n" + summary_of(report) + links() + "</header>\n";
}

std::string script(const std::string& id, const std::string& type, const std::string& content) {
  return "<script id=\"" + id + "\" type=\"" + type + "\">" + content + "</script>\n";
}

// The mesh for the viewer, within so many bytes.
std::string scene(const Shown_mesh& mesh, std::size_t most_bytes) {
  const Packed_scene packed = pack_scene(mesh, most_bytes);
  std::string text = script("scene", "application/json", html::in_script(packed.header));
  for (std::size_t i = 0; i < packed.parts.size(); ++i)
    text += script("part-" + std::to_string(i), "application/octet-stream", packed.parts[i]);
  return text;
}

const char* const no_viewer = "<p>This program was built without npm: the page has still pictures in place of a mesh "
                              "that can be turned and cut.</p>\n";

} // namespace

bool has_viewer() {
  return viewer_bundle[0] != '\0';
}

std::string make_page(const std::string& report_text, const Shown_mesh& mesh, const std::string& command,
                      std::size_t most_bytes) {
  const Json report = Json::parse(report_text);
  std::string page = head_of(report) + "<main>\n<div id=\"show\">\n";
  page += has_viewer() ? "<div id=\"viewer\"></div>\n" : no_viewer;
  page += "<div id=\"stills\">\n" + still_of_mesh(report, mesh) + (mesh.cells().size() > 0 ? still_of_cut(mesh) : "") +
          "</div>\n";
  page += "</div>\n<div id=\"tables\" tabindex=\"-1\">\n" + quality_section(report, mesh) + openings_section(report) +
          branches_section(report) + places_section(report) + times_section(report) + command_section(report, command) +
          "</div>\n</main>\n" + script("report", "application/json", html::in_script(report_text));
  if (has_viewer()) {
    const std::string viewer = script("code", "text/javascript", viewer_bundle);
    const std::size_t rest = page.size() + viewer.size() + 30;
    page += scene(mesh, most_bytes > rest ? most_bytes - rest : 0) + viewer;
  }
  return page + "</body>\n</html>\n";
}
