// SPDX-License-Identifier: GPL-2.0-or-later
#include "base/system/shared_library.hpp"

#include <dlfcn.h>
#include <fmt/format.h>

#include "base/diagnostics/diagnostics.hpp"
#include "base/system/process.hpp"
#include "base/system/temporary_folder.hpp"

namespace flatdyn {

SharedLibrary::SharedLibrary(const std::filesystem::path& folder, const std::string& stem, const std::string& flags) {
  const std::string command =
      fmt::format("LC_ALL=C {0} {1} -shared -fPIC {2}.cpp -o {2}.so 2> {2}.log", machine_compiler(), flags, stem);
  if (run_command(command, folder) != 0) {
    const std::string messages = content_of_file(folder / (stem + ".log"));
    check_room(folder, messages);
    throw Failure(FailureKind::bug, "emitted code does not compile:\n" + messages);
  }
  handle_ = ::dlopen((folder / (stem + ".so")).c_str(), RTLD_NOW | RTLD_LOCAL);
  if (handle_ == nullptr)
    throw Failure(FailureKind::bug, fmt::format("emitted code cannot be loaded: {}", ::dlerror()));
}

SharedLibrary::~SharedLibrary() {
  if (handle_ != nullptr) ::dlclose(handle_);
}

void* SharedLibrary::symbol(const std::string& name) const {
  void* const found = ::dlsym(handle_, name.c_str());
  if (found == nullptr) throw Failure(FailureKind::bug, "emitted code has no function " + name);
  return found;
}

}  // namespace flatdyn
