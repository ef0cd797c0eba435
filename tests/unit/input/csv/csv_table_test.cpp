// SPDX-License-Identifier: GPL-2.0-or-later
#include "robot/input/csv/table.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "support/robot_models.hpp"

namespace flatdyn {
namespace {

using ::testing::ElementsAre;

class Csv : public ::testing::Test {
 protected:
  // Reads `text` from a file of its own; the messages, each as "line: text", are left in `messages`.
  CsvTable read(const std::string& text) {
    std::ofstream(path_, std::ios::binary) << text;
    Diagnostics diagnostics;
    CsvTable table = read_csv(path_, diagnostics);
    const LoadedRobot arm = testing::model_of("planar_2r_example_7_2.toml");
    CsvHeading heading = table.heading(path_.string(), arm.mechanism, diagnostics);
    std::vector<CsvSource> sources;
    for (const auto& source : heading.find(CsvQuantity::q)) {
      if (source) sources.push_back(*source);
    }
    check_entries(table, sources, heading, path_.string(), diagnostics);
    for (const Diagnostic& each : diagnostics.all()) {
      EXPECT_EQ(each.place.file, path_.string());
      messages.push_back(std::to_string(each.place.line) + ": " + each.message);
    }
    std::filesystem::remove(path_);
    return table;
  }
  std::vector<std::string> messages;

 private:
  std::filesystem::path path_ =
      std::filesystem::path(::testing::TempDir()) /
      (std::string("flatdyn_csv_") + ::testing::UnitTest::GetInstance()->current_test_info()->name() + ".csv");
};

TEST_F(Csv, KeepsDecimalsAsWritten) {
  const CsvTable table = read("# a log\nq1, qd1\n0.10, -1e-3\r\n\n 3 ,+.5\n");
  EXPECT_THAT(messages, ElementsAre());
  EXPECT_THAT(table.columns, ElementsAre("q1", "qd1"));
  EXPECT_THAT(table.rows, ElementsAre(ElementsAre("0.10", "-1e-3"), ElementsAre("3", "+.5")));
  EXPECT_THAT(table.lines, ElementsAre(3, 5));
}

TEST_F(Csv, NamesLineAndColumnOfWhatIsNoNumber) {
  read("q1,q2\n1,2\n1,two\nnan,inf\n0x10,1\n");
  EXPECT_THAT(messages, ElementsAre("3: column \"q2\": \"two\" is not a finite number",
                                    "4: column \"q1\": \"nan\" is not a finite number",
                                    "4: column \"q2\": \"inf\" is not a finite number",
                                    "5: column \"q1\": \"0x10\" is not a finite number"));
}

TEST_F(Csv, CountsColumns) {
  read("q1,q2\n1\n1,2,3\n1,\n");
  EXPECT_THAT(messages,
              ElementsAre("2: 1 entries, but the heading has 2 columns", "3: 3 entries, but the heading has 2 columns",
                          "4: column \"q2\": \"\" is not a finite number"));
}

TEST_F(Csv, WantsDifferentNames) {
  read("# a comment\nq1,q1,\n1,2,3\n");
  EXPECT_THAT(messages, ElementsAre("2: column \"q1\" is there twice"));
}

// As a spreadsheet of another country writes it.
TEST_F(Csv, TakesSemicolonsDecimalCommasQuotesAndTabs) {
  for (const char* text :
       {"\xEF\xBB\xBFsep=;\r\nroom;\"q1\";q2\r\nkitchen, small;\"1,5\";-2\r\n",
        "room\tq1\tq2\nkitchen, small\t1.5\t-2\n", "room, q1, q2\n\"kitchen, small\", 1.5, \"-2\"\n"}) {
    const CsvTable table = read(text);
    EXPECT_THAT(messages, ElementsAre()) << text;
    EXPECT_THAT(table.columns, ElementsAre("room", "q1", "q2")) << text;
    EXPECT_THAT(table.rows, ElementsAre(ElementsAre("kitchen, small", "1.5", "-2"))) << text;
  }
}

TEST_F(Csv, DoesNotGuessWhatAPointIs) {
  read("q1;q2;date\n1,5;2;12.05.2024\n1.234;2;\n1.234,5;0;\n");
  EXPECT_THAT(messages, ElementsAre("3: column \"q1\": \"1.234\": decimal commas and decimal points in one file",
                                    "4: column \"q1\": \"1.234,5\": decimal commas and decimal points in one file"));
}

TEST_F(Csv, NoticesJointsThatChangeTheirOrder) {
  read("name[0],name[1],position[0],position[1]\ntheta_2,theta_1,0,1\ntheta_1,theta_2,1,0\n");
  EXPECT_THAT(messages, ElementsAre("3: column \"name[0]\": \"theta_1\" is not \"theta_2\", as in the first row",
                                    "3: column \"name[1]\": \"theta_2\" is not \"theta_1\", as in the first row"));
}

TEST_F(Csv, SaysWhatIsNoCsv) {
  read(std::string("\xFF\xFEq\0001\0", 6));
  read("q1,room\n0,K\xFC\x63he\n");
  EXPECT_THAT(messages, ElementsAre("1: the text is UTF-16, not UTF-8", "2: the line is not UTF-8"));
}

TEST_F(Csv, SaysThatThereIsNothing) {
  EXPECT_THAT(read("").rows, ElementsAre());
  EXPECT_THAT(read("q1,q2\n").rows, ElementsAre());
  EXPECT_THAT(messages, ElementsAre("0: no states in the file", "0: no states in the file"));
}

// One message per line of a wrong file would drown the first.
TEST_F(Csv, StopsAfterTwentyMessages) {
  std::string text = "q1\n";
  for (int k = 0; k < 1000; ++k) text += "x\n";
  read(text);
  EXPECT_LE(messages.size(), 21u);
}

TEST(CsvFile, ThatIsMissingIsAnInputOutputFailure) {
  Diagnostics diagnostics;
  try {
    read_csv("no/such/file.csv", diagnostics);
    FAIL();
  } catch (const Failure& failure) {
    EXPECT_EQ(failure.kind(), FailureKind::io);
    EXPECT_STREQ(failure.what(), "no/such/file.csv: cannot be read");
  }
}

}  // namespace
}  // namespace flatdyn
