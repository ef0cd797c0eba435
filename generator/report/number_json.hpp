// SPDX-License-Identifier: GPL-2.0-or-later
// Exact numbers in JSON: a number, or the text of an expression in the free symbols.
#pragma once

#include <nlohmann/json.hpp>

#include "derivation/notation/number_text.hpp"

namespace flatdyn {

inline nlohmann::ordered_json number_json(const Number& number, const NumberText& text) {
  if (has_symbols(number)) return text(number);
  return nearest_double(number);
}

template <class Numbers>
nlohmann::ordered_json list_json(const Numbers& numbers, const NumberText& text) {
  nlohmann::ordered_json json = nlohmann::ordered_json::array();
  for (const Number& number : numbers) json.push_back(number_json(number, text));
  return json;
}

inline nlohmann::ordered_json matrix_json(const Mat3& matrix, const NumberText& text) {
  nlohmann::ordered_json json = nlohmann::ordered_json::array();
  for (const Vec3& row : matrix) json.push_back(list_json(row, text));
  return json;
}

}  // namespace flatdyn
