// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_IO_INTERNAL_OUTPUT_SET_H
#define CGAL_TUBULAR_MESHING_IO_INTERNAL_OUTPUT_SET_H

#include <CGAL/Tubular_meshing/IO/Output_file.h>

#include <cstddef>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing::IO::internal {

/* Files and folders that are written all or none. */
class Output_set : public Output {
public:
  explicit Output_set(const std::string& name)
      : name_(name) {}
  // Folders that the first has made for all of them go with it.
  ~Output_set() override {
    while (!outputs_.empty())
      outputs_.pop_back();
  }

  const std::string& name() const override { return name_; }

  template <class T> T& add(std::unique_ptr<T> output) {
    T& added = *output;
    outputs_.push_back(std::move(output));
    return added;
  }
  std::size_t size() const { return outputs_.size(); }
  Output& operator[](std::size_t i) { return *outputs_[i]; }

  void finish() override {
    for (auto& o : outputs_)
      o->finish();
  }
  // None gets its name before all are whole. What is named last stands for the set: the others are there by then.
  void commit() override {
    finish();
    for (auto o = outputs_.rbegin(); o != outputs_.rend(); ++o)
      (*o)->commit();
  }

private:
  std::string name_;
  std::vector<std::unique_ptr<Output>> outputs_;
};

} // namespace CGAL::Tubular_meshing::IO::internal

#endif // CGAL_TUBULAR_MESHING_IO_INTERNAL_OUTPUT_SET_H
