// SPDX-License-Identifier: GPL-2.0-or-later
#include "base/diagnostics/diagnostics.hpp"

#include <algorithm>
#include <utility>

namespace flatdyn {

namespace {

std::string prefix_of(const Place& place, Severity severity) {
  if (place.file.empty()) return severity == Severity::error ? "flatdyn: " : "";
  if (place.line <= 0) return place.file + ": ";
  return place.file + ":" + std::to_string(place.line) + ": ";
}

}  // namespace

const char* name_of(Severity severity) {
  switch (severity) {
    case Severity::note:
      return "note";
    case Severity::warning:
      return "warning";
    case Severity::error:
      return "error";
  }
  throw std::logic_error("unknown severity");
}

std::string to_string(const Diagnostic& diagnostic) {
  std::string text =
      prefix_of(diagnostic.place, diagnostic.severity) + name_of(diagnostic.severity) + ": " + diagnostic.message;
  if (!diagnostic.hint.empty()) text += "\n    hint: " + diagnostic.hint;
  return text;
}

void Diagnostics::note(Place place, std::string message, std::string hint, std::string kind) {
  add({Severity::note, std::move(place), std::move(message), std::move(hint), false, std::move(kind)});
}

void Diagnostics::warning(Place place, std::string message, std::string hint, std::string kind) {
  add({Severity::warning, std::move(place), std::move(message), std::move(hint), false, std::move(kind)});
}

void Diagnostics::error(Place place, std::string message, std::string hint) {
  add({Severity::error, std::move(place), std::move(message), std::move(hint)});
}

void Diagnostics::unsupported(Place place, std::string message, std::string hint) {
  add({Severity::error, std::move(place), std::move(message), std::move(hint), true});
}

void Diagnostics::add(Diagnostic diagnostic) { all_.push_back(std::move(diagnostic)); }

bool Diagnostics::has_errors() const {
  return std::any_of(all_.begin(), all_.end(), [](const Diagnostic& d) { return d.severity == Severity::error; });
}

bool Diagnostics::has_warnings() const {
  return std::any_of(all_.begin(), all_.end(), [](const Diagnostic& d) { return d.severity == Severity::warning; });
}

bool Diagnostics::only_unsupported() const {
  return has_errors() && std::all_of(all_.begin(), all_.end(), [](const Diagnostic& d) {
           return d.severity != Severity::error || d.unsupported;
         });
}

bool Diagnostics::only_on_command_line() const {
  return has_errors() && std::all_of(all_.begin(), all_.end(), [](const Diagnostic& d) {
           return d.severity != Severity::error || d.place.file.empty();
         });
}

}  // namespace flatdyn
