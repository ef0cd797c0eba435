// SPDX-License-Identifier: GPL-2.0-or-later
// All readers of foreign files, given arbitrary bytes. Refused input ends in diagnostics or a Failure; accepted input
// is carried on to the places where nonsense would hurt. Anything else is a bug of the program: each of these functions
// then throws std::logic_error, or passes on what was thrown, unless it crashes before.
#pragma once

#include <string_view>

namespace flatdyn::testing {

void read_urdf_bytes(std::string_view bytes);   // as a URDF
void read_mjcf_bytes(std::string_view bytes);   // as an MJCF
void read_sdf_bytes(std::string_view bytes);    // as an SDF
void read_toml_bytes(std::string_view bytes);   // as a TOML robot file
void read_scene_bytes(std::string_view bytes);  // as a scene, for a small arm
void read_csv_bytes(std::string_view bytes);    // as a table of states and as a log, for a small arm
void read_text_bytes(std::string_view bytes);   // as an emitted header that is read back

}  // namespace flatdyn::testing
