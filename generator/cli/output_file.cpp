// SPDX-License-Identifier: GPL-2.0-or-later
#include "cli/output_file.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>

#include "diagnostics/diagnostics.hpp"

namespace flatdyn {

namespace fs = std::filesystem;

namespace {

fs::path beside(const fs::path& path) {
  return path.parent_path() / fmt::format(".{}.{}", path.filename().string(), ::getpid());
}

[[noreturn]] void fail(const fs::path& path, const std::string& why) {
  throw Failure(ExitCode::io, fmt::format("{}: cannot be written: {}", path.string(), why));
}

void write_beside(const TextFile& file) {
  std::error_code error;
  if (file.path.has_parent_path()) fs::create_directories(file.path.parent_path(), error);
  if (error) fail(file.path, error.message());
  errno = 0;
  std::ofstream stream(beside(file.path), std::ios::binary | std::ios::trunc);
  stream << file.text;
  stream.close();
  if (!stream) fail(file.path, std::strerror(errno));
}

// Removes what is left of files that were not renamed.
class Cleanup {
 public:
  explicit Cleanup(const std::vector<TextFile>& files) : files_(files) {}
  Cleanup(const Cleanup&) = delete;
  Cleanup& operator=(const Cleanup&) = delete;
  ~Cleanup() {
    std::error_code ignored;
    for (const TextFile& file : files_) fs::remove(beside(file.path), ignored);
  }

 private:
  const std::vector<TextFile>& files_;
};

}  // namespace

void write_files(const std::vector<TextFile>& files) {
  const Cleanup cleanup(files);
  for (const TextFile& file : files) write_beside(file);
  for (const TextFile& file : files) {
    std::error_code error;
    fs::rename(beside(file.path), file.path, error);
    if (error) fail(file.path, error.message());
  }
}

}  // namespace flatdyn
