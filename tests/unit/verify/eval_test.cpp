// SPDX-License-Identifier: GPL-2.0-or-later
#include "proof/verify/eval.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "functions/planning/formulations.hpp"
#include "support/robots.hpp"
#include "truth/reference/reference_model.hpp"

namespace flatdyn {
namespace {

using ::testing::ElementsAre;
using testing::joint;
using ::testing::StartsWith;

// A prismatic joint that carries a pendulum of mass m: b_11 = 2 + m, b_12 = -m sin(q_2) for a lever of 1 m.
class Eval : public ::testing::Test {
 protected:
  Eval() {
    const Inertial cart{{2, {}}, {}, zero_vector(), zero_matrix(), Inertial::About::centre_of_mass, {}};
    Inertial bob{{m, {}}, {}, {1, 0, 0}, zero_matrix(), Inertial::About::centre_of_mass, {}};
    robot.name = "cart";
    robot.links = {{"base", {}, {}}, {"cart", {cart}, {}}, {"bob", {bob}, {}}};
    robot.joints = {joint("slide", JointType::prismatic, 0, 1, {}, {1, 0, 0}),
                    joint("swing", JointType::revolute, 1, 2, {}, {0, 0, 1})};
    robot.root = 0;
    robot.tip = 2;
    robot.gravity = {0, GiNaC::numeric(-981, 100), 0};
    robot.symbols = {{m, "m", {}}};
    mechanism = make_mechanism(robot);
  }

  CsvTable evaluate(const std::string& name, const CsvTable& table, const EvalOptions& options = {}) {
    Diagnostics diagnostics;
    const CsvTable result =
        evaluate_table(robot, mechanism, derive_function(mechanism, name), table, "states.csv", options, diagnostics);
    for (const Diagnostic& each : diagnostics.all()) messages.push_back(to_string(each));
    return result;
  }

  const GiNaC::symbol m{"m"};
  Robot robot;
  Mechanism mechanism;
  std::vector<std::string> messages;
  const CsvTable states{{"time", "m", "q1", "q2"}, {{"0.5", "3", "7", "0"}, {"0.6", "0.5", "7", "0.5"}}, {2, 3}};
};

TEST_F(Eval, AppendsTheMatrixRowByRow) {
  const CsvTable result = evaluate("inertia_matrix", states);
  EXPECT_THAT(messages, ElementsAre());
  EXPECT_THAT(result.columns, ElementsAre("time", "m", "q1", "q2", "B_1_1", "B_1_2", "B_2_1", "B_2_2"));
  ASSERT_EQ(result.rows.size(), 2u);
  EXPECT_THAT(result.rows[0], ElementsAre("0.5", "3", "7", "0", "5", "0", "0", "3"));
  EXPECT_DOUBLE_EQ(std::stod(result.rows[1][5]), -0.5 * std::sin(0.5));
}

// The CSV's 0.5 is exact, and 0.1 is a tenth, not the double next to it.
TEST_F(Eval, GivesFiftyDigitsFromTheGraphAndFromTheReference) {
  const CsvTable tenth{{"q1", "q2", "m"}, {{"0", "0.1", "1"}}, {2}};
  const Real50 expected = -sin(Real50("0.1"));
  for (const bool reference : {false, true}) {
    const CsvTable result = evaluate("inertia_matrix", tenth, {.reference = reference, .digits = 50});
    ASSERT_EQ(result.rows.size(), 1u);
    EXPECT_LE(abs(Real50(Real50(result.rows[0][4]) - expected)), Real50("1e-49")) << result.rows[0][4];
  }
}

TEST_F(Eval, RoundsToTheDigitsAskedFor) {
  const CsvTable result = evaluate("inertia_matrix", states, {.digits = 3});
  EXPECT_EQ(result.rows.at(1).at(5), "-0.24");
}

TEST_F(Eval, TakesJointNames) {
  const CsvTable named{{"q_slide", "q_swing", "m"}, {{"7", "0.5", "0.5"}}, {2}};
  EXPECT_EQ(evaluate("inertia_matrix", named).rows.at(0).at(4), evaluate("inertia_matrix", states).rows.at(1).at(5));
}

// A column for an input that this robot's function does not need is not unknown.
TEST_F(Eval, NamesColumnsThatTheFunctionDoesNotTake) {
  evaluate("gravity", {{"m", "q1", "q2", "qd1", "room", "time"}, {{"1", "1", "2", "3", "kitchen", "x"}}, {2}});
  EXPECT_THAT(messages, ElementsAre("states.csv:1: note: columns that are not used: qd1, room"));
}

// Columns that the function does not read must not shift those that it reads.
TEST_F(Eval, TakesColumnsCountedFromZero) {
  const CsvTable zero{{"q0", "q1", "m"}, {{"7", "0.5", "0.5"}}, {2}};
  EXPECT_EQ(evaluate("inertia_matrix", zero).rows.at(0).at(4), evaluate("inertia_matrix", states).rows.at(1).at(5));
  EXPECT_EQ(messages.at(0), "states.csv:1: note: columns counted from 0: q0 to q1");
  messages.clear();
  for (const CsvTable& unclear : {CsvTable{{"q0", "m"}, {{"7", "0.5"}}, {2}},
                                  CsvTable{{"q0", "q1", "q2", "m"}, {{"7", "0.5", "1", "0.5"}}, {2}}}) {
    EXPECT_TRUE(evaluate("inertia_matrix", unclear).rows.empty());
  }
  ASSERT_EQ(messages.size(), 2u);
  EXPECT_THAT(messages[1], ::testing::HasSubstr("error: columns q0, q1, q2 are neither q0 to q1 nor q1 to q2, "));
}

TEST_F(Eval, ConvertsDegreesExactlyAndPassesThemOn) {
  const CsvTable degrees{{"q1 [mm]", "q2 [deg]", "m"}, {{"7", "30", "1"}}, {2}};
  const CsvTable result = evaluate("inertia_matrix", degrees, {.digits = 50});
  EXPECT_THAT(result.columns, ElementsAre("q1 [mm]", "q2 [deg]", "m", "B_1_1", "B_1_2", "B_2_1", "B_2_2"));
  ASSERT_EQ(result.rows.size(), 1u);
  EXPECT_LE(abs(Real50(Real50(result.rows[0][4]) + Real50("0.5"))), Real50("1e-49"));  // -m sin 30°
}

TEST_F(Eval, TakesTipForcesByBothNames) {
  CsvTable numbered{{"m", "q1", "q2", "qd1", "qd2", "qdd1", "qdd2", "h_e1", "h_e2", "h_e3", "h_e4", "h_e5", "h_e6"},
                    {{"1", "0", "0", "0", "0", "0", "0", "10", "20", "30", "1", "2", "3"}},
                    {2}};
  const CsvTable first = evaluate("inverse_dynamics_tip_force", numbered);
  const char* const names[] = {"fx", "fy", "fz", "mx", "my", "mz"};
  for (std::size_t k = 0; k < 6; ++k) numbered.columns[7 + k] = names[k];
  const CsvTable second = evaluate("inverse_dynamics_tip_force", numbered);
  ASSERT_EQ(first.rows.size(), 1u);
  EXPECT_EQ(first.rows, second.rows);
  // The tip is at the joint: gravity acts on the bob alone, and the moment about z is the third entry.
  EXPECT_THAT(first.rows[0][13], "10");
  EXPECT_THAT(first.rows[0][14], "12.81");
}

TEST_F(Eval, NamesColumnsThatAreMissing) {
  evaluate("gravity", {{"q1", "q2"}, {{"1", "2"}}, {2}});
  evaluate("inertia_matrix", {{"m", "q1"}, {{"1", "2"}}, {2}});
  EXPECT_THAT(messages, ElementsAre("states.csv:1: error: column m is missing; gravity reads it",
                                    "states.csv:1: error: column q2 is missing; inertia_matrix reads it\n"
                                    "    hint: by joint, it is called q_swing"));
  messages.clear();
  evaluate("kinetic_energy", {{"m", "q1", "q2"}, {{"1", "1", "2"}}, {2}});
  ASSERT_EQ(messages.size(), 1u);
  EXPECT_THAT(messages[0], StartsWith("states.csv:1: error: columns qd1, qd2 are missing; kinetic_energy reads them\n"
                                      "    hint: by joint, they are called qd_"));
}

// Without the bob's mass the second joint moves no mass, so there is no acceleration to return.
TEST_F(Eval, RefusesAnIndefiniteInertiaMatrix) {
  const CsvTable table{{"m", "q1", "q2", "qd1", "qd2", "tau1", "tau2"},
                       {{"1", "0", "0", "0", "0", "1", "1"}, {"0", "0", "0", "0", "0", "1", "1"}},
                       {2, 5}};
  EXPECT_TRUE(evaluate("forward_dynamics", table).rows.empty());
  ASSERT_EQ(messages.size(), 1u);
  EXPECT_THAT(messages[0], ::testing::HasSubstr("states.csv:5: error: the inertia matrix is not positive definite"));
}

TEST_F(Eval, WritesCsv) {
  EXPECT_EQ(to_text(CsvTable{{"a", "b, c"}, {{"say \"x\"", "1"}}, {2}}), "a,\"b, c\"\n\"say \"\"x\"\"\",1\n");
  EXPECT_EQ(to_text(CsvTable{{"a", "b"}, {{"1", "2.50"}, {"3", "-4e-9"}}, {2, 3}}), "a,b\n1,2.50\n3,-4e-9\n");
}

}  // namespace
}  // namespace flatdyn
