// SPDX-License-Identifier: GPL-2.0-or-later
// A robot's dynamics for Python: a module over the shared library that the C form is compiled to, by ctypes and numpy.
#pragma once

#include <string>
#include <vector>

#include "emit/emit.hpp"

namespace flatdyn {

struct PythonModule {
  std::string module;  // NAME.py
  std::string batch;   // NAME_batch.c: every function for many states in one call
};

// `options` are those that the C form was emitted with.
PythonModule python_module(const Mechanism& mechanism, const std::vector<Function>& functions,
                           const EmitOptions& options);

// "panda": of the module, and of the library in "libpanda.so". Throws Failure(usage) if Python cannot import that.
std::string module_name(const Mechanism& mechanism, const EmitOptions& options);

}  // namespace flatdyn
