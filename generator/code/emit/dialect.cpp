// SPDX-License-Identifier: GPL-2.0-or-later
#include "code/emit/dialect.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace flatdyn {
namespace {

constexpr std::size_t kRowIndent = 4;

}  // namespace

std::string Dialect::text(const std::string& value) const { return quoted(value); }

std::string Dialect::angle_function(const std::string& function, const std::string& angle) const {
  return fmt::format("{}({})", function, angle);
}

std::string Dialect::fused(const std::string& a, const std::string& b, const std::string& c) const {
  return fmt::format("fma({}, {}, {})", a, b, c);
}

std::string Dialect::filled_sines(const code::FillSines&) const { return ""; }

std::string Dialect::input(const std::string& name, std::size_t) const { return "const " + scalar_ + "* " + name; }

std::string Dialect::output(const std::string& name, std::size_t) const { return scalar_ + "* " + name; }

std::string Dialect::number_output(const std::string& name) const { return output(name, 1); }

std::string Dialect::array(const std::string& name, const std::string& length) const {
  return fmt::format("{}[{}]", name, length);
}

std::string Dialect::entry(const code::TableEntry& entry) const {
  if (const auto* words = std::get_if<std::string>(&entry)) return text(*words);
  if (const auto* number = std::get_if<Rational>(&entry)) return real_literal(*number);
  if (const auto* missing = std::get_if<code::Infinity>(&entry)) return infinity(missing->is_negative);
  if (const auto* whole = std::get_if<int>(&entry)) return std::to_string(*whole);
  return flag(std::get<code::Flag>(entry).is_set);
}

std::string Dialect::definition(const code::Table& table) const {
  const std::string begin = definition_begin(table), end = definition_end();
  std::vector<std::string> entries;
  for (const code::TableEntry& each : table.entries) entries.push_back(entry(each));
  if (table.row == 0) return list_line(begin, entries, end, 0);
  std::string lines = begin + "\n";
  const auto row = static_cast<std::size_t>(table.row);
  for (std::size_t k = 0; k < entries.size(); k += row) {
    const auto first = entries.begin() + static_cast<std::ptrdiff_t>(k);
    const bool is_last = k + row >= entries.size();
    lines += list_line("", {first, first + static_cast<std::ptrdiff_t>(row)}, is_last ? end : ",", kRowIndent);
  }
  return lines;
}

std::string Dialect::declaration(const code::Table&) const { return ""; }

std::string Dialect::declarations(const std::string& begin, const std::vector<std::string>& rests) const {
  return list_line(begin, rests, ";", kStatementIndent);
}

std::string Dialect::stored(const std::vector<std::string>& places, const std::string& value) const {
  return fmt::format("{} = {};", fmt::join(places, " = "), value);
}

std::string Dialect::stored_zeros(const std::string&, std::size_t, std::size_t) const { return ""; }

std::string Dialect::finite(const std::string& number) const {
  return fmt::format("{} * {} < {}", literal(0), number, literal(1));
}

std::string Dialect::check_finite(const std::string& array, std::size_t first, std::size_t end) const {
  return check_loop(first, end, finite(fmt::format("{}[{}]", array, code::kCounter)));
}

std::string Dialect::check_positive(const std::string& array, std::size_t length) const {
  return check_loop(0, length, fmt::format("{}[{}] > {}", array, code::kCounter, literal(0)));
}

std::string Dialect::check_loop(std::size_t first, std::size_t end, const std::string& check) const {
  return code_line(fmt::format("for ({0} {1} = {2}; {1} < {3}; ++{1}) {{ {4}{5}; }}", counter_type(), code::kCounter,
                               first, end, conditions_continue(), check),
                   kStatementIndent);
}

std::optional<std::string> Dialect::excess(const std::string&, const std::string&) const { return std::nullopt; }

std::string Dialect::written_entry(const std::string& output, int entry) const {
  return fmt::format("{}[{}]", output, entry);
}

}  // namespace flatdyn
