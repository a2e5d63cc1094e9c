// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "errors.h"

#include <CGAL/Tubular_meshing/base/exceptions.h>

#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <exception>
#include <new>

namespace py = pybind11;
namespace tubular = CGAL::Tubular_meshing;

namespace {

void raise(const char* type, const tubular::Error& e) {
  try {
    const py::object make = py::module_::import("tubular_meshing._errors").attr("error_of");
    const py::object error = make(type, e.what(), e.places(), e.stage());
    PyErr_SetObject(reinterpret_cast<PyObject*>(Py_TYPE(error.ptr())), error.ptr());
  } catch (py::error_already_set& failure) {
    failure.restore();
  }
}

} // namespace

void translate_errors() {
  py::register_exception_translator([](std::exception_ptr p) {
    try {
      std::rethrow_exception(p);
    } catch (const tubular::Input_error& e) {
      raise("InputError", e);
    } catch (const tubular::Parameter_error& e) {
      raise("ParameterError", e);
    } catch (const tubular::Meshing_error& e) {
      raise("MeshingError", e);
    } catch (const tubular::Output_error& e) {
      raise("OutputError", e);
    } catch (const tubular::Error& e) {
      raise("Error", e);
    } catch (const std::bad_alloc&) {
      PyErr_SetString(PyExc_MemoryError, "There is not enough memory; make the result coarser.");
    }
  });
}
