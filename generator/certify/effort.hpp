// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

namespace flatdyn {

// How many ways a search for a small bound goes, at most; it is spent on the way down to the inputs. What more of it
// brings: docs/certificates.md.
inline constexpr int kUsualEffort = 4, kLittleEffort = 1;

}  // namespace flatdyn
