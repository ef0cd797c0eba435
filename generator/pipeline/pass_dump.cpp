// SPDX-License-Identifier: GPL-2.0-or-later
#include "pipeline/pass_dump.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/diagnostics/nearest.hpp"
#include "code/emit/page_writer.hpp"
#include "graph/passes/reorder.hpp"
#include "graph/text.hpp"

namespace flatdyn {
namespace {

constexpr const char *kDerived = "derived", *kAll = "all";

bool is_asked_for(const std::vector<std::string>& names, const std::string& name) {
  return std::any_of(names.begin(), names.end(),
                     [&name](const std::string& each) { return each == name || each == kAll; });
}

}  // namespace

void check_pass_names(const std::vector<std::string>& names) {
  std::vector<std::string> known = {kDerived, kAll};
  for (const Pass& pass : pass_table()) known.emplace_back(pass.name);
  known.emplace_back(last_pass().name);
  for (const std::string& name : names) {
    if (std::find(known.begin(), known.end(), name) != known.end()) continue;
    throw Failure(FailureKind::usage, fmt::format("--dump-after: there is no pass \"{}\"", name),
                  hint_for_unknown(name, known, "passes"));
  }
}

std::vector<GeneratedFile> pass_dump(const GenerationResult& result, const std::vector<std::string>& names) {
  std::vector<GeneratedFile> files;
  if (names.empty()) return files;  // the passes take most of the time of generation
  const std::string stem = file_name(result.robot.mechanism, result.form);
  for (const OptimisedFunction& each : result.functions) {
    const std::string prefix = stem + "." + each.function.name + ".";
    const Function start = reordered(each.derived, each.search ? each.search->choices.order : 0);
    if (is_asked_for(names, kDerived)) files.push_back({prefix + "0.derived.txt", to_text(start)});
    run_passes(start, nullptr, [&](const PassRecord& done, const Function& function) {
      if (!is_asked_for(names, done.pass)) return;
      files.push_back({fmt::format("{}{}.{}.txt", prefix, done.round, done.pass), to_text(function)});
    });
  }
  return files;
}

}  // namespace flatdyn
