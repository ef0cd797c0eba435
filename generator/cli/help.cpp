// SPDX-License-Identifier: GPL-2.0-or-later
#include "cli/help.hpp"

#include "base/diagnostics/wrap.hpp"

namespace flatdyn {
namespace {

constexpr std::size_t kWidth = 120;

}  // namespace

// Wraps a description, whose lines CLI11 puts below each other.
std::string NarrowHelp::make_option_desc(const CLI::Option* option) const {
  return wrapped(CLI::Formatter::make_option_desc(option), kWidth - get_column_width());
}

std::string NarrowHelp::make_help(const CLI::App* app, std::string name, CLI::AppFormatMode mode) const {
  std::string text = CLI::Formatter::make_help(app, std::move(name), mode);
  // CLI11 puts two empty lines between groups of options.
  for (std::size_t gap; (gap = text.find("\n\n\n")) != std::string::npos;) text.erase(gap, 1);
  return wrapped(text, kWidth);
}

}  // namespace flatdyn
