// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/experiments/contestants/other_build.hpp"

#include <bit>

#include "spaces/clippers.hpp"

namespace clipscope::tests {
namespace {

constexpr int K = other_build::kAttributes;

template <Space S, class T, std::size_t N>
Simplex<S, T, K, N> simplex_in(const other_build::Input& input) {
  Simplex<S, T, K, N> simplex;
  const double* next = input.numbers.data();
  for (Vertex<S, T, K>& v : simplex) {
    for (int c = 0; c < v.kDimension; ++c) v.position[c] = T(*next++);
    for (int k = 0; k < K; ++k) v.attributes[k] = T(*next++);
  }
  return simplex;
}

template <class T>
void write(const NdcPolygon<T, K>& polygon, std::vector<double>& out) {
  for (const NdcVertex<T, K>& v : polygon) {
    for (int c = 0; c < 4; ++c) out.push_back(v.position[c]);
    for (int k = 0; k < K; ++k) out.push_back(v.attributes[k]);
  }
}

template <class C, class T, std::size_t N>
void from_view(const other_build::Input& input, std::vector<double>& out) {
  Projection<T> projection(frustum_cast<T>(std::bit_cast<Frustum<double>>(input.frustum)));
  projection.volume = std::bit_cast<ClipVolume>(input.volume);
  NdcPolygon<T, K> polygon;
  C{}(projection, simplex_in<Space::view, T, N>(input), polygon);
  write(polygon, out);
}

template <class C, class T, std::size_t N>
void from_clip(const other_build::Input& input, std::vector<double>& out) {
  NdcPolygon<T, K> polygon;
  C{}(std::bit_cast<ClipVolume>(input.volume), simplex_in<Space::clip, T, N>(input), polygon);
  write(polygon, out);
}

template <class T, std::size_t N, class... Cs>
void add(TypeList<Cs...>, const char* scalar, std::vector<other_build::Clipper>& all) {
  const auto add_one = [&]<class C>() {
    if constexpr (ClipsViewSpace<C, T, K, N>) {
      all.push_back({C::name.data(), scalar, static_cast<int>(N), from_view<C, T, N>, nullptr});
      if constexpr (ClipsClipSpace<C, T, K, N>) all.back().from_clip = from_clip<C, T, N>;
    }
  };
  (add_one.template operator()<Cs>(), ...);
}

}  // namespace
}  // namespace clipscope::tests

namespace other_build {

const std::vector<Clipper>& clippers() {
  using namespace clipscope;
  static const std::vector<Clipper> all = [] {
    std::vector<Clipper> list;
    tests::add<float, 3>(AllClippers{}, "float", list);
    tests::add<float, 2>(AllSegmentClippers{}, "float", list);
    tests::add<double, 3>(AllClippers{}, "double", list);
    tests::add<double, 2>(AllSegmentClippers{}, "double", list);
    return list;
  }();
  return all;
}

}  // namespace other_build
