// SPDX-License-Identifier: GPL-2.0-or-later
// What becomes of the files that a run has made: written, compared with those that are there, or only named.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "cli/output_file.hpp"

namespace flatdyn {

struct Delivery {
  bool check = false, dry_run = false;
  std::string depfile;  // of a build tool, in the syntax of make; empty: none

  void add_to(CLI::App& command);
  bool is_only_told() const { return check || dry_run; }  // what is printed is the result

  // The first file is the header: a certificate of another one that is there goes away. Returns lines for people.
  // `inputs`: all files that were read. Throws Failure(outdated) if --check finds a
  // difference, and what check_outputs() and write_files() throw.
  std::string deliver(std::vector<TextFile> files, const std::vector<std::string>& inputs) const;
};

// "targets: prerequisites", with what make and Ninja take for something else escaped.
std::string dependency_rule(const std::vector<std::string>& targets, const std::vector<std::string>& prerequisites);

}  // namespace flatdyn
