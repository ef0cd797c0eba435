// SPDX-License-Identifier: GPL-2.0-or-later
#include "laboratory/bench/bench.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "base/diagnostics/nearest.hpp"
#include "base/system/temporary_folder.hpp"
#include "functions/units.hpp"
#include "graph/count.hpp"
#include "graph/passes/fuse_products.hpp"
#include "laboratory/bench/abbreviations.hpp"
#include "laboratory/bench/errors.hpp"
#include "laboratory/bench/program.hpp"
#include "laboratory/bench/same_bits.hpp"
#include "laboratory/bench/stage_steps.hpp"

namespace flatdyn {
namespace {

// The number of states that the timed calls cycle through.
constexpr int kCalledStates = 1024;

// The bound on a peer's scaled error, about 2e-7 relative to the terms; a wrong model is far above. MuJoCo's numbers
// were seen 2e7 off where inertia matters.
constexpr double kPeerBound = 1e9;

std::vector<State> states_for(const Mechanism& mechanism, const std::vector<Function>& functions,
                              const SymbolValues& symbols, unsigned seed) {
  std::vector<State> states = with_parameters(random_states(mechanism, kCalledStates, seed), symbols);
  draw_own_arguments(states, functions, seed);
  return states;
}

bool is_wanted(const BenchOptions& options, const std::string& name) {
  const std::vector<std::string>& wanted = options.variants;
  return wanted.empty() || std::find(wanted.begin(), wanted.end(), name) != wanted.end();
}

std::vector<BenchVariant> wanted_variants(const BenchOptions& options) {
  std::vector<BenchVariant> variants;
  for (const BenchVariant& variant : bench_variants()) {
    if (is_wanted(options, variant.name)) variants.push_back(variant);
  }
  return variants;
}

BenchPeers wanted_peers(const BenchOptions& options, const Toolchain& toolchain, const Mechanism& mechanism) {
  BenchPeers peers = find_peers(toolchain, mechanism);
  std::erase_if(peers.found, [&](const BenchPeer& peer) { return !is_wanted(options, peer.name); });
  std::erase_if(peers.left_out,
                [&](const std::string& line) { return !is_wanted(options, line.substr(0, line.find(':'))); });
  return peers;
}

void check_variants(const BenchOptions& options) {
  const std::vector<std::string> known = bench_variant_names();
  for (const std::string& name : options.variants) {
    if (std::find(known.begin(), known.end(), name) != known.end()) continue;
    throw Failure(FailureKind::usage, "no variant named \"" + name + "\"", hint_for_unknown(name, known, "variants"));
  }
}

void check_peer(const BenchCase& peer, const std::string& name, const BenchErrors& errors) {
  if (!peer.is_peer || errors.scaled.largest <= kPeerBound) return;
  throw Failure(FailureKind::bug,
                fmt::format("{}: its numbers differ from the reference in 50 digits by {:.2g} units of "
                            "the last place: its model is another one",
                            name, errors.scaled.largest));
}

// Compares the values of variants that have to compute the same bits.
void check_bits(const std::vector<Function>& functions, const std::vector<BenchCase>& cases,
                const std::vector<std::vector<double>>& values) {
  std::map<std::pair<std::size_t, std::string>, std::size_t> first;  // by function and scalar
  for (std::size_t k = 0; k < cases.size(); ++k) {
    if (cases[k].is_peer || !has_plain_bits(cases[k].of)) continue;
    const std::size_t like = first.emplace(std::pair(cases[k].function, cases[k].scalar), k).first->second;
    check_same_bits(functions[cases[k].function].name, {cases[like].variant, values[like]},
                    {cases[k].variant, values[k]});
  }
}

BenchRow bench_row(const BenchCase& of, const BenchErrors& errors, const std::vector<double>& samples, long bytes) {
  BenchRow row;
  row.variant = of.variant;
  row.is_peer = of.is_peer;
  row.is_whole = of.is_peer || is_whole_call(of.of);
  if (of.call) row.operations = operations_as_written(of.call->function, of.of.fuses);
  row.time = quartiles(samples);
  row.rounds = samples.size();
  row.scaled = errors.scaled;
  row.absolute = errors.absolute;
  row.states = errors.states;
  row.bytes = bytes;
  return row;
}

// Marks the Pareto front of the rows whose calls do the whole work.
void mark_front(std::vector<BenchRow>& rows) {
  std::vector<BenchRow*> whole;
  std::vector<Cost> costs;
  for (BenchRow& row : rows) {
    if (!row.is_whole) continue;
    whole.push_back(&row);
    costs.push_back({row.time.median, row.scaled.percentile_99});
  }
  const std::vector<bool> front = pareto_front(costs);
  for (std::size_t k = 0; k < whole.size(); ++k) whole[k]->on_front = front[k];
}

void sort_rows(std::vector<BenchRow>& rows) {
  const double base = rows.front().time.median;
  for (BenchRow& row : rows) row.ratio = row.time.median / base;
  mark_front(rows);
  std::stable_sort(rows.begin(), rows.end(),
                   [](const BenchRow& a, const BenchRow& b) { return a.time.median < b.time.median; });
}

// One run of a robot's benchmark program, step by step.
class BenchRun {
 public:
  BenchRun(const LoadedRobot& model, const std::vector<Function>& functions, const BenchOptions& options,
           Progress& progress)
      : model_(model),
        functions_(functions),
        options_(options),
        progress_(progress),
        toolchain_(find_toolchain()),
        expected_(model.robot, model.mechanism, options.seed),
        states_(states_for(model.mechanism, functions, expected_.symbols(), options.seed)),
        variants_(wanted_variants(options)),
        peers_(wanted_peers(options, toolchain_, model.mechanism)),
        abbreviations_(abbreviations(model, functions, variants_, progress)) {}

  BenchReport run() {
    const BenchSubject subject = made_subject();
    const TemporaryFolder folder;
    progress_.step("compiling the benchmark of " + model_.mechanism.name);
    const BenchProgram program(subject, folder.path());
    const std::vector<BenchErrors> errors = errors_of(subject, program);
    progress_.step("timing " + model_.mechanism.name);
    const Times times = program.times(options_.seconds, options_.seed);
    BenchReport result = report(program.cases(), errors, times, program.sizes());
    result.stages.functions = staged_names(subject);
    for (const StageStep& step : stage_steps(subject)) {
      result.stages.steps.push_back({step.title, step.operations, quartiles(times.at(step.name))});
    }
    return result;
  }

 private:
  using Times = std::map<std::string, std::vector<double>>;

  BenchSubject made_subject() const {
    return {model_.mechanism,    functions_,          states_,
            toolchain_,          variants_,           peers_.found,
            expected_.symbols(), abbreviations_.made, bench_stages(model_, functions_, variants_, progress_)};
  }

  std::vector<BenchErrors> errors_of(const BenchSubject& subject, const BenchProgram& program) const {
    progress_.step("comparing " + model_.mechanism.name + " with 50 digits");
    const auto wanted = static_cast<std::size_t>(std::min(options_.states, kCalledStates));
    const std::vector<std::vector<double>> values = program.values(wanted);
    check_bits(functions_, program.cases(), values);
    std::vector<BenchErrors> errors = bench_errors(subject, expected_, program.cases(), values, wanted);
    for (std::size_t k = 0; k < errors.size(); ++k) {
      const BenchCase& each = program.cases()[k];
      check_peer(each, each.name(functions_), errors[k]);
    }
    return errors;
  }

  BenchReport report(const std::vector<BenchCase>& cases, const std::vector<BenchErrors>& errors, const Times& times,
                     const std::vector<long>& sizes) const {
    BenchReport report{model_.mechanism.name, toolchain_.version(), bench_flags(), options_.seconds, {}, {},
                       peers_.left_out};
    if (!toolchain_.has_xsimd && !variants_.empty())
      report.left_out.emplace_back("batch, together: they need xsimd (libxsimd-dev)");
    report.left_out.insert(report.left_out.end(), abbreviations_.left_out.begin(), abbreviations_.left_out.end());
    for (const Function& function : functions_) {
      report.functions.push_back({function.name,
                                  units_of(model_.mechanism, function),
                                  count_operations(function),
                                  count_written_entries(function),
                                  count_written_zeros(function),
                                  {}});
    }
    for (std::size_t k = 0; k < cases.size(); ++k) {
      const std::vector<double>& samples = times.at(cases[k].name(functions_));
      report.functions[cases[k].function].rows.push_back(bench_row(cases[k], errors[k], samples, sizes[k]));
    }
    std::erase_if(report.functions, [](const BenchFunction& function) { return function.rows.empty(); });
    for (BenchFunction& function : report.functions) sort_rows(function.rows);
    return report;
  }

  const LoadedRobot& model_;
  const std::vector<Function>& functions_;
  BenchOptions options_;
  Progress& progress_;
  Toolchain toolchain_;
  ExpectedValues expected_;
  std::vector<State> states_;
  std::vector<BenchVariant> variants_;
  BenchPeers peers_;
  Abbreviations abbreviations_;
};

}  // namespace

std::vector<std::string> bench_variant_names() {
  std::vector<std::string> names;
  for (const BenchVariant& variant : bench_variants()) names.emplace_back(variant.name);
  names.insert(names.end(), std::begin(kBenchPeers), std::end(kBenchPeers));
  return names;
}

BenchReport bench(const LoadedRobot& model, const std::vector<Function>& functions, const BenchOptions& options,
                  Progress& progress) {
  check_variants(options);
  return BenchRun(model, functions, options, progress).run();
}

}  // namespace flatdyn
