// SPDX-License-Identifier: GPL-2.0-or-later
#include "cli/output_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <map>
#include <memory>

#include "diagnostics/diagnostics.hpp"

namespace flatdyn {

namespace fs = std::filesystem;

namespace {

fs::path folder_of(const fs::path& file) { return file.has_parent_path() ? file.parent_path() : fs::path("."); }

// Where a file is written before it is renamed: hidden, and of this process.
std::string prefix_beside(const fs::path& path) { return fmt::format(".{}.", path.filename().string()); }
fs::path beside(const fs::path& path) {
  return path.parent_path() / (prefix_beside(path) + std::to_string(::getpid()));
}

// That such a name is of some process.
bool is_beside(const std::string& name, const fs::path& path) {
  const std::string prefix = prefix_beside(path);
  return name.size() > prefix.size() && name.rfind(prefix, 0) == 0 &&
         name.find_first_not_of("0123456789", prefix.size()) == std::string::npos;
}

[[noreturn]] void fail(const fs::path& path, const std::string& why) {
  throw Failure(ExitCode::io, fmt::format("{}: cannot be written: {}", path.string(), why));
}

void write_text(const fs::path& path, const TextFile& file) {
  errno = 0;
  std::ofstream stream(path, std::ios::binary | std::ios::trunc);
  stream << file.text;
  stream.close();
  if (!stream) fail(file.path, std::strerror(errno));
}

// A device or a pipe is written to; only a file is replaced.
bool is_replaced(const fs::path& path) {
  std::error_code ignored;
  const fs::file_status status = fs::status(path, ignored);
  return !fs::exists(status) || fs::is_regular_file(status);
}

// Also under two names. What is no file, such as /dev/null, loses nothing.
bool is_one_file(const fs::path& a, const fs::path& b) {
  if (!is_replaced(a) || !is_replaced(b)) return false;
  std::error_code error;
  if (fs::equivalent(a, b, error)) return true;
  const fs::path first = fs::weakly_canonical(fs::absolute(a), error);
  return !error && first == fs::weakly_canonical(fs::absolute(b), error) && !error;
}

// What a link leads to is replaced, not the link.
TextFile followed(const TextFile& file) {
  if (!fs::is_symlink(fs::symlink_status(file.path)) || !is_replaced(file.path)) return file;
  return {fs::weakly_canonical(file.path), file.text};
}

// Before anything is written: what rename() would find out too late, or not at all.
void check_writable(const TextFile& file) {
  std::error_code error;
  if (file.path.has_parent_path()) fs::create_directories(file.path.parent_path(), error);
  if (error) fail(file.path, error.message());
  if (fs::is_directory(file.path)) fail(file.path, std::strerror(EISDIR));
  if (fs::exists(file.path) && ::access(file.path.c_str(), W_OK) != 0) fail(file.path, std::strerror(errno));
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

// One run at a time writes to a folder: files that belong together are not mixed with another run's. A file system
// that knows no locks goes without; the kernel lets go of a lock when a run ends, however it ends.
class FolderLock {
 public:
  explicit FolderLock(const fs::path& file) {
    descriptor_ = ::open(folder_of(file).c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (descriptor_ < 0) return;
    int outcome = 0;
    do outcome = ::flock(descriptor_, LOCK_EX);
    while (outcome != 0 && errno == EINTR);
    is_held_ = outcome == 0;
  }
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;
  ~FolderLock() {
    if (descriptor_ >= 0) ::close(descriptor_);
  }
  bool is_held() const { return is_held_; }

 private:
  int descriptor_ = -1;
  bool is_held_ = false;
};

// The folders' locks, in one order for all runs, so that none waits for another that waits for it.
std::vector<std::unique_ptr<FolderLock>> locked(const std::vector<TextFile>& files) {
  std::map<fs::path, fs::path> by_folder;
  for (const TextFile& file : files) {
    std::error_code ignored;
    by_folder.emplace(fs::weakly_canonical(fs::absolute(file.path), ignored).parent_path(), file.path);
  }
  std::vector<std::unique_ptr<FolderLock>> locks;
  for (const auto& [folder, file] : by_folder) locks.push_back(std::make_unique<FolderLock>(file));
  return locks;
}

// What runs that were killed have left beside these files. For who holds the folders' locks: no other run is writing.
void remove_remains(const std::vector<TextFile>& files) {
  std::error_code ignored;
  for (const TextFile& file : files) {
    std::vector<fs::path> remains;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder_of(file.path), ignored)) {
      if (is_beside(entry.path().filename().string(), file.path)) remains.push_back(entry.path());
    }
    for (const fs::path& path : remains) fs::remove(path, ignored);
  }
}

void rename_into_place(const fs::path& path) {
  std::error_code error;
  fs::rename(beside(path), path, error);
  if (error) fail(path, error.message());
}

void remove_old(const fs::path& path) {
  std::error_code error;
  fs::remove(path, error);
  if (error) fail(path, error.message());
}

// At whatever moment this run is killed, no file of the last run stands beside one of this: the first file is replaced
// in one step, and the others are away while that happens.
void put_into_place(const std::vector<fs::path>& paths) {
  if (paths.empty()) return;
  for (auto path = paths.begin() + 1; path != paths.end(); ++path) remove_old(*path);
  for (const fs::path& path : paths) rename_into_place(path);
}

}  // namespace

void check_outputs(const std::vector<std::string>& outputs, const std::vector<std::string>& inputs) {
  for (auto output = outputs.begin(); output != outputs.end(); ++output) {
    if (output->empty()) continue;
    for (const std::string& input : inputs) {
      if (!is_one_file(*output, input)) continue;
      throw Failure(ExitCode::usage, fmt::format("{}: the output would replace the input {}", *output, input),
                    "write to another file");
    }
    for (auto other = outputs.begin(); other != output; ++other) {
      if (other->empty() || !is_one_file(*output, *other)) continue;
      throw Failure(ExitCode::usage, fmt::format("{}: two outputs would go to this file", *output),
                    "give each a file of its own");
    }
  }
}

void write_files(const std::vector<TextFile>& wanted) {
  std::vector<TextFile> files, streams;
  for (const TextFile& file : wanted) (is_replaced(file.path) ? files : streams).push_back(followed(file));
  for (const TextFile& file : wanted) check_writable(followed(file));
  const std::vector<std::unique_ptr<FolderLock>> locks = locked(files);
  if (std::all_of(locks.begin(), locks.end(), [](const auto& lock) { return lock->is_held(); })) remove_remains(files);
  const Cleanup cleanup(files);
  std::vector<fs::path> paths;
  for (const TextFile& file : files) {
    write_text(beside(file.path), file);
    paths.push_back(file.path);
  }
  put_into_place(paths);
  for (const TextFile& file : streams) write_text(file.path, file);
}

void write_and_tell(const std::vector<TextFile>& files, const Told& told, bool as_json) {
  write_files(files);
  if (as_json) {
    nlohmann::ordered_json json = told.json;
    for (const TextFile& file : files) json["files"].push_back(file.path.string());
    fmt::print("{}\n", json.dump(2));
    return;
  }
  fmt::print("{}", told.text);
  for (const TextFile& file : files) fmt::print("wrote {}\n", file.path.string());
}

}  // namespace flatdyn
