// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_BASE_ESCAPED_FOR_XML_H
#define CGAL_TUBULAR_MESHING_BASE_ESCAPED_FOR_XML_H

#include <CGAL/Tubular_meshing/base/utf_8.h>

#include <string>
#include <string_view>

namespace CGAL::Tubular_meshing::internal {

/* A text for XML or HTML, between tags or in double quotes as the value of an attribute: in UTF-8, with a blank for
 * characters that control, which no such text may hold. */
inline std::string escaped_for_xml(std::string_view text) {
  std::string out;
  for (char c : as_utf_8(text))
    switch (c) {
    case '&':
      out += "&amp;";
      break;
    case '<':
      out += "&lt;";
      break;
    case '>':
      out += "&gt;";
      break;
    case '"':
      out += "&quot;";
      break;
    default:
      out += static_cast<unsigned char>(c) < ' ' && c != '\n' && c != '\t' ? ' ' : c;
    }
  return out;
}

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_BASE_ESCAPED_FOR_XML_H
