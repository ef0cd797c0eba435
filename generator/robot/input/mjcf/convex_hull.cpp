// SPDX-License-Identifier: GPL-2.0-or-later
#include "robot/input/mjcf/convex_hull.hpp"

#include <utility>

namespace flatdyn {

namespace {

using Corner = std::size_t;

IntegerPoint difference(const IntegerPoint& a, const IntegerPoint& b) {
  return {MeshInteger(a[0] - b[0]), MeshInteger(a[1] - b[1]), MeshInteger(a[2] - b[2])};
}

IntegerPoint normal_to(const IntegerPoint& a, const IntegerPoint& b) {
  return {MeshInteger(a[1] * b[2] - a[2] * b[1]), MeshInteger(a[2] * b[0] - a[0] * b[2]),
          MeshInteger(a[0] * b[1] - a[1] * b[0])};
}

MeshInteger along(const IntegerPoint& a, const IntegerPoint& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

struct Face {
  std::array<Corner, 3> corners;
  std::array<std::size_t, 3> neighbours = {};  // across the edge from corner k to the next one
  IntegerPoint normal;                         // outwards
  MeshInteger offset;                          // normal · corner
  std::vector<Corner> outside;                 // points that see the face, each in the list of one face only
  bool is_gone = false;
};

class Hull {
 public:
  explicit Hull(const std::vector<IntegerPoint>& points) : points_(points) {}

  std::vector<std::array<Corner, 3>> triangles() {
    if (!start()) return {};
    while (!waiting_.empty()) {
      const std::size_t face = waiting_.back();
      waiting_.pop_back();
      if (!faces_[face].is_gone && !faces_[face].outside.empty()) add_point_of(face);
    }
    std::vector<std::array<Corner, 3>> found;
    for (const Face& face : faces_) {
      if (!face.is_gone) found.push_back(face.corners);
    }
    return found;
  }

 private:
  // An edge of a face that a new point does not see, along which it sees the other face.
  struct HorizonEdge {
    Corner from, to;        // in the direction of the face that goes
    std::size_t neighbour;  // the face that stays
  };

  // Distance times a positive factor that depends on the face.
  MeshInteger height(Corner point, const Face& face) const { return along(face.normal, points_[point]) - face.offset; }

  std::size_t add_face(Corner a, Corner b, Corner c) {
    Face face;
    face.corners = {a, b, c};
    face.normal = normal_to(difference(points_[b], points_[a]), difference(points_[c], points_[a]));
    face.offset = along(face.normal, points_[a]);
    faces_.push_back(std::move(face));
    return faces_.size() - 1;
  }

  // A tetrahedron of the first points that are not in one plane; false if all are.
  bool start() {
    const std::size_t n = points_.size();
    if (n < 4) return false;
    Corner third = 2;
    IntegerPoint normal;
    for (;; ++third) {
      if (third == n) return false;
      normal = normal_to(difference(points_[1], points_[0]), difference(points_[third], points_[0]));
      if (normal[0] != 0 || normal[1] != 0 || normal[2] != 0) break;
    }
    Corner fourth = 2;
    MeshInteger above = 0;
    for (;; ++fourth) {
      if (fourth == n) return false;
      above = along(normal, difference(points_[fourth], points_[0]));
      if (above != 0) break;
    }
    const Corner a = 0, b = above > 0 ? third : 1, c = above > 0 ? 1 : third, d = fourth;
    add_face(a, b, c);
    add_face(a, d, b);
    add_face(b, d, c);
    add_face(c, d, a);
    faces_[0].neighbours = {1, 2, 3};
    faces_[1].neighbours = {3, 2, 0};
    faces_[2].neighbours = {1, 3, 0};
    faces_[3].neighbours = {2, 1, 0};
    std::vector<Corner> others;
    for (Corner point = 0; point < n; ++point) {
      if (point != a && point != b && point != c && point != d) others.push_back(point);
    }
    distribute(others, {0, 1, 2, 3});
    return true;
  }

  // Each point to the first face that it sees. One that sees none is in the hull.
  void distribute(const std::vector<Corner>& points, const std::vector<std::size_t>& faces) {
    for (const Corner point : points) {
      for (const std::size_t face : faces) {
        if (height(point, faces_[face]) <= 0) continue;
        faces_[face].outside.push_back(point);
        break;
      }
    }
    for (const std::size_t face : faces) {
      if (!faces_[face].outside.empty()) waiting_.push_back(face);
    }
  }

  Corner farthest_of(const Face& face) const {
    Corner best = face.outside.front();
    MeshInteger largest = height(best, face);
    for (const Corner point : face.outside) {
      const MeshInteger found = height(point, face);
      if (found <= largest) continue;
      largest = found;
      best = point;
    }
    return best;
  }

  // The faces that the point sees go; one at each edge of what is left takes their place.
  void add_point_of(std::size_t first) {
    const Corner point = farthest_of(faces_[first]);
    std::vector<std::size_t> seen = {first};
    std::vector<HorizonEdge> horizon;
    std::vector<Corner> others;
    faces_[first].is_gone = true;
    for (std::size_t k = 0; k < seen.size(); ++k) {
      for (const Corner each : faces_[seen[k]].outside) {
        if (each != point) others.push_back(each);
      }
      look_around(seen[k], point, seen);
    }
    for (const std::size_t face : seen) add_horizon(face, horizon);
    distribute(others, close(point, horizon));
  }

  void look_around(std::size_t face, Corner point, std::vector<std::size_t>& seen) {
    for (const std::size_t neighbour : faces_[face].neighbours) {
      Face& other = faces_[neighbour];
      if (other.is_gone || height(point, other) <= 0) continue;
      other.is_gone = true;
      seen.push_back(neighbour);
    }
  }

  void add_horizon(std::size_t face, std::vector<HorizonEdge>& horizon) const {
    const Face& gone = faces_[face];
    for (std::size_t k = 0; k < 3; ++k) {
      if (faces_[gone.neighbours[k]].is_gone) continue;
      horizon.push_back({gone.corners[k], gone.corners[(k + 1) % 3], gone.neighbours[k]});
    }
  }

  // Faces from the horizon, which goes once around, to the point.
  std::vector<std::size_t> close(Corner point, const std::vector<HorizonEdge>& horizon) {
    std::map<Corner, std::size_t> by_start;
    std::vector<std::size_t> added;
    for (const HorizonEdge& edge : horizon) {
      added.push_back(add_face(edge.from, edge.to, point));
      by_start[edge.from] = added.back();
      faces_[added.back()].neighbours[0] = edge.neighbour;
      Face& other = faces_[edge.neighbour];
      for (std::size_t k = 0; k < 3; ++k) {
        if (other.corners[k] == edge.to && other.corners[(k + 1) % 3] == edge.from) other.neighbours[k] = added.back();
      }
    }
    for (const std::size_t face : added) {
      const std::size_t next = by_start.at(faces_[face].corners[1]);
      faces_[face].neighbours[1] = next;
      faces_[next].neighbours[2] = face;
    }
    return added;
  }

  const std::vector<IntegerPoint>& points_;
  std::vector<Face> faces_;
  std::vector<std::size_t> waiting_;  // faces that points may see
};

}  // namespace

TriangleMesh convex_hull(const TriangleMesh& mesh) {
  TriangleMesh hull{mesh.unit, mesh.points, {}};
  hull.triangles = Hull(hull.points).triangles();
  return hull;
}

}  // namespace flatdyn
