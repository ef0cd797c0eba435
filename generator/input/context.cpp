// SPDX-License-Identifier: GPL-2.0-or-later
#include "input/context.hpp"

#include <cln/cln.h>

#include <filesystem>
#include <fstream>
#include <sstream>

namespace flatdyn {

namespace {

bool is_word_for(std::string_view text, std::string_view word) {
  if (!text.empty() && (text[0] == '+' || text[0] == '-')) text.remove_prefix(1);
  if (text.size() < word.size()) return false;
  for (std::size_t i = 0; i < word.size(); ++i) {
    if ((text[i] | 0x20) != word[i]) return false;  // ASCII letters, either case
  }
  return text.size() == word.size() || (word == "inf" && is_word_for(text, "infinity"));
}

// "" for what exact_decimal() takes.
std::string hint_for_number(std::string_view text) {
  if (text.find("${") != std::string_view::npos) return "this is a xacro template: expand it first (xacro FILE)";
  if (text.find(',') != std::string_view::npos) return "write a decimal point, not a comma";
  return "write a decimal number such as -0.25 or 1.5e-3";
}

GiNaC::numeric rounded(const Number& rational) {
  const GiNaC::numeric half = GiNaC::ex_to<GiNaC::numeric>(rational) + GiNaC::numeric(1, 2);
  return GiNaC::numeric(cln::floor1(cln::the<cln::cl_R>(half.to_cl_N())));
}

}  // namespace

Number largest_number() { return exact_decimal("1e30"); }

std::optional<Number> checked_decimal(std::string_view text, const Spot& spot, Diagnostics& diagnostics) {
  constexpr std::size_t kLongest = 1000;
  constexpr std::size_t kShown = 40;
  const std::string shown = "\"" + std::string(text.substr(0, kShown)) + (text.size() > kShown ? "..." : "") + "\"";
  if (is_word_for(text, "nan") || is_word_for(text, "inf")) {
    diagnostics.error(spot.place, spot.what + ": " + shown + " is not a finite number", "write a finite decimal");
    return std::nullopt;
  }
  if (text.size() > kLongest) {
    diagnostics.error(spot.place, spot.what + ": the number " + shown + " is too long", "write at most 1000 digits");
    return std::nullopt;
  }
  try {
    const Number value = exact_decimal(text);
    if (GiNaC::abs(GiNaC::ex_to<GiNaC::numeric>(value)) <= GiNaC::ex_to<GiNaC::numeric>(largest_number())) return value;
    diagnostics.error(spot.place, spot.what + ": " + shown + " is too large",
                      "numbers go up to 1e30; check the units (SI)");
  } catch (const std::invalid_argument& error) {
    if (std::string_view(error.what()).find("too large") != std::string_view::npos) {
      diagnostics.error(spot.place, spot.what + ": " + shown + ": " + error.what(), "numbers go up to 1e30");
    } else {
      diagnostics.error(spot.place, spot.what + ": " + shown + " is not a number", hint_for_number(text));
    }
  }
  return std::nullopt;
}

Number snapped_angle(const Number& angle, std::string_view written, const Spot& spot, ReadContext& context) {
  constexpr int kDigitsOfPi = 100;  // above the tolerance of any decimal that can be meant for a multiple of pi/12
  constexpr int kDigitsReported = 50;
  if (angle.is_zero()) return angle;
  static const Number kTwelfth = exact_decimal(to_decimal(GiNaC::Pi, kDigitsOfPi)) / 12;
  const GiNaC::numeric multiple = rounded(angle / kTwelfth);
  const Number difference = multiple * kTwelfth - angle;
  const Number distance = GiNaC::abs(difference);
  if (GiNaC::ex_to<GiNaC::numeric>(distance) > GiNaC::ex_to<GiNaC::numeric>(context.options.snap_tolerance))
    return angle;
  if (context.options.snap_tolerance.is_zero()) return angle;
  if (context.angles_near++ == context.options.left_unsnapped) return angle;
  const Number exact = multiple * GiNaC::Pi / 12;
  context.snaps.push_back(
      {spot.place, spot.what, std::string(written), exact, exact_decimal(to_decimal(difference, kDigitsReported))});
  return exact;
}

std::optional<std::string> file_text(const std::string& path, Diagnostics& diagnostics) {
  constexpr std::uintmax_t kLargestFile = std::uintmax_t{64} * 1024 * 1024;
  std::error_code error;
  if (std::filesystem::is_directory(path, error)) {
    throw Failure(ExitCode::io, path + ": is a folder", "name a robot file (.urdf or .toml)");
  }
  std::ifstream stream(path, std::ios::binary);
  if (!stream) throw Failure(ExitCode::io, path + ": cannot be read", "check the path and the permissions");
  const std::uintmax_t size = std::filesystem::file_size(path, error);
  if (!error && size > kLargestFile) {
    diagnostics.error({path, 0}, "the file is larger than 64 MB",
                      "meshes and other data do not belong into a robot file");
    return std::nullopt;
  }
  std::ostringstream text;
  text << stream.rdbuf();
  if (stream.bad()) throw Failure(ExitCode::io, path + ": cannot be read");
  return text.str();
}

}  // namespace flatdyn
