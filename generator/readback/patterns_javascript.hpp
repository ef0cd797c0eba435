// SPDX-License-Identifier: GPL-2.0-or-later
// The helper of emitted JavaScript, as it has to be. It is written down here once more, not taken from the template.
#pragma once

namespace flatdyn {

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
