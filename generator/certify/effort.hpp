// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

namespace flatdyn {

// How many ways a search for a small bound goes, at most; it is spent on the way down to the inputs. Against 16, bounds
// of torques are 2 % larger with 4, in two fifths of the time, and 8 % at most with 1, in an eighth
// (docs/certificates.md).
inline constexpr int kUsualEffort = 4, kLittleEffort = 1;

}  // namespace flatdyn
