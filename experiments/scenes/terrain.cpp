// SPDX-License-Identifier: GPL-3.0-or-later
//
// A fractal height field by diamond-square midpoint displacement, and a flight over it.
//
// Source: Fournier, Fussell and Carpenter, "Computer Rendering of Stochastic Models", CACM 25(6),
// 1982; the square-diamond order after Miller, "The Definition and Rendering of Terrain Maps",
// SIGGRAPH 1986, whose known creases along the grid are no matter here.
#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "experiments/scenes/builtin.hpp"

namespace clipscope::experiments {
namespace {

constexpr double kSpan = 200;       // side length
constexpr double kRelief = 30;      // first displacement
constexpr double kRoughness = 0.5;  // displacement halves as the grid spacing halves

class HeightField {
 public:
  // 2^levels quads per side.
  HeightField(int levels, std::uint64_t seed)
      : size_((1 << levels) + 1), heights_(static_cast<std::size_t>(size_) * size_), random_(seed) {
    double relief = kRelief;
    for (int step = size_ - 1; step > 1; step /= 2, relief *= kRoughness) {
      const int half = step / 2;
      for (int j = half; j < size_; j += step) {
        for (int i = half; i < size_; i += step) {
          displace(i, j, {{{-half, -half}, {half, -half}, {-half, half}, {half, half}}}, relief);
        }
      }
      for (int j = 0; j < size_; j += half) {
        for (int i = (j / half) % 2 == 0 ? half : 0; i < size_; i += 2 * half) {
          displace(i, j, {{{-half, 0}, {half, 0}, {0, -half}, {0, half}}}, relief);
        }
      }
    }
  }

  int size() const { return size_; }
  double operator()(int i, int j) const { return heights_[index(i, j)]; }
  // The height above the nearest grid point of a place in the plane.
  double near_to(double x, double z) const {
    const auto grid = [this](double c) {
      return std::clamp(static_cast<int>((c / kSpan + 0.5) * (size_ - 1) + 0.5), 0, size_ - 1);
    };
    return (*this)(grid(x), grid(z));
  }

 private:
  std::size_t index(int i, int j) const { return static_cast<std::size_t>(j) * size_ + i; }

  // Moves a point at most `relief` away from the mean of those neighbours that are on the grid.
  void displace(int i, int j, const std::array<std::pair<int, int>, 4>& neighbours, double relief) {
    double sum = 0;
    int count = 0;
    for (const auto& [di, dj] : neighbours) {
      if (i + di < 0 || i + di >= size_ || j + dj < 0 || j + dj >= size_) continue;
      sum += (*this)(i + di, j + dj);
      ++count;
    }
    heights_[index(i, j)] = sum / count + random_.uniform(-relief, relief);
  }

  int size_;
  std::vector<double> heights_;
  Random random_;
};

Mesh mesh_of(const HeightField& field) {
  Mesh mesh;
  const int last = field.size() - 1;
  add_sheet(mesh, ground(kSpan, last, 20));
  std::size_t vertex = 0;
  for (int j = 0; j <= last; ++j) {
    for (int i = 0; i <= last; ++i) {
      mesh.positions[vertex++][1] = static_cast<float>(field(i, last - j));
    }
  }
  return mesh;
}

}  // namespace

Scene terrain_of_levels(int levels, std::uint64_t seed) {
  const HeightField field(levels, seed);
  const auto above = [&](double x, double z, double height) {
    return glm::dvec3(x, field.near_to(x, z) + height, z);
  };
  Scene scene;
  scene.mesh = mesh_of(field);
  scene.views = {
      make_view("high", above(-60, 120, 40), {0, 0, 0}, 0.5, 500),
      make_view("low", above(-40, 60, 3), above(-20, 0, 0), 0.1, 500),
      make_view("on the ground", above(0, 0, 0.15), above(12, -8, 0.5), 0.1, 100),
      make_view("banking", above(40, -30, 8), above(20, -50, -10), 0.1, 60),
      make_view("from underground", above(20, 20, -1), above(-30, -10, -2), 0.1, 500),
  };
  return scene;
}

}  // namespace clipscope::experiments
