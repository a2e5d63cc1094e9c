// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_OPENINGS_INTERNAL_BLIND_LEAVES_H
#define CGAL_TUBULAR_MESHING_OPENINGS_INTERNAL_BLIND_LEAVES_H

#include <CGAL/Tubular_meshing/Centerlines/Centerline_graph.h>
#include <CGAL/Tubular_meshing/Openings/internal/Lumen_tree.h>
#include <CGAL/Tubular_meshing/Openings/internal/Round_end.h>
#include <CGAL/Tubular_meshing/base/Kernel.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

enum class Blind_end_kind { vessel, sac };

/* Tells the leaves of centerlines apart that lead to the tips of vessels, of sacs and of bumps.
 *
 * A leaf in a bump hardly gets out of the balls of the vessel that it sits on. These are taken off one after the other,
 * the lowest first: of several leaves in one dome or one sac the last one stays, from which the line then leads on to
 * the vessel. A sac is what is wide before a neck and not much longer than wide, and what sits on it, unless that goes
 * on at its radius: a vessel that leaves a sac, however short. */
class Blind_leaves {
public:
  struct Leaf {
    std::size_t node;
    Round_end shape;
    Blind_end_kind kind;
  };

  /* `fixed` are the leaves at openings. */
  Blind_leaves(const Centerline_graph& graph, const std::set<std::size_t>& fixed)
      : tree_(graph)
      , fixed_(fixed) {
    for (std::size_t n = 0; n < graph.nodes().size(); ++n)
      if (tree_.is_leaf(n) && fixed.count(n) == 0)
        measure(n);
    take_bumps();
  }

  /* In the order of their nodes. */
  std::vector<Leaf> leaves() const {
    std::vector<Leaf> result;
    for (const auto& m : measured_)
      result.push_back(Leaf{m.first, m.second.shape,
                            is_sac(m.first, m.second.shape) ? Blind_end_kind::sac : Blind_end_kind::vessel});
    return result;
  }

private:
  // In radii, between the places from which it narrows: those of a ball are half a radius apart.
  static constexpr double longest_sac = 2;
  // The same of what sits on a sac: if it is longer, it is a vessel that leaves the sac.
  static constexpr double longest_lobe = 1.5;
  // Of the radius of the sac below to that of its necks.
  static constexpr double min_ratio_under_lobe = 1.5;

  struct Measured {
    Round_end shape;
    double height; ///< over the other balls, as a multiple of what a vessel has at least
  };

  void measure(std::size_t leaf) {
    const Lumen_tree::Line line = tree_.line_from(leaf);
    const Round_end shape(line);
    const double height =
        line.ends_at_junction ? shape.height_over(tree_.balls_around(line)) : shape.length() / shape.radius();
    measured_.erase(leaf);
    measured_.emplace(leaf, Measured{shape, height});
    if (height < 1)
      bumps_.emplace(height, leaf);
  }

  void take_bumps() {
    while (!bumps_.empty()) {
      const std::size_t leaf = bumps_.begin()->second;
      bumps_.erase(bumps_.begin());
      const Lumen_tree::Line line = tree_.line_from(leaf);
      measured_.erase(leaf);
      if (!line.ends_at_junction)
        continue; // the last line has nothing that it could sit on
      tree_.take(leaf);
      for (std::size_t n : tree_.leaves_around(line.last_node))
        if (fixed_.count(n) == 0) {
          const auto known = measured_.find(n);
          if (known == measured_.end())
            continue;
          bumps_.erase({known->second.height, n});
          measure(n);
        }
    }
  }

  // The longer it is against its width, the narrower its neck has to be: a vessel may begin with a bulb, as the aorta
  // does.
  bool is_sac(std::size_t leaf, const Round_end& end) const {
    const Lumen_tree::Bulge bulge = tree_.bulge_at(leaf, Round_end::narrower);
    if (bulge.number_of_necks == 0 || bulge.length > longest_sac * bulge.radius)
      return false;
    const double level = end.level_length() / end.radius(), ratio = bulge.radius / bulge.neck;
    if (bulge.radius > Round_end::narrower * end.radius()) // the end sits on it
      return ratio > min_ratio_under_lobe && level < longest_lobe;
    const double least = (std::max)(Round_end::narrower, 1.05 + 0.25 * level);
    return level < longest_sac && ratio > (bulge.number_of_necks == 1 ? least : least + 0.1);
  }

  Lumen_tree tree_;
  const std::set<std::size_t> fixed_;
  std::map<std::size_t, Measured> measured_;
  std::set<std::pair<double, std::size_t>> bumps_; ///< the lowest first
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_OPENINGS_INTERNAL_BLIND_LEAVES_H
