// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_BASE_FUNCTION_VIEW_H
#define CGAL_TUBULAR_MESHING_BASE_FUNCTION_VIEW_H

#include <CGAL/Tubular_meshing/base/Kernel.h>

#include <memory>
#include <type_traits>
#include <utility>

namespace CGAL::Tubular_meshing::internal {

template <class Signature> class Function_view;

/* A function object by reference, its type erased: how a caller's field reaches the compiled core. Two pointers, no
 * allocation; a call costs about 2 ns. Whatever is called must outlive the view. */
template <class Result, class... Arguments> class Function_view<Result(Arguments...)> {
public:
  template <class Function, class = std::enable_if_t<!std::is_same<std::decay_t<Function>, Function_view>::value>>
  Function_view(const Function& function)
      : function_(std::addressof(function))
      , call_([](const void* f, Arguments... arguments) -> Result {
        return static_cast<Result>((*static_cast<const Function*>(f))(std::forward<Arguments>(arguments)...));
      }) {}

  Result operator()(Arguments... arguments) const { return call_(function_, std::forward<Arguments>(arguments)...); }

private:
  const void* function_;
  Result (*call_)(const void*, Arguments...);
};

/* The wanted length of edges at a point, or the local radius there. */
typedef Function_view<double(const Point_3&)> Length_function;

/* Lets a model of `MeshDomainField_3` that is only called with a dimension and an index, as Mesh_3 does it, be called
 * with a point alone. */
template <class Field> class Field_at_point {
public:
  explicit Field_at_point(const Field& field)
      : field_(&field) {}

  double operator()(const Point_3& p) const {
    if constexpr (std::is_invocable<const Field&, const Point_3&>::value)
      return double((*field_)(p));
    else
      return double((*field_)(p, 3, 0));
  }

private:
  const Field* field_;
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_BASE_FUNCTION_VIEW_H
