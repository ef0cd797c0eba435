// SPDX-License-Identifier: GPL-2.0-or-later
#include "proof/verify/compiled.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <optional>

#include "base/system/process.hpp"
#include "base/system/shared_library.hpp"
#include "base/system/temporary_folder.hpp"
#include "code/languages/emit.hpp"
#include "code/lower/arguments.hpp"
#include "robot/model/identifiers.hpp"

namespace flatdyn {

namespace {

constexpr const char* kNamespace = "robot_under_test";

std::string call_text(const Mechanism& mechanism, const Function& function, const std::string& name_space) {
  std::vector<std::string> arguments;
  if (!mechanism.symbols.empty()) {
    std::vector<std::string> members;
    for (std::size_t k = 0; k < mechanism.symbols.size(); ++k) {
      members.push_back(fmt::format("in[{}][{}]", function.inputs.size(), k));
    }
    arguments.push_back(fmt::format("{}::Parameters<double>{{{}}}", name_space, fmt::join(members, ", ")));
  }
  for (std::size_t k = 0; k < function.inputs.size(); ++k) arguments.push_back(fmt::format("in[{}]", k));
  std::size_t offset = 0;
  for (const Output& output : function.outputs) {
    if (returns_value(function)) break;
    arguments.push_back(fmt::format("out + {}", offset));
    offset += output.entries.size();
  }
  return fmt::format("{}::{}({})", name_space, cpp_identifier(function.name), fmt::join(arguments, ", "));
}

}  // namespace

std::string plain_entry_text(const Mechanism& mechanism, const Function& function, const std::string& name_space,
                             const std::string& symbol) {
  const std::string call = call_text(mechanism, function, name_space);
  const std::string body = returns_value(function)                ? "out[0] = " + call + ";\n  return true;"
                           : function.validity_conditions.empty() ? call + ";\n  return true;"
                                                                  : "return " + call + ";";
  return fmt::format("extern \"C\" bool {}([[maybe_unused]] const double* const* in, double* out) {{\n  {}\n}}\n",
                     symbol, body);
}

std::vector<double> called(PlainEntry entry, const Function& function, const State& state) {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  std::size_t length = 0;
  for (const Output& output : function.outputs) length += output.entries.size();
  std::vector<double> out(length, kNone);
  std::vector<const double*> in;
  for (const InputKind kind : function.inputs) in.push_back(state.of(kind).data());
  in.push_back(state.parameters.data());
  if (!entry(in.data(), out.data())) std::fill(out.begin(), out.end(), kNone);
  return out;
}

class CompiledFunctions::Library {
 public:
  Library(const Mechanism& mechanism, const std::vector<Function>& functions, Sines sines) {
    EmitOptions options;
    options.sines = sines;
    options.name_space = kNamespace;
    write_file(folder_.path() / "robot.hpp", emit_header(mechanism, functions, options));
    std::string driver = "#include \"robot.hpp\"\n";
    for (std::size_t k = 0; k < functions.size(); ++k) {
      driver += plain_entry_text(mechanism, functions[k], kNamespace, fmt::format("entry_{}", k));
    }
    write_file(folder_.path() / "driver.cpp", driver);
    library_.emplace(folder_.path(), "driver", "-std=c++17 -O2 -ffp-contract=off -Wall -Wextra -Wconversion -Werror");
    for (std::size_t k = 0; k < functions.size(); ++k) {
      entries_.push_back(reinterpret_cast<PlainEntry>(library_->symbol(fmt::format("entry_{}", k))));
    }
  }

  PlainEntry entry(std::size_t index) const { return entries_[index]; }

 private:
  TemporaryFolder folder_;
  std::optional<SharedLibrary> library_;
  std::vector<PlainEntry> entries_;
};

CompiledFunctions::CompiledFunctions(const Mechanism& mechanism, const std::vector<Function>& functions, Sines sines)
    : library_(std::make_unique<Library>(mechanism, functions, sines)), functions_(functions) {}

CompiledFunctions::~CompiledFunctions() = default;

std::vector<double> CompiledFunctions::call(std::size_t index, const State& state) const {
  return called(library_->entry(index), functions_[index], state);
}

bool CompiledFunctions::evaluate(std::size_t index, const double* const* in, double* out) const {
  return library_->entry(index)(in, out);
}

}  // namespace flatdyn
