// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Table.h"

#include "../../command_line/words.h"

#include <CGAL/Tubular_meshing/base/exceptions.h>
#include <CGAL/Tubular_meshing/base/utf_8.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>
#include <set>
#include <string>
#include <utility>
#include <vector>

using command_line::trimmed;
namespace tubular = CGAL::Tubular_meshing;

namespace {

std::string whole_file(const std::string& file) {
  errno = 0;
  std::ifstream in(file, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
  if (!in.good() && !in.eof())
    throw tubular::Input_error("The table \"" + file + "\" cannot be read: " + std::strerror(errno) + ".");
  if (tubular::internal::as_utf_8(text) != text)
    throw tubular::Input_error("The table \"" + file + "\" is not in UTF-8: save it so.");
  const bool has_mark = text.compare(0, 3, "\xEF\xBB\xBF") == 0;
  return text.substr(has_mark ? 3 : 0);
}

/* Reads the values of a table, row by row. */
class Row_reader {
public:
  Row_reader(const std::string& file, const std::string& text, char separator)
      : file_(file)
      , text_(text)
      , separator_(separator) {}

  // The next row that is not empty; false at the end.
  bool read(Table::Row& row) {
    while (at_ < text_.size()) {
      row = {line_, {}};
      read_row(row.values);
      if (std::any_of(row.values.begin(), row.values.end(), [](const std::string& v) { return !v.empty(); }))
        return true;
    }
    return false;
  }

private:
  void read_row(std::vector<std::string>& values) {
    for (;;) {
      values.push_back(trimmed(is_at('"') ? quoted_value() : plain_value()));
      if (!is_at(separator_))
        break;
      ++at_;
    }
    if (is_at('\r'))
      ++at_;
    if (is_at('\n'))
      ++at_;
    ++line_;
  }

  bool is_at(char c) const { return at_ < text_.size() && text_[at_] == c; }

  std::string plain_value() {
    const std::size_t end = (std::min)(text_.find_first_of(std::string("\r\n") + separator_, at_), text_.size());
    const std::string value = text_.substr(at_, end - at_);
    at_ = end;
    return value;
  }

  // Two quotes in it stand for one.
  std::string quoted_value() {
    const std::size_t first_line = line_;
    std::string value;
    for (++at_; at_ < text_.size(); ++at_) {
      if (text_[at_] == '"') {
        ++at_;
        if (!is_at('"'))
          return value + plain_value();
      }
      line_ += text_[at_] == '\n';
      value += text_[at_];
    }
    throw tubular::Input_error("Line " + std::to_string(first_line) + " of the table \"" + file_ +
                               "\" has a double quote that is not closed.");
  }

  const std::string &file_, &text_;
  char separator_;
  std::size_t at_ = 0, line_ = 1;
};

void check_columns(const std::string& file, const std::vector<std::string>& columns) {
  std::set<std::string> known;
  for (const std::string& column : columns)
    if (!column.empty() && !known.insert(column).second)
      throw tubular::Input_error("The table \"" + file + "\" has two columns \"" + column + "\".");
}

void fit(const std::string& file, std::size_t columns, Table::Row& row) {
  const auto end = row.values.end();
  if (row.values.size() > columns &&
      std::any_of(row.values.begin() + long(columns), end, [](const std::string& v) { return !v.empty(); }))
    throw tubular::Input_error("Line " + std::to_string(row.line) + " of the table \"" + file + "\" has " +
                               std::to_string(row.values.size()) + " values for " + std::to_string(columns) +
                               " columns: values with a separator in them need double quotes.");
  row.values.resize(columns);
}

} // namespace

Table read_table(const std::string& file, const std::string& needed_column) {
  const std::string text = whole_file(file);
  for (char separator : {',', ';', '\t'}) {
    Row_reader reader(file, text, separator);
    Table::Row row;
    if (!reader.read(row) || std::find(row.values.begin(), row.values.end(), needed_column) == row.values.end())
      continue;
    Table table;
    table.columns = row.values;
    check_columns(file, table.columns);
    while (reader.read(row)) {
      fit(file, table.columns.size(), row);
      table.rows.push_back(std::move(row));
    }
    if (table.rows.empty())
      throw tubular::Input_error("The table \"" + file + "\" has no rows but that of its columns.");
    return table;
  }
  const std::string begin = trimmed(text).substr(0, trimmed(text).find_first_of("\r\n")).substr(0, 200);
  throw tubular::Input_error("The table \"" + file + "\" has no column \"" + needed_column + "\"; its first line is " +
                             (begin.empty() ? "empty." : "\"" + begin + "\"."));
}
