// SPDX-License-Identifier: GPL-2.0-or-later
#include "base/diagnostics/findings_text.hpp"

#include <algorithm>
#include <utility>
#include <vector>

namespace flatdyn {
namespace {

constexpr std::size_t kMostNoteLines = 10;
constexpr std::size_t kMostPlaces = 4;

// Findings reported in one line: a single one, or all of a kind and severity.
using Group = std::vector<Diagnostic>;

struct Entry {
  std::string line;
  std::string hint;  // may be empty

  std::size_t height() const { return hint.empty() ? 1 : 2; }
  std::string text() const { return line + (hint.empty() ? "" : "\n    hint: " + hint) + "\n"; }
};

bool belongs_to(const Group& group, const Diagnostic& diagnostic) {
  const Diagnostic& first = group.front();
  return !diagnostic.kind.empty() && diagnostic.kind == first.kind && diagnostic.severity == first.severity;
}

std::vector<Group> grouped(const std::vector<Diagnostic>& diagnostics) {
  std::vector<Group> groups;
  for (const Diagnostic& diagnostic : diagnostics) {
    const auto group = std::find_if(groups.begin(), groups.end(),
                                    [&diagnostic](const Group& each) { return belongs_to(each, diagnostic); });
    if (group != groups.end()) {
      group->push_back(diagnostic);
    } else {
      groups.push_back({diagnostic});
    }
  }
  return groups;
}

// The places of a group: "arm.urdf:12, 25, scene.toml:3, …".
std::string places_of(const Group& group) {
  std::vector<Place> places;
  for (const Diagnostic& diagnostic : group) {
    const Place& place = diagnostic.place;
    if (!place.file.empty() && std::find(places.begin(), places.end(), place) == places.end()) places.push_back(place);
  }
  std::string text, file;
  for (std::size_t k = 0; k < places.size(); ++k) {
    if (k > 0) text += ", ";
    if (k == kMostPlaces) return text + "…";
    const std::string line = places[k].line > 0 ? std::to_string(places[k].line) : "";
    const bool is_same = places[k].file == file && !line.empty();
    text += is_same ? line : places[k].file + (line.empty() ? "" : ":" + line);
    file = places[k].file;
  }
  return text;
}

Entry entry_of(const Group& group) {
  Diagnostic first = group.front();
  const std::string hint = std::exchange(first.hint, {});
  if (group.size() == 1) return {to_string(first), hint};
  const std::string places = places_of(group);
  first.place = {};
  first.message = std::to_string(group.size()) + " " + first.kind + (places.empty() ? "" : " (" + places + ")");
  const bool is_of_all =
      std::all_of(group.begin(), group.end(), [&hint](const Diagnostic& each) { return each.hint == hint; });
  return {to_string(first), is_of_all ? hint : ""};
}

std::size_t height_of(const std::vector<Entry>& entries) {
  std::size_t lines = 0;
  for (const Entry& entry : entries) lines += entry.height();
  return lines;
}

// Shortens the notes: first the hints are dropped, then the last notes, which a last line then reports.
void shorten(std::vector<Entry>& notes, bool is_grouped) {
  if (height_of(notes) + (is_grouped ? 1 : 0) <= kMostNoteLines) {
    if (is_grouped) notes.push_back({"note: -v lists each by itself", ""});
    return;
  }
  for (Entry& note : notes) note.hint.clear();
  const std::size_t shown = std::min(notes.size(), kMostNoteLines - 1), left_out = notes.size() - shown;
  notes.resize(shown);
  const std::string more = left_out == 0 ? "" : std::to_string(left_out) + " more; ";
  notes.push_back({"note: " + more + "-v lists each by itself, with what to do", ""});
}

std::string one_by_one(const std::vector<Diagnostic>& diagnostics) {
  std::string text;
  for (const Diagnostic& diagnostic : diagnostics) text += to_string(diagnostic) + "\n";
  return text;
}

}  // namespace

std::string findings_text(const Diagnostics& diagnostics, const OutputStyle& style) {
  std::vector<Diagnostic> notes, others;
  for (const Diagnostic& diagnostic : diagnostics.all()) {
    (diagnostic.severity == Severity::note ? notes : others).push_back(diagnostic);
  }
  if (style.quiet) notes.clear();
  if (style.verbose) return one_by_one(notes) + one_by_one(others);
  std::vector<Entry> block;
  const std::vector<Group> groups = grouped(notes);
  for (const Group& group : groups) block.push_back(entry_of(group));
  shorten(block, groups.size() < notes.size());
  for (const Group& group : grouped(others)) block.push_back(entry_of(group));
  std::string text;
  for (const Entry& entry : block) text += entry.text();
  return text;
}

}  // namespace flatdyn
