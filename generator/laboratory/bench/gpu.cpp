// SPDX-License-Identifier: GPL-2.0-or-later
#include "laboratory/bench/gpu.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <sstream>

#include "base/diagnostics/diagnostics.hpp"
#include "base/system/process.hpp"
#include "base/system/temporary_folder.hpp"
#include "code/emit/name_space.hpp"
#include "code/emit/packed_places.hpp"
#include "code/lower/arguments.hpp"
#include "laboratory/bench/gpu_states.hpp"
#include "robot/model/identifiers.hpp"
#include "templates.hpp"
#include "truth/reference/graph_evaluator.hpp"

namespace flatdyn {
namespace {

std::string header_file(const GpuSubject& subject, const std::string& scalar) {
  return subject.name + "_" + scalar + ".cuh";
}

// The state at which the program has these inputs.
StateOf<Real50> program_state(const Mechanism& mechanism, const Function& function, std::size_t number) {
  StateOf<Real50> state;
  int input = 0;
  for (const InputKind kind : function.inputs) {
    std::vector<Real50>& entries = state.of(kind);
    const int length = input_argument(kind, JointCounts(mechanism), function).length;
    entries.resize(static_cast<std::size_t>(length));
    for (int k = 0; k < length; ++k) entries[static_cast<std::size_t>(k)] = number_at(number, input, k);
    ++input;
  }
  return state;
}

std::string as_bytes(const std::vector<double>& numbers) {
  return {reinterpret_cast<const char*>(numbers.data()), numbers.size() * sizeof(double)};
}

// The values at all states; zeros, which are not compared, where the function has none.
std::string reference_of(const Mechanism& mechanism, const Function& function) {
  GraphEvaluator<Real50> evaluate(function);
  std::vector<double> written;
  for (std::size_t number = 0; number < reference_states; ++number) {
    const auto found = evaluate(program_state(mechanism, function, number));
    const std::vector<Real50> values = found.value_or(std::vector<Real50>(entry_count(function), Real50(0)));
    for (const Real50& value : values) {
      const auto high = static_cast<double>(value);
      written.push_back(high);
      written.push_back(static_cast<double>(value - high));
    }
  }
  return as_bytes(written);
}

bool can_be_packed_further(const Function& function) {
  return std::any_of(function.outputs.begin(), function.outputs.end(),
                     [&function](const Output& output) { return !is_identity(packed_places(output, function.graph)); });
}

std::string nvcc() {
  const char* const given = std::getenv("NVCC");
  return given == nullptr || *given == '\0' ? "nvcc" : given;
}

// The cells of "| a | b |"; none if the line is no row of a table.
std::vector<std::string> cells_of(const std::string& line) {
  std::vector<std::string> cells;
  if (!line.starts_with("| ")) return cells;
  for (std::size_t begin = 2; begin < line.size();) {
    const std::size_t end = std::min(line.find(" |", begin), line.size());
    cells.push_back(line.substr(begin, end - begin));
    begin = end + 3;
  }
  return cells;
}

GpuRow row_of(const std::vector<std::string>& cells) {
  return {cells[0],
          cells[1],
          cells[2],
          cells[3],
          std::stod(cells[4]),
          std::stoi(cells[5]),
          std::stol(cells[6]),
          std::stod(cells[7]),
          std::stod(cells[8]),
          std::stoi(cells[9]),
          std::stod(cells[10])};
}

}  // namespace

std::string gpu_name(const Mechanism& mechanism) {
  return namespace_of(mechanism.name, "") + (mechanism.floating_base ? "_floating" : "");
}

void check_for_gpu(const Mechanism& mechanism) {
  if (!mechanism.symbols.empty()) {
    throw Failure(FailureKind::unsupported, mechanism.name + ": bench --gpu has no values for its free symbols",
                  "give them values in the robot file");
  }
  if (input_argument(InputKind::q, JointCounts(mechanism), 0).length > 0) return;
  throw Failure(FailureKind::unsupported, mechanism.name + ": bench --gpu is for robots with joints",
                "call its functions from a program of yours: docs/cuda.md");
}

std::vector<SourceFile> gpu_files(const GpuSubject& subject) {
  std::vector<SourceFile> files = {{header_file(subject, "float"), subject.of_float},
                                   {header_file(subject, "double"), subject.of_double}};
  for (const Function& function : subject.functions) {
    files.push_back({fmt::format("{}.{}.reference", subject.name, cpp_identifier(function.name)),
                     reference_of(subject.mechanism, function)});
  }
  return files;
}

std::string gpu_cases(const GpuSubject& subject) {
  std::string lines;
  for (const Function& function : subject.functions) {
    for (const char* scalar : {"float", "double"}) {
      lines += fmt::format("{0} {1} {0} {2} {3} {4}\n", subject.name, header_file(subject, scalar),
                           cpp_identifier(function.name), can_be_packed_further(function) ? "Packed<Tiles>" : "Tiles",
                           scalar);
    }
  }
  return lines;
}

std::vector<SourceFile> gpu_program(const std::string& cases) {
  std::vector<SourceFile> files = {{"cases", cases},
                                   {"run", templates::gpu_run},
                                   {"bench.cu", templates::gpu_bench_cu},
                                   {"copy.cu", templates::gpu_copy_cu},
                                   {"gpu_states.hpp", templates::gpu_states}};
  for (const templates::Header& header : templates::headers) {
    if (std::string(header.path) == "flatdyn/cuda_batch.cuh") files.push_back({header.path, header.text});
  }
  return files;
}

void require_gpu() {
  const std::string compiler = nvcc();
  const TemporaryFolder folder;
  constexpr const char* kElsewhere =
      "or prepare a folder for another machine: flatdyn bench ROBOT --gpu --prepare -o FOLDER";
  if (run_command(shell_word(compiler) + " --version > log 2>&1", folder.path()) != 0) {
    throw Failure(FailureKind::io, fmt::format("bench --gpu needs nvcc, and \"{}\" cannot be run", compiler),
                  fmt::format("install CUDA 12 or later and name its compiler in $NVCC, {}", kElsewhere));
  }
  write_file(folder.path() / "copy.cu", templates::gpu_copy_cu);
  const auto first_line_of_log = [&folder] {
    std::istringstream log(content_of_file(folder.path() / "log"));
    std::string line;
    std::getline(log, line);
    return line;
  };
  if (run_command(shell_word(compiler) + " -O3 -arch=native copy.cu -o copy > log 2>&1", folder.path()) != 0) {
    throw Failure(FailureKind::io, fmt::format("bench --gpu: \"{}\" cannot compile: {}", compiler, first_line_of_log()),
                  "a compiler of the host that is too new for it is a common reason; name another nvcc in $NVCC");
  }
  if (run_command("./copy > log 2>&1", folder.path()) != 0) {
    throw Failure(FailureKind::io,
                  fmt::format("bench --gpu needs a device that CUDA can use, with 4 GB of memory that is free: {}",
                              first_line_of_log()),
                  fmt::format("run it where nvidia-smi shows one, {}", kElsewhere));
  }
}

GpuReport read_gpu_report(const std::string& printed) {
  constexpr std::size_t kCells = 11;
  GpuReport report;
  std::istringstream lines(printed);
  for (std::string line; std::getline(lines, line);) {
    const std::vector<std::string> cells = cells_of(line);
    if (cells.size() == kCells && cells[0] != "robot") {
      report.rows.push_back(row_of(cells));
    } else if (line.find(": a copy moves ") != std::string::npos) {
      report.device = line;
    } else if (!line.starts_with("|")) {
      report.failures.push_back(line);
    }
  }
  return report;
}

}  // namespace flatdyn
