// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_BASE_EXCEPTIONS_H
#define CGAL_TUBULAR_MESHING_BASE_EXCEPTIONS_H

#include <CGAL/Tubular_meshing/base/Sentence.h>

#include <stdexcept>
#include <string>
#include <vector>

namespace CGAL::Tubular_meshing {

/*! \ingroup PkgTubularMeshingBase
 *
 * The base of all exceptions of this package. what() is one sentence, meant for the person at the keyboard: what is
 * wrong, where (file and line, byte, vertex or face), and what to do about it.
 */
class Error : public std::runtime_error {
public:
  explicit Error(const Sentence& sentence)
      : std::runtime_error("")
      , sentence_(sentence)
      , what_(sentence.str()) {}

  const char* what() const noexcept override { return what_.c_str(); }

  /// The places that the sentence names, in the frame of the surface; none for most.
  std::vector<Place> places() const { return sentence_.places(); }

  /// The stage of a Mesher in which it happened, as its observer receives it; empty outside of one.
  const std::string& stage() const { return stage_; }
  void set_stage(const std::string& stage) { stage_ = stage; }

  /// Brings the places that the sentence names into another frame.
  template <class Map> void transform_places(const Map& map) {
    sentence_.transform(map);
    what_ = sentence_.str();
  }

private:
  Sentence sentence_;
  std::string what_, stage_;
};

/*! \ingroup PkgTubularMeshingBase
 *
 * The input cannot be read, or cannot be used: a broken file, a surface or centerlines that do not fit together.
 */
class Input_error : public Error {
public:
  using Error::Error;
};

/*! \ingroup PkgTubularMeshingBase
 *
 * An option has a value outside its documented range.
 */
class Parameter_error : public Error {
public:
  using Error::Error;
};

/*! \ingroup PkgTubularMeshingBase
 *
 * The input is usable, but no valid mesh came out of it.
 */
class Meshing_error : public Error {
public:
  using Error::Error;
};

/*! \ingroup PkgTubularMeshingBase
 *
 * A file cannot be written. The file that was there before, if any, is as it was.
 */
class Output_error : public Error {
public:
  using Error::Error;
};

} // namespace CGAL::Tubular_meshing

#endif // CGAL_TUBULAR_MESHING_BASE_EXCEPTIONS_H
