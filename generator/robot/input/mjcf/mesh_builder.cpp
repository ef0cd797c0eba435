// SPDX-License-Identifier: GPL-2.0-or-later
#include "robot/input/mjcf/mesh_builder.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

namespace flatdyn {

namespace {

constexpr int kMostDigits = 60;

bool is_digit(char c) { return c >= '0' && c <= '9'; }

MeshInteger power(int base, int exponent) {
  MeshInteger result;
  mpz_ui_pow_ui(result.get_mpz_t(), static_cast<unsigned long>(base), static_cast<unsigned long>(exponent));
  return result;
}

}  // namespace

std::optional<Scientific> exact_float(float value) {
  if (!std::isfinite(value)) return std::nullopt;
  constexpr int kDigits = std::numeric_limits<float>::digits;
  int exponent = 0;
  const float fraction = std::frexp(value, &exponent);
  return Scientific{MeshInteger(static_cast<long>(std::ldexp(fraction, kDigits))), exponent - kDigits};
}

std::optional<Scientific> exact_scientific(std::string_view text) {
  std::string digits;
  int exponent = 0;
  std::size_t i = 0;
  const bool is_negative = !text.empty() && text[0] == '-';
  if (!text.empty() && (text[0] == '-' || text[0] == '+')) ++i;
  bool has_point = false;
  for (; i < text.size() && (is_digit(text[i]) || (text[i] == '.' && !has_point)); ++i) {
    if (text[i] == '.') {
      has_point = true;
    } else {
      digits += text[i];
      if (has_point) --exponent;
    }
  }
  if (digits.empty() || digits.size() > kMostDigits) return std::nullopt;
  if (i < text.size() && (text[i] == 'e' || text[i] == 'E')) {
    ++i;
    if (i < text.size() && text[i] == '+') ++i;
    int written = 0;
    const auto [end, error] = std::from_chars(text.data() + i, text.data() + text.size(), written);
    if (error != std::errc() || std::abs(written) > kMostDigits) return std::nullopt;
    exponent += written;
    i = static_cast<std::size_t>(end - text.data());
  }
  if (i != text.size()) return std::nullopt;
  const std::size_t first = digits.find_first_not_of('0');
  if (first == std::string::npos) return Scientific{};
  constexpr int kLargest = 30;
  if (exponent < -kMostDigits || exponent + static_cast<int>(digits.size() - first) > kLargest) return std::nullopt;
  const MeshInteger mantissa(digits.substr(first));
  return Scientific{is_negative ? MeshInteger(-mantissa) : mantissa, exponent};
}

TriangleMesh MeshBuilder::mesh() const {
  int least = 0;
  for (const auto& point : points_) {
    for (const Scientific& each : point) least = each.mantissa == 0 ? least : std::min(least, each.exponent);
  }
  TriangleMesh mesh;
  mesh.unit = GiNaC::pow(Number(base_), least);
  std::map<IntegerPoint, std::size_t> known;
  std::vector<std::size_t> index;
  for (const auto& point : points_) {
    IntegerPoint whole;
    for (std::size_t k = 0; k < 3; ++k) {
      if (point[k].mantissa != 0) whole[k] = point[k].mantissa * power(base_, point[k].exponent - least);
    }
    const auto [found, is_new] = known.emplace(whole, mesh.points.size());
    if (is_new) mesh.points.push_back(whole);
    index.push_back(found->second);
  }
  for (const auto& [a, b, c] : triangles_) mesh.triangles.push_back({index[a], index[b], index[c]});
  return mesh;
}

}  // namespace flatdyn
