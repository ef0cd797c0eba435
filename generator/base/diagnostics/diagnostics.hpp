// SPDX-License-Identifier: GPL-2.0-or-later
// Messages about the user's input: severity, place, message, and a hint.
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
const char* name_of(Severity severity);

struct Diagnostic {
  Severity severity = Severity::error;
  Place place;
  std::string message;       // the problem, with the key and the value
  std::string hint;          // a remedy; may be empty
  bool unsupported = false;  // an error of the program's abilities, not of the file (exit code 4)
  std::string kind = {};     // messages of one kind are printed together; empty: printed on its own
};

// The message as text: "arm.urdf:12: error: link \"a\": mass is negative (-1)
//     hint: ..."
std::string to_string(const Diagnostic& diagnostic);

// The messages collected while reading. Readers continue after an error where they can, so that a person sees all
// errors at once; the caller decides about the messages.
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
  // Whether there are errors and all of them are something unsupported.
  bool only_unsupported() const;
  // Whether there are errors and all of them are on the command line and not in a file.
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

// An exception that ends the run with one of the documented exit codes.
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
