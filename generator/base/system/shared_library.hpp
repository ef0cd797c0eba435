// SPDX-License-Identifier: GPL-2.0-or-later
// C++ text compiled by the machine's compiler and called in this process.
#pragma once

#include <filesystem>
#include <string>

namespace flatdyn {

class SharedLibrary {
 public:
  // Compiles folder/STEM.cpp with $CXX or c++ and loads it. Throws Failure(io) if there is no compiler, Failure(bug) if
  // the text does not compile.
  SharedLibrary(const std::filesystem::path& folder, const std::string& stem, const std::string& flags);
  ~SharedLibrary();
  SharedLibrary(const SharedLibrary&) = delete;
  SharedLibrary& operator=(const SharedLibrary&) = delete;

  // The address of a function that the text declares extern "C". Throws Failure(bug) if there is none.
  void* symbol(const std::string& name) const;

 private:
  void* handle_ = nullptr;
};

}  // namespace flatdyn
