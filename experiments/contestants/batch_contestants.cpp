// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/contestants/batch_contestants.hpp"

#include "spaces/batch/methods.hpp"

namespace clipscope::experiments {
namespace {

// One per thread, so that a call after the first allocates no more.
batch::Output& reused_output() {
  thread_local batch::Output output;
  return output;
}

template <class M>
void clip_view(const Projection<float>& projection,
               std::span<const ViewTriangle<float, kSceneAttributes>> triangles,
               PolygonStream<float, kSceneAttributes>& out) {
  using Vertex = NdcVertex<float, kSceneAttributes>;
  constexpr std::size_t kFloats = 3 + kSceneAttributes;
  static_assert(sizeof(ViewTriangle<float, kSceneAttributes>) == 3 * kFloats * sizeof(float));
  static_assert(sizeof(Vertex) == (4 + kSceneAttributes) * sizeof(float));
  batch::Output& clipped = reused_output();
  batch::clip(
      batch::kMethod<M>, projection,
      {reinterpret_cast<const float*>(triangles.data()), 3 * triangles.size(), kSceneAttributes},
      clipped);
  const auto polygons = clipped.polygons();
  std::size_t next = 0, end = 0;
  out.append(std::span(reinterpret_cast<const Vertex*>(clipped.vertices().data()),
                       clipped.vertices().size() / clipped.stride()),
             triangles.size(), [&](std::size_t triangle) {
               if (next < polygons.size() && polygons[next].triangle == triangle) {
                 end = polygons[next++].end;
               }
               return end;
             });
}

template <class M>
void clip_one_view(const Projection<float>& projection,
                   const ViewTriangle<float, kRunTime>& triangle,
                   NdcPolygon<float, kRunTime>& out) {
  std::array<float, 3 * (3 + kMaxAttributes)> flat;
  float* next = flat.data();
  const int attributes = triangle[0].attributes.size();
  for (const auto& v : triangle) {
    for (int c = 0; c < 3; ++c) *next++ = v.position[c];
    for (int k = 0; k < attributes; ++k) *next++ = v.attributes[k];
  }
  batch::Output& clipped = reused_output();
  batch::clip(batch::kMethod<M>, projection, {flat.data(), 3, attributes}, clipped);
  out.clear();
  const std::span<const float> vertices = clipped.vertices();
  for (std::size_t i = 0; i < vertices.size(); i += clipped.stride()) {
    NdcVertex<float, kRunTime> v;
    v.position = Vec4<float>(vertices[i], vertices[i + 1], vertices[i + 2], vertices[i + 3]);
    v.attributes.resize(attributes);
    std::copy_n(vertices.data() + i + 4, attributes, v.attributes.values.begin());
    out.push_back(v);
  }
}

}  // namespace

std::vector<Contestant<float>> batch_contestants() {
  std::vector<Contestant<float>> all;
  for_each_type(batch::AllMethods{}, [&]<class M>() {
    if constexpr (batch::HasFull<M>) {
      all.push_back({.name = M::name,
                     .summary = M::summary,
                     .source = M::source,
                     .promise = M::promise,
                     .view = clip_view<M>,
                     .clip = nullptr,
                     .view_one = clip_one_view<M>,
                     .clip_one = nullptr});
    }
  });
  return all;
}

}  // namespace clipscope::experiments
