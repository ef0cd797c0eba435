// SPDX-License-Identifier: GPL-2.0-or-later
#include "cli/messages.hpp"

#include <fmt/format.h>

#include "base/diagnostics/progress.hpp"
#include "base/system/interrupt.hpp"
#include "report/json_text.hpp"

namespace flatdyn {
namespace {

nlohmann::ordered_json json_of(const Diagnostic& diagnostic) {
  nlohmann::ordered_json json = {{"severity", name_of(diagnostic.severity)}};
  if (!diagnostic.place.file.empty()) json["file"] = diagnostic.place.file;
  if (diagnostic.place.line > 0) json["line"] = diagnostic.place.line;
  json["message"] = diagnostic.message;
  if (!diagnostic.hint.empty()) json["hint"] = diagnostic.hint;
  return json;
}

std::string errors_text(const Diagnostics& errors, ExitCode code) {
  nlohmann::ordered_json json = {{"exit_code", static_cast<int>(code)}, {"errors", nlohmann::ordered_json::array()}};
  for (const Diagnostic& diagnostic : errors.all()) json["errors"].push_back(json_of(diagnostic));
  return json_text(json);
}

void print_errors(const Diagnostics& errors, ExitCode code) { print_result(errors_text(errors, code)); }

void print_message(const std::string& text) {
  std::fflush(stdout);
  erase_progress();
  fmt::print(stderr, "{}", text);
}

void print_failure(const std::string& message, const std::string& hint) {
  print_message(fmt::format("flatdyn: error: {}\n{}", message, hint.empty() ? "" : "    hint: " + hint + "\n"));
}

}  // namespace

void print_diagnostics(const Diagnostics& diagnostics, const OutputStyle& style) {
  print_message(findings_text(diagnostics, style));
}

void prepare_for_interruption(const OutputStyle& style) {
  if (!style.json) return;
  Diagnostics errors;
  errors.error({}, "interrupted before there was a result");
  print_when_interrupted(errors_text(errors, ExitCode::interrupted));
}

void print_result(const std::string& text) {
  erase_progress();
  print_when_interrupted("");
  fmt::print("{}", text);
}

ExitCode report_failure(const Failure& failure, const OutputStyle& style) {
  print_failure(failure.what(), failure.hint());
  // An interrupted run has already printed its result.
  if (style.json && failure.kind() != FailureKind::interrupted) {
    Diagnostics errors;
    errors.error({}, failure.what(), failure.hint());
    print_errors(errors, exit_code_of(failure.kind()));
  }
  return exit_code_of(failure.kind());
}

ExitCode report_failure(const BadInput& bad, const OutputStyle& style) {
  print_diagnostics(bad.diagnostics, style);
  if (!bad.diagnostics.has_errors()) print_failure("warnings are errors (-Werror)", "");
  if (style.json) print_errors(bad.diagnostics, exit_code_of(bad.kind()));
  return exit_code_of(bad.kind());
}

}  // namespace flatdyn
