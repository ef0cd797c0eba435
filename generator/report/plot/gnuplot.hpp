// SPDX-License-Identifier: GPL-2.0-or-later
// Colours, texts and the run of gnuplot for all pictures.
#pragma once

#include <filesystem>
#include <functional>
#include <string>

namespace flatdyn {

// A grey that is readable on white and on black.
inline constexpr const char* kPlotInk = "#8a8a8a";
// Colours after Okabe and Ito, which the colour-blind can tell apart; blue and orange have a medium lightness, and
// yellow, which is invisible on white, is left out.
inline constexpr const char* kPlotColours[] = {"#2b83ca", "#d55e00", "#009e73", "#cc79a7",
                                               "#56b4e9", "#c98a00", "#8f7ee0"};

// The text as a string of gnuplot: within single quotes only the quote itself is special.
std::string gnuplot_string(const std::string& text);

// The command "set title 'text' OPTIONS …" in the pictures' ink; `what` is "title", "xlabel" or the like.
std::string gnuplot_label(const std::string& what, const std::string& text, const std::string& options = "");

// The bytes of the picture that a script draws; `script` gets the name of the file to write. Throws Failure(io) if
// there is no gnuplot.
std::string gnuplot_picture(const std::function<std::string(const std::filesystem::path&)>& script);

}  // namespace flatdyn
