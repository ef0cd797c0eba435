#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# A Panda arm, identified from an excitation trajectory with noise on the torques. The robot file that is given to
# identify has all masses wrong: its parameters must come from the motion. There is no friction in it, nor in the log.
#   docs/examples/identify_panda.sh FOLDER
set -euo pipefail
folder=$1
flatdyn=${FLATDYN:-build/release/generator/flatdyn}
mkdir -p "$folder"

"$flatdyn" excite robots/panda.urdf -o "$folder" --rate 50 --evaluations "${EVALUATIONS:-3000}"

# Normal noise (twelve uniform numbers, less six) of 0.1 N m on the torques, the same in every run.
awk -F, -v OFS=, '
  function uniform() { state = state * 16807 % 2147483647; return state / 2147483647 }
  function normal(    k, sum) { sum = -6; for (k = 0; k < 12; ++k) sum += uniform(); return sum }
  BEGIN { state = 1 }
  NR == 1 { for (k = 1; k <= NF; ++k) if ($k ~ /^tau/) torque[k] = 1 }
  NR > 1 { for (k in torque) $k = sprintf("%.10g", $k + 0.1 * normal()) }
  { print }' "$folder/panda_excitation.csv" >"$folder/log.csv"

sed -E 's/(<mass value=")[^"]*/\11.0/' robots/panda.urdf >"$folder/panda_unknown.urdf"
"$flatdyn" identify "$folder/panda_unknown.urdf" --parameters given --data "$folder/log.csv" -o "$folder/identified.toml" --plot "$folder/residuals.svg"
