// SPDX-License-Identifier: GPL-2.0-or-later
// What the tool tells a person about his input: severity, place, message, and what to do.
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

namespace flatdyn {

// A place in an input file. line 0: the whole file; empty file: no file (the command line).
struct Place {
  std::string file;
  int line = 0;

  bool operator==(const Place&) const = default;
};

enum class Severity { note, warning, error };

struct Diagnostic {
  Severity severity = Severity::error;
  Place place;
  std::string message;       // what is wrong, naming the key and the value
  std::string hint;          // what to do; may be empty
  bool unsupported = false;  // an error that is no mistake in the file: the program cannot do it (exit code 4)
  std::string kind = {};     // those of one kind are told together; empty: this one stands by itself
};

// "arm.urdf:12: error: link \"a\": mass is negative (-1)\n    hint: ..."
std::string to_string(const Diagnostic& diagnostic);

// A list of what was found while reading. Readers go on after an error where they can, so that a person
// sees all that is wrong at once; whoever called decides what to do with the list.
class Diagnostics {
 public:
  // kind: a plural that can follow a count, "unknown attributes left out".
  void note(Place place, std::string message, std::string hint = {}, std::string kind = {});
  void warning(Place place, std::string message, std::string hint = {}, std::string kind = {});
  void error(Place place, std::string message, std::string hint = {});
  void unsupported(Place place, std::string message, std::string hint = {});  // an error
  void add(Diagnostic diagnostic);

  const std::vector<Diagnostic>& all() const { return all_; }
  bool has_errors() const;
  bool has_warnings() const;
  // Every error there is, and at least one, is something unsupported.
  bool only_unsupported() const;
  // Every error there is, and at least one, is on the command line and not in a file.
  bool only_on_command_line() const;

 private:
  std::vector<Diagnostic> all_;
};

// Exit codes of the program (documented in docs/exit-codes.md and in --help).
enum class ExitCode : int {
  ok = 0,
  bug = 1,
  usage = 2,
  input = 3,
  unsupported = 4,
  verification_failed = 5,
  io = 6,
  outdated = 7,
  interrupted = 130,  // by Ctrl-C, as shells count it
};

// Something that ends the run with one of the documented exit codes.
class Failure : public std::runtime_error {
 public:
  Failure(ExitCode code, const std::string& message, std::string hint = {})
      : std::runtime_error(message), code_(code), hint_(std::move(hint)) {}
  ExitCode code() const { return code_; }
  const std::string& hint() const { return hint_; }

 private:
  ExitCode code_;
  std::string hint_;
};

}  // namespace flatdyn
