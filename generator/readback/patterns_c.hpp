// SPDX-License-Identifier: GPL-2.0-or-later
// The helpers of emitted C, as they have to be. They are written down here once more, not taken from the templates.
#pragma once

namespace flatdyn {

inline constexpr const char* kCSign = R"(
static $real$ $prefix$sign($real$ x) { return ($real$)((x > 0.0$f$) - (x < 0.0$f$)); }
)";

inline constexpr const char* kCSinesAndCosines = R"(
static void $prefix$sines_and_cosines(const $real$* q, int first, int last, $real$* restrict sine,
    $real$* restrict cosine) {
  for (int joint = first; joint <= last; ++joint) {
    sine[joint] = sin$f$(q[joint]);
    cosine[joint] = cos$f$(q[joint]);
  }
}
)";

inline constexpr const char* kCCloseLoops = R"(
static $real$ $prefix$gap_at($parameters_argument$ const $real$* q) {
  $real$ phi[$rows$], sum = 0.0$f$;
  $closure$($parameters$ q, phi);
  for (int row = 0; row < $rows$; ++row) sum += phi[row] * phi[row];
  return sum;
}
bool $prefix$close_loops($parameters_argument$ $real$* q, $real$ tolerance, int most_steps) {
  $real$ here[$positions$], next[$positions$], dq[$positions$];
  for (int k = 0; k < $positions$; ++k) here[k] = q[k];
  $real$ gap = $prefix$gap_at($parameters$ here);
  for (int step = 0; step < most_steps && gap > tolerance * tolerance; ++step) {
    if (!$step$($parameters$ here, dq)) return false;
    $real$ next_gap = gap, size = 1.0$f$;
    for (int halving = 0; halving < 20 && !(next_gap < gap); ++halving, size *= 0.5$f$) {
      for (int k = 0; k < $positions$; ++k) next[k] = here[k] + size * dq[k];
      next_gap = $prefix$gap_at($parameters$ next);
    }
    if (!(next_gap < gap)) return false;
    for (int k = 0; k < $positions$; ++k) here[k] = next[k];
    gap = next_gap;
  }
  if (!(gap <= tolerance * tolerance)) return false;
  for (int k = 0; k < $positions$; ++k) q[k] = here[k];
  return true;
}
)";

inline constexpr const char* kCRounding = R"(
static bool $prefix$is_zero($real$ r) { return !(r < 0.0$f$) && !(r > 0.0$f$); }
bool $prefix$rounding_is_as_written(void) {
  const volatile $real$ a = 0.1$f$, b = 0.7$f$, one = 1.0$f$, tiny = 1e-17$f$, nine = 9.0$f$, seven = 7.0$f$,
      half = 0.5$f$, smallest = $smallest$;
  const volatile $real$ half_a_place = $half_a_place$;
  const volatile $real$ product = a * b, quotient = nine / seven, next = one + half_a_place;
  const $real$ x = one, y = tiny;
  return $prefix$is_zero(a * b - product) && next > one && $prefix$is_zero((x + y) - x) &&
         $prefix$is_zero((x - y) - x) && $prefix$is_zero(nine / 7.0$f$ - quotient) && smallest * half > 0.0$f$;
}
)";

}  // namespace flatdyn
