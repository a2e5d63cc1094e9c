// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef TUBULAR_MESHING_PYTHON_VIEWS_H
#define TUBULAR_MESHING_PYTHON_VIEWS_H

#include <CGAL/Tubular_meshing/base/Kernel.h>

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

namespace py = pybind11;

/* NumPy arrays that show the memory of C++ objects, without a copy: they keep the object of Python that owns it, and
 * cannot be written to. */
template <class T>
py::array read_only_view(const T* data, const std::vector<py::ssize_t>& shape, const py::handle& owner) {
  py::array_t<T> array(shape, data, owner);
  array.attr("setflags")(py::arg("write") = false);
  return std::move(array);
}

template <class T> py::array view_of(const std::vector<T>& values, const py::handle& owner) {
  return read_only_view(values.data(), {py::ssize_t(values.size())}, owner);
}

// One row an element.
template <class T, std::size_t N>
py::array view_of(const std::vector<std::array<T, N>>& rows, const py::handle& owner) {
  return read_only_view(reinterpret_cast<const T*>(rows.data()), {py::ssize_t(rows.size()), py::ssize_t(N)}, owner);
}

inline py::array view_of(const std::vector<CGAL::Tubular_meshing::Point_3>& points, const py::handle& owner) {
  static_assert(sizeof(CGAL::Tubular_meshing::Point_3) == 3 * sizeof(double), "a point is its coordinates");
  return read_only_view(reinterpret_cast<const double*>(points.data()), {py::ssize_t(points.size()), 3}, owner);
}

/* Arrays that take the memory of a vector over. */
template <class T> py::array_t<T> array_of(std::vector<T> values) {
  auto* kept = new std::vector<T>(std::move(values));
  const py::capsule owner(kept, [](void* p) { delete static_cast<std::vector<T>*>(p); });
  return py::array_t<T>({py::ssize_t(kept->size())}, kept->data(), owner);
}
template <class T, std::size_t N> py::array_t<T> array_of(std::vector<std::array<T, N>> rows) {
  auto* kept = new std::vector<std::array<T, N>>(std::move(rows));
  const py::capsule owner(kept, [](void* p) { delete static_cast<std::vector<std::array<T, N>>*>(p); });
  return py::array_t<T>({py::ssize_t(kept->size()), py::ssize_t(N)}, reinterpret_cast<const T*>(kept->data()), owner);
}

// A point, or a vector, as an array of three.
template <class Point> py::array_t<double> array_of_coordinates(const Point& p) {
  return array_of(std::vector<double>{p.x(), p.y(), p.z()});
}

#endif // TUBULAR_MESHING_PYTHON_VIEWS_H
