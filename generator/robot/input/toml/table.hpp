// SPDX-License-Identifier: GPL-2.0-or-later
// A table of a TOML robot file: values by key, exact and with their place; every key that was not asked for is an
// error.
#pragma once

#include <toml++/toml.h>

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "robot/input/common/context.hpp"

namespace flatdyn {

// The file that tables belong to. The text is kept: numbers are read from it, not from toml++'s doubles.
class TomlSource {
 public:
  // documentation: of the file's keys, for hints.
  TomlSource(std::string text, std::string file, ReadContext& context,
             std::string documentation = "docs/robot-format/toml.md");

  // nullopt and a diagnostic if the text is no TOML.
  std::optional<toml::table> parse() const;

  Place place(const toml::source_region& region) const;
  // The text between the region's begin and end, which are in one line.
  std::string text_of(const toml::source_region& region) const;
  ReadContext& context() const { return context_; }
  // The units of the file's numbers; files of a kind that has no keys for that leave it as it is.
  void set_units(const Units& units) { units_ = units; }
  const Units& units() const { return units_; }
  const std::string& documentation() const { return documentation_; }

 private:
  std::string text_;
  std::string file_;
  ReadContext& context_;
  std::string documentation_;
  std::vector<std::size_t> line_starts_;
  Units units_;
};

class TomlTable {
 public:
  // what: e.g. `link "shoulder"`; empty for the file's outermost table.
  TomlTable(const toml::table& table, std::string what, const TomlSource& source)
      : table_(table), what_(std::move(what)), source_(source) {}

  const std::string& what() const { return what_; }
  void rename(std::string what) { what_ = std::move(what); }
  Place place() const { return source_.place(table_.source()); }
  Place place_of(std::string_view key) const;  // of the table if the key is not there
  bool has(std::string_view key) const { return table_.contains(key); }

  std::optional<std::string> text(std::string_view key);
  std::optional<Reference> reference(std::string_view key);
  std::vector<Reference> references(std::string_view key);
  std::optional<bool> boolean(std::string_view key);
  bool is_text(std::string_view key) const { return has(key) && table_.get(key)->is_string(); }
  bool is_table(std::string_view key) const { return has(key) && table_.get(key)->is_table(); }
  bool is_list(std::string_view key) const { return has(key) && table_.get(key)->is_array(); }

  // The entries of a list; 0 where the key is not there or has no list.
  std::size_t list_size(std::string_view key) const { return is_list(key) ? table_.get(key)->as_array()->size() : 0; }
  void accept(std::string_view key) { find(key); }  // as a known one, which others read
  // The same table, where lists stand for one value per coordinate of a joint, of which value k is read.
  TomlTable with_element(std::size_t k, const std::string& what) const;

  // For tables whose keys are names.
  std::vector<std::string> keys() const;
  // JOINT = POSITION
  std::optional<JointPosition> locked_joint(const std::string& joint);
  // The position of a coupled joint, linear in the coordinates of others.
  std::optional<Coupled> linear_position(std::string_view key, JointType type);
  // The length of a tendon, a sum of joint positions; a constant in it is in rad or m.
  std::optional<Coupled> tendon_length(std::string_view key);

  // Lengths and angles are brought to m and rad. Of limits, `quantity` is that of the joint's position.
  // nullopt if the key is not there, or, with an error, if it is no number or expression.
  std::optional<Value> number(std::string_view key, Quantity quantity);
  Value number_or_zero(std::string_view key, Quantity quantity);
  // A number without symbols; infinite means none.
  std::optional<Value> limit(std::string_view key, Quantity quantity, Bound bound);
  Vec3 vector(std::string_view key, Quantity quantity, const Vec3& fallback);
  // A list of any length; nullopt if the key is not there, or, with an error, if it is no list of numbers.
  std::optional<std::vector<Value>> numbers(std::string_view key);

  // Without symbols: `count` of them as a list, or one that stands for all. nullopt if the key is not there or, with an
  // error, if it is neither of these.
  std::optional<std::vector<Value>> numbers(std::string_view key, std::size_t count);

  // Angles in rad. Decimals are snapped; expressions are as they are.
  Number angle(std::string_view key);
  Vec3 angles(std::string_view key);

  std::optional<TomlTable> table(std::string_view key, const std::string& hint = {});
  std::vector<TomlTable> tables(std::string_view key);  // [[key]]

  // Reports each key that none of the above has been asked for. Call it last.
  void reject_unknown_keys() const;

 private:
  const toml::node* find(std::string_view key);
  Spot spot(const toml::node& node, std::string_view key) const;
  std::optional<Number> number_of(const toml::node& node, std::string_view key);
  std::optional<Number> expression_of(const toml::node& node, const std::string& text, const Spot& spot);
  Number angle_of(const toml::node& node, std::string_view key);
  std::optional<Value> value_in_si(std::string_view key, Quantity quantity);
  Number in_si(const Number& written, Quantity quantity, const Spot& spot);
  const toml::array* three(std::string_view key);
  std::optional<Value> plain_number(const toml::node& node, std::string_view key);
  void report_kind(const toml::node& node, std::string_view key, const std::string& expected,
                   const std::string& hint = {}) const;  // without a hint: where the keys are listed

  const toml::table& table_;
  std::string what_;
  const TomlSource& source_;
  std::vector<std::string> known_;
  std::optional<std::size_t> element_;
};

}  // namespace flatdyn
