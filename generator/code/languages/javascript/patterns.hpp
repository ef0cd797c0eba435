// SPDX-License-Identifier: GPL-2.0-or-later
// The helpers of emitted JavaScript, as they have to be. They are written down here once more, not taken from the
// template.
#pragma once

namespace flatdyn {

// The sine of an angle that is turned, up to its reduction, and the functions that follow it.
inline constexpr const char* kJavascriptSineBegin = R"(
function sine_of_turned(x, turns) {
  if (!(x <= 1e5 && x >= -1e5)) return turns === 0 ? Math.sin(x) : Math.cos(x);
  const n = (x * $two_over_pi$ + $to_whole$) - $to_whole$, quadrant = n + turns;
)";

inline constexpr const char* kJavascriptSines = R"(
  return (quadrant & 2) === 0 ? sine : -sine;
}
function sin(x) {
  return sine_of_turned(x, 0);
}
function cos(x) {
  return sine_of_turned(x, 1);
}
)";

inline constexpr const char* kJavascriptCheck = R"(
function check_lengths(name, arrays, lengths, inputs) {
  Object.keys(arrays).forEach((key, k) => {
    const length = arrays[key].length, grows = k >= inputs && Array.isArray(arrays[key]);
    if (length === lengths[k] || (grows && length === 0)) return;
    throw new RangeError(name + ': ' + key + ' has ' + length + ' entries instead of ' + lengths[k]);
  });
}
)";

inline constexpr const char* kJavascriptCloseLoops = R"(
function close_loops($parameters$ q, tolerance, most_steps = 20) {
  const phi = new Float64Array($rows$), dq = new Float64Array(position_count);
  const gap_at = (position) => {
    $closure$($parameters$ position, phi);
    return phi.reduce((sum, entry) => sum + entry * entry, 0);
  };
  let here = Float64Array.from(q);
  let gap = gap_at(here);
  for (let step = 0; step < most_steps && gap > tolerance * tolerance; ++step) {
    if (!$step$($parameters$ here, dq)) return false;
    let next = here, next_gap = gap;
    for (let size = 1; size > 1e-6 && !(next_gap < gap); size *= 0.5) {
      next = here.map((x, k) => x + size * dq[k]);
      next_gap = gap_at(next);
    }
    if (!(next_gap < gap)) return false;
    here = next;
    gap = next_gap;
  }
  if (!(tolerance >= 0 && gap <= tolerance * tolerance)) return false;
  for (let k = 0; k < position_count; ++k) q[k] = here[k];
  return true;
})";

}  // namespace flatdyn
