// SPDX-License-Identifier: GPL-2.0-or-later
// The names that a format has, as rows: which attributes and elements stand in which element, and which of them are
// read. What has no row is unknown in a file, and the page of the format in docs/robot-format/ is compared with the
// rows (`ctest -R FormatPages`).
#pragma once

#include <initializer_list>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace flatdyn {

// Names as a row writes them, with blanks between them.
class SchemaNames {
 public:
  SchemaNames(std::string_view read = {}, std::string_view irrelevant = {});

  const std::vector<std::string>& read() const { return read_; }
  // Names that have nothing to do with dynamics; "*" stands for all that are not read.
  const std::vector<std::string>& irrelevant() const { return irrelevant_; }
  bool know(std::string_view name) const;
  std::vector<std::string> all() const;  // for hints: those that are read come first

 private:
  std::vector<std::string> read_, irrelevant_;
};

struct SchemaRow {
  // "axis"; "equality/joint" where the name means something else in that element, "equality/*" of all others in it.
  std::string element;
  SchemaNames attributes = {};
  SchemaNames children = {};
  bool reads_text = false;
};

class Schema {
 public:
  Schema(std::initializer_list<SchemaRow> rows);

  const std::vector<SchemaRow>& rows() const { return rows_; }
  // The row of an element in another one, nullptr if it has none.
  const SchemaRow* find(const std::string& element, const std::string& holder = {}) const;

 private:
  std::vector<SchemaRow> rows_;
};

}  // namespace flatdyn
