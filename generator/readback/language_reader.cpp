// SPDX-License-Identifier: GPL-2.0-or-later
#include "readback/language_reader.hpp"

#include <stdexcept>

namespace flatdyn {

AnyLanguageReader reader_of(const EmitOptions& options) {
  switch (options.language) {
    case Language::cpp:
      return cpp_reader();
    case Language::c:
      return c_reader(options.scalar);
    case Language::cuda:
      return cuda_reader();
    case Language::javascript:
      return javascript_reader();
  }
  throw std::logic_error("unknown language");
}

}  // namespace flatdyn
