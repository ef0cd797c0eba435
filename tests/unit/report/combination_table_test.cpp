// SPDX-License-Identifier: GPL-2.0-or-later
#include "report/combination_table.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>

#include "base/diagnostics/table.hpp"
#include "support/robot_models.hpp"

namespace flatdyn {
namespace {

using ::testing::HasSubstr;
using testing::model_of;

std::string table_of(const std::string& robot, ParameterFrames frames) {
  const Mechanism mechanism = model_of(robot).mechanism;
  const BaseParameters base = base_parameters(mechanism);
  std::vector<CombinationRow> rows;
  for (int k = 0; k < base.size(); ++k) rows.push_back({k, {std::to_string(k)}});
  return combination_table({"pi_b"}, rows, Combinations(mechanism, base, frames));
}

TEST(CombinationTable, HasLongSumsOnSeveralLines) {
  const std::string table = table_of("panda.urdf", ParameterFrames::file);
  EXPECT_THAT(table, HasSubstr("\n9     mly(panda_link3) - mlz(panda_link4)\n"));
  EXPECT_THAT(table, HasSubstr("\n      + 0.0825 m("));
  std::istringstream lines(table);
  for (std::string line; std::getline(lines, line);) EXPECT_LE(text_width(line), kReportWidth) << line;
}

TEST(CombinationTable, IsExplained) {
  const Mechanism mechanism = model_of("panda.urdf").mechanism;
  EXPECT_THAT(note_on_frames(mechanism, ParameterFrames::file),
              HasSubstr("in the link frames of the robot file: m(L)"));
  EXPECT_THAT(note_on_names(mechanism, ParameterFrames::file), HasSubstr("(--frames canonical)\n"));
  EXPECT_THAT(note_on_frames(mechanism, ParameterFrames::canonical), HasSubstr("in canonical frames (z along"));
  EXPECT_EQ(note_on_names(mechanism, ParameterFrames::canonical), "");
  EXPECT_THAT(note_on_frames(model_of("rx90.toml").mechanism, ParameterFrames::file),
              HasSubstr("the robot file, which are the canonical ones"));
}

}  // namespace
}  // namespace flatdyn
