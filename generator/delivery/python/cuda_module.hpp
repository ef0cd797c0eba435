// SPDX-License-Identifier: GPL-2.0-or-later
// A robot's dynamics on a graphics processor for Python: a module over the array interface of CUDA, and the launchers
// that it calls by ctypes.
#pragma once

#include <string>
#include <vector>

#include "code/languages/emit.hpp"

namespace flatdyn {

struct CudaPythonModule {
  std::string module;     // NAME.py
  std::string launchers;  // NAME_python.cu
};

// `options`: those with which the CUDA form was emitted. Throws Failure(usage) for robots with free symbols.
CudaPythonModule cuda_python_module(const Mechanism& mechanism, const std::vector<Function>& functions,
                                    const EmitOptions& options);

}  // namespace flatdyn
