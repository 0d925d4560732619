// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/contestants/plane_columns.hpp"

namespace clipscope::experiments {
namespace {

constexpr std::size_t kPosition = 4;  // numbers of a vertex in front of its attributes

void add(const Format& format, const Number& x, Answers& answers) {
  if (x.exact) return answers.add(*x.exact);
  if (format.precision == kFormat<dd_real>.precision) return answers.add(dd_real(x.value, x.rest));
  answers.add(x.value);
}

}  // namespace

Answers clip_without_distances(const Contestant& contestant, const Batch& batch) {
  Answers all = clip(contestant, batch);
  const std::size_t planes = batch.planes.size();
  if (planes == 0) return all;
  Answers rest(all.format(), all.stride() - planes);
  rest.overflowed = all.overflowed;
  for (std::size_t p = 0; p < all.size(); ++p) {
    for (const VertexView& v : all[p]) {
      for (std::size_t i = 0; i < v.size(); ++i) {
        if (i < kPosition || i >= kPosition + planes) add(all.format(), v[i], rest);
      }
    }
    rest.end_polygon();
  }
  return rest;
}

}  // namespace clipscope::experiments
