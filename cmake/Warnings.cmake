# SPDX-License-Identifier: GPL-2.0-or-later
# flatdyn_warnings: the compiler flags of every target of this project. Warnings are errors.
add_library(flatdyn_warnings INTERFACE)
target_compile_options(flatdyn_warnings INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Werror
  # g++ 12 reports `"x" + std::string` as overlapping or overlong copies when it inlines (GCC bugs 105651, 105329).
  $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict -Wno-stringop-overflow -Wno-stringop-overread -Wno-array-bounds>)
