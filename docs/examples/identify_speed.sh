#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# How many lines a second `flatdyn identify` folds on one core, for a 7-axis arm, within 500 MB: once with q and tau alone
# (derivatives come from the filter), once with all derivatives in the log; numbers of nine digits, more than sensors
# tell. What the set-up takes is taken off.
#   docs/examples/identify_speed.sh FOLDER [LINES]
set -euo pipefail
folder=$1
lines=${2:-1000000}
flatdyn=${FLATDYN:-build/release/generator/flatdyn}
mkdir -p "$folder"
"$flatdyn" excite robots/panda.urdf -o "$folder" --quiet --rate 1000 --duration 20 --evaluations 50 >/dev/null

# repeated COLUMNS LINES FILE: the excitation over and over, 1 ms from line to line.
repeated() {
  cut -d, -f"$1" "$folder/panda_excitation.csv" |
    awk -F, -v lines="$2" 'NR == 1 { print; next } { for (c = 2; c <= NF; ++c) row[NR - 2] = row[NR - 2] sprintf(",%.9g", $c) }
      END { for (k = 0; k < lines; ++k) printf "%.3f%s\n", k / 1000, row[k % (NR - 1)] }' >"$3"
}

# seconds FILE: of the user's time to fold it into a part.
seconds() {
  local TIMEFORMAT=%U
  { time (ulimit -v 2000000 && taskset -c 0 "$flatdyn" identify robots/panda.urdf --quiet --data "$1" --part 1/1 -o "$folder/part.json" >/dev/null 2>&1); } 2>&1
}

for columns in 1-8,23-29 1-29; do
  repeated $columns 1000 "$folder/short.csv"
  repeated $columns "$lines" "$folder/long.csv"
  awk -v columns=$columns -v lines="$lines" -v short="$(seconds "$folder/short.csv")" -v long="$(seconds "$folder/long.csv")" \
    'BEGIN { printf "columns %-10s %.0f lines a second\n", columns, (lines - 1000) / (long - short) }'
done
