// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_KEPT_BOUNDARY_FAILURE_SENTENCE_H
#define CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_KEPT_BOUNDARY_FAILURE_SENTENCE_H

#include <CGAL/Tubular_meshing/Volume/internal/kept_boundary/Child_process.h>
#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/base/Sentence.h>
#include <CGAL/Tubular_meshing/base/Vector_3d.h>
#include <CGAL/Tubular_meshing/base/crossing_pairs.h>

#include <csignal>
#include <cstring>
#include <string>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

// What went wrong with a recovery of the boundary, as the second half of a sentence; the codes are TetGen's.
inline std::string what_went_wrong(const Child_ending& ending) {
  const std::string code = std::to_string(ending.code);
  if (ending.kind == Child_ending::no_child)
    return std::string("no process could be started for it (") + std::strerror(ending.code) + ")";
  if (ending.kind == Child_ending::killed)
    switch (ending.code) {
    case SIGXCPU:
      return "it did not come to an end in the time it was given";
    case SIGKILL:
    case SIGPIPE: // this process could not take the result
      return "there was not enough memory";
    default:
      return "it crashed (signal " + code + ")";
    }
  switch (ending.code) {
  case out_of_memory_code:
    return "there was not enough memory";
  case 2:
    return "it met an error of its own";
  case crossing_facets_code:
    return "it found facets that cross or overlap";
  case 4:
    return "the surface has details too small for it";
  case 5:
    return "two facets are too close to each other for it";
  case 10:
    return "it found the input wrong";
  default:
    return "it gave up (code " + code + ")";
  }
}

// Where the surface crosses itself, as a clause that begins with a colon; empty if it does not.
inline Sentence where_it_crosses_itself(const Surface& surface) {
  const Face_pairs pairs = crossing_pairs(surface);
  if (pairs.empty())
    return "";
  const Vector_3d place(surface.point(surface.target(surface.halfedge(pairs.front().first))));
  return Sentence(": the surface crosses itself at ") + std::to_string(pairs.size()) +
         (pairs.size() == 1 ? " pair" : " pairs") + " of triangles, the first at " + place_of(place);
}

// What goes wrong is most often that the surface crosses itself, whatever the recovery says.
inline Sentence failure_sentence(const std::string& name, const Child_ending& ending, const Surface& surface,
                                 const std::string& instead) {
  const Sentence crossing = ending.kind == Child_ending::no_child ? Sentence("") : where_it_crosses_itself(surface);
  return Sentence(name + " could not fill this surface, " + what_went_wrong(ending)) + crossing +
         ((crossing.places().empty() ? ": " : "; repair it, or ") + instead + ".");
}

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_KEPT_BOUNDARY_FAILURE_SENTENCE_H
