// SPDX-License-Identifier: GPL-2.0-or-later
#include "robot/input/mjcf/mesh_moments.hpp"

#include <algorithm>
#include <sstream>

#include "robot/input/mjcf/convex_hull.hpp"

namespace flatdyn {

namespace {

constexpr int kFineBits = 200;  // of a grid for what is no rational number
constexpr int kDigits = 50;

Number number_of(const MeshInteger& a) { return GiNaC::numeric(a.get_str().c_str()); }

IntegerPoint minus(const IntegerPoint& a, const IntegerPoint& b) {
  return {MeshInteger(a[0] - b[0]), MeshInteger(a[1] - b[1]), MeshInteger(a[2] - b[2])};
}

IntegerPoint vector_product(const IntegerPoint& a, const IntegerPoint& b) {
  return {MeshInteger(a[1] * b[2] - a[2] * b[1]), MeshInteger(a[2] * b[0] - a[0] * b[2]),
          MeshInteger(a[0] * b[1] - a[1] * b[0])};
}

MeshInteger scalar_product(const IntegerPoint& a, const IntegerPoint& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

// Sums over the pyramids from a point to the triangles, or over the triangles, relative to that point.
struct PyramidSums {
  MeshInteger volume = 0;                           // times 6; of triangles their area, times 2
  IntegerPoint first = {};                          // times 24; of triangles times 6
  std::array<IntegerPoint, 3> second = {};          // ∫ r r^T, times 120; of triangles times 24; the lower half
  bool has_positive = false, has_negative = false;  // volumes
};

class Sums {
 public:
  Sums(const TriangleMesh& mesh, const std::vector<IntegerPoint>& points) : mesh_(mesh), points_(points) {}

  PyramidSums over(const IntegerPoint& origin, bool in_magnitude) const {
    PyramidSums sums;
    for (const auto& [a, b, c] : mesh_.triangles) {
      const IntegerPoint d = minus(points_[a], origin), e = minus(points_[b], origin), f = minus(points_[c], origin);
      MeshInteger volume = scalar_product(d, vector_product(e, f));
      sums.has_positive = sums.has_positive || volume > 0;
      sums.has_negative = sums.has_negative || volume < 0;
      if (in_magnitude) volume = abs(volume);
      add(d, e, f, volume, sums);
    }
    return sums;
  }

  // Areas to the nearest numbers of the grid.
  PyramidSums over_surface(const IntegerPoint& origin) const {
    PyramidSums sums;
    for (const auto& [a, b, c] : mesh_.triangles) {
      const IntegerPoint d = minus(points_[a], origin), e = minus(points_[b], origin), f = minus(points_[c], origin);
      add(d, e, f, twice_area(d, e, f), sums);
    }
    return sums;
  }

  // The centroid of the surface, to the nearest points of the grid.
  IntegerPoint centroid() const {
    MeshInteger area = 0;
    IntegerPoint sum = {};
    for (const auto& [a, b, c] : mesh_.triangles) {
      const IntegerPoint &d = points_[a], &e = points_[b], &f = points_[c];
      const MeshInteger size = twice_area(d, e, f);
      area += size;
      for (std::size_t k = 0; k < 3; ++k) sum[k] += size * (d[k] + e[k] + f[k]);
    }
    if (area == 0) return {};
    for (MeshInteger& each : sum) each /= 3 * area;
    return sum;
  }

 private:
  static MeshInteger twice_area(const IntegerPoint& d, const IntegerPoint& e, const IntegerPoint& f) {
    const IntegerPoint normal = vector_product(minus(e, d), minus(f, d));
    return sqrt(scalar_product(normal, normal));
  }

  static void add(const IntegerPoint& d, const IntegerPoint& e, const IntegerPoint& f, const MeshInteger& volume,
                  PyramidSums& sums) {
    sums.volume += volume;
    for (std::size_t k = 0; k < 3; ++k) {
      const MeshInteger of_k = d[k] + e[k] + f[k];
      sums.first[k] += volume * of_k;
      for (std::size_t l = 0; l <= k; ++l) {
        sums.second[k][l] += volume * (d[k] * d[l] + e[k] * e[l] + f[k] * f[l] + of_k * (d[l] + e[l] + f[l]));
      }
    }
  }

  const TriangleMesh& mesh_;
  const std::vector<IntegerPoint>& points_;
};

bool is_closed(const TriangleMesh& mesh) {
  std::map<std::array<std::size_t, 2>, int> edges;
  for (const auto& triangle : mesh.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t from = triangle[k], to = triangle[(k + 1) % 3];
      edges[{std::min(from, to), std::max(from, to)}] += from < to ? 1 : -1;
    }
  }
  return std::all_of(edges.begin(), edges.end(), [](const auto& edge) { return edge.second == 0; });
}

// By what the sums are multiplied, and the power of the unit of a volume or an area.
struct SumFactors {
  int volume, first, second, power;
};
constexpr SumFactors kOfPyramids = {6, 24, 120, 3}, kOfTriangles = {2, 6, 24, 2};

// Moments from sums over pyramids from a point. `centre`: whether that is the centre of mass itself.
MeshMoments moments_of(const PyramidSums& sums, const IntegerPoint& origin, const Number& unit, bool is_centre,
                       const SumFactors& factors = kOfPyramids) {
  MeshMoments found;
  const Number cube = GiNaC::pow(unit, factors.power);
  const Number volume = number_of(sums.volume) / factors.volume;
  found.volume = volume * cube;
  Vec3 shift = zero_vector();
  Mat3 second = zero_matrix();
  for (std::size_t k = 0; k < 3; ++k) {
    if (!is_centre) shift[k] = number_of(sums.first[k]) / (factors.first * volume);
    found.centre[k] = unit * (number_of(origin[k]) + shift[k]);
    for (std::size_t l = 0; l <= k; ++l) {
      second[k][l] = second[l][k] =
          cube * unit * unit * (number_of(sums.second[k][l]) / factors.second - volume * shift[k] * shift[l]);
    }
  }
  const Number trace = second[0][0] + second[1][1] + second[2][2];
  for (std::size_t k = 0; k < 3; ++k) {
    for (std::size_t l = 0; l < 3; ++l) found.tensor[k][l] = (k == l ? trace : Number(0)) - second[k][l];
  }
  return found;
}

Number rounded(const Number& a) { return exact_decimal(to_decimal(a, kDigits)); }

MeshMoments rounded(MeshMoments moments) {
  moments.volume = rounded(moments.volume);
  for (std::size_t k = 0; k < 3; ++k) {
    moments.centre[k] = rounded(moments.centre[k]);
    for (Number& each : moments.tensor[k]) each = rounded(each);
  }
  return moments;
}

}  // namespace

bool has_one_orientation(const TriangleMesh& mesh) {
  std::vector<std::array<std::size_t, 2>> edges;
  for (const auto& triangle : mesh.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      if (triangle[k] != triangle[(k + 1) % 3]) edges.push_back({triangle[k], triangle[(k + 1) % 3]});
    }
  }
  std::sort(edges.begin(), edges.end());
  return std::adjacent_find(edges.begin(), edges.end()) == edges.end();
}

MeshMoments mesh_moments(const TriangleMesh& mesh, MeshVolume volume) {
  if (volume == MeshVolume::convex) return mesh_moments(convex_hull(mesh), MeshVolume::exact);
  const bool in_magnitude = volume == MeshVolume::legacy;
  std::vector<IntegerPoint> points = mesh.points;
  for (IntegerPoint& point : points) {
    for (MeshInteger& each : point) each <<= kFineBits;
  }
  const Sums sums(mesh, points);
  const IntegerPoint centroid = sums.centroid();
  const Number fine_unit = mesh.unit / GiNaC::pow(Number(2), kFineBits);
  if (volume == MeshVolume::shell) {
    const PyramidSums surface = sums.over_surface(centroid);
    return surface.volume == 0 ? MeshMoments{} : rounded(moments_of(surface, centroid, fine_unit, false, kOfTriangles));
  }
  const PyramidSums coarse = sums.over(centroid, in_magnitude);
  if (coarse.volume == 0) return {};
  IntegerPoint centre;
  for (std::size_t k = 0; k < 3; ++k) centre[k] = centroid[k] + coarse.first[k] / (4 * coarse.volume);
  const PyramidSums fine = sums.over(centre, in_magnitude);
  const bool has_two_signs = (coarse.has_negative && coarse.has_positive) || (fine.has_negative && fine.has_positive);
  if (is_closed(mesh) && !(in_magnitude && has_two_signs)) {
    PyramidSums exact = Sums(mesh, mesh.points).over(mesh.points.front(), false);
    MeshMoments found = moments_of(exact, mesh.points.front(), mesh.unit, false);
    if (in_magnitude && exact.volume < 0) {
      found.volume = -found.volume;
      found.tensor = {Number(-1) * found.tensor[0], Number(-1) * found.tensor[1], Number(-1) * found.tensor[2]};
    }
    return found;
  }
  return rounded(moments_of(fine, centre, fine_unit, true));
}

}  // namespace flatdyn
