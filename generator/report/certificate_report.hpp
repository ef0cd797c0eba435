// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "certify/certificate.hpp"

namespace flatdyn {

// A table per function: output, unit, proven bound, largest error found, their ratio, and for torques the bound as a
// share of the joint's effort limit; then whether the scalar is enough for the share `enough`.
std::string describe_certificate(const Certificate& certificate, double enough);

// The same text with the assumptions it rests on, for the file beside the code. `header` and `hash` identify the text.
std::string certificate_markdown(const Certificate& certificate, double enough, const std::string& header,
                                 const std::string& hash);

nlohmann::ordered_json certificate_json(const Certificate& certificate, const std::string& header,
                                        const std::string& hash);

}  // namespace flatdyn
