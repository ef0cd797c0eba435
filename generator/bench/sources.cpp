// SPDX-License-Identifier: GPL-2.0-or-later
#include "bench/sources.hpp"

#include <algorithm>

#include "bench/calls.hpp"
#include "emit/arguments.hpp"
#include "emit/emit.hpp"
#include "emit/page.hpp"
#include "emit/writer.hpp"
#include "templates.hpp"

namespace flatdyn {
namespace {

using kainjow::mustache::data;

// All that a function may be given, in the order of the file of states.
constexpr InputKind kKinds[] = {InputKind::q,   InputKind::qd,   InputKind::qdd,   InputKind::tau,
                                InputKind::h_e, InputKind::qd_r, InputKind::qdd_r, InputKind::pi_b};

std::string states_text(const std::vector<State>& states) {
  std::string bytes;
  const auto add = [&](const auto& numbers_of) {
    for (const State& state : states) {
      const std::vector<double>& numbers = numbers_of(state);
      bytes.append(reinterpret_cast<const char*>(numbers.data()), numbers.size() * sizeof(double));
    }
  };
  for (const InputKind kind : kKinds) {
    add([kind](const State& state) -> const std::vector<double>& { return state.of(kind); });
  }
  add([](const State& state) -> const std::vector<double>& { return state.parameters; });
  return bytes;
}

std::vector<std::string> adders(const BenchSubject& subject) {
  std::vector<std::string> names = {"add_robot"};
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
  for (const InputKind kind : kKinds) {
    add(input_argument(kind, 0).name, subject.states[0].of(kind).size());
  }
  add("parameters", subject.states[0].parameters.size());
  data page;
  page["states"] = std::to_string(subject.states.size());
  page["lengths"] = data(lengths);
  page["arguments"] = arguments;
  page["adders"] = list_of(adders(subject));
  return page;
}

data single_row(const BenchSubject& subject, const Function& function, const BenchVariant& variant) {
  data row;
  row["name"] = function.name + "/" + variant.name;
  row["scalar"] = std::string(variant.scalar);
  row["entries"] = std::to_string(entry_count(function));
  row["call"] = single_call(subject.mechanism, function, variant);
  return row;
}

data batch_row(const BenchSubject& subject, const Function& function, const BenchVariant& variant) {
  const BatchCall call = batch_call(subject.mechanism, function, variant);
  data row;
  row["name"] = function.name + "/" + variant.name;
  row["scalar"] = std::string(variant.scalar);
  row["entries"] = std::to_string(entry_count(function));
  row["capture"] = call.capture;
  row["parameters"] = call.parameters;
  row["call"] = call.call;
  row["columns"] = call.columns;
  return row;
}

data size_row(const BenchSubject& subject, const Function& function, const BenchVariant& variant) {
  const PlainFunction plain = plain_function(subject.mechanism, function, variant);
  data row;
  row["returns"] = plain.returns;
  row["symbol"] = plain.symbol;
  row["parameters"] = plain.parameters;
  row["call"] = plain.call;
  return row;
}

data robot_page(const BenchSubject& subject) {
  data singles(data::type::list), lanes(data::type::list), functions(data::type::list);
  for (const Function& function : subject.functions) {
    for (const BenchVariant& variant : subject.variants) {
      if (!is_made(variant, function, subject.toolchain.has_xsimd)) continue;
      (variant.batch ? lanes : singles) << (variant.batch ? batch_row(subject, function, variant)
                                                          : single_row(subject, function, variant));
      functions << size_row(subject, function, variant);
    }
  }
  data page;
  page["robot"] = comment_text(subject.mechanism.name);
  std::vector<std::string> headers;
  const bool over_lanes = std::any_of(subject.variants.begin(), subject.variants.end(), needs_xsimd);
  if (over_lanes && subject.toolchain.has_xsimd) headers = {"flatdyn/batch.hpp", "flatdyn/trigonometry.hpp"};
  page["headers"] = list_of(headers);
  page["singles"] = data(singles);
  page["lanes"] = data(lanes);
  page["functions"] = data(functions);
  return page;
}

SourceFile peer_source(const BenchSubject& subject, const BenchPeer& peer) {
  data page;
  for (const Function& function : subject.functions) {
    if (peer.functions.count(function.name) > 0) page[function.name] = true;
  }
  return {peer.stem + ".cpp", rendered(peer.source, page)};
}

}  // namespace

std::vector<SourceFile> bench_sources(const BenchSubject& subject) {
  EmitOptions emit;
  emit.name_space = kBenchNamespace;
  const data main = main_page(subject), robot = robot_page(subject);
  std::vector<SourceFile> files = {{"robot.hpp", emit_cpp(subject.mechanism, subject.functions, emit)},
                                   {"cases.hpp", rendered(templates::bench_cases_hpp, main)},
                                   {"main.cpp", rendered(templates::bench_main_cpp, main)},
                                   {"robot.cpp", rendered(templates::bench_robot_cpp, robot)},
                                   {"usage.cpp", templates::bench_usage_cpp},
                                   {"sizes.cpp", rendered(templates::bench_sizes_cpp, robot)},
                                   {"mechanism.hpp", mechanism_numbers(subject.mechanism, subject.symbols)},
                                   {"states", states_text(subject.states)}};
  for (const templates::Header& header : templates::headers) files.push_back({header.path, header.text});
  for (const BenchPeer& peer : subject.peers) files.push_back(peer_source(subject, peer));
  return files;
}

}  // namespace flatdyn
