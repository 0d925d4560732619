// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a mutant of the SIMD code is attacked through: the batch method correctly_rounded alone, for
// the one instruction set that the compiler is told of, so that it compiles in seconds.
#include "spaces/batch/targets.hpp"

#include <hwy/highway.h>

#include "spaces/batch/full_rounded-inl.hpp"
#include "spaces/batch/stage-inl.hpp"
#include "tests/spaces/attack/batch_layouts.hpp"

HWY_BEFORE_NAMESPACE();
namespace clipscope::attack::HWY_NAMESPACE {

namespace target = batch::HWY_NAMESPACE;
using Method = batch::CorrectlyRoundedBatch;

bool is_plain(const Batch& b) { return clipscope::is_plain(clip_volume_of(b.volume)); }

template <class Run>
Polygons stage_polygons(const Batch& b, const Run& run) {
  batch::Output out;
  const ClipVolume volume = clip_volume_of(b.volume);
  if (b.attributes == 4) {
    target::Stage<Method, 4> stage(volume, b.attributes, out);
    run(stage);
  } else {
    target::Stage<Method, kRunTime> stage(volume, b.attributes, out);
    run(stage);
  }
  return polygons_of(out, b);
}

Polygons copy(const Batch& b) {
  return stage_polygons(b, [&](auto& stage) { stage.copy(array_of(b)); });
}
Polygons by_number(const Batch& b) {
  const Streams streams(b);
  return stage_polygons(b, [&](auto& stage) { stage.reference(streams.streams()); });
}
Polygons indexed(const Batch& b) {
  const Mesh mesh(b);
  return stage_polygons(b, [&](auto& stage) { stage.indexed(mesh.mesh()); });
}

Polygons full(const Batch& b) {
  batch::Output out;
  const Projection<float> projection = projection_of(b);
  target::FullRoundedClipper<Method, kRunTime>(projection, b.attributes)(view_array_of(b), out);
  return polygons_of(out, b);
}

bool takes_stage(const Batch& b) { return takes_clip(b) && is_plain(b); }
bool takes_full(const Batch& b) {
  if (!takes_view(b) || !is_plain(b)) return false;
  return target::FullRoundedClipper<Method, kRunTime>::takes(projection_of(b).frustum);
}

}  // namespace clipscope::attack::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

namespace clipscope::attack {

std::vector<Contestant> contestants() {
  using namespace HWY_NAMESPACE;
  return {{"copied", Contract::stage, takes_stage, copy},
          {"by number", Contract::stage, takes_stage, by_number},
          {"indexed", Contract::stage, takes_stage, indexed},
          {"full", Contract::ndc, takes_full, full}};
}

}  // namespace clipscope::attack
