// SPDX-License-Identifier: GPL-3.0-or-later
//
// The batch clippers' method correctly_rounded: three layouts of the stage and the full contract,
// in plain C++ and on each instruction set.
#include "tests/spaces/attack/batch_layouts.hpp"

// As the clippers read it.
#include "spaces/batch/targets.hpp"

#include <hwy/highway.h>

namespace clipscope::attack {
namespace {

constexpr batch::Method kMethod = batch::Method::correctly_rounded;

// Where it runs: in plain C++, or on a target of Highway's.
struct Place {
  batch::Build build;
  std::int64_t target;  // 0: whichever is best
};

template <class Clip>
Polygons clip_at(const Place& place, const Batch& batch, const Clip& clip) {
  batch::Output out;
  hwy::SetSupportedTargetsForTest(place.target);
  clip(out);
  hwy::SetSupportedTargetsForTest(0);
  return polygons_of(out, batch);
}

Polygons copy(const Place& place, const Batch& b) {
  return clip_at(place, b, [&](batch::Output& out) {
    batch::clip(kMethod, clip_volume_of(b.volume), array_of(b), out, place.build);
  });
}

Polygons by_number(const Place& place, const Batch& b) {
  const Streams streams(b);
  return clip_at(place, b, [&](batch::Output& out) {
    batch::clip(kMethod, clip_volume_of(b.volume), streams.streams(), out, place.build);
  });
}

Polygons indexed(const Place& place, const Batch& b) {
  const Mesh mesh(b);
  return clip_at(place, b, [&](batch::Output& out) {
    batch::clip(kMethod, clip_volume_of(b.volume), mesh.mesh(), out, place.build);
  });
}

Polygons full(const Place& place, const Batch& b) {
  return clip_at(place, b, [&](batch::Output& out) {
    batch::clip(kMethod, projection_of(b), view_array_of(b), out, place.build);
  });
}

void add(const std::string& name, const Place& place, std::vector<Contestant>& to) {
  const auto at_place = [&](Polygons (*clip)(const Place&, const Batch&)) {
    return [=](const Batch& b) { return clip(place, b); };
  };
  to.push_back({"batch, copied, " + name, Contract::stage, takes_clip, at_place(copy)});
  to.push_back({"batch, by number, " + name, Contract::stage, takes_clip, at_place(by_number)});
  to.push_back({"batch, indexed, " + name, Contract::stage, takes_clip, at_place(indexed)});
  to.push_back({"batch, full, " + name, Contract::ndc, takes_view, at_place(full)});
}

}  // namespace

std::vector<Contestant> batch_contestants() {
  std::vector<Contestant> r;
  add("plain", {batch::Build::plain, 0}, r);
  for (const std::int64_t target : hwy::SupportedAndGeneratedTargets()) {
    hwy::SetSupportedTargetsForTest(target);
    add("SIMD on " + batch::target_name(), {batch::Build::simd, target}, r);
  }
  hwy::SetSupportedTargetsForTest(0);
  return r;
}

}  // namespace clipscope::attack
