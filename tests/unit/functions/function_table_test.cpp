// SPDX-License-Identifier: GPL-2.0-or-later
// Every row of the table is complete, and what it says of its function holds for the derived function of several
// robots.
#include "functions/function_table.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "base/diagnostics/diagnostics.hpp"
#include "derivation/parameters/base_parameters.hpp"
#include "functions/exact_proof.hpp"
#include "functions/planning/formulations.hpp"
#include "functions/units.hpp"
#include "support/robot_models.hpp"

namespace flatdyn {
namespace {

// The number of rows or columns for a function of this robot.
int extent_of(Extent extent, const Mechanism& mechanism, const Function& function) {
  const int n = mechanism.size();
  switch (extent) {
    case Extent::one:
      return 1;
    case Extent::three:
      return 3;
    case Extent::four:
      return 4;
    case Extent::six:
      return 6;
    case Extent::joints:
      return n;
    case Extent::joint_pairs:
      return n * (n + 1) / 2;
    case Extent::positions:
      return mechanism.position_count();
    case Extent::loop_equations: {
      std::size_t rows = 0;
      for (const LoopClosure& loop : mechanism.loops) rows += loop.rows.size();
      return static_cast<int>(rows);
    }
    case Extent::task_rows:
      return static_cast<int>(function.task.rows.size());
    case Extent::parameters:
      return static_cast<int>(parameter_indices(mechanism).size());
    case Extent::base_parameters:
      return base_parameters(mechanism).size();
    case Extent::contact_rows:
      return mechanism.contact_rows();
    case Extent::cone_rows:
      return mechanism.cone_rows();
    case Extent::contact_points:
      return 3 * static_cast<int>(mechanism.contacts.size());
    case Extent::symbols:
      return static_cast<int>(mechanism.symbols.size());
    case Extent::link_rows:
      return 3 * static_cast<int>(mechanism.links.size());
    case Extent::states:
      return 2 * mechanism.size();
    case Extent::springs:
      return 2 * static_cast<int>(mechanism.bodies_on_one_axis().size());
  }
  return 0;
}

Mechanism mechanism_of(const std::string& robot) {
  return load_robot(FLATDYN_SOURCE_DIR "/robots/" + robot, {}).mechanism;
}

TEST(FunctionTable, HasRowsWithNamesOfTheirOwn) {
  std::set<std::string> names;
  for (const FunctionRow& row : function_table()) EXPECT_TRUE(names.insert(row.name).second) << row.name;
}

TEST(FunctionTable, HasADerivationADefinitionAReferenceAndAQuantityInEveryRow) {
  for (const FunctionRow& row : function_table()) {
    const DerivationRow& derivation = row.derivation;
    const int ways =
        (derivation.from_choices != nullptr) + (derivation.from_mechanism != nullptr) + (derivation.of_link != nullptr);
    EXPECT_EQ(ways, 1) << row.name;
    EXPECT_LT(derivation.alternatives.size(), kFormulationCount) << row.name;
    EXPECT_TRUE(row.definition.expected.a != nullptr && row.definition.found.c != nullptr) << row.name;
    EXPECT_NE(row.definition.degree_factor, nullptr) << row.name;
    EXPECT_TRUE(row.reference.exact != nullptr && row.reference.in_double != nullptr) << row.name;
    EXPECT_NE(row.reference.magnitude, nullptr) << row.name;
    EXPECT_FALSE(row.outputs.empty()) << row.name;
    EXPECT_NE(std::string(row.summary), "") << row.name;
    for (const OutputRow& output : row.outputs) EXPECT_NE(output.quantity, OutputQuantity::none) << row.name;
  }
}

class RowsOf : public ::testing::TestWithParam<const char*> {};

TEST_P(RowsOf, SayTheShapesArgumentsAndUnitsOfDerivedFunctions) {
  const Mechanism mechanism = mechanism_of(GetParam());
  for (const FunctionRow& row : function_table()) {
    if (!row.applies_to(mechanism)) continue;
    std::optional<Function> function;
    try {
      function = derive_function(mechanism, row.name);
    } catch (const Failure& failure) {
      EXPECT_EQ(failure.kind(), FailureKind::unsupported) << row.name << ": " << failure.what();
      continue;
    }
    for (const Input& input : inputs_read(*function)) {
      const bool is_said = input.kind == InputKind::parameter ||
                           std::find(row.inputs.begin(), row.inputs.end(), input.kind) != row.inputs.end();
      EXPECT_TRUE(is_said) << row.name;
    }
    const std::vector<OutputRow> outputs = row.outputs_for(mechanism);
    ASSERT_EQ(function->outputs.size(), outputs.size()) << row.name;
    for (std::size_t k = 0; k < outputs.size(); ++k) {
      EXPECT_EQ(function->outputs[k].rows, extent_of(outputs[k].rows, mechanism, *function)) << row.name;
      EXPECT_EQ(function->outputs[k].cols, extent_of(outputs[k].cols, mechanism, *function)) << row.name;
    }
    for (const Output& output : function->outputs) {
      for (std::size_t e = 0; e < output.entries.size(); ++e) {
        EXPECT_NE(unit_of(mechanism, *function, output, e), "") << row.name << ", " << output.name;
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Robots, RowsOf, ::testing::Values("scara.toml", "four_bar.toml"), [](const auto& instance) {
  const std::string name = instance.param;
  return name.substr(0, name.find('.'));
});

TEST(FunctionTable, IsSearchedByNamesWithAndWithoutLinks) {
  EXPECT_STREQ(find_row("jacobian:hand")->name, "jacobian");
  EXPECT_STREQ(find_row("gravity")->name, "gravity");
  EXPECT_EQ(find_row("inertia_matrix_gravity"), nullptr);
  Function unknown;
  unknown.name = "jerk";
  EXPECT_THROW(row_of(unknown), Failure);
  EXPECT_THROW(prove_exactly({}, unknown), Failure);
}

// The first two joints and the last of the SCARA turn, the third slides.
TEST(Units, GoByTheJointsThatAnEntryBelongsTo) {
  const Mechanism scara = mechanism_of("scara.toml");
  const auto units = [&scara](const std::string& name) { return units_of(scara, derive_function(scara, name)); };
  EXPECT_EQ(units("inverse_dynamics"), "N m, N");
  EXPECT_EQ(units("inertia_matrix"), "kg m^2, kg m, kg");
  EXPECT_EQ(units("christoffel"), "kg m^2, kg m, kg, kg m^-1");
  EXPECT_EQ(units("coriolis_matrix"), "N m s, N s, N s/m");
  EXPECT_EQ(units("forward_dynamics"), "rad/s^2, m/s^2");
  EXPECT_EQ(units("forward_kinematics"), "1, m");
  EXPECT_EQ(units("jacobian"), "m, 1, 1/m");
  EXPECT_EQ(units("jacobian_dot_qd"), "m/s^2, rad/s^2");
  EXPECT_EQ(units("inverse_dynamics_derivatives"), "N m, N, N/m, N m s, N s, N s/m");
  EXPECT_EQ(units("kinetic_energy"), "J");
  EXPECT_EQ(units("base_regressor"), "N m per parameter, N per parameter");
  EXPECT_EQ(units("base_parameters"), "SI");
}

TEST(Units, AreMetresForLoopsOfPointsAndRadiansForTheirJoints) {
  const Mechanism fourbar = mechanism_of("four_bar.toml");
  const auto units = [&fourbar](const std::string& name) { return units_of(fourbar, derive_function(fourbar, name)); };
  EXPECT_EQ(units("loop_closure"), "m");
  EXPECT_EQ(units("loop_jacobian"), "m");
  EXPECT_EQ(units("loop_step"), "rad");
  EXPECT_EQ(units("loop_motion"), "rad/s, rad/s^2");
}

}  // namespace
}  // namespace flatdyn
