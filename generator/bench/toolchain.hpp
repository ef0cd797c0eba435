// SPDX-License-Identifier: GPL-2.0-or-later
// The machine's compiler, and what is there for it to compile.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "system/process.hpp"

namespace flatdyn {

struct Toolchain {
  std::string compiler;    // $CXX or c++
  bool has_xsimd = false;  // for batches
  bool has_eigen = false;  // for the recursive reference
  bool has_kdl = false;    // Orocos KDL
  bool has_mujoco = false;
  bool has_dart = false;

  // "g++ (Debian 12.2.0-14+deb12u1) 12.2.0"
  std::string version() const;
};

// Throws Failure(io) where there is no compiler.
Toolchain find_toolchain();

// What generated code is timed with.
inline constexpr const char* kBenchFlags = "-std=c++17 -O3 -march=native -ffp-contract=off";

struct CompileJob {
  std::string stem, flags;
};

// Compiles folder/STEM.cpp to folder/STEM.o, all of them at the same time. Throws Failure(bug) with what the compiler
// says.
void compile_objects(const Toolchain& toolchain, const std::filesystem::path& folder,
                     const std::vector<CompileJob>& jobs);

struct CompilerUsage {
  double seconds = 0;       // of processor time
  long peak_kilobytes = 0;  // of its largest process
};

// Compiles folder/STEM.cpp alone; the folder has the sources of the benchmark's program.
CompilerUsage compiler_usage(const Toolchain& toolchain, const std::filesystem::path& folder, const CompileJob& job);

// Links folder/program.
void link_program(const Toolchain& toolchain, const std::filesystem::path& folder,
                  const std::vector<std::string>& stems, const std::string& libraries);

}  // namespace flatdyn
