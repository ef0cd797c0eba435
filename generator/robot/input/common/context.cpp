// SPDX-License-Identifier: GPL-2.0-or-later
#include "robot/input/common/context.hpp"

#include <cln/cln.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "base/diagnostics/nearest.hpp"
#include "robot/model/exact_sign.hpp"
#include "robot/model/tendon.hpp"

namespace flatdyn {

namespace {

constexpr std::size_t kLongestNumber = 1000;

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

const Number& smallest_number() {
  static const Number kSmallest = exact_decimal("1e-30");
  return kSmallest;
}

const Number& largest_number() {
  static const Number kLargest = exact_decimal("1e30");
  return kLargest;
}

// Exporters write the rounding errors of their computations.
Number taken_for_zero(const std::string& shown, const Spot& spot, Diagnostics& diagnostics) {
  diagnostics.note(spot.place, spot.what + ": " + shown + " is taken for 0", "numbers below 1e-30 are rounding errors",
                   "numbers below 1e-30 taken for 0");
  return 0;
}

// A decimal with an exponent beyond all that is read: "-2.5e-99999", or with `sign` '+' "1e400".
bool has_exponent_beyond(std::string_view text, char sign) {
  constexpr std::size_t kMostDigits = 100;  // far fewer than that exponent takes away
  const std::size_t e = text.find_first_of("eE");
  if (e > kMostDigits || e + 2 >= text.size()) return false;
  const bool has_sign = text[e + 1] == '-' || text[e + 1] == '+';
  if ((has_sign ? text[e + 1] : '+') != sign) return false;
  const std::string_view digits = text.substr(e + (has_sign ? 2 : 1));
  const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
  if (!std::all_of(digits.begin(), digits.end(), is_digit)) return false;
  try {
    return !vanishes(exact_decimal(text.substr(0, e))) || sign == '-';
  } catch (const std::invalid_argument&) {
    return false;
  }
}

// Whether a decimal that is off by so much is another number rounded, or cut off, to two to four digits: 1.57, 0.785.
bool has_few_digits_of(const GiNaC::numeric& distance, std::string_view written) {
  const std::size_t point = written.find('.');
  if (point == std::string_view::npos || written.find_first_of("eE") != std::string_view::npos) return false;
  const std::size_t first = written.find_first_of("123456789");
  const std::size_t decimals = written.size() - point - 1;
  const std::size_t digits = written.size() - first - (first < point ? 1 : 0);
  return digits >= 2 && digits <= 4 && distance < GiNaC::pow(GiNaC::numeric(10), -static_cast<int>(decimals)) &&
         distance <= GiNaC::numeric(2, 1000);
}

}  // namespace

bool is_held(const std::string& joint, const ReadContext& context) {
  return std::any_of(context.held_joints.begin(), context.held_joints.end(),
                     [&](const JointPosition& held) { return held.joint == joint; });
}

std::string relative_place_text(const Place& here, const Place& place) {
  const std::string line = std::to_string(place.line);
  return place.file == here.file ? "line " + line : place.file + ":" + line;
}

std::optional<int> find_link(const Robot& robot, const Reference& link, const std::string& what,
                             Diagnostics& diagnostics, const std::string& kind) {
  std::vector<std::string> known;
  for (std::size_t i = 0; i < robot.links.size(); ++i) {
    if (is_of_tendon(robot, static_cast<int>(i))) continue;
    if (robot.links[i].name == link.name) return static_cast<int>(i);
    known.push_back(robot.links[i].name);
  }
  diagnostics.error(link.place, what + ": there is no " + kind + " \"" + link.name + "\"",
                    hint_for_unknown(link.name, known, "links"));
  return std::nullopt;
}

bool check_magnitude(const Number& value, const std::string& shown, const Spot& spot, Diagnostics& diagnostics) {
  if (vanishes(value)) return true;
  const Number size = absolute(value);
  if (is_below(largest_number(), size)) {
    diagnostics.error(spot.place, spot.what + ": " + shown + " is too large",
                      "numbers go up to 1e30; check the units (SI)");
    return false;
  }
  if (is_below(size, smallest_number())) {
    diagnostics.error(spot.place, spot.what + ": " + shown + " is too small",
                      "numbers other than 0 go down to 1e-30; write 0 if it is only a rounding error");
    return false;
  }
  return true;
}

bool is_infinite_limit(std::string_view written) {
  if (is_word_for(written, "inf") || is_word_for(written, ".inf")) return true;
  if (written.size() > kLongestNumber) return false;
  try {
    return !is_below(absolute(exact_decimal(written)), largest_number());
  } catch (const std::invalid_argument&) {
    return has_exponent_beyond(written, '+');
  }
}

void check_infinite_limit(std::string_view written, Bound bound, const Spot& spot, Diagnostics& diagnostics) {
  const bool is_negative = written.starts_with('-');
  if (is_negative == (bound == Bound::lower)) return;
  diagnostics.error(
      spot.place, spot.what + ": \"" + std::string(written) + "\" leaves nothing that is allowed",
      std::string("if there is no limit, write ") + (bound == Bound::lower ? "-inf" : "inf") + " or leave it out");
}

bool is_pipe(const std::filesystem::path& path) {
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(path, error);
  return std::filesystem::is_fifo(status) || std::filesystem::is_character_file(status) || path == "/dev/stdin" ||
         path.string().starts_with("/dev/fd/");
}

FileKind kind_of(const std::filesystem::path& path) {
  std::string extension = path.extension().string();
  for (char& c : extension) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c + ('a' - 'A')) : c;
  if (extension == ".urdf" || extension == ".xml" || extension == ".xacro") return FileKind::urdf;
  if (extension == ".sdf" || extension == ".world") return FileKind::sdf;
  return extension == ".toml" ? FileKind::toml : FileKind::unknown;
}

Number canonical_angle(const Number& angle, const Spot& spot, Diagnostics& diagnostics) {
  constexpr int kDigits = 80;
  if (GiNaC::is_a<GiNaC::symbol>(angle)) return angle;
  if (has_symbols(angle)) {
    diagnostics.unsupported(spot.place, spot.what + ": an angle with a symbol in it must be the bare symbol",
                            "give the whole angle a symbol of its own");
    return 0;
  }
  if (is_rational(angle) || is_rational(angle / GiNaC::Pi)) return angle;
  return exact_decimal(to_decimal(angle, kDigits));
}

std::optional<Number> checked_decimal(std::string_view text, const Spot& spot, Diagnostics& diagnostics) {
  constexpr std::size_t kShown = 40;
  const std::string shown = "\"" + std::string(text.substr(0, kShown)) + (text.size() > kShown ? "..." : "") + "\"";
  if (is_word_for(text, "nan") || is_word_for(text, "inf")) {
    diagnostics.error(spot.place, spot.what + ": " + shown + " is not a finite number", "write a finite decimal");
    return std::nullopt;
  }
  if (text.size() > kLongestNumber) {
    diagnostics.error(spot.place, spot.what + ": the number " + shown + " is too long", "write at most 1000 digits");
    return std::nullopt;
  }
  try {
    const Number value = exact_decimal(text);
    if (!vanishes(value) && is_below(absolute(value), smallest_number()))
      return taken_for_zero(shown, spot, diagnostics);
    if (check_magnitude(value, shown, spot, diagnostics)) return value;
  } catch (const std::invalid_argument& error) {
    if (has_exponent_beyond(text, '-')) return taken_for_zero(shown, spot, diagnostics);
    if (std::string_view(error.what()).find("too large") != std::string_view::npos) {
      diagnostics.error(spot.place, spot.what + ": " + shown + ": " + error.what(), "numbers go from 1e-30 to 1e30");
    } else {
      diagnostics.error(spot.place, spot.what + ": " + shown + " is not a number", hint_for_number(text));
    }
  }
  return std::nullopt;
}

Number snapped_angle(const Number& angle, std::string_view written, const Spot& spot, ReadContext& context) {
  constexpr int kDigitsOfPi = 100;  // above the tolerance of any decimal that can be meant for a multiple of pi/12
  constexpr int kDigitsReported = 50;
  if (angle.is_zero() || context.options.snap_tolerance.is_zero()) return angle;
  static const Number kTwelfth = exact_decimal(to_decimal(GiNaC::Pi, kDigitsOfPi)) / 12;
  const GiNaC::numeric multiple = rounded(angle / kTwelfth);
  const Number difference = multiple * kTwelfth - angle;
  const Snap snap{spot.place, spot.what, std::string(written), multiple * GiNaC::Pi / 12,
                  exact_decimal(to_decimal(difference, kDigitsReported))};
  if (magnitude(difference) > magnitude(context.options.snap_tolerance)) {
    if (!multiple.is_zero() && has_few_digits_of(magnitude(difference), written))
      context.rounded_angles.push_back(snap);
    return angle;
  }
  if (context.angles_near++ == context.options.left_unsnapped) return angle;
  context.snaps.push_back(snap);
  return snap.exact;
}

bool check_size(std::uintmax_t size, const std::string& path, Diagnostics& diagnostics) {
  constexpr std::uintmax_t kLargestFile = std::uintmax_t{64} * 1024 * 1024;
  if (size <= kLargestFile) return true;
  diagnostics.error({path, 0}, "the file is larger than 64 MB",
                    "meshes and other data do not belong into a robot file");
  return false;
}

bool check_fetched(std::string_view text, const std::string& path, Diagnostics& diagnostics) {
  if (!text.starts_with(kLfsPointer)) return true;
  diagnostics.error({path, 1}, kIsLfsPointer, kLfsHint);
  return false;
}

std::optional<std::string> file_text(const std::string& path, Diagnostics& diagnostics) {
  std::error_code error;
  if (std::filesystem::is_directory(path, error)) {
    throw Failure(FailureKind::io, path + ": is a folder", "name a robot file (.urdf, .sdf, .xml, .xacro or .toml)");
  }
  std::ifstream stream(path, std::ios::binary);
  if (!stream) throw Failure(FailureKind::io, path + ": cannot be read", "check the path and the permissions");
  const std::uintmax_t size = std::filesystem::file_size(path, error);
  if (!error && !check_size(size, path, diagnostics)) return std::nullopt;
  std::ostringstream text;
  text << stream.rdbuf();
  if (stream.bad()) throw Failure(FailureKind::io, path + ": cannot be read to its end", "check the disk");
  if (!check_fetched(text.view(), path, diagnostics)) return std::nullopt;
  return text.str();
}

}  // namespace flatdyn
