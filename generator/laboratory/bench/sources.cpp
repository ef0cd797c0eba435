// SPDX-License-Identifier: GPL-2.0-or-later
#include "laboratory/bench/sources.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "code/emit/page.hpp"
#include "code/emit/writer.hpp"
#include "code/languages/emit.hpp"
#include "code/languages/language_table.hpp"
#include "code/lower/arguments.hpp"
#include "laboratory/bench/calls.hpp"
#include "laboratory/bench/stage_steps.hpp"
#include "robot/model/identifiers.hpp"
#include "templates.hpp"

namespace flatdyn {
namespace {

using kainjow::mustache::data;

std::string states_text(const std::vector<State>& states) {
  std::string bytes;
  const auto add = [&](const auto& numbers_of) {
    for (const State& state : states) {
      const std::vector<double>& numbers = numbers_of(state);
      bytes.append(reinterpret_cast<const char*>(numbers.data()), numbers.size() * sizeof(double));
    }
  };
  for (const InputKind kind : kMotionKinds) {
    add([kind](const State& state) -> const std::vector<double>& { return state.of(kind); });
  }
  add([](const State& state) -> const std::vector<double>& { return state.parameters; });
  return bytes;
}

// Whether a variant has this property.
bool has_any(const BenchSubject& subject, bool BenchVariant::*property) {
  return std::any_of(subject.variants.begin(), subject.variants.end(),
                     [property](const BenchVariant& variant) { return variant.*property; });
}

std::vector<std::string> adders(const BenchSubject& subject) {
  std::vector<std::string> names = {"add_robot"};
  if (has_native_cases(subject)) names.emplace_back("add_native");
  for (const BenchPeer& peer : subject.peers) names.push_back("add_" + peer.stem);
  return names;
}

data main_page(const BenchSubject& subject) {
  data lengths(data::type::list);
  std::string arguments;
  const auto add = [&](const std::string& name, std::size_t length) {
    data row;
    row["name"] = name;
    row["length"] = std::to_string(length);
    lengths << row;
    arguments += (arguments.empty() ? "" : ", ") + name;
  };
  for (const InputKind kind : kMotionKinds) {
    add(input_argument(with_base(kind, subject.mechanism.has_quasi_velocities()), 0).name,
        subject.states[0].of(kind).size());
  }
  add("parameters", subject.states[0].parameters.size());
  data page;
  page["states"] = std::to_string(subject.states.size());
  page["lengths"] = data(lengths);
  page["arguments"] = arguments;
  page["adders"] = list_of(adders(subject));
  return page;
}

data source_row(const CalledFunction& called, const BenchVariant& variant) {
  data row;
  row["name"] = called.function.name + "/" + variant.name;
  row["scalar"] = std::string(variant.scalar);
  row["entries"] = std::to_string(entry_count(called.function));
  return row;
}

data single_row(const BenchSubject& subject, const CalledFunction& called, const BenchVariant& variant) {
  data row = source_row(called, variant);
  row["call"] = single_call(subject.mechanism, called, variant);
  return row;
}

data staged_row(const BenchSubject& subject, const CalledFunction& called, const BenchVariant& variant) {
  data row = single_row(subject, called, variant);
  const std::string stage = called.receiver.substr(0, called.receiver.size() - 1);
  row["stage"] = stage;
  row["make"] = at_call(subject.mechanism, variant) +
                (stage == "motion" ? fmt::format(".with(x.{}.of(k))", velocity_argument(subject.mechanism)) : "");
  return row;
}

data batch_row(const BenchSubject& subject, const CalledFunction& called, const BenchVariant& variant) {
  const BatchCall call = batch_call(subject.mechanism, called, variant);
  data row = source_row(called, variant);
  row["capture"] = call.capture;
  row["parameters"] = call.parameters;
  row["call"] = call.call;
  row["tiles"] = call.tiles;
  row["sets"] = call.entries;
  return row;
}

data kernel_row(const BenchSubject& subject, const CalledFunction& called, const BenchVariant& variant) {
  data row = source_row(called, variant);
  std::vector<std::size_t> lengths;
  for (const Output& output : called.function.outputs) lengths.push_back(output.entries.size());
  row["lengths"] = fmt::format("{}", fmt::join(lengths, ", "));
  row["call"] = kernel_call(subject.mechanism, called, variant);
  return row;
}

data size_row(const BenchSubject& subject, const CalledFunction& called, const BenchVariant& variant) {
  const PlainFunction plain = plain_function(subject.mechanism, called, variant);
  data row;
  row["returns"] = plain.returns;
  row["symbol"] = plain.symbol;
  row["parameters"] = plain.parameters;
  row["call"] = plain.call;
  return row;
}

data step_rows(const BenchSubject& subject) {
  data rows(data::type::list);
  for (const StageStep& step : stage_steps(subject)) {
    data row;
    row["name"] = step.name;
    row["entries"] = std::to_string(step.entries);
    row["call"] = step.call;
    rows << row;
  }
  return rows;
}

// The header's name: "robot.hpp", or that of the abbreviated functions.
std::string header_of(const AbbreviatedFunctions& functions) {
  return cpp_identifier("robot " + functions.budget) + ".hpp";
}

bool has_kernels(const BenchSubject& subject) {
  return std::any_of(subject.variants.begin(), subject.variants.end(),
                     [](const BenchVariant& variant) { return variant.call_mode == CallMode::kernel; });
}

data headers_of_robot(const BenchSubject& subject) {
  std::vector<std::string> names = {"robot.hpp"};
  if (has_any(subject, &BenchVariant::fuses)) names.emplace_back(kFusedHeader);
  if (has_any(subject, &BenchVariant::has_lanes)) names.emplace_back(kLimbsHeader);
  for (const AbbreviatedFunctions& each : subject.abbreviated) names.push_back(header_of(each));
  if (has_kernels(subject)) {
    names.emplace_back("flatdyn/cuda_batch.cuh");
    names.emplace_back(kKernelsHeader);
  }
  return list_of(names);
}

// The cases that the compiler tunes for this processor, or the others.
data robot_page(const BenchSubject& subject, bool native) {
  data singles(data::type::list), staged(data::type::list), lanes(data::type::list), kernels(data::type::list),
      functions(data::type::list);
  for (std::size_t k = 0; k < subject.functions.size(); ++k) {
    for (const BenchVariant& variant : subject.variants) {
      const std::optional<CalledFunction> called = called_function(subject, k, variant);
      if (!called || variant.is_native != native) continue;
      if (variant.call_mode == CallMode::single) singles << single_row(subject, *called, variant);
      if (variant.call_mode == CallMode::staged) staged << staged_row(subject, *called, variant);
      if (variant.call_mode == CallMode::batch) lanes << batch_row(subject, *called, variant);
      if (variant.call_mode == CallMode::kernel) kernels << kernel_row(subject, *called, variant);
      functions << size_row(subject, *called, variant);
    }
  }
  data page;
  page["robot"] = comment_text(subject.mechanism.name);
  page["adder"] = std::string(native ? "add_native" : "add_robot");
  std::vector<std::string> headers;
  const bool over_lanes = std::any_of(subject.variants.begin(), subject.variants.end(), needs_xsimd);
  if (!native && over_lanes && subject.toolchain.has_xsimd) headers = {"flatdyn/batch.hpp", "flatdyn/trigonometry.hpp"};
  page["headers"] = list_of(headers);
  page["robots"] = native ? list_of({kNativeHeader}) : headers_of_robot(subject);
  page["singles"] = data(singles);
  page["staged"] = data(staged);
  page["steps"] = native ? data(data::type::list) : step_rows(subject);
  page["lanes"] = data(lanes);
  page["kernels"] = data(kernels);
  page["functions"] = data(functions);
  return page;
}

// A function of a peer whose source file calls them all in the same way.
data pinocchio_row(const BenchSubject& subject, const BenchPeer& peer, const Function& function) {
  const bool is_halved = peer.halved.count(function.name) > 0;
  const auto n = static_cast<std::size_t>(subject.mechanism.size());
  std::vector<std::string> inputs;
  for (const InputKind kind : function.inputs) {
    if (kind == InputKind::g_b) continue;
    inputs.push_back("&x." + input_argument(kind, JointCounts(subject.mechanism), function).name);
  }
  if (!subject.states[0].of(InputKind::g_b).empty()) inputs.emplace_back("&x.g_b");
  data row;
  row["name"] = function.name;
  row["inputs"] = fmt::format("{}", fmt::join(inputs, ", "));
  row["whole"] = std::to_string(entry_count(function) - (is_halved ? n * n : 0));
  row["side"] = std::to_string(is_halved ? n : 0);
  row["call"] = fmt::format(fmt::runtime(peer.call), function.name);
  return row;
}

SourceFile peer_source(const BenchSubject& subject, const BenchPeer& peer) {
  const bool quasi_velocities = subject.mechanism.has_quasi_velocities();
  data page;
  page["floating?"] = subject.mechanism.floating_base;
  page["spherical?"] = subject.mechanism.has_spherical_joints();
  page["velocities"] = input_argument(with_base(InputKind::qd, quasi_velocities), 0).name;
  page["accelerations"] = input_argument(with_base(InputKind::qdd, quasi_velocities), 0).name;
  data rows(data::type::list);
  for (const Function& function : subject.functions) {
    if (peer.functions.count(function.name) == 0) continue;
    page[function.name] = true;
    if (!peer.call.empty()) rows << pinocchio_row(subject, peer, function);
  }
  page["peer"] = peer.name;
  page["stem"] = peer.stem;
  page["include"] = peer.include;
  page["functions"] = data(rows);
  return {peer.stem + ".cpp", rendered(peer.source, page)};
}

}  // namespace

std::string kernels_header(const Mechanism& mechanism, const std::vector<Function>& functions) {
  EmitOptions emit;
  emit.language = language_with(&LanguageRow::has_kernels).option;
  emit.name_space = kKernelsNamespace;
  return emit_code(mechanism, functions, emit).front().text;
}

bool has_native_cases(const BenchSubject& subject) {
  return *kTuning != '\0' && has_any(subject, &BenchVariant::is_native);
}

std::vector<SourceFile> bench_sources(const BenchSubject& subject) {
  EmitOptions emit;
  emit.name_space = kBenchNamespace;
  const data main = main_page(subject), robot = robot_page(subject, false);
  std::vector<SourceFile> files = {
      {"robot.hpp", emit_header(subject.mechanism, subject.functions, emit, subject.stages)},
      {"cases.hpp", rendered(templates::bench_cases_hpp, main)},
      {"main.cpp", rendered(templates::bench_main_cpp, main)},
      {"robot.cpp", rendered(templates::bench_robot_cpp, robot)},
      {"usage.cpp", templates::bench_usage_cpp},
      {"sizes.cpp", rendered(templates::bench_sizes_cpp, robot)},
      {"mechanism.hpp", mechanism_numbers(subject.mechanism, subject.symbols)},
      {"mechanism", mechanism_file(subject.mechanism, subject.symbols)},
      {"states", states_text(subject.states)}};
  for (const AbbreviatedFunctions& each : subject.abbreviated) {
    emit.name_space = name_space_of_budget(each.budget);
    files.push_back({header_of(each), emit_header(subject.mechanism, each.functions, emit)});
  }
  if (has_any(subject, &BenchVariant::has_lanes)) {
    emit.name_space = kLimbsNamespace;
    emit.limbs_in_lanes = true;
    files.push_back({kLimbsHeader, emit_header(subject.mechanism, subject.functions, emit)});
    emit.limbs_in_lanes = false;
  }
  if (has_native_cases(subject)) {
    emit.name_space = kNativeNamespace;
    files.push_back({kNativeHeader, emit_header(subject.mechanism, subject.functions, emit)});
    files.push_back({"native.cpp", rendered(templates::bench_robot_cpp, robot_page(subject, true))});
  }
  if (has_any(subject, &BenchVariant::fuses)) {
    emit.name_space = kFusedNamespace;
    emit.fuses = true;
    files.push_back({kFusedHeader, emit_header(subject.mechanism, subject.functions, emit)});
  }
  if (has_kernels(subject)) files.push_back({kKernelsHeader, kernels_header(subject.mechanism, subject.functions)});
  for (const templates::Header& header : templates::headers) files.push_back({header.path, header.text});
  for (const BenchPeer& peer : subject.peers) files.push_back(peer_source(subject, peer));
  return files;
}

}  // namespace flatdyn
