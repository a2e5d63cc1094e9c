// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "options.h"

#include "tubular_mesh/declare_options.h"

#include <CGAL/Tubular_meshing/base/exceptions.h>

#include <CLI/CLI.hpp>
#include <pybind11/stl.h>

#include <algorithm>

namespace {

// The options of the tool, with which a program can do without files.
void declare(CLI::App& app, Options& options) {
  declare_options(app, options, TUBULAR_MESHING_VERSION);
}

// Points and the like, which come as text with commas; repeatable ones take one value at a time.
bool is_repeatable(const CLI::Option& option) {
  return option.get_multi_option_policy() == CLI::MultiOptionPolicy::TakeAll;
}

py::dict description_of(const CLI::Option& option) {
  py::dict d;
  d["name"] = option.get_lnames().front();
  d["is_flag"] = option.get_items_expected_max() == 0;
  d["is_repeatable"] = is_repeatable(option);
  d["description"] = option.get_description();
  d["default"] = option.get_default_str();
  return d;
}

// Those of what is not made of arrays of cells with corners alone, of cases for solvers and reduced models, and of how the program tells
// what it does: only the program has them.
bool is_of_files_alone(const CLI::Option& option) {
  const std::string name = option.get_lnames().front();
  return name == "order" || name == "order-2-complete" || name == "partitions" || name == "dry-run" ||
         name == "log-json" || option.get_group() == batch_group || option.get_group() == case_group ||
         option.get_group() == reduced_model_group || option.get_group() == physics_group;
}

py::list descriptions() {
  CLI::App app;
  Options options;
  declare(app, options);
  py::list list;
  for (const CLI::Option* option : static_cast<const CLI::App&>(app).get_options()) {
    const bool is_of_terminal = option == app.get_help_ptr() || option == app.get_version_ptr();
    if (!is_of_terminal && !option->get_positional() && !option->get_lnames().empty() && !is_of_files_alone(*option))
      list.append(description_of(*option));
  }
  return list;
}

} // namespace

Options parse_options(std::vector<std::string> arguments) {
  CLI::App app;
  Options options;
  declare(app, options);
  std::reverse(arguments.begin(), arguments.end()); // the order in which CLI11 takes them
  try {
    app.parse(std::move(arguments));
  } catch (const CLI::ParseError& e) {
    throw CGAL::Tubular_meshing::Parameter_error(command_line::sentence_of(e));
  }
  return options;
}

void add_options(py::module_& module) {
  module.def("options", &descriptions);
  module.def("check_options", [](std::vector<std::string> arguments, bool has_output) {
    check(parse_options(std::move(arguments)), has_output);
  });
}
