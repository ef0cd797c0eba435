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
  bool unsupported = false;  // an error of the program's abilities, not of the file
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

// The reasons for which a run ends early. The program makes an exit code of each (cli/exit_codes.hpp).
enum class FailureKind {
  bug,                  // of the program
  usage,                // of what was asked for
  input,                // an error in a file
  unsupported,          // a file that is right, and that the program cannot do
  verification_failed,  // code that is not what it has to be
  io,                   // files that cannot be read or written, programs that cannot be run
  outdated,             // files that are not what would be written
  interrupted,          // by the user
};

// An exception that ends the run.
class Failure : public std::runtime_error {
 public:
  Failure(FailureKind kind, const std::string& message, std::string hint = {})
      : std::runtime_error(message), kind_(kind), hint_(std::move(hint)) {}
  FailureKind kind() const { return kind_; }
  const std::string& hint() const { return hint_; }

 private:
  FailureKind kind_;
  std::string hint_;
};

}  // namespace flatdyn
