// SPDX-License-Identifier: GPL-2.0-or-later
// The licence of emitted files in full.
#pragma once

#include <string>

namespace flatdyn {

// The BSD-3-Clause licence, whose copyright holder is the user of flatdyn, as lines of comment that begin with //.
std::string licence_comment();

}  // namespace flatdyn
