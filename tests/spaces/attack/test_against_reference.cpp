// SPDX-License-Identifier: GPL-3.0-or-later
//
// The integer clipper against the reference: two exact answers that have no code in common.
#include <algorithm>
#include <set>

#include "tests/catch.hpp"
#include "tests/spaces/attack/integer_clip.hpp"
#include "tests/spaces/attack/kinds.hpp"
#include "tests/spaces/attack/spaces_types.hpp"
#include "tests/spaces/barycentric/rounded_rows.hpp"

namespace clipscope::attack {
namespace {

using reference::ExactPolygon;
using reference::ExactVertex;
using reference::kAttributes;
using reference::Rows;

// The same batch with as many attributes as the reference's rows have, and no -0, which it does not
// know.
Batch with_row_attributes(const Batch& batch) {
  Batch r{batch.volume, batch.frustum, kAttributes, {}};
  r.volume.clip_distances = std::min(batch.volume.clip_distances, kAttributes);
  for (std::size_t i = 0; i < 3 * batch.triangles(); ++i) {
    const float* v = batch.vertex(0, i);
    for (std::size_t k = 0; k < r.stride(); ++k) {
      r.floats.push_back(k < batch.stride() ? v[k] + 0.0f : static_cast<float>(i % 3));
    }
  }
  return r;
}

ExactPolygon reference_polygon(const Batch& batch, std::size_t t) {
  if (!batch.is_view()) {
    return clip(reference::Truth::of_clip(clip_volume_of(batch.volume)),
                reference::input_triangle(triangle_of<Space::clip, kAttributes>(batch, t)));
  }
  const Projection<float> p = projection_of(batch);
  return clip(reference::Truth::of_frustum(frustum_cast<double>(p.frustum), p.volume),
              reference::input_triangle(triangle_of<Space::view, kAttributes>(batch, t)));
}

Rows rows_of(const std::vector<float>& polygon) {
  Rows r;
  for (std::size_t i = 0; i < polygon.size(); i += reference::Row{}.size()) {
    std::copy_n(polygon.data() + i, reference::Row{}.size(), r.emplace_back().data());
  }
  return r;
}

bool agrees_from_some_vertex(Rows computed, const ExactPolygon& exact) {
  std::size_t turns = std::max<std::size_t>(1, computed.size());
  for (; turns > 0; --turns) {
    if (reference::agrees(computed, exact)) return true;
    if (!computed.empty()) std::rotate(computed.begin(), computed.begin() + 1, computed.end());
  }
  return false;
}

// Clip coordinates of a vertex, rounded once: NDC over 1/w.
std::array<float, 4> clip_position(const ExactVertex& v) {
  const reference::Rational inverse = to_rational(v.inv_w);
  const auto over = [&](const reference::Fraction& c) {
    const reference::Rational r = to_rational(c) / inverse;
    return reference::round_to<float>(r);
  };
  const reference::Rational w = 1 / inverse;
  return {over(v.x), over(v.y), over(v.z), reference::round_to<float>(w)};
}

using Positions = std::multiset<std::array<float, 4>>;

Positions stage_positions(const std::vector<float>& polygon) {
  Positions r;
  for (std::size_t i = 0; i < polygon.size(); i += reference::Row{}.size()) {
    r.insert({polygon[i], polygon[i + 1], polygon[i + 2], polygon[i + 3]});
  }
  return r;
}

Positions stage_positions(const ExactPolygon& exact) {
  Positions r;
  for (const ExactVertex& v : exact.vertices) r.insert(clip_position(v));
  return r;
}

}  // namespace

TEST_CASE("attack: exact integers answer as the reference does, whatever the kind of input") {
  for (const Kind& kind : all_kinds()) {
    INFO(std::string(kind.name));
    Dice dice(2);
    int cut = 0;
    for (int i = 0; i < 12; ++i) {
      const Batch batch = with_row_attributes(kind.make(dice));
      for (std::size_t t = 0; t < batch.triangles(); ++t) {
        Facts facts;
        const Answer answer = exact_answer(batch, t, facts);
        const ExactPolygon exact = reference_polygon(batch, t);
        if (!agrees_from_some_vertex(rows_of(answer.ndc), exact)) {
          FAIL("batch " << i << ", triangle " << t << " has " << answer.ndc.size() / 7
                        << " vertices, in the reference " << exact.vertices.size());
        }
        cut += facts[Fact::cut] != 0;
        if (batch.is_view() || !has_area(exact)) continue;
        CHECK(stage_positions(answer.stage) == stage_positions(exact));
      }
    }
    CHECK(cut > 20);
  }
}

}  // namespace clipscope::attack
