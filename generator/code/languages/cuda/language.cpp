// SPDX-License-Identifier: GPL-2.0-or-later
#include "code/languages/cuda/language.hpp"

#include "code/languages/cuda/dialect.hpp"
#include "code/languages/cuda/read.hpp"

namespace flatdyn {

LanguageRow cuda_language() {
  LanguageRow row{.option = "cuda", .name = "CUDA"};
  row.description = "a header of CUDA for many states at once on a graphics processor";
  row.endings = {".cuh"};
  row.has_scalar = row.has_namespace = row.has_fma = true;
  row.has_kernels = row.is_called_by_python = true;
  row.has_parts = false;
  row.dialect = [](const Mechanism&, const EmitOptions&) -> std::unique_ptr<const PageDialect> {
    return std::make_unique<CudaDialect>();
  };
  row.reader = [](const EmitOptions&) { return cuda_reader(); };
  return row;
}

}  // namespace flatdyn
