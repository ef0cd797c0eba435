// SPDX-License-Identifier: GPL-2.0-or-later
// The entry point that libFuzzer calls: one of the readers, FLATDYN_FUZZ_TARGET.
#include "fuzz/readers.hpp"

extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size);
extern "C" int LLVMFuzzerTestOneInput(const unsigned char* data, std::size_t size) {
  flatdyn::testing::FLATDYN_FUZZ_TARGET({reinterpret_cast<const char*>(data), size});
  return 0;
}
