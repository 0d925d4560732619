// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/contestants/batch_contestants.hpp"

#include "spaces/barycentric/correctly_rounded.hpp"
#include "spaces/barycentric/distance_matrix.hpp"
#include "spaces/homogeneous/sutherland_hodgman.hpp"
#include "spaces/view/sutherland_hodgman.hpp"

namespace clipscope::experiments {
namespace {

// One per thread, so that a call after the first allocates no more.
batch::Output& reused_output() {
  thread_local batch::Output output;
  return output;
}

template <batch::Method kMethod>
void clip_view(const Projection<float>& projection,
               std::span<const ViewTriangle<float, kSceneAttributes>> triangles,
               PolygonStream<float, kSceneAttributes>& out) {
  using Vertex = NdcVertex<float, kSceneAttributes>;
  constexpr std::size_t kFloats = 3 + kSceneAttributes;
  static_assert(sizeof(ViewTriangle<float, kSceneAttributes>) == 3 * kFloats * sizeof(float));
  static_assert(sizeof(Vertex) == (4 + kSceneAttributes) * sizeof(float));
  batch::Output& clipped = reused_output();
  batch::clip(
      kMethod, projection,
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

template <batch::Method kMethod>
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
  batch::clip(kMethod, projection, {flat.data(), 3, attributes}, clipped);
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

template <batch::Method kMethod>
Contestant<float> contestant(std::string_view summary, std::string_view source,
                             const Promise& promise) {
  return {.name = batch_clipper_name(kMethod),
          .summary = summary,
          .source = source,
          .promise = promise,
          .view = clip_view<kMethod>,
          .clip = nullptr,
          .view_one = clip_one_view<kMethod>,
          .clip_one = nullptr};
}

}  // namespace

std::string_view batch_clipper_name(batch::Method method) {
  switch (method) {
    case batch::Method::view: return "view/batch";
    case batch::Method::homogeneous: return "homogeneous/batch";
    case batch::Method::homogeneous_double: return "homogeneous/batch_double";
    case batch::Method::barycentric: return "barycentric/batch";
    default: return "barycentric/correctly_rounded_batch";
  }
}

// Of those that compute in more than float: every coordinate and attribute is rounded once, and a coordinate
// times w by three roundings, which is less than projecting and dividing in float.
constexpr Promise kRoundedOnce{.ulps = kProjectUlps};
constexpr Promise kFromOriginals{
    .ulps = kProjectUlps, .watertight = true, .rotation_invariant = false};

std::vector<Contestant<float>> batch_contestants() {
  using batch::Method;
  const std::string_view literature = HomogeneousSutherlandHodgman::source;
  const std::string_view matrix = DistanceMatrix::source;
  return {
      contestant<Method::view>("many triangles at once: Sutherland-Hodgman in view space, in SIMD",
                               ViewSutherlandHodgman::source, ViewSutherlandHodgman::promise),
      contestant<Method::homogeneous>(
          "many triangles at once: Sutherland-Hodgman in clip space, in SIMD", literature,
          HomogeneousSutherlandHodgman::promise),
      contestant<Method::homogeneous_double>("the same in double, rounded to float once",
                                             literature, kRoundedOnce),
      contestant<Method::barycentric>(
          "many triangles at once: every vertex from the three original ones, in double", matrix,
          kFromOriginals),
      contestant<Method::correctly_rounded>(
          "many triangles at once: decisions exact, every float the nearest to the exact value",
          CorrectlyRounded::source, CorrectlyRounded::promise),
  };
}

}  // namespace clipscope::experiments
