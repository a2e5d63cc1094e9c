// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_IO_INTERNAL_CHECK_NAMES_H
#define CGAL_TUBULAR_MESHING_IO_INTERNAL_CHECK_NAMES_H

#include <CGAL/Tubular_meshing/IO/internal/Input_file.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>
#include <CGAL/Tubular_meshing/base/labels.h>

#include <string>

namespace CGAL::Tubular_meshing::IO::internal {

inline void check_names(const Label_names& names, const std::string& file) {
  for (const auto& n : names)
    for (char c : n.second)
      if (c == '"' || (c >= 0 && c < ' '))
        throw Output_error("The file " + quoted(file) + " cannot be written: the name of label " +
                           std::to_string(n.first) + " contains a quotation mark or a control character; rename it.");
}

} // namespace CGAL::Tubular_meshing::IO::internal

#endif // CGAL_TUBULAR_MESHING_IO_INTERNAL_CHECK_NAMES_H
