// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_IO_INTERNAL_OUTPUT_FILE_H
#define CGAL_TUBULAR_MESHING_IO_INTERNAL_OUTPUT_FILE_H

#include <CGAL/Tubular_meshing/base/exceptions.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

namespace CGAL {
namespace Tubular_meshing {
namespace IO {

/*! \ingroup PkgTubularMeshingRef
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
  explicit Output_file(const std::string& file)
      : name_(file) {
    namespace fs = std::filesystem;
    std::error_code error;
    const fs::file_status status = fs::status(name_, error);
    if (name_.empty() || fs::is_directory(status))
      fail("it is not the name of a file");
    if (fs::exists(status) && !fs::is_regular_file(status)) {
      open(name_, "wb");
      return;
    }
    target_ = without_links(name_);
    if (fs::exists(status))
      check_existing();
    open_temporary();
    if (fs::exists(status))
      fs::permissions(temporary_, status.permissions(), error);
  }

  Output_file(const Output_file&) = delete;
  Output_file& operator=(const Output_file&) = delete;

  ~Output_file() { discard(); }

  const std::string& name() const { return name_; }

  void write(std::string_view bytes) {
    if (!bytes.empty() && std::fwrite(bytes.data(), 1, bytes.size(), stream_.get()) != bytes.size())
      fail_with_errno();
  }

  /*! A second file, which finish() and commit() take along: some formats keep a mesh in two. */
  Output_file& companion(const std::string& file) {
    companions_.push_back(std::make_unique<Output_file>(file));
    return *companions_.back();
  }

  /*! Closes the file; it is whole now, and only lacks its name. */
  void finish() {
    if (stream_) {
      errno = 0;
      const bool flushed = std::fflush(stream_.get()) == 0;
      const int reason = errno;
      const bool closed = std::fclose(stream_.release()) == 0;
      if (!flushed)
        errno = reason;
      if (!flushed || !closed)
        fail_with_errno();
    }
    for (const auto& c : companions_)
      c->finish();
  }

  /*! Finishes the file and gives it its name. */
  void commit() {
    finish();
    for (const auto& c : companions_)
      c->commit();
    if (temporary_.empty())
      return;
    std::error_code error;
    std::filesystem::rename(temporary_, target_, error);
    if (error)
      fail(error.message());
    temporary_.clear();
  }

private:
  struct Close {
    void operator()(std::FILE* f) const { std::fclose(f); }
  };

  // The file that a chain of symbolic links leads to, which need not exist.
  static std::filesystem::path without_links(std::filesystem::path file) {
    namespace fs = std::filesystem;
    std::error_code error;
    for (int i = 0; i < 40 && fs::is_symlink(fs::symlink_status(file, error)); ++i) {
      const fs::path next = fs::read_symlink(file, error);
      file = next.is_absolute() ? next : file.parent_path() / next;
    }
    return file;
  }

  // Renaming would replace a file that is write-protected; opening it for writing tells, and changes nothing.
  void check_existing() {
    errno = 0;
    const std::unique_ptr<std::FILE, Close> existing(std::fopen(target_.string().c_str(), "r+b"));
    if (!existing)
      fail_with_errno();
  }

  void open(const std::filesystem::path& file, const char* mode) {
    errno = 0;
    stream_.reset(std::fopen(file.string().c_str(), mode));
    if (!stream_)
      fail_with_errno();
  }

  // The first free of a thousand names: what a killed process left behind is not in the way.
  void open_temporary() {
    for (int i = 0; !stream_; ++i) {
      const std::filesystem::path file = target_.parent_path() / (".tubular_meshing_" + std::to_string(i) + ".partial");
      errno = 0;
      stream_.reset(std::fopen(file.string().c_str(), "wbx"));
      if (stream_)
        temporary_ = file;
      else if (errno != EEXIST || i == 1000)
        fail_with_errno();
    }
  }

  void discard() noexcept {
    stream_.reset();
    std::error_code ignored;
    if (!temporary_.empty())
      std::filesystem::remove(temporary_, ignored);
    temporary_.clear();
  }

  [[noreturn]] void fail_with_errno() { fail(errno != 0 ? std::strerror(errno) : "unknown reason"); }

  [[noreturn]] void fail(const std::string& reason) {
    discard();
    throw Output_error("The file \"" + name_ + "\" cannot be written (" + reason +
                       "); check its directory, its permissions and the free space.");
  }

  std::string name_;
  std::filesystem::path target_;
  std::filesystem::path temporary_; // empty: written directly, or done
  std::unique_ptr<std::FILE, Close> stream_;
  std::vector<std::unique_ptr<Output_file>> companions_;
};

/*! \ingroup PkgTubularMeshingRef
 * Throws Output_error if the file cannot be created or replaced: to learn it before hours of work, not after. Leaves
 * no trace. Devices and pipes pass. */
inline void check_writable(const std::string& file) {
  namespace fs = std::filesystem;
  std::error_code ignored;
  const fs::file_status status = fs::status(file, ignored);
  if (fs::exists(status) && !fs::is_regular_file(status) && !fs::is_directory(status))
    return;
  Output_file probe(file);
}

} // namespace IO
} // namespace Tubular_meshing
} // namespace CGAL

#endif // CGAL_TUBULAR_MESHING_IO_INTERNAL_OUTPUT_FILE_H
