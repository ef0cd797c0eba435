// SPDX-License-Identifier: GPL-2.0-or-later
// The benchmark on a graphics processor: a folder with the CUDA form of robots, a program that measures it and what its
// functions have to be, and what that program prints.
#pragma once

#include <string>
#include <vector>

#include "graph/function.hpp"
#include "laboratory/bench/sources.hpp"
#include "robot/model/mechanism.hpp"

namespace flatdyn {

// One robot in that folder.
struct GpuSubject {
  std::string name;  // of its files and namespace: "panda", "quadruped12_floating"
  const Mechanism& mechanism;
  const std::vector<Function>& functions;
  std::string of_float, of_double;  // headers in CUDA, divided among kernels for these scalars
};

// The name of the robot's files and of the namespace in its headers.
std::string gpu_name(const Mechanism& mechanism);

// Throws Failure(unsupported) for robots with free symbols or without joints: the program has no values for the former,
// and nothing to vary for the latter.
void check_for_gpu(const Mechanism& mechanism);

// The robot's headers, and of each function the values in 50 digits at the states of the program, two doubles for each
// entry, whose sum it is.
std::vector<SourceFile> gpu_files(const GpuSubject& subject);

// The robot's lines of the file "cases": name, header, namespace, function, layout, scalar. Layouts are packed where
// that leaves out entries.
std::string gpu_cases(const GpuSubject& subject);

// The program, with these cases: "run" compiles and runs all of them.
std::vector<SourceFile> gpu_program(const std::string& cases);

// Throws Failure(io), with what is missing, if there is no nvcc ($NVCC or nvcc) or no device that CUDA can use.
void require_gpu();

// One line of what "run" prints.
struct GpuRow {
  std::string robot, function, layout, scalar;
  double time = 0;  // of one state among many, ns
  int registers = 0;
  long local_bytes = 0;   // memory of a thread for registers that are put aside
  double throughput = 0;  // of inputs and outputs, GB/s
  double error = 0;       // the largest, in last places of the scalar, relative to the output's largest entry
  int kernels = 0;
  double single = 0;  // time of one state by a graph, us
};

struct GpuReport {
  std::string device;
  std::vector<GpuRow> rows;
  std::vector<std::string> failures;  // lines about cases that could not be compiled or run
};

// Reads what "run" printed.
GpuReport read_gpu_report(const std::string& printed);

}  // namespace flatdyn
