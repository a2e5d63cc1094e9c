// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef TUBULAR_MESH_PAGE_HTML_H
#define TUBULAR_MESH_PAGE_HTML_H

#include <CGAL/Tubular_meshing/base/escaped_for_xml.h>

#include <nlohmann/json.hpp>

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

/* The pieces that pages are made of. */
namespace html {

typedef nlohmann::ordered_json Json;

using CGAL::Tubular_meshing::internal::escaped_for_xml;

// JSON within a script element: as JSON, it says the same.
std::string in_script(std::string json);

std::string number(double x, int digits = 6);
// A number with digits in groups of three, or text; nothing for null.
std::string value(const Json& json);
std::string point(const Json& xyz);

/* A table, in a box of its own that scrolls where it is wider than the page. */
class Table {
public:
  // A heading that begins with # is of a column of numbers.
  explicit Table(const std::string& caption, std::vector<std::string> headings);
  // Of cells that are escaped already.
  void row(const std::vector<std::string>& cells);
  bool empty() const { return rows_.empty(); }
  std::string text() const;

private:
  std::string caption_;
  std::vector<std::string> headings_;
  std::string rows_;
};

std::string section(const std::string& id, const std::string& title, const std::string& content);

// A button that the viewer answers by turning to a place; hidden where there is no viewer.
std::string show_place(const Json& xyz, double radius, const std::string& of_what);
std::string show_branch(std::size_t branch);

} // namespace html

#endif // TUBULAR_MESH_PAGE_HTML_H
