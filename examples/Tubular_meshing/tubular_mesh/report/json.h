// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef TUBULAR_MESH_REPORT_JSON_H
#define TUBULAR_MESH_REPORT_JSON_H

#include <nlohmann/json.hpp>

typedef nlohmann::ordered_json Json;

template <class Point> Json vector_of(const Point& p) {
  return {p.x(), p.y(), p.z()};
}

#endif // TUBULAR_MESH_REPORT_JSON_H
