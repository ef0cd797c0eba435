// SPDX-License-Identifier: GPL-2.0-or-later
// Elements and attributes of an SDF that nothing is read from: left out with a note, or refused where the robot that is
// meant may be another one than is read without them.
#pragma once

#include "robot/input/common/context.hpp"
#include "robot/input/common/unknown_names.hpp"

namespace flatdyn {

class SdfUnknown : public UnknownNames {
 public:
  explicit SdfUnknown(const ReadContext& context);

  // A model whose names have this prefix in messages, "arm::"; models that are nested in it are checked by themselves.
  void check_model(const FileNode& model, const std::string& what, const std::string& prefix, bool is_static);

 private:
  bool goes_into(const FileNode& element, const FileNode& holder) const override;
  std::string name_in(const std::string& holder, const FileNode& element) const override;
  bool refuse_by_format(const FileNode& element, const std::string& what) override;

  const ReadContext& context_;
  std::string prefix_;
  bool is_static_ = false;
};

}  // namespace flatdyn
