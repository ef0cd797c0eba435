// SPDX-License-Identifier: GPL-2.0-or-later
#include "robot/input/csv/units.hpp"

#include <algorithm>

namespace flatdyn {
namespace {

struct Unit {
  std::string name;
  Number factor;
};

Number tenth_to_the(int exponent) { return GiNaC::pow(GiNaC::numeric(1, 10), exponent); }

std::vector<Unit> angles(const std::string& over_time) {
  return {{"rad" + over_time, 1}, {"deg" + over_time, GiNaC::Pi / 180}};
}

std::vector<Unit> lengths(const std::string& over_time) {
  return {{"m" + over_time, 1}, {"mm" + over_time, tenth_to_the(3)}, {"cm" + over_time, tenth_to_the(2)}};
}

// SI first.
std::vector<Unit> units_of(CsvDimension dimension) {
  switch (dimension) {
    case CsvDimension::none:
      return {};
    case CsvDimension::time:
      return {{"s", 1}, {"ms", tenth_to_the(3)}, {"us", tenth_to_the(6)}, {"ns", tenth_to_the(9)}};
    case CsvDimension::angle:
      return angles("");
    case CsvDimension::angle_rate:
      return angles("/s");
    case CsvDimension::angle_acceleration:
      return angles("/s2");
    case CsvDimension::length:
      return lengths("");
    case CsvDimension::length_rate:
      return lengths("/s");
    case CsvDimension::length_acceleration: {
      std::vector<Unit> units = lengths("/s2");
      units.push_back({"g", GiNaC::numeric(980665, 100000)});
      return units;
    }
    case CsvDimension::force:
      return {{"N", 1}, {"kN", 1000}, {"mN", tenth_to_the(3)}};
    case CsvDimension::moment:
      return {{"Nm", 1}, {"kNm", 1000}, {"mNm", tenth_to_the(3)}, {"Nmm", tenth_to_the(3)}};
    case CsvDimension::current:
      return {{"A", 1}, {"mA", tenth_to_the(3)}};
    case CsvDimension::temperature:
      return {{"degC", 1}, {"C", 1}};
  }
  return {};
}

void replace_all(std::string& text, const std::string& from, const std::string& to) {
  for (auto at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size())) {
    text.replace(at, from.size(), to);
  }
}

// As the tables have it: "N m" → "Nm", "°/s²" → "deg/s2".
std::string as_in_tables(std::string unit) {
  static const std::pair<const char*, const char*> kSpellings[] = {
      {" ", ""},          {"*", ""},           {"^", ""},         {"\xC2\xB7", ""},
      {"\xC2\xB2", "2"},  {"\xC2\xB0", "deg"}, {"\xC2\xB5", "u"}, {"\xCE\xBC", "u"},
      {"degrees", "deg"}, {"radians", "rad"},  {"seconds", "s"},  {"sec", "s"}};
  for (const auto& [from, to] : kSpellings) replace_all(unit, from, to);
  return unit;
}

}  // namespace

std::optional<Number> unit_factor(const std::string& unit, CsvDimension dimension) {
  const std::vector<Unit> units = units_of(dimension);
  const auto known = std::find_if(units.begin(), units.end(),
                                  [name = as_in_tables(unit)](const Unit& each) { return each.name == name; });
  return known == units.end() ? std::nullopt : std::optional(known->factor);
}

std::vector<std::string> known_units(CsvDimension dimension) {
  std::vector<std::string> names;
  for (const Unit& unit : units_of(dimension)) names.push_back(unit.name);
  return names;
}

}  // namespace flatdyn
