// SPDX-License-Identifier: GPL-2.0-or-later
// The content that files of emitted code must have in addition to the statements of their functions, and its comparison
// with the text: signatures, names, tables, helpers, structs, loops over functions. No token is left over.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "code/emit/emit_options.hpp"
#include "code/readback/emitted_text.hpp"
#include "graph/function.hpp"

namespace flatdyn {

// A table of constants: of texts, of numbers, or of zeros and ones.
struct FileTable {
  std::string type;          // "const char*", "Real", "int", "bool"
  std::string name, length;  // "joint_names", "joint_count"; its length in digits if there is no name for it
  std::vector<std::string> texts{};
  std::vector<double> numbers{};  // infinite where there is no limit
};

struct FileFunction {
  const Function* function = nullptr;
  std::string name;                // "gravity", as it would be without a prefix
  std::vector<FileTable> zeros{};  // which entries of its matrices are not always zero
  std::string made{};              // the stage that it makes: "Motion"
  std::string member_of{};         // the stage that it is a member of
  std::string given{};             // in C: the name of the function that takes its sines and cosines, if there is one
};

// A stage: the function that makes it, and its members.
struct FileStage {
  std::string name;
  FileFunction make;
  std::vector<FileFunction> members;
};

// The functions that close_loops() calls.
struct FileLoops {
  std::string closure, step;
  int rows = 0;  // of the closure
};

struct FileContents {
  Form form = Form::header;
  Sines sines = Sines::polynomials;
  bool is_module = true;                 // in JavaScript: exports names instead of returning them
  std::string file_name;                 // without ending
  std::vector<std::string> name_spaces;  // those that the text may have
  std::string scalar;                    // of constants
  std::vector<std::string> scalars;      // those that the source of a pair is compiled for
  int joints = 0, positions = 0;         // lengths of qd (but for the base's six) and q
  int angles = 0;                        // angles whose sines and cosines there may be
  bool has_positions = false;
  std::vector<FileTable> tables;
  std::optional<int> base_count;  // base parameters, if functions take them
  std::vector<FileTable> base_tables;
  std::vector<std::string> parameters;  // names of the robot's symbols
  std::vector<FileFunction> functions;
  std::vector<FileStage> stages;
  std::optional<FileLoops> closing;
  std::optional<int> velocities;    // the length of v, with a floating base
  std::vector<int> kernel_parts{};  // in CUDA, by function: how many parts it has behind the functions
};

// Compares all of the text but the statements of functions with what it has to hold, and makes sure that
// EmittedText::read() reads those. Throws Failure(bug) with the line of the first difference.
void read_file(const EmittedText& text, const FileContents& contents);

}  // namespace flatdyn
