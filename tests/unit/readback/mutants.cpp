// SPDX-License-Identifier: GPL-2.0-or-later
#include "unit/readback/mutants.hpp"

namespace flatdyn::testing {
namespace {

constexpr const char *kCpp = "c++ pair", *kAll = "c++ pair c float javascript lanes rust",
                     *kReturning = "c++ pair c float javascript lanes", *kWithTables = "c++ pair c float javascript",
                     *kWithNames = "c++ pair c float javascript rust", *kPlain = "c javascript",
                     *kTyped = "c++ pair c float";

// Changes that are the same in all languages.
const Mutant kMutantsInAll[] = {
    {"a result that is always valid", kReturning, "return valid;", "return true;"},
    {"a result that is never valid", kReturning, "return valid;", "return false;"},
    {"no result", kReturning, "return valid;", ""},
    {"a comparison with equality", kAll, "valid = Ic_1_zz >", "valid = Ic_1_zz >="},
    {"another pivot", kAll, "valid = Ic_1_zz >", "valid = m_1 >"},
    {"an input that is read after an output is written", kAll, "tau[1] = qd_1 * t3", "tau[1] = qd[0] * t3"},
    {"an output that is read", kAll, "tau[1] = qd_1 * t3", "tau[1] = tau[0] - tau[0] + qd_1 * t3"},
    {"an input that is written", kAll, "tau[1] = qd_1", "qd[1] = qd_1"},
    {"an entry that is not written", kAll, "tau[0] = ", "const t9 = "},
    {"an entry beyond the end", kAll, "tau[1] = qd_1", "tau[2] = qd_1"},
    {"another entry", kAll, "tau[1] = qd_1", "tau[0] = qd_1"},
    {"an early return", kAll, "tau[0] = ", "return; tau[0] = "},
    {"a statement in parentheses", kAll, "tau[1] = qd_1", "(qd_1); tau[1] = qd_1"},
    {"an empty statement", kAll, "tau[1] = qd_1", "; tau[1] = qd_1"},
    {"a block", kAll, "tau[1] = qd_1 * t3", "{} tau[1] = qd_1 * t3"},
    {"a label", kAll, "tau[1] = qd_1", "here: tau[1] = qd_1"},
    {"a condition", kAll, "tau[1] = qd_1", "if (qd_1 > 0) tau[1] = qd_1"},
    {"a compound assignment", kAll, "tau[1] = qd_1", "tau[1] += qd_1"},
    {"an increment", kAll, "tau[1] = qd_1 * t3", "tau[1] = ++qd_1 * t3"},
    {"two signs that are one operator", kAll, "tau[1] = qd_1 * t3", "tau[1] = --qd_1 * t3"},
    {"a comma between values", kAll, "tau[1] = qd_1 * t3", "tau[1] = (t3, qd_1 * t3)"},
    {"an octal index", kAll, "qd_2 = qd[1]", "qd_2 = qd[01]"},
    {"an index that is computed", kAll, "qd_2 = qd[1]", "qd_2 = qd[0 + 1]"},
    {"a macro in a function", kTyped, "tau[0] = ", "\n#define t3 t4\n  tau[0] = "},
    {"an undefined macro", kTyped, "tau[0] = ", "\n#undef t3\n  tau[0] = "},
    {"a line that is skipped", kTyped, "tau[0] = ", "\n#if 0\n#endif\n  tau[0] = "},
    {"a digraph", kAll, "qd_2 = qd[1]", "qd_2 = qd<:1:>"},
    {"a comment instead of a statement", kAll, "tau[1] = qd_1", "// tau[1] = qd_1"},
    {"a comment that goes on", kAll, "  tau[1] = qd_1", "  // then \\\n  tau[1] = qd_1"},
    {"a comment that a trigraph continues", kAll, "  tau[1] = qd_1", "  // then ?\?/\n  tau[1] = qd_1"},
    {"a comment that ends on two lines", kAll, "  tau[1] = qd_1", "  /* then *\\\n/ ; /* */ tau[1] = qd_1"},
    {"a comment that is not closed", kAll, "  tau[1] = qd_1", "  /* tau[1] = qd_1"},
    {"a continued line", kAll, "tau[1] = qd_1", "tau[1] \\\n = qd_1"},
    {"a variable that is defined twice", kAll, "t2 = ", "t1 = "},
    {"a variable that hides an argument", kAll, "t1 = ", "qdd = "},
    {"a name that is not known", kAll, "tau[1] = qd_1 * t3", "tau[1] = qd_1 * t7"},
    {"another operand", kAll, "tau[1] = qd_1 * t3", "tau[1] = qd_2 * t3"},
    {"another operator", kAll, "tau[1] = qd_1 * t3 -", "tau[1] = qd_1 * t3 +"},
    {"a table of zeros that says one", kWithTables, "1, 0,", "1, 1,", "nonzero"},
    {"a table of zeros that is short", kWithTables, "1, 0,", "1,", "nonzero"},
    {"another name of a joint", kWithNames, "\"elbow\"", "\"ankle\""},
    {"names of joints exchanged", kWithNames, "\"shoulder\", \"elbow\"", "\"elbow\", \"shoulder\""},
    {"a name less", kWithNames, "\"shoulder\", \"elbow\"", "\"shoulder\""},
    {"another name of a base parameter", kWithTables, "\"m1lx\"", "\"m2lx\"", "base_parameter_names", "base"},
    {"a result that is always valid after parts", kReturning, "return valid;", "return true;", "", "finger", true},
    {"an input that is read after parts have written", kAll, "n[1] = -t24", "n[1] = -qd[0]", "", "finger", true},
};

// Changes of C++ and C, which have types, and of C and JavaScript, whose literals are plain.
const Mutant kMutantsInSome[] = {
    {"a parameter that is read after an output is written", kCpp, "B[3] = Scalar(0.4)",
     "B[3] = Scalar(0.4) + parameters.m_1 - parameters.m_1"},
    {"a parameter that is read after an output is written", "c", "B[3] = 0.4",
     "B[3] = 0.4 + parameters->m_1 - parameters->m_1"},
    {"a parameter that is read after an output is written", "javascript", "B[3] = 0.4",
     "B[3] = 0.4 + parameters.m_1 - parameters.m_1"},
    {"zeros that are not written", kCpp, "B[1] = B[2] = Scalar(0.0);", ""},
    {"zeros that are not written", kPlain, "B[1] = B[2] = 0.0;", ""},
    {"zeros that are not written", "float", "B[1] = B[2] = 0.0f;", ""},
    {"an entry that is written twice", kCpp, "B[1] = B[2] = ", "B[0] = B[1] = B[2] = "},
    {"an entry that is written twice", kPlain, "B[1] = B[2] = ", "B[0] = B[1] = B[2] = "},
    {"a value that is checked against another bound", kCpp, "valid = Ic_1_zz > Scalar(0.0)",
     "valid = Ic_1_zz > Scalar(0.5)"},
    {"a value that is checked against another bound", kPlain, "valid = Ic_1_zz > 0.0", "valid = Ic_1_zz > 0.5"},
    {"another constant", kCpp, "Scalar(0.2) * c_2", "Scalar(0.20000000000000004) * c_2"},
    {"another constant", kPlain, "0.2 * c_2", "0.20000000000000004 * c_2"},
    {"another constant", "float", "0.2f * c_2", "0.3f * c_2"},
    {"a quotient of whole numbers", kCpp, "Scalar(0.2) * c_2", "Scalar(1 / 5) * c_2"},
    {"a quotient of whole numbers", "c float", "tau[1] = qd_1", "tau[1] = 1 / 5 + qd_1"},
    {"a whole number", kCpp, "Scalar(2.0) * qd_2", "Scalar(2) * qd_2"},
    {"a whole number", "c", "2.0 * qd_2", "2 * qd_2"},
    {"a literal of another type", kCpp, "Scalar(0.2) * c_2", "Scalar(0.2f) * c_2"},
    {"a literal of another type", kPlain, "0.2 * c_2", "0.2f * c_2"},
    {"a literal of another type", "float", "0.2f * c_2", "0.2 * c_2"},
    {"a literal in hexadecimal", kCpp, "Scalar(2.0) * qd_2", "Scalar(0x1p1) * qd_2"},
    {"a literal in hexadecimal", kPlain, "2.0 * qd_2", "0x2 * qd_2"},
    {"a variable that may change", kCpp, "const Scalar t1", "Scalar t1"},
    {"a variable that may change", "c", "const double t1", "double t1"},
    {"a variable that may change", "javascript", "const t1", "let t1"},
    {"a variable of another type", kCpp, "const Scalar t1", "const float t1"},
    {"a variable of another type", "c", "const double t1", "const float t1"},
    {"a variable of another type", "float", "const float t1", "const int t1"},
};

}  // namespace

std::vector<Mutant> mutants() {
  std::vector<Mutant> all(std::begin(kMutantsInAll), std::end(kMutantsInAll));
  all.insert(all.end(), std::begin(kMutantsInSome), std::end(kMutantsInSome));
  for (const std::vector<Mutant>& more :
       {mutants_in_cpp(), mutants_in_c(), mutants_in_javascript(), mutants_over_states(), mutants_in_rust()}) {
    all.insert(all.end(), more.begin(), more.end());
  }
  return all;
}

}  // namespace flatdyn::testing
