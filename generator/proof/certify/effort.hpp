// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

namespace flatdyn {

// The largest number of alternatives that the search for a small bound tries; it is divided up on the path down to the
// inputs. docs/certificates.md shows what more effort gains.
inline constexpr int kUsualEffort = 4, kLittleEffort = 1;

}  // namespace flatdyn
