// SPDX-License-Identifier: GPL-2.0-or-later
// Changes of emitted C++.
#include "unit/readback/mutants.hpp"

namespace flatdyn::testing {
namespace {

constexpr const char *kBoth = "c++ pair", *kHeader = "c++", *kPair = "pair";

const Mutant kSignatures[] = {
    {"arguments exchanged", kHeader, "const Scalar* qd, const Scalar* tau", "const Scalar* tau, const Scalar* qd"},
    {"arguments exchanged", kPair, "const Scalar* qd,\n    const Scalar* tau,", "const Scalar* tau, const Scalar* qd,"},
    {"arguments exchanged in the source", kPair, "const Scalar* qd,\n    const Scalar* tau,",
     "const Scalar* tau, const Scalar* qd,", "#include \"arm.hpp\""},
    {"a function renamed", kBoth, "void inverse_dynamics(", "void inverse_dynamic("},
    {"names of functions exchanged", kBoth, "bool forward_dynamics(", "bool gravity("},
    {"another type of result", kBoth, "bool forward_dynamics(", "void forward_dynamics("},
    {"an argument more", kBoth, "Scalar* tau,", "Scalar* tau, int,"},
    {"an input that may be written", kBoth, "const Scalar* q,", "Scalar* q,"},
    {"an input by value", kBoth, "const Scalar* q,", "const Scalar q,"},
    {"an argument without a name", kHeader, "const Scalar* qdd, Scalar* tau", "const Scalar*, Scalar* tau"},
    {"an unused argument with a name", kHeader, "/* parameters */", "parameters"},
    {"no noexcept", kPair, ") noexcept;", ");", "namespace arm"},
    {"no noexcept", kHeader, ") noexcept {", ") {", "inline void inverse_dynamics"},
    {"no default of the source of sines", kBoth, "class SinCos = DefaultSinCos", "class SinCos"},
    {"another default of the source of sines", kHeader, "sin_cos = {}", "sin_cos"},
    {"not inline", kHeader, "inline void inverse_dynamics", "void inverse_dynamics"},
    {"no check of the scalar", kHeader, "static_assert(detail::Interface::checked<Scalar>());", "",
     "void inverse_dynamics"},
    {"another check of the scalar", kHeader, "checked<Scalar>());", "checked<double>());", "void inverse_dynamics"},
    {"a function that is deleted", kPair, "noexcept;", "noexcept = delete;", "void inverse_dynamics"},
    {"a function more", kBoth, "namespace functions {", "inline int more() { return 1; } namespace functions {"},
    {"a variable more", kBoth, "namespace functions {", "inline int more = 1; namespace functions {"},
    {"a specialisation", kBoth, "namespace functions {", "template <> void gravity(int); namespace functions {"},
    {"an answer that may be dropped", kBoth, "[[nodiscard]] ", ""},
    {"a message that is not there", kBoth, "static_assert(sizeof...(Of) == 0,", "static_assert(true,"},
    {"objects that are not found", kBoth, "Of*>(nullptr)->data()", "Of*>(nullptr)->size()"},
    {"a function without the message", kBoth,
     "template <class... Of>\ndetail::IfObjects<Of...> forward_dynamics(const Of&...);", ""},
    {"a message that is a function", kBoth, "forward_dynamics(const Of&...);",
     "forward_dynamics(const Of&...) { return true; }"},
    {"an older standard", kBoth, "__cplusplus < 201703L", "__cplusplus < 201103L"},
    {"an operator", kBoth, "namespace functions {", "int operator+(X, X); namespace functions {"},
};

const Mutant kSines[] = {
    {"an array of sines that is too short", kBoth, "sine[joint_count]", "sine[1]"},
    {"an array of sines with another count", kBoth, "sine[angle_count]", "sine[joint_count]", "", "finger"},
    {"sine and cosine exchanged in LibrarySinCos", kBoth, "((s[joint] = sin(", "((s[joint] = cos("},
    {"sine and cosine exchanged in GivenSinCos", kBoth, "((s[joint] = sine[", "((s[joint] = cosine["},
    {"sines of the library instead of its own", kBoth, "DefaultSinCos = PolynomialSinCos",
     "DefaultSinCos = LibrarySinCos"},
    {"another coefficient of a sine", kBoth, "2.75573137070700676789e-06", "2.75573137070700776789e-06"},
    {"another coefficient of a cosine in float", kBoth, "2.443315711809948e-5f", "2.443315711809949e-5f"},
    {"another part of pi/2", kBoth, "0x1.0b4611a6p-34", "0x1.0b4611a7p-34"},
    {"a rest that is left out", kBoth, "leading * missing", "leading"},
    {"a rest with another sign", kBoth, "+ r * missing", "- r * missing"},
    {"another quadrant", kBoth, "(next & 2u)", "(next & 4u)"},
    {"a sine with another sign", kBoth, "(quadrant & 2u) << 62", "(quadrant & 2u) << 61"},
    {"sine and cosine not exchanged", kBoth, "0u - (quadrant & 1u)", "0u & (quadrant & 1u)"},
    {"sine and cosine exchanged in lanes", kBoth, "s[joint] = sine[k];", "s[joint] = cosine[k];"},
    {"a lane of another joint", kBoth, "q[joints[first + k < count ? first + k : count - 1]]", "q[joints[count - 1]]"},
    {"angles that are not looked at", kBoth, "squares += x * x;", ""},
    {"a larger range of polynomials", kBoth, "most = 1e5", "most = 1e6"},
    {"large angles that stay", kBoth, "if (!(squares <= most * most)) ask_library(", "if (false) ask_library("},
    {"sine and cosine of large angles exchanged", kBoth, "s[joints[k]] = std::sin(x);", "s[joints[k]] = std::cos(x);"},
    {"registers that this machine may not have", kBoth, "#ifdef __AVX__", "#ifdef __SSE2__"},
    {"sines that other files may share", kHeader, "static inline void sine_and_cosine(",
     "inline void sine_and_cosine("},
    {"sines that are not inlined", kHeader, "[[gnu::always_inline]] void", "[[gnu::noinline]] void"},
    {"other sines in the source", kPair, "  detail::sines_and_cosines(q, all, s, c);",
     "  LibrarySinCos()(q, all, s, c);"},
    {"another function of sines", kBoth, "using std::sin;", "using std::sinh;"},
    {"sines of another array", kBoth, "sin_cos(q, ", "sin_cos(qd, "},
    {"sines of another joint", kBoth, "Joints<1>()", "Joints<0>()"},
    {"sines of a joint more", kBoth, "Joints<1>()", "Joints<0, 1>()"},
    {"arrays of sines exchanged", kBoth, "sine, cosine);", "cosine, sine);"},
    {"sines that are asked for twice", kBoth, "  sin_cos(q, Joints<1>(), sine, cosine);",
     "  sin_cos(q, Joints<1>(), sine, cosine); sin_cos(q, Joints<1>(), sine, cosine);"},
    {"a multiple of another position", kBoth, "angle[3] = Scalar(0.6666666666666666) * q[2]",
     "angle[3] = Scalar(0.6666666666666666) * q[1]", "", "finger"},
    {"angles that are not filled", kBoth, "detail::angles(q, angle);", "", "", "finger"},
    {"sines of positions instead of angles", kBoth, "sin_cos(angle, ", "sin_cos(q, ", "", "finger"},
};

const Mutant kHelpers[] = {
    {"a directive that goes on behind its comment", kHeader, "#else\n", "#else  // then \\ \n", "evaluate("},
    {"a sign of zero that is one", kBoth, "(x > Scalar(0.0))", "(x >= Scalar(0.0))"},
    {"another square root", kBoth, "using std::sqrt;", "using std::cbrt;", "", "root"},
    {"zeros that are not", kBoth, "Scalar zeros[together] = {};", "Scalar zeros[together] = {1};", "", "root"},
    {"other scalars whose zeros are not", kBoth, "entries[0] = Scalar(0.0)", "entries[0] = Scalar(1.0)", "", "root"},
    {"zeros of any scalar at a time", kBoth, "(const void*) noexcept { return false; }",
     "(const void*) noexcept { return true; }", "", "root"},
    {"a zero less", kBoth, "store<16>(g + 1)", "store<15>(g + 1)", "", "root"},
    {"a zero too many", kBoth, "store<16>(g + 1)", "store<17>(g + 1)", "", "root"},
    {"zeros in other entries", kBoth, "store<16>(g + 1)", "store<16>(g)", "", "root"},
    {"zeros behind the array", kBoth, "store<16>(g + 1)", "store<16>(g + 3)", "", "root"},
    {"zeros in an argument", kBoth, "store<16>(g + 1)", "store<16>(q + 1)", "", "root"},
    {"zeros by another helper", kBoth, "detail::Zeros::store<16>", "detail::Zeros::stored<16>", "", "root"},
    {"a check of fractions that holds always", kHeader, "Scalar(1.5) > Scalar(1.0)", "Scalar(1.5) >= Scalar(1.0)"},
    {"another version of the interface", kBoth, "flatdyn_interface = 1", "flatdyn_interface = 2"},
    {"another version of the interface that is asked for", kHeader, "flatdyn_interface == 1", "flatdyn_interface == 2"},
    {"a check of rounding that is weaker", kBoth, "!(next > one)", "!(next >= one)"},
    {"a check of rounding with another constant", kBoth, "0x1.001p-53", "0x1.001p-52"},
    {"a check of rounding that is left out", kBoth, "!is_zero((x + y) - x)", "false"},
    {"an answer that is not asked for", kBoth, "hash = detail::hash_of(result, 4, hash);", ""},
    {"a call that is left out", kBoth, "inertia_matrix(parameters, q, result, given);", ""},
    {"a known state with other numbers", kBoth, "seed * 1664525u", "seed * 1664524u"},
    {"a known state with another seed", kBoth, "seed + 2u", "seed + 3u"},
    {"results that are not hashed", kBoth, "(hash ^ (is_number ? bits : 0u))", "(hash ^ (is_number ? 0u : 0u))"},
    {"sines that are not checked", kBoth, "if (!detail::sines_are_right<Scalar>()) return false;", ""},
    {"other sines that are right", kBoth, "0x7b037ac8b2e0683cu", "0x7b037ac8b2e0683du"},
    {"other sines that are right in float", kBoth, "0x803948b6889bcc50u", "0x803948b6889bcc51u"},
    {"an answer that is always right", kBoth, "return hash == (is_float", "return hash == hash || hash == (is_float"},
    {"a build with -ffast-math", kBoth, "#error \"-ffast-math", "#warning \"-ffast-math"},
    {"a function that other files may share", "c++", "static inline void gravity", "inline void gravity"},
    {"a gap that may stay", kBoth, "gap <= tolerance * tolerance", "gap <= tolerance", "", "four_bar"},
    {"a tolerance below zero", kBoth, "tolerance >= Scalar(0.0)", "tolerance >= Scalar(-1.0)", "", "four_bar"},
    {"loops that are closed with another step", kBoth, "size * dq[k]", "dq[k]", "", "four_bar"},
    {"loops that are closed by another function", kBoth, "!loop_step(parameters, here", "!gravity(parameters, here", "",
     "four_bar"},
    {"another number of rows of the closure", kBoth, "dq[position_count], phi[2]", "dq[position_count], phi[1]", "",
     "four_bar"},
};

const Mutant kTables[] = {
    {"another limit", kBoth, "Real(-2.0)", "Real(-2.0000000000000004)"},
    {"a limit less", kBoth, "Real(HUGE_VAL)", "Real(3.0)"},
    {"a limit that is not there", kBoth,
     "inline constexpr Real velocity_limit[joint_count] = {Real(3.0), "
     "Real(HUGE_VAL)};",
     ""},
    {"names of tables exchanged", kBoth, "position_upper[", "velocity_limit["},
    {"another count of joints", kBoth, "joint_count = 2", "joint_count = 3"},
    {"another independent position", kBoth, "independent_positions[joint_count] = {0}",
     "independent_positions[joint_count] = {1}", "", "four_bar"},
    {"another value of a base parameter", kBoth, "Real(177.51)", "Real(177.52)", "base_parameter_values", "base"},
    {"another count of base parameters", kBoth, "base_parameter_count = 7", "base_parameter_count = 6", "", "base"},
    {"constants in another type", kBoth, "using Real = double", "using Real = float"},
    {"a symbol renamed", kBoth, "Scalar m_1;", "Scalar m_2;"},
    {"a symbol more", kBoth, "Scalar m_1;", "Scalar m_1; Scalar m_2;"},
    {"another shape of a matrix", kBoth, "(&B)[2][2]", "(&B)[2][3]"},
    {"another shape of an input", kBoth, "Scalar (&q)[2]", "Scalar (&q)[1]"},
    {"another function behind a shape", kBoth, "::arm::gravity(of...)", "::arm::bias(of...)"},
    {"a shape that says that entries are left out", kBoth, "Scalar (&g)[2]);",
     "Scalar (&g)[2]); static constexpr bool leaves_out = true;"},
};

const Mutant kFiles[] = {
    {"no include", kBoth, "#include <cmath>", ""},
    {"another include", kBoth, "#include <cmath>", "#include <math.h>"},
    {"another macro as a guard", kBoth, "#define FLATDYN_", "#define FLATDYN_OTHER_"},
    {"a macro", kBoth, "using Real", "#define Scalar float\nusing Real"},
    {"a pragma", kBoth, "using Real", "#pragma GCC optimize(\"fast-math\")\nusing Real"},
    {"a macro behind the end", kBoth, "#endif", "#endif\n#define sin cos"},
    {"another namespace", kBoth, "namespace arm {", "namespace harm {"},
    {"a name from another namespace", kBoth, "using Real", "using namespace std; using Real"},
    {"another header", kPair, "#include \"arm.hpp\"", "#include \"harm.hpp\""},
    {"an instance less", kPair, "extern template struct Configuration<float>;", ""},
    {"an instance less in the source", kPair, "template struct Configuration<float>;", "", "#include \"arm.hpp\""},
    {"an instance in another type", kPair, "extern template void gravity(const Parameters<double>&",
     "extern template void gravity(const Parameters<float>&"},
};

const Mutant kStagesAndParts[] = {
    {"fields of a stage exchanged", kBoth, "stage.x1 = ", "stage.x2 = "},
    {"a field that is not written", kBoth, "stage.Ic_1_zz = Ic_1_zz;", ""},
    {"a field that is declared twice", kBoth, "Scalar x1, Ic_1_zz, x2;", "Scalar x1, x1, x2;"},
    {"a field less", kBoth, "Scalar x1, Ic_1_zz, x2;", "Scalar x1, Ic_1_zz;"},
    {"a member of another stage", kBoth, "Motion<Scalar>::forward_dynamics", "Configuration<Scalar>::forward_dynamics"},
    {"a member that may change its stage", kBoth, "Scalar* qdd) const noexcept", "Scalar* qdd) noexcept"},
    {"another stage that is returned", kBoth, "return stage;", "return Configuration<Scalar>();"},
    {"a stage of another type", kBoth, "Configuration<Scalar> stage;", "Motion<Scalar> stage;"},
    {"a member behind another name", kBoth, "return stage.forward_dynamics(of...)", "return stage.bias(of...)"},
    {"parts in another order", kBoth, "  detail::bias_part_1(qd, sine, cosine, kept);\n", "", "", "finger", true},
    {"a part that is called twice", kBoth, "detail::bias_part_1(qd, sine, cosine, kept);",
     "detail::bias_part_1(qd, sine, cosine, kept); detail::bias_part_1(qd, sine, cosine, kept);", "", "finger", true},
    {"arguments of a part exchanged", kBoth, "detail::bias_part_2(sine, cosine,", "detail::bias_part_2(cosine, sine,",
     "", "finger", true},
    {"parameters of a part exchanged", kBoth, "void bias_part_2(const Scalar* sine, const Scalar* cosine,",
     "void bias_part_2(const Scalar* cosine, const Scalar* sine,", "", "finger", true},
    {"another place of a value that is kept", kBoth, "t6 = kept[10]", "t6 = kept[9]", "", "finger", true},
    {"an array between parts that is too short", kBoth, "Scalar kept[13]", "Scalar kept[12]", "", "finger", true},
    {"an array between parts that is too long", kBoth, "Scalar kept[13]", "Scalar kept[14]", "", "finger", true},
    {"pivots that are not checked", kBoth, "for (const Scalar& pivot : pivots) valid &= pivot > Scalar(0.0);", "", "",
     "finger", true},
    {"pivots that are checked against another bound", kBoth, "valid &= pivot > Scalar(0.0)",
     "valid &= pivot > Scalar(-1.0)", "", "finger", true},
    {"a pivot less", kBoth,
     "pivots[2] = detail::Excess<Scalar>::of(Scalar(0.00002) +\n      Scalar(0.015625) * b_3_3q, Scalar(0.00002));", "",
     "", "finger", true},
    {"a part that nothing calls", kBoth, "template <class Scalar>\nstatic void bias_part_2(",
     "template <class Scalar>\nstatic void bias_part_3() noexcept {}\ntemplate <class Scalar>\nstatic void "
     "bias_part_2(",
     "", "finger", true},
};

}  // namespace

std::vector<Mutant> mutants_in_cpp() {
  std::vector<Mutant> all;
  const auto add = [&all](const auto& list) { all.insert(all.end(), std::begin(list), std::end(list)); };
  add(kSignatures);
  add(kSines);
  add(kHelpers);
  add(kTables);
  add(kFiles);
  add(kStagesAndParts);
  return all;
}

}  // namespace flatdyn::testing
