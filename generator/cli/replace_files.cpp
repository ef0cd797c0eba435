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

#include "base/diagnostics/diagnostics.hpp"

namespace flatdyn {

namespace fs = std::filesystem;

namespace {

fs::path folder_of(const fs::path& file) { return file.has_parent_path() ? file.parent_path() : fs::path("."); }

// Prefixes of hidden names next to a file, which belong to this process: of the new file, and of the previous one.
constexpr const char *kNew = "", *kOld = "old.";

std::string prefix_beside(const fs::path& path, const char* kind) {
  return fmt::format(".{}.{}", path.filename().string(), kind);
}
fs::path beside(const fs::path& path, const char* kind) {
  return path.parent_path() / (prefix_beside(path, kind) + std::to_string(::getpid()));
}

// Whether the name is such a name of any process.
bool is_beside(const std::string& name, const fs::path& path) {
  const auto is_of = [&](const char* kind) {
    const std::string prefix = prefix_beside(path, kind);
    return name.size() > prefix.size() && name.rfind(prefix, 0) == 0 &&
           name.find_first_not_of("0123456789", prefix.size()) == std::string::npos;
  };
  return is_of(kNew) || is_of(kOld);
}

// A lock of a folder: one run at a time writes to it, so that files of different runs are not mixed. File systems
// without locks go without; the kernel releases the lock when a run ends in any way.
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

// Locks all folders, in the same order in every run, so that no two runs wait for each other.
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

// Removes the files that killed runs have left next to these. The caller must hold the folders' locks: no other run is
// writing.
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

// The replacement of the last run's files by this run's, which are first written next to their final places. Whenever
// this run is killed, no file of one run is next to one of the other: the first file is replaced in one step, and the
// others are absent meanwhile.
class Change {
 public:
  // places: those of the files, followed by those of outdated files.
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
  // Removes folders of outdated files if they are empty.
  void remove_emptied_folders() const {
    std::error_code ignored;
    for (const fs::path& place : places_) {
      const fs::path folder = folder_of(place);
      if (folder != folder_of(files_.front().path)) fs::remove(folder, ignored);
    }
  }

  // Gives the previous first file a second name, or copies it on file systems without hard links.
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
  throw Failure(FailureKind::io, fmt::format("{}: cannot be written: {}", path.string(), why),
                "check that its folder exists and may be written to, and that the disk is not full");
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
  // Folders that are not empty stay.
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
