// SPDX-License-Identifier: GPL-2.0-or-later
// The text of the benchmark's program.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "laboratory/bench/subject.hpp"

namespace flatdyn {

struct SourceFile {
  std::filesystem::path path;
  std::string text;
};

// All files of the program, with the states that it reads.
std::vector<SourceFile> bench_sources(const BenchSubject& subject);

// Whether native.cpp has cases, which are compiled without kTuning.
bool has_native_cases(const BenchSubject& subject);

// The header kKernelsHeader: the functions in CUDA, none of them in parts.
std::string kernels_header(const Mechanism& mechanism, const std::vector<Function>& functions);

}  // namespace flatdyn
