// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_BASE_PARAMETERS_H
#define CGAL_TUBULAR_MESHING_BASE_PARAMETERS_H

// What every caller of a function with named parameters meets besides.
#include <CGAL/Tubular_meshing/base/exceptions.h>
#include <CGAL/Tubular_meshing/base/labels.h>

#include <CGAL/Named_function_parameters.h>

namespace CGAL::Tubular_meshing {

namespace internal_np {

// One tag a parameter; the tag's only value is what get_parameter() is asked with.
#define CGAL_TUBULAR_MESHING_PARAMETER(name) enum name##_t{name};
#include <CGAL/Tubular_meshing/base/parameter_names.h>
#undef CGAL_TUBULAR_MESHING_PARAMETER

} // namespace internal_np

/*! \ingroup PkgTubularMeshingBase
 *
 * A sequence of named parameters that can be continued with this package's names: any function that takes CGAL's named
 * parameters takes it too. CGAL's own names may follow ours in a chain, not precede them:
 * `parameters::gradation(1.2).points_per_circumference(24).vertex_point_map(vpm)`.
 */
template <class T, class Tag, class Base = CGAL::internal_np::No_property>
struct Named_parameters : CGAL::Named_function_parameters<T, Tag, Base> {
  typedef CGAL::Named_function_parameters<T, Tag, Base> Cgal_parameters;

  explicit Named_parameters(const T& value)
      : Cgal_parameters(value) {}
  Named_parameters(const T& value, const Base& previous)
      : Cgal_parameters(value, previous) {}

#define CGAL_TUBULAR_MESHING_PARAMETER(name)                                                                           \
  template <class K> Named_parameters<K, internal_np::name##_t, Cgal_parameters> name(const K& value) const {          \
    return Named_parameters<K, internal_np::name##_t, Cgal_parameters>(value, *this);                                  \
  }
#include <CGAL/Tubular_meshing/base/parameter_names.h>
#undef CGAL_TUBULAR_MESHING_PARAMETER
};

/*! \ingroup PkgTubularMeshingBase
 *
 * The named parameters of the package as free functions, to start a chain with.
 */
namespace parameters {

#define CGAL_TUBULAR_MESHING_PARAMETER(name)                                                                           \
  template <class K> Named_parameters<K, internal_np::name##_t> name(const K& value) {                                 \
    return Named_parameters<K, internal_np::name##_t>(value);                                                          \
  }
#include <CGAL/Tubular_meshing/base/parameter_names.h>
#undef CGAL_TUBULAR_MESHING_PARAMETER

using CGAL::parameters::default_values;

} // namespace parameters

namespace internal {

// The value of a parameter, or the default, always by value: choose(np, internal_np::gradation, 1.3).
template <class NamedParameters, class Tag, class Default>
Default choose(const NamedParameters& np, Tag tag, const Default& default_value) {
  using CGAL::parameters::choose_parameter;
  using CGAL::parameters::get_parameter;
  return Default(choose_parameter(get_parameter(np, tag), default_value));
}

} // namespace internal
} // namespace CGAL::Tubular_meshing

#endif // CGAL_TUBULAR_MESHING_BASE_PARAMETERS_H
