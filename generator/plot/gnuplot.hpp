// SPDX-License-Identifier: GPL-2.0-or-later
// What all pictures share: colours, texts, and the run of gnuplot.
#pragma once

#include <filesystem>
#include <functional>
#include <string>

namespace flatdyn {

// Readable on white and on black alike.
inline constexpr const char* kPlotInk = "#8a8a8a";
// After Okabe and Ito, distinct to the colour-blind; blue and orange moved to a middle lightness, their yellow, which
// white swallows, left out.
inline constexpr const char* kPlotColours[] = {"#2b83ca", "#d55e00", "#009e73", "#cc79a7",
                                               "#56b4e9", "#c98a00", "#8f7ee0"};

// A text of gnuplot: within single quotes only the quote itself is special.
std::string gnuplot_string(const std::string& text);

// "set title 'text' OPTIONS …", as written, in the pictures' ink.
std::string gnuplot_label(const std::string& what, const std::string& text, const std::string& options = "");

// The bytes of the picture that a script draws; `script` is given the file that it has to write. Throws Failure(io)
// where there is no gnuplot.
std::string gnuplot_picture(const std::function<std::string(const std::filesystem::path&)>& script);

}  // namespace flatdyn
