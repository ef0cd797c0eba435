// SPDX-License-Identifier: GPL-2.0-or-later
#include "report/held_code_report.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/diagnostics/table.hpp"

namespace flatdyn {
namespace {

// The most statements of which there are messages; JSON has them all.
constexpr std::size_t kMostMessages = 20;

// "inverse_dynamics: ", or nothing around the functions.
std::string subject(const TextDifference& difference) {
  return difference.function.empty() ? "" : difference.function + ": ";
}

// A directive or a text has quotes of its own.
std::string quoted(const std::string& statement) {
  const char* const quote = statement.find('"') == std::string::npos ? "\"" : "'";
  return quote + statement + quote;
}

std::string message_of(const TextDifference& difference) {
  const std::string begin = subject(difference);
  if (difference.held.empty()) return fmt::format("{}the statement {} is missing", begin, quoted(difference.own));
  if (difference.own.empty()) return fmt::format("{}the statement {} is one too many", begin, quoted(difference.held));
  const std::string word = difference.held_word.empty() ? "it ends" : quoted(difference.held_word);
  return fmt::format("{}{} in {} is not the robot's", begin, word, quoted(difference.held));
}

std::string hint_of(const TextDifference& difference) {
  if (difference.held.empty() || difference.own.empty()) return "";
  if (difference.own_word.empty()) return fmt::format("flatdyn writes {}", quoted(difference.own));
  return fmt::format("flatdyn writes {} in {}", quoted(difference.own_word), quoted(difference.own));
}

bool has_differences(const HeldReport& report, const std::string& function) {
  return std::any_of(report.differences.begin(), report.differences.end(), [&function](const TextDifference& each) {
    return each.function == function || each.function.starts_with(function + "_part");
  });
}

std::string text_of_held_verdict(const HeldFunction& function) {
  switch (function.verdict) {
    case HeldVerdict::same:
      return "the robot's, proven";
    case HeldVerdict::equal:
      return "the robot's, proven; its statements are others";
    case HeldVerdict::different:
      return "NOT the robot's: " + function.reason;
    case HeldVerdict::unreadable:
      return "NOT the robot's: " + function.reason;
    case HeldVerdict::missing:
      return "missing";
    case HeldVerdict::unknown:
      return "not one of those that its stamp names";
  }
  return "";
}

const char* held_verdict_name(HeldVerdict verdict) {
  constexpr const char* kNames[] = {"same", "equal", "different", "unreadable", "missing", "unknown"};
  return kNames[static_cast<int>(verdict)];
}

std::size_t around(const HeldReport& report) {
  return static_cast<std::size_t>(std::count_if(report.differences.begin(), report.differences.end(),
                                                [](const TextDifference& each) { return each.function.empty(); }));
}

}  // namespace

void add_findings(const HeldReport& report, const PlaceOfLine& place, const std::string& robot, Diagnostics& findings) {
  if (!report.unreadable.empty()) {
    findings.error(place(report.unreadable_line), "it is no text that flatdyn writes: " + report.unreadable);
  }
  for (const HeldFunction& each : report.functions) {
    if (each.verdict == HeldVerdict::missing) {
      findings.error(place(0), fmt::format("there is no function {}, which {} has", each.name, robot));
    } else if (each.verdict == HeldVerdict::unknown) {
      findings.error(place(each.line), fmt::format("there is a function {} more", each.name), "nothing is known of it");
    } else if (!each.is_right() && !has_differences(report, each.name)) {
      findings.error(place(each.line), fmt::format("{} is not the robot's: {}", each.name, each.reason));
    }
  }
  for (std::size_t k = 0; k < std::min(kMostMessages, report.differences.size()); ++k) {
    const TextDifference& each = report.differences[k];
    findings.error(place(each.line), message_of(each), hint_of(each));
  }
  if (report.differences.size() > kMostMessages) {
    findings.error(place(0),
                   fmt::format("{} statements more are not the robot's", report.differences.size() - kMostMessages),
                   "--json lists them all");
  } else if (report.is_only_first) {
    findings.error(place(0), "more statements are not the robot's, too many to tell them apart");
  }
}

std::string to_text(const HeldReport& report, const std::string& name) {
  std::vector<std::vector<std::string>> rows = {{"function", "it is"}};
  for (const HeldFunction& each : report.functions) rows.push_back({each.name, text_of_held_verdict(each)});
  std::string text = report.functions.empty() ? "" : aligned_table(rows) + "\n";
  if (const std::size_t count = around(report); count > 0) {
    text += fmt::format("around the functions, {} statement{} {} not what flatdyn writes\n", count,
                        count == 1 ? "" : "s", count == 1 ? "is" : "are");
  }
  return text + name +
         (report.passed() ? ": every function is the robot's, and nothing else is in it"
                          : ": NOT the robot's as it is");
}

nlohmann::ordered_json to_json(const HeldReport& report, const PlaceOfLine& place, const std::string& version) {
  nlohmann::ordered_json json = {{"header", place(1).file}, {"written_by", version}, {"passed", report.passed()}};
  if (!report.unreadable.empty()) {
    json["unreadable"] = {{"line", place(report.unreadable_line).line}, {"reason", report.unreadable}};
  }
  json["functions"] = nlohmann::ordered_json::array();
  for (const HeldFunction& each : report.functions) {
    json["functions"].push_back({{"function", each.name}, {"verdict", held_verdict_name(each.verdict)}});
    if (!each.reason.empty()) json["functions"].back()["reason"] = each.reason;
  }
  json["differences"] = nlohmann::ordered_json::array();
  for (const TextDifference& each : report.differences) {
    const Place at = place(each.line);
    json["differences"].push_back({{"file", at.file},
                                   {"line", at.line},
                                   {"function", each.function},
                                   {"held", each.held},
                                   {"expected", each.own}});
  }
  json["only_first_difference"] = report.is_only_first;
  return json;
}

}  // namespace flatdyn
