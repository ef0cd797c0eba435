// SPDX-License-Identifier: GPL-2.0-or-later
// CUDA: the text of C++ as functions for graphics processors and their hosts. Arrays are of any type that an index
// reads or writes, so that a kernel can keep many states side by side. A struct per function says the shapes of its
// arguments, where its entries are if zeros and equal entries are left out, and into which parts its kernels divide it.
#pragma once

#include <string>
#include <vector>

#include "code/languages/cpp/dialect.hpp"

namespace flatdyn {

class CudaDialect : public CppDialect {
 public:
  std::vector<std::string> reserved() const override;
  std::string input(const std::string& name, std::size_t) const override { return "In " + name; }
  std::string part_begin(const std::string& name) const override { return "FLATDYN_FUNCTION void " + name + "("; }
  std::string before_part() const override { return "template <class Scalar, class In>\n"; }
  void declare(FunctionText& text, const UndeclaredFunction& function) const override;
  // Functions stay whole: a call within a kernel would put its arrays into memory.
  LanguageTraits traits() const override;
  std::string written_entry(const std::string& output, int entry) const override;

  bool has_known_answer() const override { return false; }
  std::vector<FileTemplate> files() const override;
  void write_function(kainjow::mustache::data& item, const Function& function, const FunctionText& text) const override;
  void write_page(kainjow::mustache::data& page, const CodeContent& content) const override;
};

}  // namespace flatdyn
