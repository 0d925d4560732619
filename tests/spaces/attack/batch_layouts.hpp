// SPDX-License-Identifier: GPL-3.0-or-later
//
// A batch of triangles in the layouts of the batch clippers, and their output as polygons.
#pragma once

#include <array>
#include <cstdint>
#include <numeric>
#include <vector>

#include "spaces/batch/batch.hpp"
#include "tests/spaces/attack/contestants.hpp"
#include "tests/spaces/attack/spaces_types.hpp"

namespace clipscope::attack {

// Polygons by the numbers of the triangles; those inside are the triangles themselves.
inline Polygons polygons_of(const batch::Output& out, const Batch& batch) {
  Polygons r(batch.triangles());
  for (const std::uint32_t t : out.inside()) {
    r[t].assign(batch.vertex(t, 0), batch.vertex(t, 0) + 3 * batch.stride());
  }
  for (std::size_t i = 0; i < out.polygons().size(); ++i) {
    const auto polygon = out.polygon(i);
    r[out.polygons()[i].triangle].assign(polygon.begin(), polygon.end());
  }
  return r;
}

inline batch::VertexArray array_of(const Batch& batch) {
  return {batch.floats.data(), 3 * batch.triangles(), batch.attributes};
}

inline batch::ViewVertexArray view_array_of(const Batch& batch) {
  return {batch.floats.data(), 3 * batch.triangles(), batch.attributes};
}

// Positions as twelve arrays.
class Streams {
 public:
  explicit Streams(const Batch& batch) {
    const std::size_t count = batch.triangles();
    for (std::size_t v = 0; v < 3; ++v) {
      for (std::size_t c = 0; c < 4; ++c) {
        std::vector<float>& to = positions_[v][c];
        for (std::size_t t = 0; t < count; ++t) to.push_back(batch.vertex(t, v)[c]);
        streams_.positions[v][c] = to.data();
      }
    }
    for (std::size_t i = 0; i < 3 * count; ++i) {
      const float* own = batch.vertex(0, i) + 4;
      attributes_.insert(attributes_.end(), own, own + batch.attributes);
    }
    streams_.count = count;
    streams_.attributes = attributes_.data();
    streams_.attribute_count = batch.attributes;
  }
  Streams(const Streams&) = delete;
  Streams& operator=(const Streams&) = delete;

  const batch::TriangleStreams& streams() const { return streams_; }

 private:
  std::array<std::array<std::vector<float>, 4>, 3> positions_;
  std::vector<float> attributes_;
  batch::TriangleStreams streams_;
};

// The vertices in another order, which the indices undo.
class Mesh {
 public:
  explicit Mesh(const Batch& batch) : stride_(batch.stride()), attributes_(batch.attributes) {
    const std::size_t count = 3 * batch.triangles();
    std::size_t step = count / 2 + 1;
    while (std::gcd(step, count) != 1) ++step;
    vertices_.resize(batch.floats.size());
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t place = i * step % count;
      std::copy_n(batch.vertex(0, i), stride_, vertices_.data() + place * stride_);
      indices_.push_back(static_cast<std::uint32_t>(place));
    }
  }

  batch::IndexedMesh mesh() const {
    return {{vertices_.data(), vertices_.size() / stride_, attributes_}, indices_};
  }

 private:
  std::size_t stride_;
  int attributes_;
  std::vector<float> vertices_;
  std::vector<std::uint32_t> indices_;
};

}  // namespace clipscope::attack
