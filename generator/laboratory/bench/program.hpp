// SPDX-License-Identifier: GPL-2.0-or-later
// The benchmark of one robot as a separate program: text in a folder, compiled by the machine's compiler.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "laboratory/bench/sources.hpp"

namespace flatdyn {

// A function in one variant, or of a peer.
struct BenchCase {
  std::size_t function = 0;  // index of the function
  std::string variant;       // name of the variant or the peer
  std::string scalar = "double";
  bool is_peer = false;
  BenchVariant of = {};                     // empty for a peer
  std::optional<CalledFunction> call = {};  // none for a peer

  // The name in the program: "gravity/batch-double".
  std::string name(const std::vector<Function>& functions) const { return functions[function].name + "/" + variant; }
};

class BenchProgram {
 public:
  // Writes, compiles and links the program. The objects that the subject refers to must outlive it.
  BenchProgram(const BenchSubject& subject, std::filesystem::path folder);

  const std::vector<BenchCase>& cases() const { return cases_; }

  // Entries of all outputs at the first `states` states, one vector per case.
  std::vector<std::vector<double>> values(std::size_t states) const;
  // Samples of the time of one call in ns, by name of the case or of the stages' step. Takes about `seconds`.
  std::map<std::string, std::vector<double>> times(double seconds, unsigned seed) const;
  // Bytes of machine code per case, without the functions that it calls; 0 for a peer.
  std::vector<long> sizes() const;
  // Compiles the generated functions alone, each once per variant.
  CompilerUsage compilation() const;

 private:
  void build() const;
  std::map<std::string, std::size_t> index_by_name() const;

  BenchSubject subject_;
  std::filesystem::path folder_;
  std::vector<BenchCase> cases_;
};

}  // namespace flatdyn
