// SPDX-License-Identifier: GPL-2.0-or-later
#include "code/languages/common/patterns_sines.hpp"

namespace flatdyn {
namespace {

using Holes = std::map<std::string, std::string>;

// 2/pi; 1.5 times the number beyond which there are no fractions; and pi/2 in parts.
const Holes kHexadecimalsOfDoubles = {{"two_over_pi", "0x1.45f306dc9c883p-1"},
                                      {"to_whole", "0x1.8p+52"},
                                      {"pi_1", "0x1.921fb544p+0"},
                                      {"pi_2", "0x1.0b4611a6p-34"},
                                      {"pi_3", "0x1.3198a2e037073p-69"}};
const Holes kDecimalsOfDoubles = {{"two_over_pi", "0.6366197723675814"},
                                  {"to_whole", "6755399441055744"},
                                  {"pi_1", "1.5707963267341256"},
                                  {"pi_2", "6.077100506303966e-11"},
                                  {"pi_3", "2.0222662487959506e-21"}};
const Holes kHexadecimalsOfFloats = {{"two_over_pi", "0x1.45f306p-1"}, {"to_whole", "0x1.8p+23"},
                                     {"pi_1", "0x1.922p+0"},           {"pi_2", "-0x1.2cp-18"},
                                     {"pi_3", "0x1.11p-26"},           {"pi_4", "0x1.68c234p-39"}};
const Holes kDecimalsOfFloats = {{"two_over_pi", "0.63661975"}, {"to_whole", "12582912"}, {"pi_1", "1.5708008"},
                                 {"pi_2", "-4.4703484e-6"},     {"pi_3", "1.5890691e-8"}, {"pi_4", "2.563344e-12"}};

const Holes& constants(const SinesStyle& style) {
  if (style.is_float) return style.has_hexadecimals ? kHexadecimalsOfFloats : kDecimalsOfFloats;
  return style.has_hexadecimals ? kHexadecimalsOfDoubles : kDecimalsOfDoubles;
}

}  // namespace

std::map<std::string, std::string> sines_holes(const SinesStyle& style) {
  Holes holes = {{"k", style.cosine_polynomial},

                 {"let", style.let},
                 {"next_let", style.next_let},
                 {"f", style.suffix},
                 {"one", style.one + style.suffix}};
  for (const auto& [name, digits] : constants(style)) {
    const bool is_whole = name == "to_whole" && !style.has_hexadecimals && style.one == "1.0";
    holes[name] = digits + (is_whole ? ".0" : "") + style.suffix;
  }
  return holes;
}

std::string reduction_pattern(bool is_float) {
  return is_float ? R"(
  $let$ above = (x - n * $pi_1$) - n * $pi_2$ $next_let$ below = n * $pi_3$;
  $let$ r = above - below $next_let$ missing = (below - (above - r)) + n * $pi_4$;)"
                  : R"(
  $let$ above = x - n * $pi_1$ $next_let$ below = n * $pi_2$ $next_let$ r = above - below;
  $let$ missing = (below - (above - r)) + n * $pi_3$;)";
}

std::string squares_pattern(bool is_float) {
  return is_float
             ? "$let$ z = r * r $next_let$ half = 0.5$f$ * z $next_let$ leading = $one$ - half;"
             : "$let$ z = r * r $next_let$ zz = z * z $next_let$ half = 0.5 * z $next_let$ leading = $one$ - half;";
}

std::string sine_polynomial_pattern(bool is_float) {
  return is_float ? "$let$ p = 1.6666654611e-1$f$ + z * (-8.3321608736e-3$f$ + z * 1.9515295891e-4$f$);" : R"(
  $let$ p = (1.66666666666666324348e-01 + z * -8.33333333332248946124e-03) +
      zz * ((1.98412698298579493134e-04 + z * -2.75573137070700676789e-06) +
      zz * (2.50507602534068634195e-08 + z * -1.58969099521155010221e-10));)";
}

std::string cosine_polynomial_pattern(bool is_float) {
  return is_float
             ? "$let$ $k$ = 4.166664568298827e-2$f$ + z * (-1.388731625493765e-3$f$ + z * 2.443315711809948e-5$f$);"
             : R"(
  $let$ $k$ = (4.16666666666666019037e-02 + z * -1.38888888888741095749e-03) +
      zz * ((2.48015872894767294178e-05 + z * -2.75573143513906633035e-07) +
      zz * (2.08757232129817482790e-09 + z * -1.13596475577881948265e-11));)";
}

std::string sine_pattern(bool) { return "r - (z * r * p + leading * missing);"; }

std::string cosine_pattern(bool is_float) {
  return std::string("leading + (((($one$ - leading) - half) + r * missing) + ") + (is_float ? "z * z" : "zz") +
         " * $k$);";
}

std::string sines_by_bits_pattern(bool is_float, const BitsOfSines& words) {
  const std::string zero = words.is_initialised ? " = 0" : "", to_sign = is_float ? "30" : "62";
  const std::string zero_number = !words.is_initialised ? "" : is_float ? " = 0.0f" : " = 0.0";
  const auto copy = [&words](const std::string& to, const std::string& from) {
    return words.memcpy + "(" + to + ", &" + from + ", sizeof(" +
           (from.starts_with("bits_of_") ? from.substr(8) : from) + "));";
  };
  return "$let$ turns = x * $two_over_pi$ + $to_whole$;" + words.bits + " quadrant" + zero + ", bits_of_s" + zero +
         ", bits_of_c" + zero + ";" + copy("&quadrant", "turns") + "const " + words.bits + " next = quadrant + " +
         (is_float ? "0x200001u" : "0x4000000000001u") + ";" + words.number + " n" + zero_number + ";" +
         copy("&n", "next") + "n -= " + (is_float ? "0x1.c00002p+23f" : "0x1.c000000000001p+52") + ";" +
         reduction_pattern(is_float) + polynomials_pattern(is_float) + copy("&bits_of_s", "s") +
         copy("&bits_of_c", "c") + "const " + words.bits +
         " exchange = (bits_of_s ^ bits_of_c) & (0u - (quadrant & 1u));" +
         "bits_of_s ^= exchange ^ ((quadrant & 2u) << " + to_sign + ");" + "bits_of_c ^= exchange ^ ((next & 2u) << " +
         to_sign + ");" + copy(words.address + "sine", "bits_of_s") + copy(words.address + "cosine", "bits_of_c") + "}";
}

std::string polynomials_pattern(bool is_float) {
  return squares_pattern(is_float) + sine_polynomial_pattern(is_float) + cosine_polynomial_pattern(is_float) +
         "$let$ s = " + sine_pattern(is_float) + "$let$ c = " + cosine_pattern(is_float);
}

}  // namespace flatdyn
