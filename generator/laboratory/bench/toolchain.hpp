// SPDX-License-Identifier: GPL-2.0-or-later
// The machine's compiler and the libraries that it finds.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "base/system/process.hpp"

namespace flatdyn {

struct Toolchain {
  std::string compiler;    // $CXX or c++
  bool has_xsimd = false;  // for batches
  bool has_eigen = false;  // for the recursive reference
  bool has_kdl = false;    // Orocos KDL
  bool has_mujoco = false;
  bool has_dart = false;
  std::string
      peers_folder;  // $FLATDYN_PEERS: Pinocchio and its recorders, as scripts/bench --peers builds them; or empty

  // The version, such as "g++ (Debian 12.2.0-14+deb12u1) 12.2.0".
  std::string version() const;
};

// Finds the compiler. Throws Failure(io) if there is none.
Toolchain find_toolchain();

// The compiler flags for timed generated code, which round as it is written (docs/generated-code.md).
inline constexpr const char* kNativeFlags = "-std=c++17 -O3 -march=native -ffp-contract=off -fno-tree-slp-vectorize";
// The flag that suits generated code behind -march=native: g++ that tunes for recent processors keeps doubles in
// general registers, and moves them back and forth. Empty where it is not known.
#if defined(__x86_64__) || defined(__i386__)
inline constexpr const char* kTuning = "-mtune=generic";
#else
inline constexpr const char* kTuning = "";
#endif
// Both.
std::string bench_flags();

struct CompileJob {
  std::string stem, flags;
};

// Compiles folder/STEM.cpp to folder/STEM.o for all jobs in parallel. Throws Failure(bug) with the compiler's messages.
void compile_objects(const Toolchain& toolchain, const std::filesystem::path& folder,
                     const std::vector<CompileJob>& jobs);

// Runs a command in the folder that prints a source file, and writes it there. Throws Failure(bug) with its messages.
void record_source(const std::filesystem::path& folder, const std::string& command, const std::string& file);

struct CompilerUsage {
  double seconds = 0;       // processor time, s
  long peak_kilobytes = 0;  // memory of its largest process
};

// Compiles folder/STEM.cpp alone; the folder holds the sources of the benchmark's program.
CompilerUsage compiler_usage(const Toolchain& toolchain, const std::filesystem::path& folder, const CompileJob& job);

// Links the objects to folder/program.
void link_program(const Toolchain& toolchain, const std::filesystem::path& folder,
                  const std::vector<std::string>& stems, const std::string& libraries);

}  // namespace flatdyn
