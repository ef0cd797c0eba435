// SPDX-License-Identifier: GPL-2.0-or-later
#include "cli/replace_files.hpp"

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

// Names beside a file's, hidden and of this process: of what will be in its place, and of what was.
constexpr const char *kNew = "", *kOld = "old.";

std::string prefix_beside(const fs::path& path, const char* kind) {
  return fmt::format(".{}.{}", path.filename().string(), kind);
}
fs::path beside(const fs::path& path, const char* kind) {
  return path.parent_path() / (prefix_beside(path, kind) + std::to_string(::getpid()));
}

// That such a name is of some process.
bool is_beside(const std::string& name, const fs::path& path) {
  const auto is_of = [&](const char* kind) {
    const std::string prefix = prefix_beside(path, kind);
    return name.size() > prefix.size() && name.rfind(prefix, 0) == 0 &&
           name.find_first_not_of("0123456789", prefix.size()) == std::string::npos;
  };
  return is_of(kNew) || is_of(kOld);
}

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
std::vector<std::unique_ptr<FolderLock>> locked(const std::vector<fs::path>& places) {
  std::map<fs::path, fs::path> by_folder;
  for (const fs::path& place : places) {
    std::error_code ignored;
    by_folder.emplace(fs::weakly_canonical(fs::absolute(place), ignored).parent_path(), place);
  }
  std::vector<std::unique_ptr<FolderLock>> locks;
  for (const auto& [folder, file] : by_folder) locks.push_back(std::make_unique<FolderLock>(file));
  return locks;
}

// What runs that were killed have left beside these files. For who holds the folders' locks: no other run is writing.
void remove_remains(const std::vector<fs::path>& places) {
  std::error_code ignored;
  for (const fs::path& place : places) {
    std::vector<fs::path> remains;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder_of(place), ignored)) {
      if (is_beside(entry.path().filename().string(), place)) remains.push_back(entry.path());
    }
    for (const fs::path& path : remains) fs::remove(path, ignored);
  }
}

void rename(const fs::path& from, const fs::path& to, const fs::path& wanted) {
  std::error_code error;
  fs::rename(from, to, error);
  if (error) cannot_write(wanted, error.message());
}

// The change from the last run's files to this one's, which are written beside their places before. At whatever moment
// this run is killed, no file of the one stands beside one of the other: the first is replaced in one step, and the
// others are away while that happens.
class Change {
 public:
  // places: those of the files, then those of outdated ones.
  Change(const std::vector<TextFile>& files, const std::vector<fs::path>& places) : files_(files), places_(places) {}
  Change(const Change&) = delete;
  Change& operator=(const Change&) = delete;
  ~Change() {
    std::error_code ignored;
    if (is_half_) take_back();
    for (const fs::path& place : places_) fs::remove(beside(place, kOld), ignored);
    for (const TextFile& file : files_) fs::remove(beside(file.path, kNew), ignored);
    remove_emptied_folders();
  }

  void write() const {
    for (const TextFile& file : files_) write_text(beside(file.path, kNew), file);
  }

  void make() {
    is_half_ = true;
    for (const fs::path& place : places_) set_aside(place);
    for (const TextFile& file : files_) {
      rename(beside(file.path, kNew), file.path, file.path);
      ++in_place_;
    }
    is_half_ = false;
  }

 private:
  // Of outdated files that were in a folder of their own. One that has files stays.
  void remove_emptied_folders() const {
    std::error_code ignored;
    for (const fs::path& place : places_) {
      const fs::path folder = folder_of(place);
      if (folder != folder_of(files_.front().path)) fs::remove(folder, ignored);
    }
  }

  // Of the first file a second name; where there are no such names, a copy.
  void set_aside(const fs::path& path) const {
    if (!fs::exists(path)) return;
    const fs::path old = beside(path, kOld);
    if (path != files_.front().path) return rename(path, old, path);
    std::error_code error;
    fs::create_hard_link(path, old, error);
    if (error) fs::copy_file(path, old, error);
    if (error) cannot_write(path, error.message());
  }

  void take_back() const {
    std::error_code ignored;
    for (std::size_t k = in_place_; k-- > 0;) {
      if (k > 0 || !fs::exists(beside(files_[k].path, kOld))) fs::remove(files_[k].path, ignored);
    }
    for (const fs::path& place : places_) {
      if (fs::exists(beside(place, kOld))) fs::rename(beside(place, kOld), place, ignored);
    }
  }

  const std::vector<TextFile>& files_;
  const std::vector<fs::path>& places_;
  std::size_t in_place_ = 0;
  bool is_half_ = false;
};

}  // namespace

void cannot_write(const fs::path& path, const std::string& why) {
  throw Failure(ExitCode::io, fmt::format("{}: cannot be written: {}", path.string(), why));
}

void write_text(const fs::path& place, const TextFile& file) {
  errno = 0;
  std::ofstream stream(place, std::ios::binary | std::ios::trunc);
  stream << file.text;
  stream.close();
  if (!stream) cannot_write(file.path, std::strerror(errno));
}

NewFolders::~NewFolders() {
  std::error_code ignored;
  // What is not empty stays.
  for (auto folder = made_.rbegin(); folder != made_.rend(); ++folder) fs::remove(*folder, ignored);
}

void NewFolders::make_for(const fs::path& file) {
  std::vector<fs::path> missing;
  for (fs::path folder = file.parent_path(); !folder.empty() && !fs::exists(folder); folder = folder.parent_path()) {
    missing.push_back(folder);
  }
  made_.insert(made_.end(), missing.rbegin(), missing.rend());
  std::error_code error;
  if (!missing.empty()) fs::create_directories(missing.front(), error);
  if (error) cannot_write(file, error.message());
}

void replace_files(const std::vector<TextFile>& files, const std::vector<fs::path>& outdated) {
  if (files.empty()) return;
  std::vector<fs::path> places;
  for (const TextFile& file : files) places.push_back(file.path);
  places.insert(places.end(), outdated.begin(), outdated.end());
  const std::vector<std::unique_ptr<FolderLock>> locks = locked(places);
  if (std::all_of(locks.begin(), locks.end(), [](const auto& lock) { return lock->is_held(); })) remove_remains(places);
  Change change(files, places);
  change.write();
  change.make();
}

}  // namespace flatdyn
