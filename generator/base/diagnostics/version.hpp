// SPDX-License-Identifier: GPL-2.0-or-later
// The program's version, in a file of its own: a new version compiles one file again.
#pragma once

namespace flatdyn {

extern const char* const kProgramVersion;  // "1.2.3", of CMakeLists.txt

}  // namespace flatdyn
