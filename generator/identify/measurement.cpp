// SPDX-License-Identifier: GPL-2.0-or-later
#include "identify/measurement.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <tuple>

#include "input/common/content_hash.hpp"

namespace flatdyn {
namespace {

void drop_every_other(std::vector<MotionSample>& samples) {
  std::size_t kept = 0;
  for (std::size_t k = 0; k < samples.size(); k += 2) std::swap(samples[kept++], samples[k]);
  samples.resize(kept);
}

LogIdentity identity_of(const std::filesystem::path& log) {
  constexpr std::size_t kBeginning = 65536;
  std::string beginning(kBeginning, '\0');
  std::ifstream file(log, std::ios::binary);
  file.read(beginning.data(), static_cast<std::streamsize>(beginning.size()));
  beginning.resize(static_cast<std::size_t>(file.gcount()));
  return {log.filename().string(), std::filesystem::file_size(log), content_hash({beginning})};
}

struct PlannedLog {
  std::filesystem::path path;
  StreamPlan plan;
  LogIdentity identity;
};

// The logs in the order of their identities: a shell on another machine may list them in another order, and the share
// of each part depends on it.
std::vector<PlannedLog> planned_logs(const TorqueModel& model, const std::vector<std::filesystem::path>& logs,
                                     const StreamOptions& options, Diagnostics& diagnostics) {
  std::vector<PlannedLog> planned;
  for (const std::filesystem::path& log : logs) {
    StreamPlan plan = plan_stream(log, model.mechanism(), options, diagnostics);
    if (diagnostics.has_errors()) return planned;
    planned.push_back({log, std::move(plan), identity_of(log)});
  }
  std::stable_sort(planned.begin(), planned.end(),
                   [](const PlannedLog& a, const PlannedLog& b) { return a.identity < b.identity; });
  for (std::size_t k = 1; k < planned.size(); ++k) {
    if (planned[k].identity != planned[k - 1].identity) continue;
    diagnostics.error({planned[k].path.string(), 0},
                      fmt::format("the same log as {}, by name, size and beginning", planned[k - 1].path.string()),
                      "what is given twice would count as new data; a log of another motion needs another name");
  }
  return planned;
}

}  // namespace

void ThinnedSamples::offer(const TorqueModel& model, const MeasuredMotion& motion, int log) {
  if (offered_++ % stride_ != 0) return;
  const int n = model.joints();
  const auto numbers = [n](const double* from) { return std::vector<double>(from, from + n); };
  const int positions = model.mechanism().position_count();
  MotionSample sample{log,
                      motion.time,
                      std::vector<double>(motion.q, motion.q + positions),
                      numbers(motion.qd),
                      numbers(motion.qdd),
                      numbers(motion.tau)};
  if (motion.h_e != nullptr) {
    std::vector<double> tip(static_cast<std::size_t>(n));
    model.tip_torque(motion.q, motion.h_e, tip.data());
    for (std::size_t i = 0; i < tip.size(); ++i) sample.tau[i] -= tip[i];
  }
  kept_.push_back(std::move(sample));
  if (kept_.size() < kMost) return;
  drop_every_other(kept_);
  stride_ *= 2;
}

std::vector<SampleFilter> Measurement::filters() const {
  std::vector<SampleFilter> different;
  for (const MeasuredLog& log : logs) {
    if (std::find(different.begin(), different.end(), log.filter) == different.end()) different.push_back(log.filter);
  }
  return different;
}

double Measurement::correlation() const {
  double largest = 1;
  for (const SampleFilter& filter : filters()) largest = std::max(largest, filter.correlation());
  return largest;
}

Measurement measure(const TorqueModel& model, const std::vector<std::filesystem::path>& logs,
                    const StreamOptions& options, Progress& progress, Diagnostics& diagnostics) {
  ObservationFolder folder(model);
  ThinnedSamples samples;
  Measurement result;
  std::vector<PlannedLog> planned = planned_logs(model, logs, options, diagnostics);
  if (diagnostics.has_errors()) return result;
  BlockPartition shares(options.part, options.parts);
  for (PlannedLog& log : planned) {
    progress.step("reading " + log.path.string());
    const auto sink = [&, at = static_cast<int>(result.logs.size())](const MeasuredMotion& motion) {
      folder.add(motion);
      samples.offer(model, motion, at);
    };
    const StreamCount count = stream(log.path, model.mechanism(), log.plan, shares, sink, diagnostics);
    if (diagnostics.has_errors()) return result;
    result.count.lines += count.lines;
    result.count.used += count.used;
    result.count.gaps += count.gaps;
    result.logs.push_back({std::move(log.identity), log.plan.filter});
  }
  result.observations = folder.observations();
  result.observations.set_correlation(result.correlation());
  result.samples = samples.kept();
  return result;
}

Measurement joined(const std::vector<Measurement>& measurements) {
  Measurement result = measurements.front();
  for (std::size_t k = 1; k < measurements.size(); ++k) {
    const Measurement& next = measurements[k];
    result.observations = joined(result.observations, next.observations);
    result.samples.insert(result.samples.end(), next.samples.begin(), next.samples.end());
    result.count.lines += next.count.lines;
    result.count.used += next.count.used;
    result.count.gaps += next.count.gaps;
  }
  std::stable_sort(result.samples.begin(), result.samples.end(), [](const MotionSample& a, const MotionSample& b) {
    return std::tie(a.log, a.time) < std::tie(b.log, b.time);
  });
  while (result.samples.size() > ThinnedSamples::kMost) drop_every_other(result.samples);
  return result;
}

}  // namespace flatdyn
