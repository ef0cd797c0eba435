// SPDX-License-Identifier: GPL-2.0-or-later
// Changes of emitted JavaScript.
#include "unit/readback/mutants.hpp"

namespace flatdyn::testing {
namespace {

constexpr const char* kScript = "javascript";

const Mutant kMutantsOfJavascript[] = {
    {"arguments exchanged", kScript, "(parameters, q, qd, tau, qdd) {", "(parameters, q, tau, qd, qdd) {"},
    {"outputs before inputs", kScript, "(parameters, q, qd, tau, qdd) {", "(parameters, q, qd, qdd, tau) {"},
    {"a function renamed", kScript, "function inverse_dynamics(", "function inverse_dynamic("},
    {"names of functions exchanged", kScript, "function forward_dynamics(", "function gravity("},
    {"an argument with a default", kScript, "(parameters, q, g) {", "(parameters, q, g = []) {"},
    {"an argument more", kScript, "(parameters, q, g) {", "(parameters, q, g, h) {"},
    {"a function that is asynchronous", kScript, "function gravity(", "async function gravity("},
    {"a generator", kScript, "function gravity(", "function* gravity("},
    {"a result on another line", kScript, "return valid;", "return\n  valid;"},
    {"a number on another line", kScript, "  return 0.2 * qd_2", "  return\n  0.2 * qd_2"},
    {"no strict mode", kScript, "'use strict';", ""},
    {"a sine of another array", kScript, "sin(q[1])", "sin(qd[1])"},
    {"a sine of another joint", kScript, "sin(q[1])", "sin(q[0])"},
    {"a sine that is a cosine", kScript, "sin(q[1])", "cos(q[1])"},
    {"a function of the library", kScript, "= sin(q[1])", "= Math.tan(q[1])"},
    {"a sine of the library", kScript, "= sin(q[1])", "= Math.sin(q[1])"},
    {"sines that are hidden", kScript, "const t1 = 0.2 * c_2;", "const sin = 0.2 * c_2;"},
    {"sine and cosine exchanged", kScript, "return sine_of_turned(x, 0);", "return sine_of_turned(x, 1);"},
    {"another coefficient of a sine", kScript, "2.75573137070700676789e-06", "2.75573137070700776789e-06"},
    {"another part of pi/2", kScript, "6.077100506303966e-11", "6.077100506303967e-11"},
    {"a rest that is left out", kScript, "leading * rest", "leading"},
    {"another quadrant", kScript, "(quadrant & 1) === 0", "(quadrant & 1) === 1"},
    {"a sine with another sign", kScript, "? sine : -sine", "? -sine : sine"},
    {"a larger range of polynomials", kScript, "x <= 1e5", "x <= 1e6"},
    {"another sine of large angles", kScript, "? Math.sin(x) : Math.cos(x)", "? Math.cos(x) : Math.sin(x)"},
    {"a sign that is an absolute value", kScript, "Math.sign(qd_1)", "Math.abs(qd_1)"},
    {"a square root that is a cube root", kScript, "Math.sqrt(", "Math.cbrt(", "", "root"},
    {"a library that is written", kScript, "tau[1] = qd_1", "Math.sin = Math.cos; tau[1] = qd_1"},
    {"a library that is hidden", kScript, "const t1 = 0.2 * c_2;", "const Math = 0.2 * c_2;"},
    {"an array of sines that is too short", kScript, "sine = new Float64Array(4)", "sine = new Float64Array(3)", "",
     "finger", true},
    {"an array of sines in another type", kScript, "sine = new Float64Array(4)", "sine = new Float32Array(4)", "",
     "finger", true},
    {"a multiple of another position", kScript, "sin(0.6666666666666666 * q[2])", "sin(0.6666666666666666 * q[1])", "",
     "finger"},
    {"a gap that may stay", kScript, "gap <= tolerance * tolerance", "gap <= tolerance", "", "four_bar"},
    {"a tolerance below zero", kScript, "tolerance >= 0", "tolerance >= -1", "", "four_bar"},
    {"loops that are closed with another step", kScript, "x + size * dq[k]", "x + dq[k]", "", "four_bar"},
    {"no result of loops that are closed", kScript, "  return true;\n}", "  return\n true;\n}", "function close_loops",
     "four_bar"},
    {"another length of the closure", kScript, "const phi = new Float64Array(2), dq",
     "const phi = new Float64Array(1), dq", "", "four_bar"},
    {"another limit", kScript, "[-2.0, -Infinity]", "[-2.0000000000000004, -Infinity]"},
    {"a limit less", kScript, "[2.0, Infinity]", "[2.0, 3.0]"},
    {"names of tables exchanged", kScript, "const position_upper", "const velocity_limit"},
    {"a table less", kScript, "const velocity_limit = [3.0, Infinity];", ""},
    {"another count of joints", kScript, "joint_count = 2", "joint_count = 3"},
    {"another independent position", kScript, "independent_positions = [0]", "independent_positions = [1]", "",
     "four_bar"},
    {"another value of a base parameter", kScript, "177.51", "177.52", "base_parameter_values", "base"},
    {"another symbol", kScript, "[\"m_1\"]", "[\"m_2\"]"},
    {"a table that may change", kScript, "const joint_names", "let joint_names"},
    {"an export less", kScript, "    gravity};", "    };"},
    {"an export under another name", kScript, "    gravity};", "    gravity as bias};"},
    {"a statement behind the end", kScript, "    gravity};", "    gravity};\nMath.sin = Math.cos;"},
    {"an export more", kScript, "    gravity};", "    gravity, Math};"},
    {"a default export", kScript, "export {", "export default {"},
    {"an import", kScript, "const joint_count", "import './other.js';\nconst joint_count"},
    {"a statement of the module", kScript, "const joint_count", "Math.sin = Math.cos;\nconst joint_count"},
    {"a function more", kScript, "export {", "function more() {}\nexport {"},
    {"a comment that ends early", kScript, "  tau[1] = qd_1", "  // then \xE2\x80\xA8 tau[0] = 1;\n  tau[1] = qd_1"},
    {"a comment that a carriage return ends", kScript, "  tau[1] = qd_1", "  // then \r tau[0] = 1;\n  tau[1] = qd_1"},
    {"a comment of a page", kScript, "  tau[1] = qd_1", "  <!-- tau[1] = qd_1"},
    {"a regular expression", kScript, "tau[1] = qd_1", "/x/; tau[1] = qd_1"},
    {"a template", kScript, "tau[1] = qd_1", "``; tau[1] = qd_1"},
    {"a part that is not called", kScript, "  bias_part_1(qd, sine, cosine, kept);\n", "", "", "finger", true},
    {"arguments of a part exchanged", kScript, "  bias_part_2(sine, cosine,", "  bias_part_2(cosine, sine,", "",
     "finger", true},
    {"another place of a value that is kept", kScript, "t6 = kept[10]", "t6 = kept[9]", "", "finger", true},
    {"an array between parts that is too short", kScript, "kept = new Float64Array(13)", "kept = new Float64Array(12)",
     "", "finger", true},
    {"a loop of checks that ends early", kScript, "k < 3; ++k", "k < 2; ++k", "", "finger", true},
    {"a loop of checks with a counter that is not declared", kScript, "for (let k = 0", "for (k = 0", "", "finger",
     true},
};

}  // namespace

std::vector<Mutant> mutants_in_javascript() {
  return {std::begin(kMutantsOfJavascript), std::end(kMutantsOfJavascript)};
}

}  // namespace flatdyn::testing
