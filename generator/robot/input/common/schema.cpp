// SPDX-License-Identifier: GPL-2.0-or-later
#include "robot/input/common/schema.hpp"

#include <algorithm>

#include "robot/input/common/words.hpp"

namespace flatdyn {

namespace {

bool has_name(const std::vector<std::string>& names, std::string_view name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

}  // namespace

SchemaNames::SchemaNames(std::string_view read, std::string_view irrelevant)
    : read_(words_of(std::string(read))), irrelevant_(words_of(std::string(irrelevant))) {}

bool SchemaNames::know(std::string_view name) const {
  return has_name(read_, name) || has_name(irrelevant_, name) || has_name(irrelevant_, "*");
}

std::vector<std::string> SchemaNames::all() const {
  std::vector<std::string> names = read_;
  names.insert(names.end(), irrelevant_.begin(), irrelevant_.end());
  return names;
}

Schema::Schema(std::initializer_list<SchemaRow> rows) : rows_(rows) {}

const SchemaRow* Schema::find(const std::string& element, const std::string& holder) const {
  const auto called = [this](const std::string& name) {
    return std::find_if(rows_.begin(), rows_.end(), [&name](const SchemaRow& row) { return row.element == name; });
  };
  auto found = called(holder + "/" + element);
  if (found == rows_.end()) found = called(holder + "/*");
  if (found == rows_.end()) found = called(element);
  return found == rows_.end() ? nullptr : &*found;
}

}  // namespace flatdyn
