// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef TUBULAR_MESH_REPORT_JSON_H
#define TUBULAR_MESH_REPORT_JSON_H

#include <nlohmann/json.hpp>

#include <string>

typedef nlohmann::ordered_json Json;

/* As the text of a file; names and file names in it need not be UTF-8. */
inline std::string text_of(const Json& json) {
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

template <class Point> Json vector_of(const Point& p) {
  return {p.x(), p.y(), p.z()};
}

#endif // TUBULAR_MESH_REPORT_JSON_H
