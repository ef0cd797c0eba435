#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# The planar arm of Example 7.2, identified from its own motion: both joints turn by pi/2 with a triangular velocity
# profile, at the same time (Fig. 7.5) and one after the other. Sensors: torques with 2 N m of noise.
#   docs/examples/identify_planar_arm.sh FOLDER
set -euo pipefail
robot=robots/planar_2r_example_7_2.toml
folder=$1
flatdyn=${FLATDYN:-build/release/generator/flatdyn}
mkdir -p "$folder"

# motion NAME START_1 START_2: 1000 samples a second; each joint takes 0.5 s from its start on, within 1 s.
motion() {
  awk -v start1="$2" -v start2="$3" 'BEGIN {
    pi = atan2(0, -1); q0[1] = -1.470629; q0[2] = 2.941258   # the tip at (0.2, 0), lower elbow
    start[1] = start1; start[2] = start2
    print "t,q1,q2,qd1,qd2,qdd1,qdd2"
    for (k = 0; k <= 1000; ++k) {
      t = k / 1000
      for (i = 1; i <= 2; ++i) {
        s = t - start[i]; a = 2 * pi / 0.5 ^ 2; half = 0.25; rest = 0.5 - s   # pi/2 in 0.5 s: a = 4 (pi/2) / T^2
        if (s <= 0)         { q[i] = q0[i];                              qd[i] = 0;        qdd[i] = 0 }
        else if (s <= half) { q[i] = q0[i] + a * s ^ 2 / 2;              qd[i] = a * s;    qdd[i] = a }
        else if (rest > 0)  { q[i] = q0[i] + pi / 2 - a * rest ^ 2 / 2;  qd[i] = a * rest; qdd[i] = -a }
        else                { q[i] = q0[i] + pi / 2;                     qd[i] = 0;        qdd[i] = 0 }
      }
      printf "%.3f,%.12g,%.12g,%.12g,%.12g,%.12g,%.12g\n", t, q[1], q[2], qd[1], qd[2], qdd[1], qdd[2]
    }
  }' >"$folder/$1_motion.csv"
  "$flatdyn" eval "$robot" --function inverse_dynamics --states "$folder/$1_motion.csv" --quiet -o "$folder/$1_exact.csv"
}

# Normal noise (twelve uniform numbers, less six) on the torques, the same in every run.
measured() {
  awk -F, -v OFS=, -v state="$2" '
    function uniform() { state = state * 16807 % 2147483647; return state / 2147483647 }
    function normal(    k, sum) { sum = -6; for (k = 0; k < 12; ++k) sum += uniform(); return sum }
    NR > 1 { for (k = 8; k <= 9; ++k) $k = sprintf("%.10g", $k + 2 * normal()) }
    { print }' "$folder/$1_exact.csv" >"$folder/$1.csv"
}

motion together 0 0
motion one_by_one 0 0.5
measured together 1
measured one_by_one 2
"$flatdyn" identify "$robot" --parameters given --sequential --data "$folder/together.csv" "$folder/one_by_one.csv" \
  -o "$folder/identified.toml" --plot "$folder/residuals.svg"
