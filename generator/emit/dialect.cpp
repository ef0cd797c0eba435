// SPDX-License-Identifier: GPL-2.0-or-later
#include "emit/dialect.hpp"

#include <fmt/format.h>

#include "emit/writer.hpp"

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

std::string Dialect::filled_sines(const std::string&, const std::set<int>&) const { return ""; }

std::string Dialect::input(const std::string& name) const { return "const " + scalar_ + "* " + name; }

std::string Dialect::output(const std::string& name) const { return scalar_ + "* " + name; }

std::string Dialect::number_output(const std::string& name) const { return output(name); }

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

std::string Dialect::braced_check_loop(const std::string& counter, std::size_t first, std::size_t end,
                                       const std::string& check) const {
  return code_line(fmt::format("for ({0} {1} = {2}; {1} < {3}; ++{1}) {{ {4}{5}; }}", counter, code::kCounter, first,
                               end, conditions_continue(), check),
                   kStatementIndent);
}

std::optional<std::string> Dialect::excess(const std::string&, const std::string&) const { return std::nullopt; }

std::string Dialect::written_entry(const std::string& output, int entry) const {
  return fmt::format("{}[{}]", output, entry);
}

}  // namespace flatdyn
