// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "code/readback/file_contents.hpp"
#include "proof/certify/certificate.hpp"
#include "proof/verify/snap_effect.hpp"
#include "robot/model/robot.hpp"

namespace flatdyn {

// The header that a certificate is about, what it has to hold by the model, and the numbers of its robot file that the
// model has replaced by exact ones: with what they change of torques.
struct CertifiedHeader {
  std::string name, hash;
  FileContents contents;  // angles are 0 where no function asks for their sines
  std::vector<Snap> snaps;
  SnapEffects snap_effects;
};

// A table per function: output, unit, proven bound, largest error found, their ratio, and for torques the bound as a
// share of the joint's effort limit; then whether the scalar is enough for the share `enough`.
std::string describe_certificate(const Certificate& certificate, double enough);

// The same text with the assumptions it rests on, for the file beside the code. `header` and `hash` identify the text.
std::string certificate_markdown(const Certificate& certificate, double enough, const CertifiedHeader& header);

nlohmann::ordered_json certificate_json(const Certificate& certificate, const CertifiedHeader& header);

}  // namespace flatdyn
