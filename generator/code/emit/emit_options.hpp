// SPDX-License-Identifier: GPL-2.0-or-later
// The options of emitted code.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "derivation/parameters/parameter_frames.hpp"

namespace flatdyn {

// The form of C++: all in one header, or declarations in a header and definitions in a source that is compiled once.
enum class Form { header, pair };

// Where emitted code has its sines and cosines from, unless they are given: from polynomials of its own, or from the
// language's library.
enum class Sines { polynomials, library };

struct EmitOptions {
  std::string name_space;         // empty: from the robot's name
  std::string scalar = "double";  // default of the template parameter: "double" or "float"
  std::string options_stamp;      // the options that affect the output, for the stamp
  std::string input_hash;         // hash of the robot file's content (and of files that it includes)
  std::string scene_stamp;        // the content of the scene file
  std::string scene_facts;        // sentences about what a scene has fixed
  int most_lines = 0;             // limit of lines per function; 0: only that of compilers
  std::string language = "c++";   // the value of --language, a row of code/languages/language_table.hpp
  std::string file_name{};        // name of header and source without extension; empty: the robot's name
  Form form = Form::header;
  Sines sines = Sines::polynomials;
  bool fuses = false;                              // whether products and sums are fused multiply-adds, in C++ and C
  ParameterFrames frames = ParameterFrames::file;  // those to which the names of base parameters' parts refer
  std::vector<std::string> more_scalars{};         // other scalars that the source of a pair is compiled for, too
  bool limbs_in_lanes = false;                     // whether limbs alike are computed together, in C++
  // In CUDA, by function: how many parts of it, in order, are behind the functions. Empty if there are no parts.
  std::vector<int> kernel_parts{};
  bool is_kernel_part(std::size_t function) const { return !kernel_parts.empty() && function >= kernel_parts.size(); }
};

}  // namespace flatdyn
