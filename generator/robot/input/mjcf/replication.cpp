// SPDX-License-Identifier: GPL-2.0-or-later
#include "robot/input/mjcf/replication.hpp"

#include <charconv>

#include "robot/input/mjcf/renaming.hpp"

namespace flatdyn {

namespace {

constexpr std::size_t kMostElements = 10000;

std::size_t element_count(const FileNode& element) {
  std::size_t count = 1;
  for (const FileNode& child : element.children) count += element_count(child);
  return count;
}

class Replicator {
 public:
  Replicator(FileNode& replicate, FileNode& root, Diagnostics& diagnostics)
      : replicate_(replicate), root_(root), diagnostics_(diagnostics) {}

  void apply(std::size_t& elements) {
    const std::optional<std::size_t> count = this->count();
    if (!count || refuse_direct_children() || refuse_many(*count, elements)) return replicate_.children.clear();
    MjcfNames names = mjcf_names_in(replicate_);
    for (const char* section : {"tendon", "equality", "actuator"}) {
      for (FileNode& holder : root_.children) {
        if (holder.name == section) copy_references(holder, names, *count);
      }
    }
    copy_children(*count);
  }

 private:
  std::optional<std::size_t> count() {
    const FileAttribute* written = replicate_.attribute("count");
    const std::string text = written == nullptr ? "" : written->text;
    std::size_t count = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), count);
    if (error == std::errc() && end == text.data() + text.size() && count > 0) return count;
    diagnostics_.error(written == nullptr ? replicate_.place : written->place,
                       written == nullptr ? "<replicate> has no count"
                                          : "<replicate>, count: \"" + text + "\" is not a number of copies",
                       "write count=\"...\", 1 or more");
    return std::nullopt;
  }

  bool refuse_direct_children() {
    for (const FileNode& child : replicate_.children) {
      if (child.name != "joint" && child.name != "freejoint" && child.name != "inertial") continue;
      diagnostics_.error(child.place, "a <replicate> has a <" + child.name + "> of its own",
                         "write it in a <body> in the <replicate>");
      return true;
    }
    return false;
  }

  bool refuse_many(std::size_t count, std::size_t& elements) {
    const std::size_t size = element_count(replicate_);
    if (count <= kMostElements / size && elements + count * size <= kMostElements) {
      elements += count * size;
      return false;
    }
    diagnostics_.unsupported(replicate_.place, "<replicate>: more than 10000 elements are not supported",
                             "write a smaller count");
    return true;
  }

  std::string suffix(std::size_t copy, std::size_t count) const {
    const std::string number = std::to_string(copy);
    return replicate_.value("sep") + std::string(std::to_string(count).size() - number.size(), '0') + number;
  }

  FileNode renamed(FileNode element, std::size_t copy, std::size_t count, bool references) const {
    const std::string end = suffix(copy, count);
    rename_mjcf(
        element, [&end](const std::string& name) { return name.empty() ? name : name + end; }, references);
    return element;
  }

  // Instead of what acts on the replicated elements, a copy that acts on each of theirs. Names of tendons are added.
  void copy_references(FileNode& section, MjcfNames& names, std::size_t count) {
    std::vector<FileNode> children;
    for (const FileNode& child : section.children) {
      const MjcfReferences found = mjcf_references(child, names);
      if (found.inside > 0 && found.outside > 0) {
        diagnostics_.error(
            child.place,
            section.name + ", " + name_in_messages(child) + " acts on what is replicated and on what is not",
            "let it act on elements of one <replicate>, or on none");
        continue;
      }
      if (found.inside == 0) {
        children.push_back(child);
        continue;
      }
      if (section.name == "tendon" && !child.value("name").empty()) names["tendon"].insert(child.value("name"));
      for (std::size_t copy = 0; copy < count; ++copy) children.push_back(renamed(child, copy, count, true));
    }
    section.children = children;
  }

  void copy_children(std::size_t count) {
    FileNode original{"copy", {}, {}, replicate_.place};
    original.children.swap(replicate_.children);
    for (std::size_t copy = 0; copy < count; ++copy)
      replicate_.children.push_back(renamed(original, copy, count, false));
  }

  FileNode& replicate_;
  FileNode& root_;
  Diagnostics& diagnostics_;
};

}  // namespace

void replicate_mjcf(FileNode& replicate, FileNode& root, Diagnostics& diagnostics, std::size_t& elements) {
  Replicator(replicate, root, diagnostics).apply(elements);
}

}  // namespace flatdyn
