// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_BASE_EXCEPTIONS_H
#define CGAL_TUBULAR_MESHING_BASE_EXCEPTIONS_H

#include <stdexcept>
#include <string>

namespace CGAL {
namespace Tubular_meshing {

/*! \ingroup PkgTubularMeshingRef
 *
 * The base of all exceptions of this package. what() is one sentence, meant for the person at the keyboard: what is
 * wrong, where (file and line, byte, vertex or face), and what to do about it.
 */
class Error : public std::runtime_error {
public:
  explicit Error(const std::string& sentence)
      : std::runtime_error(sentence) {}
};

/*! \ingroup PkgTubularMeshingRef
 *
 * The input cannot be read, or cannot be used: a broken file, a surface or centerlines that do not fit together.
 */
class Input_error : public Error {
public:
  explicit Input_error(const std::string& sentence)
      : Error(sentence) {}
};

/*! \ingroup PkgTubularMeshingRef
 *
 * An option has a value outside its documented range.
 */
class Parameter_error : public Error {
public:
  explicit Parameter_error(const std::string& sentence)
      : Error(sentence) {}
};

/*! \ingroup PkgTubularMeshingRef
 *
 * The input is usable, but no valid mesh came out of it.
 */
class Meshing_error : public Error {
public:
  explicit Meshing_error(const std::string& sentence)
      : Error(sentence) {}
};

/*! \ingroup PkgTubularMeshingRef
 *
 * A file cannot be written. The file that was there before, if any, is as it was.
 */
class Output_error : public Error {
public:
  explicit Output_error(const std::string& sentence)
      : Error(sentence) {}
};

} // namespace Tubular_meshing
} // namespace CGAL

#endif // CGAL_TUBULAR_MESHING_BASE_EXCEPTIONS_H
