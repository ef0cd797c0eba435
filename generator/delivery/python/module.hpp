// SPDX-License-Identifier: GPL-2.0-or-later
// A robot's dynamics for Python: a module that calls, by ctypes and numpy, the shared library compiled from the C form.
#pragma once

#include <string>
#include <vector>

#include "code/languages/emit.hpp"

namespace flatdyn {

struct PythonModule {
  std::string module;  // NAME.py
  std::string batch;   // NAME_batch.c: each function for many states in one call
};

// Makes the module. `options`: those with which the C form was emitted.
PythonModule python_module(const Mechanism& mechanism, const std::vector<Function>& functions,
                           const EmitOptions& options);

// The name of the module, "panda", whose library is "libpanda.so". Throws Failure(usage) if Python cannot import it.
std::string module_name(const Mechanism& mechanism, const EmitOptions& options);

}  // namespace flatdyn
