#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# An arm as it is in practice, identified from positions and torques alone. It has friction and rotors that its file
# lacks, and links that differ from the file's. The torques have what the model lacks, too: friction that is larger near
# rest (Stribeck) and ripple. There are noise, encoder steps, times in which the arm stands still, and a joint that is
# held. A second log, of another motion, says how well the parameters hold.
#   docs/examples/identify_practical.sh FOLDER [ur5|panda]
set -euo pipefail
folder=$1
robot=${2:-ur5}
flatdyn=${FLATDYN:-build/release/generator/flatdyn}
rate=${RATE:-1000}  # samples a second
seed=${SEED:-1}     # of the search for the motion, and of noise
mkdir -p "$folder"

# By joint: friction, rotors as they are felt at the joint, and the standard deviation of torque noise, N m. The joints
# that are held in each log; the amplitude, rad, with which joints swing in the second one within the arm's speed limits.
case $robot in
  ur5)
    viscous="8 8 6 2 2 1.5" coulomb="9 9 7 2.5 2.2 1.8" armature="3 3 1.6 0.35 0.35 0.2" noise="0.5 0.5 0.4 0.1 0.1 0.1"
    held=3 held_in_validation=5 swing=0.5
    ;;
  panda)
    viscous="4 4 3 3 1 1 0.7" coulomb="5 5 4 4 1.5 1.5 1" armature="0.6 0.6 0.5 0.5 0.2 0.2 0.15"
    noise="0.15 0.15 0.15 0.15 0.05 0.05 0.05" held=4 held_in_validation=2 swing=0.4
    ;;
  *) echo "identify_practical.sh: robots are ur5 and panda, not \"$robot\"" >&2 && exit 2 ;;
esac
plain=$PWD/robots/$robot.urdf

# The arm as it is: every second link is heavier than its file says, the others are lighter, and masses lie elsewhere.
awk -v plain="$plain" -v viscous="$viscous" -v coulomb="$coulomb" -v armature="$armature" '
  function value(name) {
    return match($0, name "=\"[^\"]*") ? substr($0, RSTART + length(name) + 2, RLENGTH - length(name) - 2) : 0
  }
  BEGIN {
    split(viscous, f_v, " "); split(coulomb, f_s, " "); split(armature, i_m, " ")
    print "robot = \"" plain "\""
  }
  /<link name/ { link = value("name") }
  /<joint name.*type="revolute"/ {
    printf "[[joint]]\nname = \"%s\"\nviscous = %s\n", value("name"), f_v[++n]
    printf "coulomb = %s\narmature = %s\n", f_s[n], i_m[n]
  }
  /<inertial>/ { inertial = 1 }
  inertial && /<origin/ { split(value("xyz"), com, " ") }
  inertial && /<mass/ { mass = value("value") }
  inertial && /<inertia / {
    sign = ++links % 2 ? 1 : -1
    printf "[[link]]\nname = \"%s\"\nmass = %.6g\n", link, mass * (1 + 0.06 * sign)
    printf "com = [%.6g, %.6g, %.6g]\ninertia_about = \"com\"\n", com[1] + 0.005, com[2] - 0.004 * sign, com[3] + 0.003
    printf "inertia = { xx = %.6g, yy = %.6g, zz = %.6g, ", value("ixx"), value("iyy"), value("izz")
    printf "xy = %.6g, xz = %.6g, yz = %.6g }\n", value("ixy"), value("ixz"), value("iyz")
    inertial = 0
  }' "$plain" >"$folder/truth.toml"

# with_rests FILE JOINT: a motion from rest to rest twice, the second time with a joint held, and a second of rest
# before, between and behind.
with_rests() {
  awk -F, -v held="$2" -v rate="$rate" '
    function still(seconds,    k) { for (k = 0; k < rate * seconds; ++k) row(1, 1) }
    function row(from, is_all,    i, c, line, moving) {
      line = sprintf("%.3f", time / rate); ++time
      for (c = 0; c < 3; ++c) {
        for (i = 1; i <= n; ++i) {
          moving = moves[from] && (is_all || i != held)
          line = line sprintf(",%.12g", moving ? motion[from, c * n + i] : c ? 0 : motion[1, i])
        }
      }
      print line
    }
    NR == 1 { while ($(n + 2) ~ /^q[0-9]/) ++n; head = $1; for (c = 2; c <= 3 * n + 1; ++c) head = head "," $c; next }
    { ++rows; for (c = 1; c <= 3 * n; ++c) motion[rows, c] = $(c + 1) }
    END {
      print head
      for (k = 2; k < rows; ++k) moves[k] = 1
      still(1)
      for (k = 1; k <= rows; ++k) row(k, 1)
      still(1)
      for (k = 1; k <= rows; ++k) row(k, 0)
      still(1)
    }' "$1"
}

# swings FILE: each joint swings to one side and back at a pace of its own, from where the motion in FILE begins.
swings() {
  awk -F, -v rate="$rate" -v a="$swing" -v cycles="2 1 3 4 3 5 2" '
    NR == 1 { while ($(n + 2) ~ /^q[0-9]/) ++n; head = $1; for (c = 2; c <= 3 * n + 1; ++c) head = head "," $c }
    NR == 2 {
      print head
      split(cycles, k, " ")
      for (sample = 0; sample <= 5 * rate; ++sample) {
        q = qd = qdd = ""
        for (i = 1; i <= n; ++i) {
          w = k[i] * 2 * atan2(0, -1) / 5; phase = w * sample / rate
          q = q sprintf(",%.12g", $(i + 1) + a * (1 - cos(phase)))
          qd = qd sprintf(",%.12g", a * w * sin(phase))
          qdd = qdd sprintf(",%.12g", a * w * w * cos(phase))
        }
        print sample / rate q qd qdd
      }
      exit
    }' "$1"
}

# torques ROBOT MOTION: t, q, qd, qdd and tau of a robot file for a motion.
torques() { "$flatdyn" eval "$1" --function inverse_dynamics --states "$2" --quiet; }

# measured FILE SEED: what the sensors say of a motion with the model's torques.
measured() {
  awk -F, -v state="$2" -v coulomb="$coulomb" -v noise="$noise" '
    function uniform() { state = state * 16807 % 2147483647; return state / 2147483647 }
    function normal() { return sqrt(-2 * log(uniform())) * cos(6.283185307179586 * uniform()) }
    function lacking(i, qd) { return 0.3 * f_s[i] * (qd > 0 ? 1 : -1) * exp(-(qd > 0 ? qd : -qd) / 0.1) }
    # Friction at rest may be anything within its bounds.
    function holding(i) {
      rest[i] += rests[i]++ ? 0.01 * (2 * uniform() - 1) : 2 * uniform() - 1 - rest[i]
      if (rest[i] > 1 || rest[i] < -1) rest[i] = rest[i] > 0 ? 1 : -1
      return rest[i] * f_s[i]
    }
    NR == 1 {
      n = (NF - 1) / 4; split(coulomb, f_s, " "); split(noise, sigma, " ")
      line = "t"; for (i = 1; i <= n; ++i) line = line ",q" i
      for (i = 1; i <= n; ++i) line = line ",tau" i
      print line; next
    }
    {
      line = $1
      for (i = 1; i <= n; ++i) line = line sprintf(",%.4f", $(1 + i))
      for (i = 1; i <= n; ++i) {
        q = $(1 + i); qd = $(1 + n + i); tau = $(1 + 3 * n + i)
        if (qd == 0) { tau += holding(i) } else { tau += lacking(i, qd); rests[i] = 0 }
        line = line sprintf(",%.6g", tau * (1 + 0.02 * sin(20 * q)) + sigma[i] * normal())
      }
      print line
    }' "$1"
}

"$flatdyn" excite "$plain" -o "$folder" --quiet --rate "$rate" --duration 10 --evaluations "${EVALUATIONS:-1000}" \
  --seed "$seed"
excitation=$folder/${robot}_excitation.csv
with_rests "$excitation" "$held" >"$folder/motion.csv"
swings "$excitation" >"$folder/swings.csv"
with_rests "$folder/swings.csv" "$held_in_validation" >"$folder/validation_motion.csv"
torques "$folder/truth.toml" "$folder/motion.csv" >"$folder/exact.csv"
torques "$folder/truth.toml" "$folder/validation_motion.csv" >"$folder/validation_exact.csv"
measured "$folder/exact.csv" $((2 * seed - 1)) >"$folder/log.csv"
measured "$folder/validation_exact.csv" $((2 * seed)) >"$folder/validation.csv"

"$flatdyn" identify "$plain" --data "$folder/log.csv" --validate "$folder/validation.csv" -o "$folder/identified.toml" \
  --plot "$folder/residuals.svg" --validation-plot "$folder/validation.svg"
