// SPDX-License-Identifier: GPL-2.0-or-later
// The helpers of emitted Rust, as they have to be. They are written down here once more, not taken from the templates.
#pragma once

namespace flatdyn {

inline constexpr const char* kRustAttributes = R"(
#![forbid(unsafe_code)]
#![allow(non_snake_case)]
#![allow(clippy::approx_constant)]
#![allow(clippy::excessive_precision)]
#![allow(clippy::too_many_arguments)]
#![cfg_attr(rustfmt, rustfmt_skip)]
use core::hint::black_box;
)";

inline constexpr const char* kRustSign = R"(
#[inline]
fn sign(x: $real$) -> $real$ { $real$::from(i8::from(x > 0.0) - i8::from(x < 0.0)) }
)";

inline constexpr const char* kRustSqrt = R"(
fn sqrt(x: $real$) -> $real$ {
  if x.is_nan() || x < 0.0 { return $real$::NAN; }
  if x == 0.0 || x == $real$::INFINITY { return x; }
  let is_tiny = x < $real$::MIN_POSITIVE;
  let scaled = if is_tiny { x * $tiny_factor$ } else { x };
  let bits = scaled.to_bits();
  let exponent = (bits >> $places$) as i32 - $least$;
  let mantissa = (bits & $fraction$) | $hidden$;
  let is_odd = exponent & 1;
  let square = $wide$::from(mantissa << $odd_or_even$) << $behind$;
  let (mut root, mut remainder) = (0$bits$, 0$bits$);
  for pair in (0..$pairs$).rev() {
    remainder = (remainder << 2) | (((square >> (2 * pair)) as $bits$) & 3);
    let trial = (root << 2) | 1;
    let fits = remainder >= trial;
    remainder -= if fits { trial } else { 0 };
    root = (root << 1) | $bits$::from(fits);
  }
  let scale = (exponent $half_exponent$ - if is_tiny { $tiny_scale$ } else { 0 };
  ((root + 1) >> 1) as $real$ * $real$::from_bits((($bias$ + scale) as $bits$) << $places$)
}
)";

inline constexpr const char* kRustMultiplyAdd = R"(
#[inline]
fn multiply_add(a: $real$, b: $real$, c: $real$) -> $real$ {
  if cfg!(any(target_feature = "fma", target_arch = "aarch64")) { a.mul_add(b, c) } else { a * b + c }
}
)";

inline constexpr const char* kRustLibrarySines = R"(
#[inline]
fn sines_and_cosines(q: &[$real$], sine: &mut [$real$], cosine: &mut [$real$]) {
  for ((x, s), c) in q.iter().zip(sine).zip(cosine) { (*s, *c) = (x.sin(), x.cos()); }
}
)";

// Before the reduction of an angle; between it and the polynomials; and after them.
inline constexpr const char* kRustSineBegin = R"(
#[inline]
fn sine_and_cosine(x: $real$) -> ($real$, $real$) {
  let turns = x * $two_over_pi$ + $to_whole$;
  let n = turns - $to_whole$;
)";

inline constexpr const char* kRustSineReduced = R"(
  of_quarter(r, missing, turns.to_bits())
}
#[inline]
fn of_quarter(r: $real$, missing: $real$, quadrant: $bits$) -> ($real$, $real$) {
)";

inline constexpr const char* kRustSineEnd = R"(
  let exchange = (s.to_bits() ^ c.to_bits()) & (quadrant & 1).wrapping_neg();
  let sine = s.to_bits() ^ exchange ^ ((quadrant & 2) << $to_sign$);
  let cosine = c.to_bits() ^ exchange ^ ((quadrant.wrapping_add(1) & 2) << $to_sign$);
  ($real$::from_bits(sine), $real$::from_bits(cosine))
}
)";

inline constexpr const char* kRustBitsForDoubles = R"(
const TWO_OVER_PI: [u64; 20] = [
  0x0000_0000_0000_0000, 0xa2f9_836e_4e44_1529, 0xfc27_57d1_f534_ddc0, 0xdb62_9599_3c43_9041,
  0xfe51_63ab_debb_c561, 0xb724_6e3a_424d_d2e0, 0x0649_2eea_09d1_921c, 0xfe1d_eb1c_b129_a73e,
  0xe882_35f5_2ebb_4484, 0xe99c_7026_b45f_7e41, 0x3991_d639_8353_39f4, 0x9c84_5f8b_bdf9_283b,
  0x1ff8_97ff_de05_980f, 0xef2f_118b_5a0a_6d1f, 0x6d36_7ecf_27cb_09b7, 0x4f46_3f66_9e5f_ea2d,
  0x7527_bac7_ebe5_f17b, 0x3d07_39f7_8a52_92ea, 0x6bfb_5fb1_1f8d_5d08, 0x5603_3046_fc7b_6bab,
];
)";

inline constexpr const char* kRustBitsForFloats = R"(
const TWO_OVER_PI: [u64; 6] = [
  0x0000_0000_0000_0000, 0xa2f9_836e_4e44_1529, 0xfc27_57d1_f534_ddc0, 0xdb62_9599_3c43_9041,
  0xfe51_63ab_debb_c561, 0xb724_6e3a_424d_d2e0,
];
)";

inline constexpr const char* kRustLargeAngles = R"(
#[cold]
fn sine_and_cosine_of_large(x: $real$) -> ($real$, $real$) {
  let bits = $as_double$.to_bits();
  let exponent = ((bits >> 52) & 0x7ff) as usize;
  if exponent == 0x7ff { return ($real$::NAN, $real$::NAN); }
  let mantissa = (bits & 0x000f_ffff_ffff_ffff) | 0x0010_0000_0000_0000;
  let first = exponent - 1013;
  let word = |k: usize| u128::from(TWO_OVER_PI.get(first / 64 + k).copied().unwrap_or(0));
  let window = |k: usize| (((word(k) << 64) | word(k + 1)) << (first % 64)) >> 64;
  let low = u128::from(mantissa) * window(2);
  let middle = u128::from(mantissa) * window(1) + (low >> 64);
  let turn = (u128::from(mantissa).wrapping_mul(window(0)) << 64).wrapping_add(middle);
  let quadrant = ((turn >> 125) + 1) >> 1;
  let rest = turn.wrapping_sub(quadrant << 126) as i128;
  let magnitude = rest.unsigned_abs() | 1;
  let zeros = magnitude.leading_zeros();
  let product = ((((magnitude << zeros) >> 64) * 0xc90f_daa2_2168_c235) >> 2) as i128;
  let unit = f64::from_bits(u64::from(900 - zeros) << 52);
  let signed_unit = if rest < 0 { -unit } else { unit };
)";

inline constexpr const char* kRustLargeInDouble = R"(
  let rounded = product as f64;
  let missing = (rounded as i128 - product) as f64;
  let (s, c) = of_quarter(rounded * signed_unit, missing * signed_unit, quadrant as u64);
)";

inline constexpr const char* kRustLargeInFloat = R"(
  let angle = product as f64 * signed_unit;
  let r = angle as f32;
  let (s, c) = of_quarter(r, (f64::from(r) - angle) as f32, quadrant as u32);
)";

inline constexpr const char* kRustSines = R"(
  (if x < 0.0 { -s } else { s }, c)
}
#[inline]
fn sines_and_cosines(q: &[$real$], sine: &mut [$real$], cosine: &mut [$real$]) {
  let is_small = |x: $real$| (-$most_angle$..=$most_angle$).contains(&x);
  let mut all_are_small = true;
  for ((x, s), c) in q.iter().zip(sine.iter_mut()).zip(cosine.iter_mut()) {
    (*s, *c) = sine_and_cosine(*x);
    all_are_small &= is_small(*x);
  }
  if all_are_small { return; }
  for ((x, s), c) in q.iter().zip(sine).zip(cosine) {
    if !is_small(*x) { (*s, *c) = sine_and_cosine_of_large(*x); }
  }
}
)";

inline constexpr const char* kRustCloseLoops = R"(
fn gap_at($parameters_argument$ q: &[$real$; $position_count$]) -> $real$ {
  let mut phi = [0.0; $rows$];
  $closure$($parameters$ q, &mut phi);
  phi.iter().fold(0.0, |sum, entry| sum + entry * entry)
}
#[must_use]
pub fn close_loops($parameters_argument$ q: &mut [$real$; $position_count$], tolerance: $real$, most_steps: usize) -> bool {
  let mut here = *q;
  let mut gap = gap_at($parameters$ &here);
  for _ in 0..most_steps {
    let is_open = gap > tolerance * tolerance;
    if !is_open { break; }
    let mut dq = [0.0; $position_count$];
    if !$step$($parameters$ &here, &mut dq) { return false; }
    let (mut next, mut size, mut is_less) = (here, 1.0, false);
    for _ in 0..20 {
      for ((x, from), change) in next.iter_mut().zip(&here).zip(&dq) { *x = from + size * change; }
      let next_gap = gap_at($parameters$ &next);
      is_less = next_gap < gap;
      if is_less { gap = next_gap; break; }
      size *= 0.5;
    }
    if !is_less { return false; }
    here = next;
  }
  let is_closed = tolerance >= 0.0 && gap <= tolerance * tolerance;
  if is_closed { *q = here; }
  is_closed
}
)";

// The functions that rounding_is_as_written() calls, in this order; those about sines only if there are sines.
inline constexpr const char* kRustFill = R"(
fn fill(x: &mut [$real$], seed: u32) -> u32 {
  let mut state = seed;
  for entry in x {
    state = state.wrapping_mul(1664525).wrapping_add(1013904223);
    *entry = ((state >> 8) as $real$ - 8388608.0) / 8388608.0;
  }
  state
}
)";

inline constexpr const char* kRustFillSines = R"(
fn fill_sines(sine: &mut [$real$], cosine: &mut [$real$], seed: u32) {
  fill(sine, seed);
  for (s, c) in sine.iter_mut().zip(cosine) {
    let (t, square) = (*s, *s * *s);
    (*s, *c) = (2.0 * t / (1.0 + square), (1.0 - square) / (1.0 + square));
  }
}
)";

inline constexpr const char* kRustHash = R"(
fn hash_of(x: &[$real$], hash: u64) -> u64 {
  let mut sum = hash;
  for entry in x {
    let bits = if entry.is_nan() { 0 } else { entry.to_bits() };
    sum = (sum ^ $hashed_bits$).wrapping_mul(1099511628211);
    sum ^= sum >> 32;
  }
  sum
}
)";

inline constexpr const char* kRustSinesAreRight = R"(
fn sines_are_right() -> bool {
  let x = black_box([0.5, 0.6875, 1.28125, 1.53125, 1.796875, 3.125, 10.28125, 11.125]);
  let (mut sine, mut cosine) = ([0.0; 8], [0.0; 8]);
  sines_and_cosines(&x, &mut sine, &mut cosine);
  hash_of(&cosine, hash_of(&sine, 14695981039346656037)) == $hash_of_sines$
}
)";

inline constexpr const char* kRustRounding = R"(
#[must_use]
pub fn rounding_is_as_written() -> bool {
  let [u, w, one, tiny]: [$real$; 4] = black_box([0.1, 0.7, 1.0, 1e-17]);
  let [nine, seven, half]: [$real$; 3] = black_box([9.0, 7.0, 0.5]);
  let half_a_place = black_box($real$::from_bits($half_a_place$));
  let smallest = black_box($real$::MIN_POSITIVE);
  let (product, quotient, next) = (black_box(u * w), black_box(nine / seven), black_box(one + half_a_place));
  if u * w - product != 0.0 || next <= 1.0 || (one + tiny) - one != 0.0 || (one - tiny) - one != 0.0
      || nine / 7.0 - quotient != 0.0 || smallest * half <= 0.0 {
    return false;
  }
)";

// A test of the crate's own.
inline constexpr const char* kRustTestBegin = R"(
#[cfg(test)]
mod tests {
#[test]
)";

inline constexpr const char* kRustTestOfFused = R"(
#[cfg_attr(not(any(target_feature = "fma", target_arch = "aarch64")), ignore = "nothing is fused")]
)";

inline constexpr const char* kRustTest = R"(
  fn rounding_is_as_written() { assert!(super::rounding_is_as_written()); }
}
)";

inline constexpr const char* kRustManifest = R"(
# SPDX-License-Identifier: BSD-3-Clause
[package]
name = "$crate$"
version = "0.1.0"
edition = "2021"
rust-version = "1.66"
license = "BSD-3-Clause"
publish = false
)";

}  // namespace flatdyn
