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
 * What is written whole or not at all: an Output_file, or an Output_folder. Where it is destroyed before commit(),
 * nothing is left of it.
 */
class Output {
public:
  Output() = default;
  Output(const Output&) = delete;
  Output& operator=(const Output&) = delete;
  virtual ~Output() = default;

  /*! What was asked for, as it was given. */
  virtual const std::string& name() const = 0;
  /*! Closes everything; it is whole now, and only lacks its name. */
  virtual void finish() = 0;
  /*! Finishes it and gives it its name. */
  virtual void commit() = 0;
};

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
class Output_file : public Output {
public:
  explicit Output_file(const std::string& file)
      : Output_file(file, file) {}
  /*! A file that exceptions call otherwise, as part of something else. */
  Output_file(const std::string& file, const std::string& name);
  ~Output_file() override { discard(); }

  const std::string& name() const override { return name_; }

  void write(std::string_view bytes);

  /*! A second file, which finish() and commit() take along: some formats keep a mesh in two. */
  Output_file& companion(const std::string& file);

  /*! Whether it is a device, a pipe or a socket, which is written directly. */
  bool is_direct() const { return target_.empty(); }

  /*! Leaves the writing to a library that wants a name and makes the file itself.
   * \returns the name of the temporary file */
  std::string name_for_library();

  /*! Closes the file; it is whole now, and only lacks its name. */
  void finish() override;

  /*! Finishes the file and gives it its name. */
  void commit() override;

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
