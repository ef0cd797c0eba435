// SPDX-License-Identifier: GPL-2.0-or-later
// The file of emitted CUDA: a header like that of C++, whose arrays are of any type.
#pragma once

#include "code/languages/cpp/read_file.hpp"

namespace flatdyn {

class CudaFile : public CppFile {
 public:
  CudaFile(const EmittedText& text, const FileContents& contents);

 private:
  // A function as its kernels call it.
  struct Kernel {
    const FileFunction* function = nullptr;
    std::vector<std::string> outputs;  // their names in the text
  };

  void file() override;
  void cuda_helpers();
  void cuda_polynomials();
  void angles_part();
  void cuda_function(const FileFunction& function);
  Kernel parameters_and_body(const FileFunction& function, bool has_sin_cos, const ScannedFunction& body);
  void kernels();
  void kernel(std::size_t k, std::size_t first_part, int parts);
  void places(const Function& function);
  void callee(const FileFunction& function, int part);

  std::vector<Kernel> kernels_;
  bool has_stored_ = false;
};

}  // namespace flatdyn
