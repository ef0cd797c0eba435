// SPDX-License-Identifier: GPL-2.0-or-later
#include "report/fields.hpp"

#include <fmt/format.h>

namespace flatdyn {

std::string cell_of(const nlohmann::ordered_json& value, const std::string& format) {
  if (value.is_null()) return "";
  const auto form = fmt::runtime(format);
  if (value.is_string()) return fmt::format(form, value.get_ref<const std::string&>());
  if (value.is_number_float()) return fmt::format(form, value.get<double>());
  return fmt::format(form, value.get<long long>());
}

void put_value(nlohmann::ordered_json& object, const std::string& key, nlohmann::ordered_json value) {
  if (value.is_null()) return;
  const std::size_t dot = key.find('.');
  nlohmann::ordered_json& place =
      dot == std::string::npos ? object[key] : object[key.substr(0, dot)][key.substr(dot + 1)];
  place = std::move(value);
}

}  // namespace flatdyn
