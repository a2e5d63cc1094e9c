// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_IO_INTERNAL_HDF5_WRITER_H
#define CGAL_TUBULAR_MESHING_IO_INTERNAL_HDF5_WRITER_H

#ifdef CGAL_TUBULAR_MESHING_WITH_HDF5

#include <CGAL/Tubular_meshing/IO/Output_file.h>
#include <CGAL/Tubular_meshing/IO/internal/refuse.h>

#include <hdf5.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace CGAL::Tubular_meshing::IO::internal {

// Data sets of a new HDF5 file, each a table of numbers that are made one after the other and not kept.
class Hdf5_writer {
public:
  explicit Hdf5_writer(Output_file& file)
      : name_(file.name()) {
    const std::string path = file.name_for_library();
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr); // errors become exceptions, not text
    file_ = H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT);
    check(file_);
  }
  Hdf5_writer(const Hdf5_writer&) = delete;
  ~Hdf5_writer() {
    if (file_ >= 0)
      H5Fclose(file_);
  }

  // f() gives the next of rows x columns numbers, row after row.
  template <class T, class F> void table(const std::string& path, std::size_t rows, std::size_t columns, F f) {
    const hsize_t size[2] = {rows, columns};
    const hid_t groups = H5Pcreate(H5P_LINK_CREATE);
    H5Pset_create_intermediate_group(groups, 1);
    const hid_t space = H5Screate_simple(columns == 1 ? 1 : 2, size, nullptr);
    const hid_t set = H5Dcreate2(file_, path.c_str(), type(T()), space, groups, H5P_DEFAULT, H5P_DEFAULT);
    herr_t status = set < 0 ? -1 : 0;
    std::vector<T> part;
    const std::size_t most = (std::max)(std::size_t(1), (std::size_t(1) << 17) / columns); // rows at a time
    for (std::size_t row = 0; row < rows && status >= 0; row += most) {
      const hsize_t begin[2] = {row, 0}, count[2] = {(std::min)(most, rows - row), columns};
      part.resize(std::size_t(count[0]) * columns);
      for (T& value : part)
        value = f();
      const hid_t memory = H5Screate_simple(columns == 1 ? 1 : 2, count, nullptr);
      H5Sselect_hyperslab(space, H5S_SELECT_SET, begin, nullptr, count, nullptr);
      status = H5Dwrite(set, type(T()), memory, space, H5P_DEFAULT, part.data());
      H5Sclose(memory);
    }
    if (set >= 0 && H5Dclose(set) < 0)
      status = -1;
    H5Sclose(space);
    H5Pclose(groups);
    check(status);
  }

  void close() {
    const hid_t file = file_;
    file_ = -1;
    check(H5Fclose(file));
  }

private:
  static hid_t type(double) { return H5T_NATIVE_DOUBLE; }
  static hid_t type(std::int32_t) { return H5T_NATIVE_INT32; }

  template <class Status> void check(Status status) const {
    if (status < 0)
      refuse(name_, "HDF5 failed to write it", "check its directory, its permissions and the free space");
  }

  const std::string name_;
  hid_t file_ = -1;
};

} // namespace CGAL::Tubular_meshing::IO::internal

#endif // CGAL_TUBULAR_MESHING_WITH_HDF5

#endif // CGAL_TUBULAR_MESHING_IO_INTERNAL_HDF5_WRITER_H
