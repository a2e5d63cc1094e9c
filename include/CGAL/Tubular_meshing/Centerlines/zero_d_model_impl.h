// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_CENTERLINES_ZERO_D_MODEL_IMPL_H
#define CGAL_TUBULAR_MESHING_CENTERLINES_ZERO_D_MODEL_IMPL_H

#include <CGAL/Tubular_meshing/Centerlines/Branch_curve.h>
#include <CGAL/Tubular_meshing/Centerlines/zero_d_model.h>
#include <CGAL/Tubular_meshing/base/Sentence.h>
#include <CGAL/Tubular_meshing/base/element_measures.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>
#include <CGAL/Tubular_meshing/base/labels.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing {
namespace internal {

class Zero_d_maker {
public:
  Zero_d_maker(const Centerline_graph& graph, const std::vector<Opening>& openings,
               const std::vector<Cross_section>& sections, const Zero_d_options& options,
               const std::vector<std::size_t>& inlets)
      : graph_(graph)
      , openings_(openings)
      , sections_(sections)
      , options_(options)
      , inlets_(inlets.begin(), inlets.end()) {
    check();
  }

  Zero_d_model make() {
    model_.density = options_.density;
    model_.viscosity = options_.viscosity;
    for (std::size_t b = 0; b < graph_.branches().size(); ++b)
      model_.vessels.push_back(vessel(b));
    add_junctions();
    add_boundary_conditions();
    return std::move(model_);
  }

private:
  struct Sample {
    double abscissa, radius, stiffness; // the last is the wall's thickness over the radius
  };

  void check() const {
    const std::pair<double, const char*> values[] = {{options_.length_unit, "unit of length"},
                                                     {options_.density, "density"},
                                                     {options_.viscosity, "viscosity"},
                                                     {options_.youngs_modulus, "Young's modulus"},
                                                     {options_.murray_exponent, "Murray's exponent"},
                                                     {options_.mean_pressure, "mean pressure"}};
    for (const auto& v : values)
      if (!(v.first > 0) || !std::isfinite(v.first))
        throw Parameter_error(std::string("The ") + v.second + " of a zero-dimensional model is " +
                              std::to_string(v.first) + ": it has to be above 0.");
    if (!(options_.flow_rate >= 0) || !std::isfinite(options_.flow_rate))
      throw Parameter_error("The flow rate of a zero-dimensional model is " + std::to_string(options_.flow_rate) +
                            ": it has to be above 0, or 0 for one that is found.");
  }

  // --- the integrals along a branch ---

  std::vector<Sample> samples_of(std::size_t b) const {
    const auto& branch = graph_.branches()[b];
    std::vector<Sample> samples;
    const auto first = std::lower_bound(sections_.begin(), sections_.end(), b,
                                        [](const Cross_section& s, std::size_t k) { return s.branch < k; });
    for (auto s = first; s != sections_.end() && s->branch == b; ++s)
      samples.push_back({s->abscissa, radius_of(*s, branch), 0});
    if (samples.empty()) { // shorter than it is wide
      Cross_section middle;
      const Branch_curve curve(graph_, b);
      middle.branch = b;
      middle.abscissa = 0.5 * branch.length;
      middle.point = middle.center = as<Point_3>(curve.point(middle.abscissa));
      middle.normal = as<Vector_3>(curve.tangent(middle.abscissa));
      middle.inscribed_radius = curve.radius(middle.abscissa);
      samples.push_back({middle.abscissa, middle.inscribed_radius, 0});
      samples.back().stiffness = stiffness(middle, samples.back().radius);
      return samples;
    }
    for (std::size_t i = 0; i < samples.size(); ++i)
      samples[i].stiffness = stiffness(*(first + std::ptrdiff_t(i)), samples[i].radius);
    return samples;
  }

  double radius_of(const Cross_section& s, const Centerline_graph::Branch& branch) const {
    const double radius = s.area > 0 && !cuts_several_vessels(s, branch) ? s.radius() : s.inscribed_radius;
    if (!(radius > 0))
      throw Input_error("At " + place_of(Vector_3d(s.point)) +
                        " the branch has neither a section nor a radius above 0.");
    return radius;
  }

  // Within two radii of a bifurcation, and much larger than the vessel.
  bool cuts_several_vessels(const Cross_section& s, const Centerline_graph::Branch& branch) const {
    if (!(s.area > 2 * pi * s.inscribed_radius * s.inscribed_radius))
      return false;
    const auto is_near = [&](std::size_t node, double distance) {
      const auto& n = graph_.nodes()[node];
      return !n.is_end() && distance < 2 * graph_.radii()[n.point];
    };
    return is_near(branch.source, s.abscissa) || is_near(branch.target, branch.length - s.abscissa);
  }

  double stiffness(const Cross_section& s, double radius) const {
    if (!options_.wall_thickness)
      return 0.2;
    const double thickness = options_.wall_thickness(s);
    if (!(thickness > 0) || !std::isfinite(thickness))
      throw Input_error("The wall's thickness at " + place_of(Vector_3d(s.point)) + " is " + std::to_string(thickness) +
                        ": a wall has one above 0.");
    return thickness / radius;
  }

  // Linear beyond the first and the last, as far as that makes sense.
  static void extend_to_ends(double length, std::vector<Sample>& samples) {
    const auto beyond = [](const Sample& a, const Sample& b, double abscissa) { // beyond a, away from b
      const double t = (abscissa - a.abscissa) / (a.abscissa - b.abscissa);
      const double radius = a.radius + t * (a.radius - b.radius);
      return Sample{abscissa, (std::min)((std::max)(radius, 0.8 * a.radius), 1.25 * a.radius), a.stiffness};
    };
    const std::size_t n = samples.size();
    const Sample front = n > 1 ? beyond(samples[0], samples[1], 0) : Sample{0, samples[0].radius, samples[0].stiffness};
    const Sample back = n > 1 ? beyond(samples[n - 1], samples[n - 2], length)
                              : Sample{length, samples[0].radius, samples[0].stiffness};
    samples.insert(samples.begin(), front);
    samples.push_back(back);
  }

  Zero_d_vessel vessel(std::size_t b) const {
    const double unit = options_.length_unit;
    std::vector<Sample> samples = samples_of(b);
    extend_to_ends(graph_.branches()[b].length, samples);
    Zero_d_vessel v;
    v.branch = b;
    v.length = unit * graph_.branches()[b].length;
    for (std::size_t i = 0; i + 1 < samples.size(); ++i) {
      const double h = unit * (samples[i + 1].abscissa - samples[i].abscissa), r = unit * samples[i].radius,
                   q = unit * samples[i + 1].radius;
      v.resistance += 8 * options_.viscosity / pi * h * (r * r + r * q + q * q) / (3 * std::pow(r * q, 3));
      v.inductance += options_.density / pi * h / (r * q);
      // r³ over the thickness is r² over the stiffness
      const double stiffness = 0.5 * (samples[i].stiffness + samples[i + 1].stiffness);
      v.capacitance += 3 * pi / (2 * options_.youngs_modulus * stiffness) * h * (r * r + r * q + q * q) / 3;
    }
    return v;
  }

  // --- the circuit ---

  void add_junctions() {
    std::vector<Zero_d_junction> at_node(graph_.nodes().size());
    for (std::size_t b = 0; b < graph_.branches().size(); ++b) {
      at_node[graph_.branches()[b].target].inlets.push_back(b);
      at_node[graph_.branches()[b].source].outlets.push_back(b);
    }
    for (std::size_t n = 0; n < at_node.size(); ++n)
      if (!graph_.nodes()[n].is_end())
        model_.junctions.push_back(std::move(at_node[n]));
  }

  // What the openings of one vessel, whose branches hang together, share.
  struct Vessel_ends {
    double flow = 0;  // of its inlets
    double power = 0; // sum of its outlets' radii, to Murray's power
  };

  void add_boundary_conditions() {
    std::map<std::size_t, std::size_t> opening_at; // by node
    for (std::size_t i = 0; i < openings_.size(); ++i) {
      const std::size_t node = openings_[i].node;
      if (node < graph_.nodes().size() && graph_.nodes()[node].is_end() && opening_at.emplace(node, i).second)
        continue;
      if (inlets_.count(i) != 0)
        throw Input_error("No centerline leads to " + name_of(i) +
                          ", where flow would come into the zero-dimensional model; give another inlet.");
      model_.openings_left_out.push_back(name_of(i));
    }
    const std::vector<std::size_t> component = components();
    std::map<std::size_t, Vessel_ends> ends; // by component
    for (const auto& o : opening_at) {
      Vessel_ends& e = ends[component[o.first]];
      if (inlets_.count(o.second) != 0)
        e.flow += flow_at(o.second);
      else
        e.power += power_of_radius(o.second);
    }
    std::set<std::string> used;
    std::size_t blind = 0;
    for (std::size_t n = 0; n < graph_.nodes().size(); ++n) {
      if (!graph_.nodes()[n].is_end())
        continue;
      const auto found = opening_at.find(n);
      Zero_d_boundary_condition condition;
      if (found == opening_at.end())
        condition.name = "blind_" + std::to_string(++blind);
      else
        condition = condition_of(found->second, ends[component[n]]);
      used.insert(condition.name = unused_name(condition.name, used));
      attach(condition, n);
      model_.boundary_conditions.push_back(std::move(condition));
    }
  }

  Zero_d_boundary_condition condition_of(std::size_t opening, const Vessel_ends& ends) {
    Zero_d_boundary_condition condition;
    condition.name = name_of(opening);
    if (inlets_.count(opening) != 0) {
      condition.value = flow_at(opening);
      if (model_.flow_rate == 0)
        model_.flow_rate = condition.value;
    } else if (options_.murray && ends.flow > 0) {
      condition.type = Zero_d_boundary_condition::resistance;
      condition.value = options_.mean_pressure / ends.flow * ends.power / power_of_radius(opening);
    } else
      condition.type = Zero_d_boundary_condition::pressure;
    return condition;
  }

  // One a node.
  std::vector<std::size_t> components() const {
    std::vector<std::size_t> root(graph_.nodes().size());
    for (std::size_t n = 0; n < root.size(); ++n)
      root[n] = n;
    const auto find = [&](std::size_t n) {
      while (root[n] != n)
        n = root[n] = root[root[n]];
      return n;
    };
    for (const auto& b : graph_.branches())
      root[find(b.source)] = find(b.target);
    for (std::size_t n = 0; n < root.size(); ++n)
      root[n] = find(n);
    return root;
  }

  double power_of_radius(std::size_t opening) const {
    return std::pow(options_.length_unit * openings_[opening].radius, options_.murray_exponent);
  }

  // Signs are for flow that comes in at a branch's source and leaves at its target.
  void attach(Zero_d_boundary_condition& condition, std::size_t n) {
    Zero_d_vessel& vessel = model_.vessels[graph_.nodes()[n].branches.front()];
    const bool is_source = graph_.branches()[vessel.branch].source == n;
    (is_source ? vessel.inlet : vessel.outlet) = condition.name;
    if ((is_source && condition.type == Zero_d_boundary_condition::resistance) ||
        (!is_source && condition.type == Zero_d_boundary_condition::flow))
      condition.value = -condition.value;
  }

  // What was given, or that of a usual wall shear stress τ: Q = π r³ τ / (4 μ).
  double flow_at(std::size_t opening) const {
    const double shear_stress = 15, radius = options_.length_unit * openings_[opening].radius;
    return options_.flow_rate > 0 ? options_.flow_rate
                                  : pi * radius * radius * radius * shear_stress / (4 * options_.viscosity);
  }

  std::string name_of(std::size_t opening) const {
    const Opening& o = openings_[opening];
    return !o.name.empty() ? o.name : opening == 0 ? "inlet" : "outlet_" + std::to_string(opening);
  }

  const Centerline_graph& graph_;
  const std::vector<Opening>& openings_;
  const std::vector<Cross_section>& sections_;
  const Zero_d_options& options_;
  const std::set<std::size_t> inlets_;
  Zero_d_model model_;
};

} // namespace internal

CGAL_TUBULAR_MESHING_INLINE Zero_d_model make_zero_d_model(const Centerline_graph& graph,
                                                           const std::vector<Opening>& openings,
                                                           const std::vector<Cross_section>& sections,
                                                           const Zero_d_options& options,
                                                           const std::vector<std::size_t>& inlets) {
  return internal::Zero_d_maker(graph, openings, sections, options, inlets).make();
}

} // namespace CGAL::Tubular_meshing

#endif // CGAL_TUBULAR_MESHING_CENTERLINES_ZERO_D_MODEL_IMPL_H
