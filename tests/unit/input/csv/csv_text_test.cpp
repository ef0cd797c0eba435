// SPDX-License-Identifier: GPL-2.0-or-later
#include "robot/input/csv/text.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/diagnostics/characters.hpp"
#include "robot/input/csv/units.hpp"

namespace flatdyn {
namespace {

using ::testing::ElementsAre;

TEST(CsvText, SeparatorsAreTold) {
  EXPECT_EQ(separator_of("t,q1"), ',');
  EXPECT_EQ(separator_of("t;q1"), ';');
  EXPECT_EQ(separator_of("t\tq1"), '\t');
  EXPECT_EQ(separator_of("t,\tq1"), ',');
  EXPECT_EQ(separator_of("q1"), ',');
  EXPECT_EQ(separator_of("\"q;1\",t"), ',');
}

TEST(CsvText, EntriesMayBeQuoted) {
  EXPECT_THAT(csv_entries("a, b ,\"c,d\",\"say \"\"x\"\"\",", ','), ElementsAre("a", "b", "c,d", "say \"x\"", ""));
  EXPECT_THAT(csv_entries("\"a,b", ','), ElementsAre("\"a", "b"));
  EXPECT_THAT(csv_entries("", ','), ElementsAre(""));
  EXPECT_THAT(csv_entries("\"\",\"\"\"\"", ','), ElementsAre("", "\""));
  for (const char* text : {"plain", "c,d", "say \"x\"", " a "}) {
    EXPECT_THAT(csv_entries(csv_entry(text), ','), ElementsAre(trimmed(text)));
  }
}

TEST(CsvText, ADecimalCommaIsReadWhereCommasDoNotSeparate) {
  DecimalMarks marks(';');
  std::string comma = "-1,5e3", point = "1.5", thousand = "1.234,5", name = "a,b";
  EXPECT_TRUE(marks.normalise(comma));
  EXPECT_EQ(comma, "-1.5e3");
  EXPECT_TRUE(marks.normalise(name));
  EXPECT_EQ(name, "a,b");
  EXPECT_FALSE(marks.normalise(thousand));
  EXPECT_FALSE(marks.normalise(point));
  DecimalMarks commas_separate(',');
  EXPECT_FALSE(commas_separate.may_be_commas());
}

TEST(CsvText, OtherFilesAreTold) {
  const std::pair<std::string, const char*> lines[] = {
      {"\x1F\x8B\b", "the file is compressed"},
      {std::string("\xFF\xFEt\0,\0", 6), "the text is UTF-16, not UTF-8"},
      {std::string("\0t\0,", 4), "the file is no text, or it is UTF-16"},
      {"PK\x03\x04", "this is a zip archive or a spreadsheet, not CSV"},
      {"#ROSBAG V2.0", "this is a bag, not CSV"},
      {"t,q1 [\xB0]", "the heading is not UTF-8"},
      {"t,q1\r0,1\r", "lines end with a carriage return alone"},
      {"0,1,-2e3", "there is a row of numbers where the heading is expected"},
  };
  for (const auto& [line, message] : lines) {
    Diagnostics found;
    EXPECT_FALSE(is_csv_heading(line, {"log.csv", 1}, found));
    ASSERT_EQ(found.all().size(), 1u) << message;
    EXPECT_EQ(found.all()[0].message, message);
    EXPECT_NE(found.all()[0].hint, "");
  }
  Diagnostics found;
  EXPECT_TRUE(is_csv_heading("t,q1 [\xC2\xB0]", {"log.csv", 1}, found));
}

TEST(CsvUnits, AreReadAsPeopleWriteThem) {
  for (const char* unit : {"deg/s^2", "deg/s2", "\xC2\xB0/s\xC2\xB2", "degrees/s^2"}) {
    EXPECT_EQ(unit_factor(unit, CsvDimension::angle_acceleration).value_or(0), GiNaC::Pi / 180) << unit;
  }
  for (const char* unit : {"N m", "Nm", "N*m", "N\xC2\xB7m"}) {
    EXPECT_EQ(unit_factor(unit, CsvDimension::moment).value_or(0), 1) << unit;
  }
  EXPECT_EQ(unit_factor("\xC2\xB5s", CsvDimension::time).value_or(0), GiNaC::numeric(1, 1000000));
  EXPECT_EQ(unit_factor("sec", CsvDimension::time).value_or(0), 1);
  EXPECT_FALSE(unit_factor("deg", CsvDimension::length));
  EXPECT_FALSE(unit_factor("kg", CsvDimension::none));
}

}  // namespace
}  // namespace flatdyn
