// SPDX-License-Identifier: GPL-2.0-or-later
#include "robot/input/common/unknown_names.hpp"

#include <algorithm>

#include "base/diagnostics/nearest.hpp"
#include "robot/input/common/spelling.hpp"
#include "robot/input/common/words.hpp"

namespace flatdyn {

bool UnknownNames::goes_into(const FileNode&, const FileNode&) const { return true; }

std::string UnknownNames::name_in(const std::string& holder, const FileNode& element) const {
  return element.has("name") ? name_in_messages(element) : holder + ", " + element.name;
}

bool UnknownNames::refuse_by_format(const FileNode&, const std::string&) { return false; }

bool UnknownNames::says_nothing(const FileNode& element) const {
  return is_zero_text(element.text) && std::all_of(element.children.begin(), element.children.end(),
                                                   [this](const FileNode& each) { return says_nothing(each); });
}

bool UnknownNames::is_refused_by_name(const FileNode& element) const {
  return is_dynamics_name(element.name) && !says_nothing(element);
}

// The known name that was meant; "" if none is near, unless the format refuses every other name.
std::string UnknownNames::hint_for(const std::string& name, const SchemaNames& names, bool is_element) const {
  const char* plural = is_element ? "elements" : "attributes";
  if (format_.is_strict) return names.all().empty() ? "delete it" : hint_for_unknown(name, names.all(), plural);
  const bool is_of_others = has_namespace(name) && (!format_.is_strict_of_prefix || is_force_or_constraint_name(name));
  if (const std::string meant = known_spelling_of(name, names.read()); !meant.empty() && !is_of_others) {
    return "names in " + format_.name + " are told apart by case and prefix: write " +
           (is_element ? "<" + meant + ">" : meant + "=\"...\"");
  }
  const std::string hint = hint_for_unknown(name, names.read(), plural);
  return hint.starts_with("did you mean") ? hint : "";
}

bool UnknownNames::refuse_spelling(const FileNode& element, const std::string& what, const SchemaNames& names) {
  const std::string hint = hint_for(element.name, names, true);
  if (hint.empty()) return false;
  diagnostics_.error(element.place, what + ": unknown element <" + element.name + ">", hint);
  return true;
}

void UnknownNames::note(const FileNode& element, const std::string& what) {
  if (!noted_.insert(element.name).second) return;
  diagnostics_.note(
      element.place, what + ": unknown element <" + element.name + ">: not read, here and elsewhere",
      "delete it if it is meant to change how the robot moves, or write it in " + format_.name + "'s words",
      "unknown elements not read");
}

void UnknownNames::check_attributes(const FileNode& element, const std::string& what, const SchemaNames& names) {
  for (const FileAttribute& each : element.attributes) {
    if (names.know(each.name) || has_namespace(each.name)) continue;
    const std::string message = what + ": unknown attribute \"" + each.name + "\"";
    if (const std::string hint = hint_for(each.name, names, false); !hint.empty()) {
      diagnostics_.error(each.place, message, hint);
    } else if (noted_.insert(element.name + " " + each.name).second) {
      diagnostics_.note(each.place, message + ": not read, here and in every <" + element.name + ">",
                        "delete it, or write it in " + format_.name + "'s words", "unknown attributes not read");
    }
  }
}

void UnknownNames::check_child(const FileNode& child, const std::string& what, const SchemaNames& names) {
  if (refuse_spelling(child, what, names) || refuse_by_format(child, what)) return;
  if (!is_refused_by_name(child)) return note(child, what);
  diagnostics_.unsupported(child.place,
                           what + ": <" + child.name + "> is not known, and by its name it changes how the robot moves",
                           "write it in the words of " + format_.page + ", or delete it");
}

void UnknownNames::check_text(const FileNode& element, const std::string& what) {
  const std::vector<std::string> words = words_of(element.text);
  if (words.empty() || !noted_.insert("text of " + element.name).second) return;
  diagnostics_.note(element.place, what + ": the text \"" + joined_words(words) + "\" is not read",
                    "a comment is <!-- ... -->", "unknown elements not read");
}

void UnknownNames::check(const FileNode& element, const std::string& what, const std::string& holder) {
  const SchemaRow* row = schema_.find(element.name, holder);
  if (row == nullptr) return;
  check_attributes(element, what, row->attributes);
  if (!format_.is_strict && !row->reads_text) check_text(element, what);
  for (const FileNode& child : element.children) {
    if (!row->children.know(child.name)) {
      check_child(child, what, row->children);
    } else if (goes_into(child, element)) {
      check(child, name_in(what, child), element.name);
    }
  }
}

}  // namespace flatdyn
