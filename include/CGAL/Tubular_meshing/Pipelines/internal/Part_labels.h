// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_PIPELINES_INTERNAL_PART_LABELS_H
#define CGAL_TUBULAR_MESHING_PIPELINES_INTERNAL_PART_LABELS_H

#include <CGAL/Tubular_meshing/base/exceptions.h>
#include <CGAL/Tubular_meshing/base/labels.h>

#include <cstddef>
#include <numeric>
#include <string>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* The labels of one of several parts, as labels of the whole. */
class Part_labels {
public:
  Part_labels(const std::vector<std::size_t>& openings, std::size_t part)
      : part_(int(part))
      , openings_(int(openings[part]))
      , before_(int(std::accumulate(openings.begin(), openings.begin() + std::ptrdiff_t(part), std::size_t(0))))
      , outer_(outer_wall(openings_))
      , outer_of_all_(outer_wall(int(std::accumulate(openings.begin(), openings.end(), std::size_t(0))))) {}

  int operator()(int label) const {
    if (label < labels::inlet)
      return label; // wall
    if (label < labels::inlet + openings_)
      return label + before_;
    if (label < outer_)
      throw Input_error("A part has a patch of the label " + std::to_string(label) + ", but only " +
                        std::to_string(openings_) + " openings.");
    const int beyond = label - outer_;
    return outer_of_all_ + (beyond < labels::inlet ? beyond : (*this)(beyond));
  }

  /* The package's own names are numbered through, others stay. */
  std::string name(int label, const std::string& name) const {
    const bool is_ring = label >= outer_;
    const int i = (is_ring ? label - outer_ : label) - labels::inlet;
    if (i < 0 || i >= openings_ || part_ == 0)
      return name;
    const std::string kind = is_ring ? "_ring" : "";
    const std::string own = i == 0 ? "inlet" + kind : "outlet" + kind + "_" + std::to_string(i);
    if (name != own)
      return name;
    // outlets before: of each part all openings but one
    return i == 0 ? "inlet" + kind + "_" + std::to_string(part_ + 1)
                  : "outlet" + kind + "_" + std::to_string(before_ - part_ + i);
  }

private:
  static int outer_wall(int openings) { return labels::outer_wall_for(labels::wall + openings); }

  int part_, openings_, before_, outer_, outer_of_all_;
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_PIPELINES_INTERNAL_PART_LABELS_H
