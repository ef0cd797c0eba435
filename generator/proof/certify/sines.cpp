// SPDX-License-Identifier: GPL-2.0-or-later
#include "proof/certify/sines.hpp"

#include "templates.hpp"

namespace flatdyn {

std::vector<GappaScript> scripts_of_sines(const std::string& scalar) {
  if (scalar == "float") {
    return {{"sines.reduction.g", templates::gappa_reduction_of_floats_g},
            {"sines.sine.g", templates::gappa_sine_of_floats_g},
            {"sines.cosine.g", templates::gappa_cosine_of_floats_g},
            {"sines.cosine_near_1.g", templates::gappa_cosine_near_1_of_floats_g}};
  }
  return {{"sines.reduction.g", templates::gappa_reduction_of_doubles_g},
          {"sines.sine.g", templates::gappa_sine_of_doubles_g},
          {"sines.cosine.g", templates::gappa_cosine_of_doubles_g},
          {"sines.cosine_near_1.g", templates::gappa_cosine_near_1_of_doubles_g}};
}

}  // namespace flatdyn
