// SPDX-License-Identifier: GPL-3.0-or-later
//
// The correctly rounded clipper of one triangle.
#include "spaces/barycentric/correctly_rounded.hpp"
#include "tests/spaces/attack/contestants.hpp"
#include "tests/spaces/attack/spaces_types.hpp"

namespace clipscope::attack {
namespace {

// K: kRunTime, or a number at compile time, for batches that have as many attributes.
template <Space S, int K, class Where>
Polygons ndc_polygons(const Batch& batch, const Where& where) {
  Polygons r;
  NdcPolygon<float, K> polygon;
  for (std::size_t t = 0; t < batch.triangles(); ++t) {
    CorrectlyRounded{}(where, triangle_of<S, K>(batch, t), polygon);
    r.push_back(floats_of(polygon));
  }
  return r;
}

template <int K>
Polygons ndc_of_clip_space(const Batch& batch) {
  return ndc_polygons<Space::clip, K>(batch, clip_volume_of(batch.volume));
}

template <int K>
Polygons ndc_of_view_space(const Batch& batch) {
  return ndc_polygons<Space::view, K>(batch, projection_of(batch));
}

template <int K>
Polygons stage(const Batch& batch) {
  const ClipVolume volume = clip_volume_of(batch.volume);
  Polygons r;
  for (std::size_t t = 0; t < batch.triangles(); ++t) {
    r.push_back(floats_of(CorrectlyRounded::cut(volume, triangle_of<Space::clip, K>(batch, t))));
  }
  return r;
}

template <bool (*takes)(const Batch&)>
bool takes_four(const Batch& batch) {
  return takes(batch) && batch.attributes == 4;
}

}  // namespace

std::vector<Contestant> scalar_contestants() {
  return {{"clip space to NDC", Contract::ndc, takes_clip, ndc_of_clip_space<kRunTime>},
          {"clip space to NDC, 4 attributes", Contract::ndc, takes_four<takes_clip>,
           ndc_of_clip_space<4>},
          {"view space to NDC", Contract::ndc, takes_view, ndc_of_view_space<kRunTime>},
          {"view space to NDC, 4 attributes", Contract::ndc, takes_four<takes_view>,
           ndc_of_view_space<4>},
          {"stage", Contract::stage, takes_clip, stage<kRunTime>},
          {"stage, 4 attributes", Contract::stage, takes_four<takes_clip>, stage<4>}};
}

}  // namespace clipscope::attack
