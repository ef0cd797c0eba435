// SPDX-License-Identifier: GPL-2.0-or-later
#include "laboratory/bench/program.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <sstream>

#include "base/diagnostics/diagnostics.hpp"
#include "base/system/temporary_folder.hpp"
#include "laboratory/bench/calls.hpp"

namespace flatdyn {
namespace {

namespace fs = std::filesystem;

void check(int status, const fs::path& folder) {
  if (status == 0) return;
  const std::string messages = content_of_file(folder / "log");
  check_room(folder, messages);
  throw Failure(FailureKind::bug, fmt::format("the benchmark's program ended with {}\n{}", status, messages));
}

// The cases: the generated functions in all variants, then the peers'.
std::vector<BenchCase> cases_of(const BenchSubject& subject) {
  std::vector<BenchCase> cases;
  for (std::size_t k = 0; k < subject.functions.size(); ++k) {
    for (const BenchVariant& variant : subject.variants) {
      std::optional<CalledFunction> called = called_function(subject, k, variant);
      if (called) cases.push_back({k, variant.name, variant.scalar, false, variant, std::move(called)});
    }
    for (const BenchPeer& peer : subject.peers) {
      if (peer.functions.count(subject.functions[k].name) > 0) cases.push_back({k, peer.name, "double", true, {}, {}});
    }
  }
  return cases;
}

// The names of the functions of the subject that a peer has.
std::vector<std::string> functions_of(const BenchSubject& subject, const BenchPeer& peer) {
  std::vector<std::string> names;
  for (const Function& function : subject.functions) {
    if (peer.functions.count(function.name) > 0) names.push_back(function.name);
  }
  return names;
}

// Parses lines such as "0000 001a W void robot::gravity<double>(double const*, double*)": sizes by the name before the
// arguments.
std::map<std::string, long> bytes_by_symbol(const std::string& text) {
  std::map<std::string, long> bytes;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    std::string address, size, type, name;
    std::istringstream words(line);
    if (!(words >> address >> size >> type) || !std::getline(words >> std::ws, name)) continue;
    const std::size_t dot = name.find(kBenchNamespace + std::string("::"));
    const std::size_t first = dot == std::string::npos ? 0 : dot;
    bytes[name.substr(first, name.find('(') - first)] = std::stol(size, nullptr, 16);
  }
  return bytes;
}

// The entry of a template's instance: "robot::gravity<double>", or one that begins so if the list of its arguments is
// open: "robot::kernels::gravity<double, ".
std::map<std::string, long>::const_iterator find_template(const std::map<std::string, long>& bytes,
                                                          const std::string& name) {
  if (name.back() == '>') return bytes.find(name);
  const auto next = bytes.lower_bound(name);
  return next != bytes.end() && next->first.starts_with(name) ? next : bytes.end();
}

}  // namespace

BenchProgram::BenchProgram(const BenchSubject& subject, fs::path folder)
    : subject_(subject), folder_(std::move(folder)), cases_(cases_of(subject)) {
  for (const SourceFile& file : bench_sources(subject)) {
    const fs::path path = folder_ / file.path;
    fs::create_directories(path.parent_path());
    write_file(path, file.text);
  }
  build();
}

void BenchProgram::build() const {
  std::vector<CompileJob> jobs = {{"sizes", bench_flags()}, {"robot", bench_flags()}, {"main", "-std=c++17 -O1"}};
  std::vector<std::string> linked = {"main", "robot"};
  if (has_native_cases(subject_)) {
    jobs.push_back({"native", kNativeFlags});
    linked.emplace_back("native");
  }
  std::string libraries;
  for (const BenchPeer& peer : subject_.peers) {
    if (!peer.recorder.empty()) {
      record_source(folder_, fmt::format("{} {}", peer.recorder, fmt::join(functions_of(subject_, peer), " ")),
                    peer.include);
    }
    jobs.push_back({peer.stem, peer.flags});
    linked.push_back(peer.stem);
    libraries += " " + peer.libraries;
  }
  compile_objects(subject_.toolchain, folder_, jobs);
  link_program(subject_.toolchain, folder_, linked, libraries);
}

CompilerUsage BenchProgram::compilation() const {
  return compiler_usage(subject_.toolchain, folder_, {"sizes", bench_flags()});
}

std::map<std::string, std::size_t> BenchProgram::index_by_name() const {
  std::map<std::string, std::size_t> index;
  for (std::size_t k = 0; k < cases_.size(); ++k) index[cases_[k].name(subject_.functions)] = k;
  return index;
}

std::vector<std::vector<double>> BenchProgram::values(std::size_t states) const {
  check(run_command(fmt::format("./program values {} > names 2> log", states), folder_), folder_);
  const std::map<std::string, std::size_t> index = index_by_name();
  const std::string bytes = content_of_file(folder_ / "values");
  std::vector<std::vector<double>> values(cases_.size());
  std::istringstream names(content_of_file(folder_ / "names"));
  std::size_t offset = 0;
  for (std::string name; std::getline(names, name);) {
    const std::size_t k = index.at(name), count = states * entry_count(subject_.functions[cases_[k].function]);
    values[k].resize(count);
    bytes.copy(reinterpret_cast<char*>(values[k].data()), count * sizeof(double), offset);
    offset += count * sizeof(double);
  }
  if (offset != bytes.size())
    throw Failure(FailureKind::bug, "the benchmark's program wrote other values than expected");
  return values;
}

std::map<std::string, std::vector<double>> BenchProgram::times(double seconds, unsigned seed) const {
  check(run_command(fmt::format("./program times {} {} > times 2> log", seconds, seed), folder_, true), folder_);
  std::map<std::string, std::vector<double>> samples;
  std::istringstream lines(content_of_file(folder_ / "times"));
  for (std::string line; std::getline(lines, line);) {
    const std::size_t blank = line.rfind(' ');
    samples[line.substr(0, blank)].push_back(std::stod(line.substr(blank + 1)));
  }
  return samples;
}

std::vector<long> BenchProgram::sizes() const {
  check(run_command("nm -S -C --defined-only sizes.o > symbols 2> log", folder_), folder_);
  const std::map<std::string, long> bytes = bytes_by_symbol(content_of_file(folder_ / "symbols"));
  std::vector<long> sizes;
  for (const BenchCase& each : cases_) {
    if (each.is_peer || each.of.is_native) {
      sizes.push_back(0);
      continue;
    }
    const auto own = find_template(bytes, template_symbol(*each.call, each.of));
    sizes.push_back(own == bytes.end() ? bytes.at(plain_symbol(each.call->function, each.variant)) : own->second);
  }
  return sizes;
}

}  // namespace flatdyn
