// SPDX-License-Identifier: GPL-2.0-or-later
// A report says each thing once: a row of ReportFields is a column of the table that people read, a key of the JSON
// that programs read, or both.
#pragma once

#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "base/diagnostics/table.hpp"

namespace flatdyn {

template <class Thing>
struct ReportField {
  std::string heading;  // the column's, in the table, " " if it has none; "": the table has no such column
  std::string key;      // in JSON, "ns.low" for low in the object ns; "": the JSON has no such key
  std::function<nlohmann::ordered_json(const Thing&)> value;  // null: an empty cell, and no key
  std::string format = "{}";                                  // of the cell, with the syntax of fmt::format
};

template <class Thing>
using ReportFields = std::vector<ReportField<Thing>>;

// A value as a cell of a table.
std::string cell_of(const nlohmann::ordered_json& value, const std::string& format);

// Puts a value into an object under "key" or "object.key".
void put_value(nlohmann::ordered_json& object, const std::string& key, nlohmann::ordered_json value);

// The cells of a table: the headings, and a row for each thing.
template <class Thing>
std::vector<std::vector<std::string>> cells_of(const ReportFields<Thing>& fields, const std::vector<Thing>& things) {
  std::vector<std::vector<std::string>> rows(1 + things.size());
  for (const ReportField<Thing>& field : fields) {
    if (field.heading.empty()) continue;
    rows[0].push_back(field.heading);
    for (std::size_t k = 0; k < things.size(); ++k) {
      rows[1 + k].push_back(cell_of(field.value(things[k]), field.format));
    }
  }
  return rows;
}

template <class Thing>
std::string table_of(const ReportFields<Thing>& fields, const std::vector<Thing>& things) {
  return aligned_table(cells_of(fields, things));
}

template <class Thing>
nlohmann::ordered_json object_of(const ReportFields<Thing>& fields, const Thing& thing) {
  nlohmann::ordered_json object = nlohmann::ordered_json::object();
  for (const ReportField<Thing>& field : fields) {
    if (!field.key.empty()) put_value(object, field.key, field.value(thing));
  }
  return object;
}

// A list of objects, one for each thing; [] if there is none.
template <class Thing>
nlohmann::ordered_json objects_of(const ReportFields<Thing>& fields, const std::vector<Thing>& things) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const Thing& thing : things) list.push_back(object_of(fields, thing));
  return list;
}

}  // namespace flatdyn
