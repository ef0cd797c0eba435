// SPDX-License-Identifier: GPL-2.0-or-later
// Changes of emitted C.
#include "unit/readback/mutants.hpp"

namespace flatdyn::testing {
namespace {

constexpr const char *kInC = "c", *kFloat = "float", *kEither = "c float";
constexpr const char* kSource = "#include \"arm.h\"";

const Mutant kMutantsOfC[] = {
    {"arguments exchanged", kInC, "const double* qd, const double* tau", "const double* tau, const double* qd",
     kSource},
    {"arguments exchanged in the header", kInC, "const double* qd, const double* tau",
     "const double* tau, const double* qd"},
    {"sine and cosine exchanged among arguments", kInC, "const double* sine,\n    const double* cosine",
     "const double* cosine,\n    const double* sine", kSource},
    {"a function renamed", kEither, "void arm_inverse_dynamics(", "void arm_inverse_dynamic("},
    {"names of functions exchanged", kEither, "bool arm_forward_dynamics(", "bool arm_gravity(", kSource},
    {"another type of result", kEither, "bool arm_forward_dynamics(", "void arm_forward_dynamics("},
    {"a result that is dropped", kEither, "return arm_forward_dynamics_given(", "arm_forward_dynamics_given("},
    {"arguments of a call exchanged", kEither, "(parameters, sine, cosine, qd, qdd, tau)",
     "(parameters, sine, cosine, qdd, qd, tau)"},
    {"sines of a call exchanged", kEither, "(parameters, sine, cosine, qd, qdd, tau)",
     "(parameters, cosine, sine, qd, qdd, tau)"},
    {"a call of another function", kEither, "arm_inertia_matrix_given(parameters, sine, cosine, B);",
     "arm_gravity_given(parameters, sine, cosine, B);"},
    {"an input that may be written", kInC, "const double* q,", "double* q,"},
    {"an output that may overlap", kInC, "double* restrict tau", "double* tau"},
    {"an input that may not overlap", kInC, "const double* qd", "const double* restrict qd"},
    {"an unused argument", kEither, "(void)parameters;", ""},
    {"an argument that is used and cast", kEither, "tau[1] = qd_1", "(void)qd; tau[1] = qd_1"},
    {"an array of sines that is too short", kEither, "sine[ARM_JOINT_COUNT]", "sine[1]"},
    {"sine and cosine exchanged in the helper", kInC, "sine[joint] = sin(", "sine[joint] = cos("},
    {"sines in another type", kFloat, "sinf(q[joint])", "sin(q[joint])"},
    {"a joint less in the helper", kEither, "joint <= last", "joint < last"},
    {"sines of another array", kEither, "arm_sines_and_cosines(q, 1, 1", "arm_sines_and_cosines(qd, 1, 1"},
    {"sines of another joint", kEither, "arm_sines_and_cosines(q, 1, 1", "arm_sines_and_cosines(q, 0, 0"},
    {"sines of a joint more", kEither, "arm_sines_and_cosines(q, 1, 1", "arm_sines_and_cosines(q, 0, 1"},
    {"sines of a joint that there is not", kEither, "arm_sines_and_cosines(q, 1, 1", "arm_sines_and_cosines(q, 1, 2"},
    {"arrays of sines exchanged", kEither, "1, 1, sine, cosine);", "1, 1, cosine, sine);"},
    {"a multiple of another position", kInC, "angle[3] = 0.6666666666666666 * q[2]",
     "angle[3] = 0.6666666666666666 * q[1]", "", "finger"},
    {"angles that are not filled", kEither, "finger_angles(q, angle);", "", "", "finger"},
    {"a sign of zero that is one", kEither, "(x > 0.0", "(x >= 0.0"},
    {"another square root", kInC, " sqrt(", " cbrt(", "", "root"},
    {"a square root in another type", kFloat, " sqrtf(", " sqrt(", "", "root"},
    {"a check of rounding that is weaker", kEither, "next > one", "next >= one"},
    {"a check of rounding with another constant", kEither, "0x1.001p-", "0x1.002p-"},
    {"a check of rounding that is left out", kEither, "arm_is_zero((x + y) - x) &&", ""},
    {"another test of zero", kEither, "!(r < 0.0", "(r < 0.0"},
    {"a gap that may stay", kEither, "!(gap <= tolerance * tolerance)", "!(gap <= tolerance)", "", "four_bar"},
    {"loops that are closed with another step", kEither, "size * dq[k]", "dq[k]", "", "four_bar"},
    {"another sum of squares", kEither, "phi[row] * phi[row]", "phi[row]", "", "four_bar"},
    {"another limit", kInC, "{-2.0, -HUGE_VAL}", "{-2.0000000000000004, -HUGE_VAL}"},
    {"another limit", kFloat, "{-2.0f, -HUGE_VALF}", "{-2.0000002f, -HUGE_VALF}"},
    {"a limit less", kInC, "{2.0, HUGE_VAL}", "{2.0, 3.0}"},
    {"names of tables exchanged", kEither, "arm_position_upper[", "arm_velocity_limit["},
    {"a table in another type", kInC, "extern const double arm_position_upper",
     "extern const float arm_position_upper"},
    {"another count of joints", kEither, "ARM_JOINT_COUNT = 2", "ARM_JOINT_COUNT = 3"},
    {"another independent position", kEither, "independent_positions[FOUR_BAR_JOINT_COUNT] = {0}",
     "independent_positions[FOUR_BAR_JOINT_COUNT] = {1}", "", "four_bar"},
    {"another value of a base parameter", kInC, "177.51", "177.52", "base_parameter_values[", "base"},
    {"a symbol renamed", kInC, "double m_1;", "double m_2;"},
    {"a symbol in another type", kInC, "double m_1;", "float m_1;"},
    {"no include", kEither, "#include <stdbool.h>", ""},
    {"names that C++ mangles", kEither, "extern \"C\" {", "{"},
    {"another macro as a guard", kEither, "#define FLATDYN_", "#define FLATDYN_OTHER_"},
    {"a macro", kEither, "enum { ARM", "#define double float\nenum { ARM"},
    {"a pragma", kEither, kSource, "#include \"arm.h\"\n#pragma STDC FP_CONTRACT ON"},
    {"another header", kEither, kSource, "#include \"harm.h\""},
    {"a function more", kEither, "bool arm_rounding_is_as_written(void) {",
     "int arm_more(void) { return 1; } bool arm_rounding_is_as_written(void) {"},
    {"a variable more", kEither, "bool arm_rounding_is_as_written(void) {",
     "int arm_more; bool arm_rounding_is_as_written(void) {"},
    {"an attribute", kEither, "void arm_inverse_dynamics(", "__attribute__((cold)) void arm_inverse_dynamics(",
     kSource},
    {"a function of this file only", kEither, "void arm_inverse_dynamics(", "static void arm_inverse_dynamics(",
     kSource},
    {"a part that is not called", kEither, "  finger_bias_part_1(qd, sine, cosine, kept);\n", "", "", "finger", true},
    {"arguments of a part exchanged", kEither, "finger_bias_part_2(sine, cosine,", "finger_bias_part_2(cosine, sine,",
     "", "finger", true},
    {"another place of a value that is kept", kEither, "t6 = kept[10]", "t6 = kept[9]", "", "finger", true},
    {"an array between parts that is too short", kEither, " kept[13];", " kept[12];", "", "finger", true},
    {"a loop of checks that ends early", kEither, "k < 3; ++k", "k < 2; ++k", "", "finger", true},
    {"a loop of checks that begins late", kEither, "int k = 0; k < 3", "int k = 1; k < 3", "", "finger", true},
};

}  // namespace

std::vector<Mutant> mutants_in_c() { return {std::begin(kMutantsOfC), std::end(kMutantsOfC)}; }

}  // namespace flatdyn::testing
