// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "../../command_line/words.h"
#include "Batch_row.h"
#include "Digest.h"
#include "Job_options.h"
#include "Table.h"

#include <CGAL/Tubular_meshing/base/exceptions.h>

#include <fnmatch.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <system_error>
#include <vector>

namespace tubular = CGAL::Tubular_meshing;
namespace fs = std::filesystem;

namespace {

const std::set<std::string> endings = {".stl", ".off", ".obj", ".ply", ".vtp", ".vtu", ".vtk", ".msh", ".mesh"};

constexpr const char* plain_characters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789._-";

// The name itself if it is fit for files, else what is fit of it, and a digest.
std::string id_of(const std::string& name) {
  const std::size_t most = 100, most_of_others = 60, digits = 12;
  const bool is_plain = !name.empty() && name.size() <= most && std::isalnum(static_cast<unsigned char>(name[0])) &&
                        name.find_first_not_of(plain_characters) == name.npos;
  if (is_plain)
    return name;
  std::string fit;
  for (char c : name)
    if (std::string(plain_characters).find(c) != std::string::npos)
      fit += c;
    else if (fit.empty() || fit.back() != '_')
      fit += '_';
  fit = fit.substr(fit.size() - (std::min)(fit.size(), most_of_others));
  fit.erase(0, fit.find_first_not_of("._-"));
  fit.erase(fit.find_last_not_of("._-") + 1);
  return (fit.empty() ? "surface" : fit) + "-" + digest(name).substr(0, digits);
}

std::string without_ending(const std::string& file) {
  return fs::path(file).replace_extension().string();
}

Batch_row row_of(const fs::path& folder, const std::string& given, const std::string& name) {
  Batch_row row;
  row.given = given;
  row.name = name;
  row.id = id_of(name);
  row.folder = (fs::current_path() / folder).string(); // the folder of a table here has no name
  row.surface = (fs::path(row.folder) / given).lexically_normal().string();
  return row;
}

// ---- folders

bool is_surface(const fs::path& file) {
  std::string ending = file.extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(), [](unsigned char c) { return char(std::tolower(c)); });
  return endings.count(ending) > 0;
}

bool is_hidden(const fs::path& path) {
  return path.filename().string()[0] == '.';
}

std::vector<std::string> surfaces_of(const fs::path& folder, const Options& o) {
  std::error_code error;
  std::vector<std::string> found;
  fs::recursive_directory_iterator end;
  for (fs::recursive_directory_iterator i(folder, fs::directory_options::skip_permission_denied, error);
       !error && i != end; i.increment(error)) {
    const fs::path& path = i->path();
    std::error_code ignored;
    if (i->is_directory(ignored)) { // the results of this batch or another are no surfaces of it
      if (is_hidden(path) || fs::equivalent(path, o.output, ignored) || fs::exists(path / ".status", ignored))
        i.disable_recursion_pending();
      continue;
    }
    const std::string given = path.lexically_relative(folder).string();
    if (is_surface(path) && !is_hidden(path) && fnmatch(o.batch.pattern.c_str(), given.c_str(), 0) == 0)
      found.push_back(given);
  }
  if (error)
    throw tubular::Input_error("The folder \"" + folder.string() + "\" cannot be searched: " + error.message() + ".");
  std::sort(found.begin(), found.end());
  return found;
}

std::vector<Batch_row> rows_of_folder(const Options& o) {
  const fs::path folder = o.batch.surfaces;
  std::error_code ignored;
  if (fs::equivalent(folder, o.output, ignored))
    throw tubular::Parameter_error("The results would be among the surfaces: give another folder by --output.");
  const std::vector<std::string> found = surfaces_of(folder, o);
  if (found.empty())
    throw tubular::Input_error("The folder \"" + folder.string() + "\" has no surfaces" +
                               (o.batch.pattern == "*" ? "" : " of the pattern " + o.batch.pattern) +
                               ": .stl .off .obj .ply .vtp .vtu .vtk .msh .mesh.");
  std::map<std::string, int> number;
  for (const std::string& given : found)
    ++number[without_ending(given)];
  std::vector<Batch_row> rows;
  for (const std::string& given : found) {
    rows.push_back(row_of(folder, given, number[without_ending(given)] > 1 ? given : without_ending(given)));
    rows.back().place = "\"" + given + "\"";
  }
  return rows;
}

// ---- tables

// The options of a table's columns, by column; empty for those that are none.
std::vector<std::string> options_of_columns(const std::string& file, const Table& table, const Known_options& known) {
  std::vector<std::string> options;
  for (const std::string& column : table.columns) {
    const bool is_other =
        column.empty() || column[0] == '#' || column == "surface" || column == "name" || column == "options";
    options.push_back(is_other ? "" : known.name_of(column));
    if (!is_other && options.back().empty())
      throw tubular::Input_error(
          "The table \"" + file + "\" has a column \"" + column +
          "\", which is no option that a surface of a batch can have (see --help); if it is to be "
          "shown on the page alone, call it \"#" +
          column + "\".");
  }
  return options;
}

// Adds an option with the value that a table has; several of one that is repeatable are separated by spaces.
void add_option(const std::string& name, const std::string& value, const Known_options& known, Batch_row& row) {
  std::string lower = value;
  std::transform(lower.begin(), lower.end(), lower.begin(), [](unsigned char c) { return char(std::tolower(c)); });
  const bool is_true = lower == "true" || lower == "yes" || lower == "1";
  const bool is_false = lower == "false" || lower == "no" || lower == "0";
  if (value.empty())
    return;
  if (known.is_flag(name)) {
    if (!is_true && !is_false)
      row.problem = "\"" + value + "\" in the column of --" + name + " is neither yes nor no.";
    row.options.push_back("--" + name + (is_false ? "=false" : ""));
    return;
  }
  std::vector<std::string> values;
  if (!known.is_repeatable(name))
    values = {value};
  else if (!command_line::split_words(value, values))
    row.problem = "\"" + value + "\" in the column of --" + name + " has a quote that is not closed.";
  for (const std::string& v : values)
    row.options.push_back("--" + name + "=" + v);
}

Batch_row row_of_table(const Options& o, const Table& table, const Table::Row& values,
                       const std::vector<std::string>& option_of_column, const Known_options& known) {
  std::map<std::string, std::string> own;
  for (std::size_t c = 0; c < table.columns.size(); ++c)
    own[table.columns[c]] = values.values[c];
  const std::string& given = own["surface"];
  if (given.empty())
    throw tubular::Input_error("Line " + std::to_string(values.line) + " of the table \"" + o.batch.surfaces +
                               "\" names no surface.");
  std::string name = without_ending(given);
  name.erase(0, (std::min)(name.find_first_not_of('/'), name.size()));
  Batch_row row = row_of(fs::path(o.batch.surfaces).parent_path(), given, own["name"].empty() ? name : own["name"]);
  row.place = "line " + std::to_string(values.line);
  if (!command_line::split_words(own["options"], row.options))
    row.problem = "The options cannot be split into words, since a quote is not closed: " + own["options"];
  for (std::size_t c = 0; c < table.columns.size(); ++c) {
    if (!option_of_column[c].empty())
      add_option(option_of_column[c], values.values[c], known, row);
    else if (!table.columns[c].empty() && table.columns[c][0] == '#')
      row.shown.emplace_back(table.columns[c].substr(1), values.values[c]);
  }
  return row;
}

std::vector<Batch_row> rows_of_table(const Options& o) {
  const Table table = read_table(o.batch.surfaces, "surface");
  const Known_options known;
  const std::vector<std::string> option_of_column = options_of_columns(o.batch.surfaces, table, known);
  std::vector<Batch_row> rows;
  for (const Table::Row& values : table.rows)
    rows.push_back(row_of_table(o, table, values, option_of_column, known));
  return rows;
}

} // namespace

std::vector<Batch_row> read_rows(const Options& options) {
  std::error_code ignored;
  const bool is_folder = fs::is_directory(options.batch.surfaces, ignored);
  std::vector<Batch_row> rows = is_folder ? rows_of_folder(options) : rows_of_table(options);
  std::map<std::string, const Batch_row*> known;
  for (const Batch_row& row : rows) {
    const auto [other, is_new] = known.emplace(row.id, &row);
    if (!is_new)
      throw tubular::Input_error("Of \"" + options.batch.surfaces + "\", " + other->second->place + " and " +
                                 row.place + " have the same name, " + row.name +
                                 ", hence the same output: give each a name of its own in the column \"name\".");
  }
  return rows;
}
