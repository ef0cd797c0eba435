// SPDX-License-Identifier: GPL-2.0-or-later
#include "robot/input/mjcf/mesh_file.hpp"

#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <sstream>

#include "robot/input/common/words.hpp"

namespace flatdyn {

namespace {

constexpr std::size_t kHeader = 80, kTriangle = 50;  // of a binary STL, bytes

using Corners = std::vector<std::size_t>;

template <typename T>
T value_at(const std::string& bytes, std::size_t offset) {
  T value;
  std::memcpy(&value, bytes.data() + offset, sizeof(T));
  return value;
}

// Its size is the one that its count of triangles says.
bool is_binary_stl(const std::string& bytes) {
  if (bytes.size() < kHeader + 4) return false;
  const auto count = static_cast<std::size_t>(value_at<std::uint32_t>(bytes, kHeader));
  return bytes.size() == kHeader + 4 + count * kTriangle;
}

class MeshReader {
 public:
  MeshReader(const std::string& path, const Spot& spot, Diagnostics& diagnostics)
      : path_(path), spot_(spot), diagnostics_(diagnostics) {}

  std::optional<TriangleMesh> read_stl(const std::string& bytes) {
    return is_binary_stl(bytes) ? read_binary(bytes) : read_lines(bytes, &MeshReader::read_stl_line);
  }

  std::optional<TriangleMesh> read_obj(const std::string& text) { return read_lines(text, &MeshReader::read_obj_line); }

 private:
  using LineReader = bool (MeshReader::*)(const std::vector<std::string>& words);

  std::optional<TriangleMesh> read_binary(const std::string& bytes) {
    MeshBuilder builder(2);
    for (std::size_t at = kHeader + 4; at < bytes.size(); at += kTriangle) {
      for (std::size_t corner = 0; corner < 3; ++corner) {
        std::array<Scientific, 3> point;
        for (std::size_t k = 0; k < 3; ++k) {
          const std::size_t offset = at + 12 * (corner + 1) + 4 * k;  // behind the normal
          const std::optional<Scientific> number = exact_float(value_at<float>(bytes, offset));
          if (!number) {
            report(0, "a number is not finite");
            return std::nullopt;
          }
          point[k] = *number;
        }
        builder.add_point(point);
      }
      builder.add_triangle(builder.point_count() - 3, builder.point_count() - 2, builder.point_count() - 1);
    }
    return builder.mesh();
  }

  std::optional<TriangleMesh> read_lines(const std::string& text, LineReader read) {
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) {
      ++line_;
      if (!line.empty() && line.back() == '\r') line.pop_back();
      const std::vector<std::string> words = words_of(line);
      if (!words.empty() && !(this->*read)(words)) return std::nullopt;
    }
    return decimals_.mesh();
  }

  // facet normal x y z / outer loop / vertex x y z, three times / endloop / endfacet
  bool read_stl_line(const std::vector<std::string>& words) {
    if (words[0] == "vertex") {
      if (!read_point(words)) return false;
      corners_.push_back(decimals_.point_count() - 1);
      return true;
    }
    if (words[0] == "endloop") {
      if (corners_.size() != 3) return report(line_, "a face does not have three corners");
      decimals_.add_triangle(corners_[0], corners_[1], corners_[2]);
      corners_.clear();
      return true;
    }
    for (const char* known : {"solid", "facet", "outer", "endfacet", "endsolid"}) {
      if (words[0] == known) return true;
    }
    return report(line_, "\"" + words[0].substr(0, 20) + "\" is not a word of an STL file");
  }

  bool read_obj_line(const std::vector<std::string>& words) {
    if (words[0] == "v") return read_point(words);
    if (words[0] == "o" || words[0] == "g") {
      is_next_shape_ = has_faces_;
      return true;
    }
    return words[0] != "f" || read_face(words);
  }

  bool read_point(const std::vector<std::string>& words) {
    if (words.size() < 4) return report(line_, "a point does not have three numbers");
    std::array<Scientific, 3> point;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::optional<Scientific> number = exact_scientific(words[k + 1]);
      if (!number) return report(line_, "\"" + words[k + 1].substr(0, 40) + "\" is not a number, or too large or long");
      point[k] = *number;
    }
    decimals_.add_point(point);
    points_.push_back(point);
    return true;
  }

  bool read_face(const std::vector<std::string>& words) {
    if (is_next_shape_) {
      return refuse("several objects or groups with faces, of which MuJoCo reads the first, are not supported");
    }
    has_faces_ = true;
    Corners corners;
    for (std::size_t k = 1; k < words.size() && words[k][0] != '#'; ++k) {
      const std::optional<std::size_t> corner = corner_of(words[k]);
      if (!corner) return report(line_, "\"" + words[k].substr(0, 40) + "\" is no point that is there");
      corners.push_back(*corner);
    }
    if (corners.size() == 3) {
      decimals_.add_triangle(corners[0], corners[1], corners[2]);
      return true;
    }
    if (corners.size() != 4) return refuse("a face of other than three or four corners is not supported");
    cut(corners);
    return true;
  }

  // "7", "7/1", "7//2", "-1": counted from 1, or from the end.
  std::optional<std::size_t> corner_of(const std::string& word) const {
    long number = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
    if (error != std::errc() || (end != word.data() + word.size() && *end != '/')) return std::nullopt;
    const auto count = static_cast<long>(points_.size());
    const long index = number < 0 ? count + number : number - 1;
    if (number == 0 || index < 0 || index >= count) return std::nullopt;
    return static_cast<std::size_t>(index);
  }

  void cut(const Corners& c) {
    if (square_of_distance(c[0], c[2]) < square_of_distance(c[1], c[3])) {
      decimals_.add_triangle(c[0], c[1], c[2]);
      decimals_.add_triangle(c[0], c[2], c[3]);
    } else {
      decimals_.add_triangle(c[0], c[1], c[3]);
      decimals_.add_triangle(c[1], c[2], c[3]);
    }
  }

  double square_of_distance(std::size_t a, std::size_t b) const {
    double sum = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const double difference = nearest(points_[a][k]) - nearest(points_[b][k]);
      sum += difference * difference;
    }
    return sum;
  }

  static double nearest(const Scientific& number) { return number.mantissa.get_d() * std::pow(10.0, number.exponent); }

  bool report(int line, const std::string& what) {
    diagnostics_.error({path_, line}, spot_.what + ": " + what, "export the mesh anew");
    return false;
  }

  bool refuse(const std::string& what) {
    diagnostics_.unsupported({path_, line_}, spot_.what + ": " + what, "export the mesh as one object of triangles");
    return false;
  }

  const std::string& path_;
  const Spot& spot_;
  Diagnostics& diagnostics_;
  MeshBuilder decimals_{10};
  std::vector<std::array<Scientific, 3>> points_;
  Corners corners_;
  int line_ = 0;
  bool has_faces_ = false, is_next_shape_ = false;
};

std::string ending_of(const std::string& path) {
  std::string ending = path.substr(std::min(path.size(), path.rfind('.')));
  for (char& c : ending) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c | 0x20) : c;
  return ending;
}

}  // namespace

std::optional<TriangleMesh> read_mesh_file(const std::string& path, const Spot& spot, Diagnostics& diagnostics) {
  const std::string ending = ending_of(path);
  if (ending != ".stl" && ending != ".obj") {
    diagnostics.unsupported(spot.place, spot.what + ": mesh files other than .stl and .obj are not supported",
                            "convert it to .stl, or write an <inertial> of the body");
    return std::nullopt;
  }
  const std::optional<std::string> bytes = file_text(path, diagnostics);
  if (!bytes) return std::nullopt;
  MeshReader reader(path, spot, diagnostics);
  return ending == ".stl" ? reader.read_stl(*bytes) : reader.read_obj(*bytes);
}

}  // namespace flatdyn
