// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which ways through the clippers the attack takes: what no input reaches is not attacked.
#include "spaces/barycentric/correctly_rounded.hpp"
#include "spaces/batch/batch.hpp"
#include "tests/catch.hpp"
#include "tests/spaces/attack/batch_layouts.hpp"
#include "tests/spaces/attack/kinds.hpp"

namespace clipscope::attack {
namespace {

using barycentric::CountStages;
using barycentric::Stage;

// f(batch) for some of each kind, of view space or of clip space.
template <class F>
void for_batches(bool in_view, F&& f) {
  for (const Kind& kind : all_kinds()) {
    Dice dice(3);
    for (int i = 0; i < 15; ++i) {
      const Batch batch = kind.make(dice);
      if (batch.is_view() == in_view) f(batch);
    }
  }
}

CountStages stages(bool in_view) {
  CountStages count;
  NdcPolygon<float, kRunTime> out;
  for_batches(in_view, [&](const Batch& batch) {
    for (std::size_t t = 0; t < batch.triangles(); ++t) {
      if (in_view) {
        CorrectlyRounded{}(projection_of(batch), triangle_of<Space::view, kRunTime>(batch, t), out,
                           count);
      } else {
        CorrectlyRounded{}(clip_volume_of(batch.volume),
                           triangle_of<Space::clip, kRunTime>(batch, t), out, count);
      }
    }
  });
  return count;
}

batch::Tally tally(bool in_view) {
  batch::Tally sum;
  batch::Output out;
  for_batches(in_view, [&](const Batch& b) {
    if (in_view) {
      batch::clip(batch::Method::correctly_rounded, projection_of(b), view_array_of(b), out);
    } else {
      batch::clip(batch::Method::correctly_rounded, clip_volume_of(b.volume), array_of(b), out);
    }
    sum.rejected += out.tally().rejected;
    sum.inside += out.tally().inside;
    sum.one_plane += out.tally().one_plane;
    sum.planes += out.tally().planes;
    sum.exact += out.tally().exact;
    sum.exact_vertices += out.tally().exact_vertices;
    sum.plain += out.tally().plain;
  });
  return sum;
}

}  // namespace

TEST_CASE("attack: every stage of the scalar clipper settles some answers, in both spaces") {
  for (const bool in_view : {false, true}) {
    INFO((in_view ? "view space" : "clip space"));
    const CountStages count = stages(in_view);
    for (const Stage stage :
         {Stage::sign_filtered, Stage::sign_exact, Stage::quotient_filtered, Stage::quotient_exact,
          Stage::quotient_midpoint, Stage::quotient_tie}) {
      INFO("stage " << static_cast<int>(stage));
      CHECK(count[stage] > 100);
    }
  }
}

TEST_CASE("attack: triangles take every way through the batch clippers") {
  for (const bool in_view : {false, true}) {
    INFO((in_view ? "view space" : "clip space"));
    const batch::Tally sum = tally(in_view);
    CHECK(sum.rejected > 20);
    CHECK(sum.inside > 20);
    CHECK(sum.plain > 20);
    if (batch::target_name() == "plain") continue;
    CHECK(sum.one_plane > 20);
    CHECK(sum.planes > 20);
    if (in_view) continue;
    CHECK(sum.exact > 20);
    CHECK(sum.exact_vertices > 20);
  }
}

}  // namespace clipscope::attack
