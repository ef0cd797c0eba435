// SPDX-License-Identifier: GPL-2.0-or-later
// Fields say once what a table shows and what its JSON has.
#include "report/fields.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <optional>

namespace flatdyn {
namespace {

struct Motor {
  std::string name;
  int poles;
  double time;
  std::optional<double> limit;
};

const std::vector<Motor> kMotors = {{"α", 4, 0.25, 12.5}, {"hip", 12, std::numeric_limits<double>::infinity(), {}}};

ReportFields<Motor> motor_fields() {
  using Json = nlohmann::ordered_json;
  return {{"motor", "name", &Motor::name},
          {"poles", "", &Motor::poles, "{:03}"},
          {"ms", "", [](auto& motor) { return 1000 * motor.time; }, "{:.1f}"},
          {"", "time.constant", &Motor::time},
          {"", "time.half", [](auto& motor) { return motor.time / 2; }},
          {"limit", "limit", [](auto& motor) { return motor.limit ? Json(*motor.limit) : Json(); }, "{} N m"},
          {" ", "", [](auto& motor) { return motor.limit ? "limited" : "free"; }}};
}

TEST(Fields, AreColumnsOfATable) {
  EXPECT_EQ(table_of(motor_fields(), kMotors),
            "motor  poles  ms     limit\n"
            "α      004    250.0  12.5 N m  limited\n"
            "hip    012    inf              free\n");
}

TEST(Fields, AreKeysInJson) {
  EXPECT_EQ(objects_of(motor_fields(), kMotors).dump(),
            R"([{"name":"α","time":{"constant":0.25,"half":0.125},"limit":12.5},)"
            R"({"name":"hip","time":{"constant":null,"half":null}}])");
  EXPECT_EQ(objects_of(motor_fields(), {}).dump(), "[]");
}

}  // namespace
}  // namespace flatdyn
