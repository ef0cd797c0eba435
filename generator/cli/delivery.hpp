// SPDX-License-Identifier: GPL-2.0-or-later
// Delivery of the files that a run has made: they are written, compared with those on disk, or only listed.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "cli/output_file.hpp"

namespace flatdyn {

struct Delivery {
  bool check = false, dry_run = false;
  std::string depfile;  // for a build tool, in the syntax of make; empty: none

  void add_to(CLI::App& command);
  bool only_prints() const { return check || dry_run; }  // only the printed text is the result

  // Delivers the files, the first of which is the header; an outdated certificate is removed. Returns lines for people.
  // `inputs`: all files that were read. Throws Failure(outdated) if --check finds a difference, and what
  // check_outputs() and write_files() throw.
  std::string deliver(std::vector<TextFile> files, const std::vector<std::string>& inputs) const;
};

// The rule "targets: prerequisites", with characters escaped that are special in make and Ninja.
std::string dependency_rule(const std::vector<std::string>& targets, const std::vector<std::string>& prerequisites);

}  // namespace flatdyn
