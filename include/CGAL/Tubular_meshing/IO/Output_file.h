// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_IO_OUTPUT_FILE_H
#define CGAL_TUBULAR_MESHING_IO_OUTPUT_FILE_H

#include <CGAL/Tubular_meshing/base/config.h>

#include <cstdio>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace CGAL::Tubular_meshing::IO {

/*! \ingroup PkgTubularMeshingIO
 *
 * A file that is written whole or not at all.
 *
 * What is written goes into a temporary file in the same directory; commit() gives it its name, over a file that was
 * there before. Without commit(), the destructor removes the temporary, and the file that was there is as it was. A
 * symbolic link stays one: the file it leads to is replaced. A device, a pipe or a socket is written directly.
 *
 * To write several files all or none: write each, finish() each, and only then commit() each.
 *
 * Where a process may exceed a limit on file size or write into a closed pipe, it must ignore `SIGXFSZ` and `SIGPIPE`
 * to get an exception instead of a signal.
 *
 * \exception Output_error from every function but the destructor, with the system's reason
 */
class Output_file {
public:
  explicit Output_file(const std::string& file);
  Output_file(const Output_file&) = delete;
  Output_file& operator=(const Output_file&) = delete;
  ~Output_file() { discard(); }

  const std::string& name() const { return name_; }

  void write(std::string_view bytes);

  /*! A second file, which finish() and commit() take along: some formats keep a mesh in two. */
  Output_file& companion(const std::string& file);

  /*! Closes the file; it is whole now, and only lacks its name. */
  void finish();

  /*! Finishes the file and gives it its name. */
  void commit();

private:
  struct Close {
    void operator()(std::FILE* f) const { std::fclose(f); }
  };

  void check_existing();
  void open(const std::string& file, const char* mode);
  void open_temporary();
  void discard() noexcept;
  [[noreturn]] void fail_with_errno();
  [[noreturn]] void fail(const std::string& reason);

  std::string name_;
  std::string target_;
  std::string temporary_; // empty: written directly, or done
  std::unique_ptr<std::FILE, Close> stream_;
  std::vector<std::unique_ptr<Output_file>> companions_;
};

/*! \ingroup PkgTubularMeshingIO
 * Throws Output_error if the file cannot be created or replaced: to learn it before hours of work, not after. Leaves
 * no trace. Devices and pipes pass. */
void check_writable(const std::string& file);

} // namespace CGAL::Tubular_meshing::IO

#ifdef CGAL_TUBULAR_MESHING_HEADER_ONLY
#include <CGAL/Tubular_meshing/IO/Output_file_impl.h>
#endif

#endif // CGAL_TUBULAR_MESHING_IO_OUTPUT_FILE_H
