// SPDX-License-Identifier: GPL-2.0-or-later
#include "delivery/firmware/folder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include "base/diagnostics/diagnostics.hpp"
#include "base/diagnostics/version.hpp"
#include "code/emit/literals.hpp"
#include "code/emit/page.hpp"
#include "code/emit/sections.hpp"
#include "code/emit/writer.hpp"
#include "code/lower/arguments.hpp"
#include "delivery/firmware/test_vectors.hpp"
#include "robot/model/identifiers.hpp"
#include "templates.hpp"

namespace flatdyn {
namespace {

using kainjow::mustache::data;

class FolderWriter {
 public:
  FolderWriter(const Robot& robot, const Mechanism& mechanism, const std::vector<Function>& functions,
               const EmitOptions& options, const FirmwareTarget& target, Progress& progress)
      : mechanism_(mechanism),
        functions_(functions),
        options_(options),
        target_(target),
        dialect_(dialect_of(mechanism, options)) {
    for (const Function& function : functions) {
      if (function.base_parameters > 0 || function.own.length > 0)
        throw Failure(FailureKind::unsupported, "--firmware: no self test for " + function.name);
    }
    vectors_ = test_vectors(robot, mechanism, functions, options, progress);
  }

  std::vector<FirmwareFile> files() const {
    const data page = filled();
    std::vector<FirmwareFile> files = {{"test_vectors.h", rendered(templates::firmware_vectors_h, page)},
                                       {"test_vectors.c", rendered(templates::firmware_vectors_c, page)},
                                       {"main.c", rendered(templates::firmware_main_c, page)},
                                       {"makefile", rendered(templates::firmware_makefile, page)},
                                       {"report", rendered(templates::firmware_report, page)}};
    if (measures()) files.push_back({"measure.c", rendered(templates::firmware_measure_c, page)});
    if (target_.has_own_start) {
      files.push_back({"startup.c", rendered(templates::firmware_startup_c, page)});
      files.push_back({"target.ld", rendered(templates::firmware_target_ld, page)});
    }
    return files;
  }

 private:
  data filled() const {
    data page;
    const std::string header = header_name(mechanism_, options_);
    page["robot"] = comment_text(mechanism_.name);
    page["version"] = std::string(kProgramVersion);
    page["name"] = header.substr(0, header.size() - 2);
    page["prefix"] = dialect_->global("");
    page["nodiscard"] = dialect_->count_name("nodiscard");
    page["scalar"] = options_.scalar;
    page["is_float"] = options_.scalar == "float";
    page["target"] = std::string(target_.name);
    page["flags"] = std::string(target_.flags);
    page["tools"] = std::string(target_.tools);
    page["link_flags"] = std::string(target_.link_flags);
    page["emulator"] = std::string(target_.emulator);
    page["branches"] = std::string(target_.branches);
    page["packages"] = std::string(target_.packages);
    page["own_start?"] = target_.has_own_start;
    page["soft?"] = is_soft(target_, options_.scalar);
    page["soft_double"] = std::string(is_soft(target_, options_.scalar) ? target_.soft_double : "");
    page["measures?"] = measures();
    page["sines"] = angle_literals(Rational(3, 5));
    page["cosines"] = angle_literals(Rational(4, 5));
    page["units"] = fmt::format("{}", kAllowedUnits);
    page["state_count"] = std::to_string(vectors_.states.size());
    page["function_count"] = std::to_string(functions_.size());
    page["most_entries"] = std::to_string(most_entries());
    page["parameters?"] = !mechanism_.symbols.empty();
    page["arrays"] = arrays();
    page["states"] = states();
    page["functions"] = functions();
    return page;
  }

  // Whether the emulator can count instructions: one that emulates a whole board can derive its clock from them, one
  // that runs a program for Linux cannot.
  bool measures() const { return std::string_view(target_.emulator).starts_with("qemu-system"); }

  std::string angle_literals(const Rational& value) const {
    const auto angles = static_cast<std::size_t>(std::max(1, mechanism_.angle_count()));
    return fmt::format("{}", fmt::join(std::vector<std::string>(angles, dialect_->literal(value)), ", "));
  }

  std::size_t most_entries() const {
    std::size_t most = 1;
    for (const Function& function : functions_) most = std::max(most, entry_count(function));
    return most;
  }

  bool is_read(InputKind kind) const {
    return std::any_of(functions_.begin(), functions_.end(), [kind](const Function& function) {
      return std::find(function.inputs.begin(), function.inputs.end(), kind) != function.inputs.end();
    });
  }

  data arrays() const {
    data list(data::type::list);
    for (const InputKind kind : kArgumentKinds) {
      if (kind == InputKind::parameter) continue;
      const InputArgument argument = input_argument(kind, JointCounts(mechanism_));
      if (!is_read(kind)) continue;
      data item;
      item["name"] = argument.name;
      item["length"] = std::to_string(argument.length);
      list << item;
    }
    return list;
  }

  // Initialisers of the states, in lines such as ".q = {0.5f, -1.25f},".
  data states() const {
    data list(data::type::list);
    for (const State& state : vectors_.states) {
      std::string lines;
      if (!mechanism_.symbols.empty()) lines += member("parameters", state.parameters);
      for (const InputKind kind : kArgumentKinds) {
        if (kind == InputKind::parameter) continue;
        if (is_read(kind)) lines += member(input_argument(kind, 0).name, state.of(kind));
      }
      list << data("members", without_newline(lines));
    }
    return list;
  }

  std::string member(const std::string& name, const std::vector<double>& values) const {
    constexpr std::size_t kIndent = 6;
    std::vector<std::string> literals;
    for (const double value : values) literals.push_back(dialect_->literal(Rational(value)));
    return list_line(fmt::format(".{} = {{", name), literals, "},", kIndent);
  }

  data functions() const {
    data list(data::type::list);
    const std::vector<StraightCall> straight = straight_calls(mechanism_, functions_, options_);
    for (std::size_t k = 0; k < functions_.size(); ++k) {
      data item, expected(data::type::list);
      for (const ExpectedEntry& entry : vectors_.expected[k]) {
        expected << data("entry",
                         fmt::format("{}, {}, {}, {}", decimal_literal(entry.exact), decimal_literal(entry.rest),
                                     decimal_literal(entry.allowed), decimal_literal(entry.proven)));
      }
      item["function"] = cpp_identifier(functions_[k].name);
      item["entries"] = std::to_string(entry_count(functions_[k]));
      item["call"] = call(functions_[k]);
      item["straight_call"] = straight_call(functions_[k], straight[k]);
      item["expected"] = data(expected);
      list << item;
    }
    return list;
  }

  // The statement "return panda_forward_dynamics(s->q, s->qd, s->tau, out);".
  std::string call(const Function& function) const {
    constexpr std::size_t kIndent = 2;
    std::vector<std::string> arguments;
    if (!mechanism_.symbols.empty()) arguments.emplace_back("&s->parameters");
    for (const InputKind kind : function.inputs) arguments.push_back("s->" + input_argument(kind, 0).name);
    std::size_t offset = 0;
    for (const Output& output : function.outputs) {
      if (!returns_value(function)) arguments.push_back(offset == 0 ? "out" : fmt::format("out + {}", offset));
      offset += output.entries.size();
    }
    const bool gives_bool = !function.validity_conditions.empty();
    const std::string begin = returns_value(function) ? "out[0] = " : gives_bool ? "return " : "";
    const std::string name = dialect_->global(cpp_identifier(function.name));
    const std::string line = list_line(begin + name + "(", arguments, ");", kIndent);
    return without_newline(line + (gives_bool ? "" : "  return true;\n"));
  }

  // The call of the variant that takes sines and cosines, if the function needs any: "(void)panda_gravity_given(sine,
  // cosine, out);".
  std::string straight_call(const Function& function, const StraightCall& call) const {
    constexpr std::size_t kIndent = 2;
    std::vector<std::string> arguments;
    for (const std::string& name : call.arguments) arguments.push_back(argument_for(name, function));
    const std::string receiver = returns_value(function) ? "out[0] = " : "(void)";
    return without_newline(list_line(receiver + call.function + "(", arguments, ");", kIndent));
  }

  std::string argument_for(const std::string& parameter, const Function& function) const {
    if (parameter == "parameters") return "&state->parameters";
    if (parameter == "sine" || parameter == "cosine") return parameter;
    for (const InputKind kind : function.inputs) {
      if (parameter == input_argument(kind, 0).name) return "state->" + parameter;
    }
    std::size_t offset = 0;
    for (const Output& output : function.outputs) {
      if (parameter == output.name) break;
      offset += output.entries.size();
    }
    return offset == 0 ? "out" : fmt::format("out + {}", offset);
  }

  const Mechanism& mechanism_;
  const std::vector<Function>& functions_;
  const EmitOptions& options_;
  const FirmwareTarget& target_;
  std::unique_ptr<const Dialect> dialect_;
  TestVectors vectors_;
};

}  // namespace

std::vector<FirmwareFile> firmware_files(const Robot& robot, const Mechanism& mechanism,
                                         const std::vector<Function>& functions, const EmitOptions& options,
                                         const FirmwareTarget& target, Progress& progress) {
  return FolderWriter(robot, mechanism, functions, options, target, progress).files();
}

}  // namespace flatdyn
