// SPDX-License-Identifier: GPL-2.0-or-later
// Everything that reads what others have written, given any bytes at all. What is refused ends in diagnostics or a
// Failure; what is accepted is carried on to where nonsense would hurt. All else is a mistake of the program: each of
// these throws std::logic_error then, or what else was thrown, unless it crashes before.
#pragma once

#include <string_view>

namespace flatdyn::testing {

void read_urdf_bytes(std::string_view bytes);   // as a URDF
void read_toml_bytes(std::string_view bytes);   // as a TOML robot file
void read_scene_bytes(std::string_view bytes);  // as a scene, for a small arm
void read_csv_bytes(std::string_view bytes);    // as a table of states and as a log, for a small arm
void read_text_bytes(std::string_view bytes);   // as an emitted header that is read back

}  // namespace flatdyn::testing
