// SPDX-License-Identifier: GPL-2.0-or-later
// Changes of a certified header of the planar arm that scripts/check-certificate has to refuse, although the
// certificate has the hash of the changed text.
#pragma once

namespace flatdyn::testing {

// A change of the header, with its hash renewed, and what is said of it.
struct Attack {
  const char *kind, *before, *after;
  const char* behind = "";
  const char* message = "of the header is not what flatdyn writes there: ";
};

inline constexpr const char *kFunction = "void inverse_dynamics(", *kAnother = "of the header is another number",
                            *kHash =
                                "rounding_is_as_written() expects other results than those of the header's functions",
                            *kAnswer = "rounding_is_as_written() is not the one that flatdyn writes",
                            *kArguments = "the shape of inverse_dynamics has other arguments than the function";

inline const Attack kAttacksAroundFunctions[] = {
    {"a specialisation", "namespace functions {",
     "template <> inline void inverse_dynamics<double>(const double*, const double*, const double*, double*) noexcept "
     "{} namespace functions {"},
    {"an overload for double", "namespace functions {",
     "inline void inverse_dynamics(const double*, const double*, const double*, double*) {} namespace functions {"},
    {"an include", "namespace functions {", "#include \"more.h\"\nnamespace functions {"},
    {"an include among the others", "#include <cmath>", "#include <cmath>\n#include <more>"},
    {"a pragma", "namespace functions {", "#pragma STDC FP_CONTRACT ON\nnamespace functions {"},
    {"an operator pragma", "namespace functions {", "_Pragma(\"GCC optimize\") namespace functions {"},
    {"a macro", "namespace functions {", "#define double float\nnamespace functions {"},
    {"a macro that goes on", "namespace functions {", "#define\\\n double float\nnamespace functions {"},
    {"a directive without its name", "namespace functions {", "#\nnamespace functions {"},
    {"a directive by a digraph", "namespace functions {", "%:define double float\nnamespace functions {"},
    {"a directive by a trigraph", "namespace functions {", "?\?=define double float\nnamespace functions {"},
    {"a using-directive", "namespace functions {", "using namespace std; namespace functions {"},
    {"a namespace more", "namespace functions {", "namespace std { } namespace functions {"},
    {"an operator", "namespace functions {", "struct X { friend X operator+(X, X); }; namespace functions {"},
    {"an attribute", "static inline void inverse_dynamics",
     "[[gnu::optimize(\"fast-math\")]] static inline void inverse_dynamics"},
    {"an attribute of GNU C", "static inline void inverse_dynamics",
     "__attribute__((optimize(\"fast-math\"))) static inline void inverse_dynamics"},
    {"a function that files share", "static inline void inverse_dynamics", "inline void inverse_dynamics"},
    {"text behind the namespace", "}  // namespace planar_2r_example_7_2\n", "}\nint more;\n"},
    {"another branch of the guard", "#endif  // FLATDYN", "#else\nint more;\n#endif  // FLATDYN"},
    {"another guard", "#ifndef FLATDYN_", "#ifndef FLATDYN_X_"},
    {"a guard that hides a function", "#ifndef FLATDYN_", "#ifndef memcpy //"},
    {"a comment that goes on", "// tau = B", "// tau \\\n int more; // = B"},
    {"a comment that goes on behind blanks", "// tau = B", "// tau \\ \n int more; // = B"},
    {"a comment that goes on by a trigraph", "// tau = B", "// tau ?\?/\n int more; // = B"},
    {"a comment whose end is on two lines", "// tau = B", "/* tau *\\\n/ int more; /* */ // = B"},
    {"a comment with a carriage return", "// tau = B", "// tau\r int more; // = B"},
    {"a comment with a separator of lines", "// tau = B", "// tau\xE2\x80\xA8int more; // = B"},
    {"a comment that is no UTF-8", "// tau = B", "// \xff tau = B", "", "codec can't decode byte"},
    {"another source of sines", "SinCos = DefaultSinCos>\nstatic inline void inverse_dynamics",
     "SinCos = LibrarySinCos>\nstatic inline void inverse_dynamics"},
    {"another source of all sines", "DefaultSinCos = PolynomialSinCos", "DefaultSinCos = LibrarySinCos"},
    {"another function of the library", "using std::sin;", "using std::sinh;"},
    {"another polynomial", "2.75573137070700676789e-06", "2.75573137070700776789e-06"},
    {"another polynomial in float", "2.443315711809948e-5f", "2.443315711809949e-5f"},
    {"another quadrant", "(quadrant & 2u) << 62", "(quadrant & 2u) << 61"},
    {"a larger range", "most = 1e5", "most = 1e6"},
    {"another list of joints", "((s[joint] = sine[joint]", "((s[joint] = sine[0]"},
    {"another namespace", "namespace planar_2r_example_7_2 {", "namespace std {"},
    {"another scalar", "using Real = double", "using Real = float"},
    {"more joints", "joint_count = 2", "joint_count = 3"},
    {"names exchanged", "{\"theta_1\", \"theta_2\"}", "{\"theta_2\", \"theta_1\"}", "", "joint_names is "},
    {"a raw text", "{\"theta_1\"", "{R\"(theta_1)\""},
    {"brackets by digraphs", "joint_names[joint_count]", "joint_names<:joint_count:>"},
    {"a table of zeros", "inertia_matrix_nonzero[4] = {\n    1", "inertia_matrix_nonzero[4] = {\n    0", "",
     "the header's tables of zeros are not those of inertia_matrix"},
    {"another shape", "(&B)[2][2]", "(&B)[4][1]", "", "inertia_matrix has other arguments than the certificate says"},
    {"arguments exchanged in the shape", "const Scalar (&qd)[2], const Scalar (&qdd)[2]",
     "const Scalar (&qdd)[2], const Scalar (&qd)[2]", "", kArguments},
    {"another function by the adapter", "return ::planar_2r_example_7_2::inverse_dynamics",
     "return ::planar_2r_example_7_2::inertia_matrix"},
    {"arguments exchanged where it is called", "q, qd, qdd, result, given", "q, qdd, qd, result, given", "", kAnswer},
};

inline const Attack kAttacksOnFunctions[] = {
    {"another constant", "Scalar(22.5)", "Scalar(22.25)", kFunction, kHash},
    {"a constant in hexadecimal", "Scalar(22.5)", "Scalar(0x22p0)", kFunction},
    {"a constant of float", "Scalar(22.5)", "Scalar(22.5f)", kFunction},
    {"a constant with a quote", "Scalar(22.5)", "Scalar(2'2.5)", kFunction},
    {"a quotient", "Scalar(22.5)", "Scalar(22.5) / Scalar(1.0)", kFunction},
    {"a function of the library", "Scalar(22.5) *", "std::sqrt(Scalar(506.25)) *", kFunction},
    {"a fused operation of the library", "qd_1 + qd_2;", "fma(qd_1, Scalar(1.0), qd_2);", kFunction},
    {"a decrement", "tau[1] = qdd_1", "tau[1] = --qdd_1", kFunction},
    {"a comma", "tau[1] = qdd_1 + N_2_z", "tau[1] = qdd_1, N_2_z", kFunction, "is no sum or product of names"},
    {"sines in another order", "Joints<0, 1>()", "Joints<1, 0>()", kFunction},
    {"sines of another array", "sin_cos(q, ", "sin_cos(qd, ", kFunction},
    {"sine and cosine exchanged", "sine, cosine);", "cosine, sine);", kFunction},
    {"a sine that nothing computes", "Joints<0, 1>()", "Joints<0>()", kFunction},
    {"a sine of another joint", "s_1 = sine[0]", "s_1 = sine[1]", kFunction, kHash},
    {"a variable that hides sines", "const Scalar s_1 = sine[0]", "const Scalar sine = sine[0]", kFunction},
    {"a variable of letters that are no ASCII", "const Scalar N_2_z",
     "const Scalar \xD0\xB0 = qd_1; const Scalar N_2_z", kFunction},
    {"a variable by its number of character", "const Scalar N_2_z", "const Scalar \\u0061 = qd_1; const Scalar N_2_z",
     kFunction},
    {"an entry that is written twice", "tau[0] =", "tau[0] = tau[1] =", kFunction},
    {"an entry that is added to", "tau[0] =", "tau[0] +=", kFunction},
    {"an octal index", "tau[0] =", "tau[00] =", kFunction},
    {"an entry too many", "tau[0] =", "tau[2] =", kFunction, kHash},
    {"an entry that is read", "+ N_2_z -", "+ N_2_z * tau[1] -", kFunction},
    {"an input that is read too late", "tau[1] = qdd_1", "tau[1] = qdd[0]", kFunction},
    {"an empty statement", "tau[1] =", "; tau[1] =", kFunction},
    {"a block", "tau[1] =", "{} tau[1] =", kFunction},
    {"an early return", "tau[1] =", "return; tau[1] =", kFunction},
    {"a condition", "tau[1] =", "if (qd_1 > qd_2) tau[1] =", kFunction},
    {"a using-declaration", "tau[1] =", "using std::fma; tau[1] =", kFunction},
    {"arguments exchanged", "const Scalar* qd, const Scalar* qdd", "const Scalar* qdd, const Scalar* qd", "",
     kArguments},
    {"an argument more", "Scalar* tau, const SinCos", "Scalar* tau, int, const SinCos"},
    {"an argument that is written", "(const Scalar* q, const Scalar* qd,", "(Scalar* q, const Scalar* qd,"},
    {"another answer", "return hash ==", "return hash !=", "All functions at", kAnswer},
    {"a statement in front of the answer", "return hash ==", "hash = 1; return hash ==", "All functions at", kAnswer},
    {"an array that is not filled", "detail::fill(q, 2,", "detail::fill(q, 1,", "", kAnswer},
    {"a check of rounding that is left out", "if (!detail::sines_are_right<Scalar>()) return false;", ""},
    {"a hash that is none", "hash ^= hash >> 32;", "hash = 0;"},
};

}  // namespace flatdyn::testing
