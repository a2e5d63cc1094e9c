// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_IO_OUTPUT_FOLDER_H
#define CGAL_TUBULAR_MESHING_IO_OUTPUT_FOLDER_H

#include <CGAL/Tubular_meshing/IO/Output_file.h>
#include <CGAL/Tubular_meshing/base/config.h>

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

namespace CGAL::Tubular_meshing::IO {

/*! \ingroup PkgTubularMeshingIO
 *
 * A folder of files that is written whole or not at all.
 *
 * Its files go into a temporary folder beside it; commit() gives that the folder's name, in place of a folder that was
 * there before. Without commit(), the destructor removes the temporary, and the folder that was there is as it was.
 * Folders above it that are missing are made, and go again with the temporary. A symbolic link stays one.
 *
 * \exception Output_error from every function but the destructor
 */
class Output_folder : public Output {
public:
  /*! Whether a file, of which the path in the folder is given, may be there before and be replaced. */
  typedef bool (*Belongs)(const std::filesystem::path&);

  /*! A folder with files of another kind is not replaced: the exception names the first of them. */
  Output_folder(const std::string& folder, Belongs belongs);
  ~Output_folder() override { discard(); }

  const std::string& name() const override { return name_; }

  /*! Begins a file of the folder; folders in its path are made. One file is open at a time: the one before is
   * finished.*/
  Output_file& file(const std::string& path);

  /*! Where its files are until it has its name: for what is written by names of files. */
  const std::filesystem::path& folder() const { return temporary_; }

  void finish() override;
  void commit() override;

private:
  void check_existing();
  void make_parents();
  void make_temporary();
  std::filesystem::path sibling(int i) const;
  std::filesystem::path unused_sibling() const;
  void close();
  void discard() noexcept;
  void forget() noexcept;
  [[noreturn]] void fail(const std::string& reason);

  std::string name_;
  Belongs belongs_;
  std::filesystem::path target_, temporary_;   // empty: done
  std::vector<std::filesystem::path> parents_; // that were made, the innermost last
  std::unique_ptr<Output_file> file_;
};

} // namespace CGAL::Tubular_meshing::IO

#ifdef CGAL_TUBULAR_MESHING_HEADER_ONLY
#include <CGAL/Tubular_meshing/IO/Output_folder_impl.h>
#endif

#endif // CGAL_TUBULAR_MESHING_IO_OUTPUT_FOLDER_H
