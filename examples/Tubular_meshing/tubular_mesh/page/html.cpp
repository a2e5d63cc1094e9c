// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "html.h"

#include <cstddef>
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

namespace html {

// Within JSON, a < stands in strings alone.
std::string in_script(std::string json) {
  std::string out;
  for (char c : json)
    if (c == '<')
      out += "\\u003c";
    else
      out += c;
  return out;
}

std::string number(double x, int digits) {
  char text[40];
  std::snprintf(text, sizeof text, "%.*g", digits, x);
  return text;
}

std::string value(const Json& json) {
  if (json.is_null())
    return "";
  if (json.is_string())
    return escaped_for_xml(json.get<std::string>());
  if (json.is_boolean())
    return json.get<bool>() ? "yes" : "no";
  if (!json.is_number_integer())
    return json.is_number() ? number(json.get<double>(), 4) : escaped_for_xml(json.dump());
  std::string digits = std::to_string(json.get<long long>());
  for (std::ptrdiff_t i = std::ptrdiff_t(digits.size()) - 3; i > (digits[0] == '-' ? 1 : 0); i -= 3)
    digits.insert(std::size_t(i), "\u202f");
  return digits;
}

std::string point(const Json& xyz) {
  return number(xyz[0].get<double>(), 5) + ", " + number(xyz[1].get<double>(), 5) + ", " +
         number(xyz[2].get<double>(), 5);
}

Table::Table(const std::string& caption, std::vector<std::string> headings)
    : caption_(caption)
    , headings_(std::move(headings)) {}

void Table::row(const std::vector<std::string>& cells) {
  rows_ += "<tr>";
  for (std::size_t i = 0; i < cells.size(); ++i)
    rows_ += i == 0 ? "<th scope=\"row\">" + cells[i] + "</th>"
                    : (headings_[i][0] == '#' ? "<td class=\"number\">" : "<td>") + cells[i] + "</td>";
  rows_ += "</tr>\n";
}

std::string Table::text() const {
  std::string head;
  for (const std::string& h : headings_)
    head += h[0] == '#' ? "<th scope=\"col\" class=\"number\">" + escaped_for_xml(h.substr(1)) + "</th>"
                        : "<th scope=\"col\">" + escaped_for_xml(h) + "</th>";
  return "<div class=\"scroll\" tabindex=\"0\" role=\"region\" aria-label=\"" + escaped_for_xml(caption_) +
         "\"><table><thead><tr>" + head + "</tr></thead>\n<tbody>\n" + rows_ + "</tbody></table></div>\n";
}

std::string section(const std::string& id, const std::string& title, const std::string& content) {
  return "<section id=\"" + id + "\"><h2>" + escaped_for_xml(title) + "</h2>\n" + content + "</section>\n";
}

std::string show_place(const Json& xyz, double radius, const std::string& of_what) {
  if (!xyz.is_array())
    return "";
  std::string at;
  for (const auto& x : xyz)
    at += (at.empty() ? "" : ",") + number(x.get<double>(), 9);
  return "<button type=\"button\" class=\"show\" hidden data-place=\"" + at + "\" data-radius=\"" + number(radius) +
         "\" aria-label=\"Show me " + escaped_for_xml(of_what) + "\">show me</button>";
}

std::string show_branch(std::size_t branch) {
  const std::string number = std::to_string(branch);
  return "<button type=\"button\" class=\"show\" hidden data-branch=\"" + number + "\" aria-label=\"Show me branch " +
         number + "\">show me</button>";
}

} // namespace html
