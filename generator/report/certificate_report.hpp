// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "certify/certificate.hpp"

namespace flatdyn {

// A table per function: output, unit, proven bound, largest error seen, their ratio, and of torques what part of the
// joint's effort limit the bound is; and whether the scalar is enough for `enough` of it.
std::string describe_certificate(const Certificate& certificate, double enough);

// The same, and what it rests on, for the file that goes with the code. `header` and `hash`: the text it is of.
std::string certificate_markdown(const Certificate& certificate, double enough, const std::string& header,
                                 const std::string& hash);

nlohmann::ordered_json certificate_json(const Certificate& certificate, const std::string& header,
                                        const std::string& hash);

}  // namespace flatdyn
