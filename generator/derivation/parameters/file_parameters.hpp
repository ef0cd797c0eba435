// SPDX-License-Identifier: GPL-2.0-or-later
// The dynamic parameters of a robot as its file has them: ten of every written link in the link's own frame, in which
// the canonical ones, π, are linear.
#pragma once

#include <string>
#include <vector>

#include "derivation/parameters/base_parameters.hpp"
#include "derivation/parameters/parameter_frames.hpp"

namespace flatdyn {

// A parameter of a written link, about the origin and along the axes of the link's frame in the file, with the rotors
// that the link carries held still; or I_m, F_v or F_s of a joint.
struct FileParameter {
  int index = 0;     // index in π of the parameter of this kind of the body that the link moves with
  std::string name;  // "m(forearm)", "mlx(forearm)", "Ixy(forearm)", "Im(elbow)", "Fv(elbow)", "Fs(elbow)"
  Number value;
  ParameterForm in_canonical;  // what a unit of it adds to π
};

// The links of body i that have parameters: the one that its joint moves, then those fixed to it that have mass or
// carry rotors, in file order.
std::vector<const WrittenLink*> links_of(const Mechanism& mechanism, int i);

// The parameters of `set` body by body, first those of its links, then those of its joint. Where they are the canonical
// ones, they have the same names as these.
std::vector<FileParameter> file_parameters(const Mechanism& mechanism, ParameterSet set);

// Whether the file's parameters are the canonical ones: the frame of every moving link is the canonical one, and
// nothing is fixed to it that has mass or carries rotors.
bool has_canonical_links(const Mechanism& mechanism);

// Whether parameters in these frames have names of their own, by links and joints of the file: "m(forearm)", not "m3".
bool has_names_of_file(const Mechanism& mechanism, ParameterFrames frames);

// A linear form in π as one in the file's parameters, by index in `parameters`.
ParameterForm in_file_parameters(const ParameterForm& form, const std::vector<FileParameter>& parameters);

}  // namespace flatdyn
