// SPDX-License-Identifier: GPL-2.0-or-later
// The flags that emitted code refuses to be compiled with, as the text has to be.
#pragma once

namespace flatdyn {

inline constexpr const char* kNoFastMath = R"(
#if defined(__FAST_MATH__) || (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__ > 0) || \
    defined(_M_FP_FAST)
#error "-ffast-math, -Ofast and /fp:fast leave out checks of results: add -fno-finite-math-only"
#endif
)";

inline constexpr const char* kCppDoubleConstants = R"(
static_assert(sizeof(1.0) == 8,
    "constants have to be doubles of 64 bits: compile this without -fsingle-precision-constant");
)";

inline constexpr const char* kCDoubleConstants = R"(
typedef char $prefix$has_double_constants[sizeof(1.0) == 8 ? 1 : -1];
)";

}  // namespace flatdyn
