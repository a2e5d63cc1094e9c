// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_OPENINGS_INTERNAL_LABEL_ROLES_H
#define CGAL_TUBULAR_MESHING_OPENINGS_INTERNAL_LABEL_ROLES_H

#include <string>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

enum class Label_role { unknown, wall, opening, inlet };

/* The words of a name, in lower case: what digits, signs and changes from small to capital letters separate.
 * "Inlet-aorta", "inletAorta" and "INLET_AORTA2" all have the words inlet and aorta. */
inline std::vector<std::string> words_of(const std::string& name) {
  std::vector<std::string> words;
  bool in_word = false, was_small = false;
  for (char c : name) {
    const bool capital = c >= 'A' && c <= 'Z', small = c >= 'a' && c <= 'z';
    if (capital || small) {
      if (!in_word || (capital && was_small))
        words.emplace_back();
      words.back() += capital ? char(c - 'A' + 'a') : c;
    }
    in_word = capital || small;
    was_small = small;
  }
  return words;
}

/* What a name says. An end is called by what flows there, whatever it is an end of: "vessel_inlet" is one. */
inline Label_role role_of_name(const std::string& name) {
  const auto begins = [](const std::string& word, const char* with) { return word.rfind(with, 0) == 0; };
  Label_role role = Label_role::unknown;
  for (const std::string& w : words_of(name)) {
    if (begins(w, "inlet") || begins(w, "inflow"))
      return Label_role::inlet;
    if (begins(w, "outlet") || begins(w, "outflow") || w == "cap" || w == "caps" || w == "opening" || w == "openings")
      role = Label_role::opening;
    else if (role == Label_role::unknown && (begins(w, "wall") || begins(w, "vessel") || begins(w, "lumen")))
      role = Label_role::wall;
  }
  return role;
}

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_OPENINGS_INTERNAL_LABEL_ROLES_H
