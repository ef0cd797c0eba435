// SPDX-License-Identifier: GPL-2.0-or-later
// The helpers of emitted JavaScript, as they have to be. They are written down here once more, not taken from the
// template.
#pragma once

namespace flatdyn {

inline constexpr const char* kJavascriptSines = R"(
function sine_of_turned(x, turns) {
  if (!(x <= 1e5 && x >= -1e5)) return turns === 0 ? Math.sin(x) : Math.cos(x);
  const n = (x * 0.6366197723675814 + 6755399441055744) - 6755399441055744, quadrant = n + turns;
  const above = x - n * 1.5707963267341256, below = n * 6.077100506303966e-11, r = above - below;
  const missing = (below - (above - r)) + n * 2.0222662487959506e-21;
  const z = r * r, zz = z * z, half = 0.5 * z, leading = 1 - half;
  let sine = 0;
  if ((quadrant & 1) === 0) {
    const p = (1.66666666666666324348e-01 + z * -8.33333333332248946124e-03) +
        zz * ((1.98412698298579493134e-04 + z * -2.75573137070700676789e-06) +
        zz * (2.50507602534068634195e-08 + z * -1.58969099521155010221e-10));
    sine = r - (z * r * p + leading * missing);
  } else {
    const k = (4.16666666666666019037e-02 + z * -1.38888888888741095749e-03) +
        zz * ((2.48015872894767294178e-05 + z * -2.75573143513906633035e-07) +
        zz * (2.08757232129817482790e-09 + z * -1.13596475577881948265e-11));
    sine = leading + ((((1 - leading) - half) + r * missing) + zz * k);
  }
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
