// SPDX-License-Identifier: GPL-2.0-or-later
// The state that the readers share while one robot is read: the options, the list of findings, symbols, snapped angles.
#pragma once

#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "base/diagnostics/diagnostics.hpp"
#include "robot/input/common/read_options.hpp"
#include "robot/input/common/sources.hpp"
#include "robot/input/common/symbol_table.hpp"
#include "robot/model/robot.hpp"

namespace flatdyn {

// The meaning of a number in messages, and its place: `joint "shoulder", origin rpy`.
struct Spot {
  Place place;
  std::string what;
};

// The units of a file's angles and lengths.
struct Units {
  bool degrees = false;
  bool millimetres = false;
  bool has_keys = false;  // a file of this kind says so by `angles` and `lengths`
};

// In the units of the file that holds it.
struct HeldJoint : JointPosition {
  Units units = {};
};

// A length that is perhaps in millimetres (robot/input/common/units.hpp).
struct LongLength {
  Number metres;
  Spot spot;
  bool has_key = false;  // its file may say lengths = "mm"
};

struct ReadContext;
using FormatReader = void (*)(const std::string& text, const std::string& file, ReadContext& context, Robot& robot);

struct ReadContext {
  const ReadOptions& options;
  Diagnostics& diagnostics;
  SymbolTable symbols;
  std::vector<Snap> snaps;
  std::size_t angles_near = 0;         // to a multiple of pi/12, so far
  std::vector<HeldJoint> held_joints;  // that options, scene or robot file want held; of two for one joint the first
  std::set<std::string> rotor_joints;  // whose armature is gear_ratio^2 rotor_inertia of a URDF
  std::vector<LongLength> long_lengths = {};
  std::vector<Snap> rounded_angles = {};  // multiples of pi/12 to a few digits
  bool model_was_chosen = false;          // among those of an SDF
  bool mjcf_was_read = false;
  FormatReader (*reader_of)(FileKind) = nullptr;  // of every format but TOML, whose files may stand over one
};

bool is_held(const std::string& joint, const ReadContext& context);

// "line 3", or "arm.urdf:3" where the place is in another file than the message is about.
std::string relative_place_text(const Place& here, const Place& place);

// Index of the link of this name, or nullopt and a diagnostic; `what` says who refers to it, and `kind` what it is to
// it, such as "parent link".
std::optional<int> find_link(const Robot& robot, const Reference& link, const std::string& what,
                             Diagnostics& diagnostics, const std::string& kind = "link");

// The number of a decimal as written. nullopt and a diagnostic if it is not a number, not finite, too long, or out of
// range.
std::optional<Number> checked_decimal(std::string_view text, const Spot& spot, Diagnostics& diagnostics);

// A decimal angle: the exact multiple of pi/12 if it is within the tolerance of one, which is then recorded, else
// the decimal as it is; recorded, too, if it is such a multiple to a few digits. `written` is the text that `angle` was
// read from.
Number snapped_angle(const Number& angle, std::string_view written, const Spot& spot, ReadContext& context);

// The number that an expression stands for, if it may be an angle: a multiple of Pi by a rational, a rational, or a
// symbol. Other numbers (sqrt(2), pi/2 - 0.1) become a rational that is equal to many more digits than are kept of a
// rotation.
Number canonical_angle(const Number& angle, const Spot& spot, Diagnostics& diagnostics);

// True if the number is 0 or of a magnitude from 1e-30 to 1e30: products and squares of such numbers stay within
// double. Else a diagnostic. No symbols may be in it.
bool check_magnitude(const Number& value, const std::string& shown, const Spot& spot, Diagnostics& diagnostics);

// Which limit a number is. An infinite one means none, but only where that is what it bounds.
enum class Bound { lower, upper, magnitude };
// inf, infinity or .inf with a sign, or a decimal from 1e30, which is beyond all numbers that are read: programs write
// the largest float or double where there is no limit, as 1.79769e+308 or 3.40282e+38, or 1e308.
bool is_infinite_limit(std::string_view written);
void check_infinite_limit(std::string_view written, Bound bound, const Spot& spot, Diagnostics& diagnostics);

// /dev/stdin, <(...) of a shell: what is there can be read only once, and the name says nothing about it.
bool is_pipe(const std::filesystem::path& path);

FileKind kind_of(const std::filesystem::path& path);  // by its extension; .xacro is a URDF, .xml any XML

// False, and a diagnostic, if a file is larger than 64 MB.
bool check_size(std::uintmax_t size, const std::string& path, Diagnostics& diagnostics);

// The text that Git LFS leaves where it has not fetched a file. Its first line has no blanks before it.
inline constexpr std::string_view kLfsPointer = "version https://git-lfs.github.com/spec/";
inline constexpr const char *kIsLfsPointer = "this is a pointer of Git LFS, not the file itself",
                            *kLfsHint = "fetch the file: git lfs pull";

// False, and a diagnostic, if it is such a pointer.
bool check_fetched(std::string_view text, const std::string& path, Diagnostics& diagnostics);

// The text of a file. Throws Failure(io) if it cannot be read; nullopt and a diagnostic if it is larger than 64 MB, or
// a pointer of Git LFS.
std::optional<std::string> file_text(const std::string& path, Diagnostics& diagnostics);

}  // namespace flatdyn
