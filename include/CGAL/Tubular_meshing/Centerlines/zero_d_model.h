// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_CENTERLINES_ZERO_D_MODEL_H
#define CGAL_TUBULAR_MESHING_CENTERLINES_ZERO_D_MODEL_H

#include <CGAL/Tubular_meshing/Centerlines/Centerline_graph.h>
#include <CGAL/Tubular_meshing/Centerlines/cross_sections.h>
#include <CGAL/Tubular_meshing/base/Opening.h>
#include <CGAL/Tubular_meshing/base/config.h>

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace CGAL::Tubular_meshing {

/*! \ingroup PkgTubularMeshingCenterlines
 *
 * What make_zero_d_model() needs to know of blood, walls and flow: in centimetres, grams and seconds, as
 * svZeroDSolver's models are. */
struct Zero_d_options {
  double length_unit = 1;      ///< that of the graph, in cm: 0.1 where it is in millimetres
  double density = 1.06;       ///< of blood, g/cm³
  double viscosity = 0.04;     ///< dynamic, of blood, g/(cm s)
  double youngs_modulus = 4e6; ///< of the wall, dyn/cm²
  /// The wall's thickness at a section, in the unit of the graph; none: a fifth of the section's radius.
  std::function<double(const Cross_section&)> wall_thickness;
  double flow_rate = 0;          ///< at the inlet, cm³/s; 0: that of a wall shear stress of 15 dyn/cm² there
  bool murray = false;           ///< whether outlets have resistances by Murray's law; else their pressure is 0
  double murray_exponent = 3;    ///< flow goes with this power of the outlet's radius
  double mean_pressure = 133322; ///< at the outlets, by which these resistances are set, dyn/cm²: 100 mmHg
};

/*! \ingroup PkgTubularMeshingCenterlines
 * A branch of a zero-dimensional model: a resistance and an inductance in series, and a capacitance. */
struct Zero_d_vessel {
  std::size_t branch = 0; ///< of the graph, and its number in the model
  double length = 0;      ///< cm
  double resistance = 0;  ///< dyn s/cm⁵
  double capacitance = 0; ///< cm⁵/dyn
  double inductance = 0;  ///< dyn s²/cm⁵
  std::string inlet;      ///< the boundary condition at its source, if there is one
  std::string outlet;     ///< and at its target
};

/*! \ingroup PkgTubularMeshingCenterlines
 * Where vessels meet. */
struct Zero_d_junction {
  std::vector<std::size_t> inlets, outlets; ///< vessels that end and that begin there
};

/*! \ingroup PkgTubularMeshingCenterlines
 * What is known where a vessel ends. */
struct Zero_d_boundary_condition {
  enum Type { flow, pressure, resistance };

  std::string name; ///< that of the opening; blind_1, blind_2, … of ends that are none
  Type type = flow;
  double value = 0; ///< cm³/s, dyn/cm² or dyn s/cm⁵
};

/*! \ingroup PkgTubularMeshingCenterlines
 * A zero-dimensional, or lumped-parameter, model of vessels: an electric circuit, with pressure for voltage and flow
 * for current. IO::write_zero_d_model() writes it for svZeroDSolver. */
struct Zero_d_model {
  std::vector<Zero_d_vessel> vessels; ///< one a branch, in their order
  std::vector<Zero_d_junction> junctions;
  std::vector<Zero_d_boundary_condition> boundary_conditions;
  double density = 0, viscosity = 0;          ///< as they were given
  double flow_rate = 0;                       ///< at the first inlet, cm³/s
  std::vector<std::string> openings_left_out; ///< at which no branch ends, or another opening's does
};

/*! \ingroup PkgTubularMeshingCenterlines
 *
 * makes a zero-dimensional model of vessels from their cross-sections. With the radius r of the disk of a section's
 * area, the thickness h of the wall and Young's modulus E, as SimVascular has it,
 *
 * \f[ R = \int \frac{8 \mu}{\pi r^4} \, ds, \qquad C = \int \frac{3 \pi r^3}{2 E h} \, ds, \qquad
 *     L = \int \frac{\rho}{\pi r^2} \, ds \f]
 *
 * along each branch, for a radius, and a ratio of h to r, that are linear between sections and beyond the last ones:
 * of tubes and tapers the integrals are exact. Where a section is next to a bifurcation and cuts several vessels at
 * once, or there is none, the inscribed radius is taken.
 *
 * Each branch is a vessel, from its source to its target; each node where several meet a junction. The first opening is
 * the inlet, of a given flow; at the others the pressure is 0, or, if it is asked for, there is a resistance by Murray's
 * law \cgalCite{murray1926}: flow goes with a power of the radius, so that outlet i has
 * \f$ R_i = (p / Q) \sum_j r_j^m / r_i^m \f$. Ends that are no openings let nothing through.
 *
 * \param graph the branches
 * \param openings those of the vessels: their `node` and `name` are used; the first is the inlet
 * \param sections those of all branches, in order, see cross_sections()
 * \param options the fluid, the wall, and what is at the ends
 * \param inlets the openings that are inlets, where there are several vessels; else the first
 *
 * \throws Parameter_error if a value is not above 0
 * \throws Input_error if a branch has no section of positive radius, the thickness of a wall is not above 0, or no
 *   branch ends at an inlet
 */
Zero_d_model make_zero_d_model(const Centerline_graph& graph, const std::vector<Opening>& openings,
                               const std::vector<Cross_section>& sections,
                               const Zero_d_options& options = Zero_d_options(),
                               const std::vector<std::size_t>& inlets = {0});

} // namespace CGAL::Tubular_meshing

#ifdef CGAL_TUBULAR_MESHING_HEADER_ONLY
#include <CGAL/Tubular_meshing/Centerlines/zero_d_model_impl.h>
#endif

#endif // CGAL_TUBULAR_MESHING_CENTERLINES_ZERO_D_MODEL_H
