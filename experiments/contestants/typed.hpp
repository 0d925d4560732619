// SPDX-License-Identifier: GPL-3.0-or-later
//
// Makes the contestants of one scalar; included once per scalar, each in its own translation unit.
#pragma once

#include <algorithm>
#include <array>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "experiments/contestants/made.hpp"
#include "experiments/contestants/polygon_stream.hpp"
#include "experiments/contestants/typed_input.hpp"
#include "spaces/clippers.hpp"
#include "spaces/homogeneous/polygon.hpp"

namespace clipscope::experiments {

template <Space S, Scalar T, int K, std::size_t N>
std::vector<Simplex<S, T, K, N>> simplices_in(const Batch& batch) {
  const VertexReader<S, T, K> read(batch);
  std::vector<Simplex<S, T, K, N>> simplices(batch.size());
  for (std::size_t i = 0; i < simplices.size(); ++i) {
    for (std::size_t v = 0; v < N; ++v) simplices[i][v] = read(i * N + v);
  }
  return simplices;
}

// What a clipper does with a block, its polygons in the space kOut; null where it does not take the
// input's space.
template <Scalar T, int K, std::size_t N, Space kOut = Space::ndc>
struct BlockClips {
  template <Space S>
  using Block = std::span<const Simplex<S, T, K, N>>;

  void (*view)(const Projection<T>&, const PointSize<T>&, Block<Space::view>,
               PolygonStream<T, K, kOut>&) = nullptr;
  void (*clip)(const ClipVolume&, const PointSize<T>&, Block<Space::clip>,
               PolygonStream<T, K, kOut>&) = nullptr;
};

// Where: a projection or a volume. Only points have a size.
template <class C, class Where, Scalar T, Space S, int K, std::size_t N>
void clip_block(const Where& where, [[maybe_unused]] const PointSize<T>& size,
                std::span<const Simplex<S, T, K, N>> block, PolygonStream<T, K>& out) {
  NdcPolygon<T, K> polygon;
  for (const Simplex<S, T, K, N>& primitive : block) {
    if constexpr (N == 1) {
      C{}(where, primitive, size, polygon);
    } else {
      C{}(where, primitive, polygon);
    }
    out.append(polygon);
  }
}

template <class C, Scalar T, int K, std::size_t N>
BlockClips<T, K, N> clips_of() {
  BlockClips<T, K, N> clips;
  clips.view = clip_block<C, Projection<T>, T, Space::view, K, N>;
  if constexpr (ClipsClipSpace<C, T, K, N>) {
    clips.clip = clip_block<C, ClipVolume, T, Space::clip, K, N>;
  }
  return clips;
}

template <Scalar T, int K, std::size_t N, Space kOut>
class BlockRunner final : public Runner {
 public:
  BlockRunner(const BlockClips<T, K, N, kOut>& clips, std::span<const Batch> batches)
      : clips_(clips) {
    for (const Batch& batch : batches) {
      Part& part = parts_.emplace_back();
      part.attributes = batch.attributes + static_cast<int>(batch.planes.size());
      part.size = point_size_in<T>(batch);
      part.projection = projection_in<T>(batch);
      if (batch.matrix) part.matrix = matrix_from<T>(*batch.matrix);
      if (batch.space == Space::view) part.view = simplices_in<Space::view, T, K, N>(batch);
      if (batch.space == Space::clip) part.clip = simplices_in<Space::clip, T, K, N>(batch);
    }
  }

  void clip(std::size_t batch, std::size_t first, std::size_t count) override {
    last_ = &parts_[batch];
    out_.clear();
    if (last_->matrix) {
      transformed_.clear();
      for (const auto& simplex : std::span(last_->view).subspan(first, count)) {
        transformed_.push_back(to_clip(*last_->matrix, simplex));
      }
      clips_.clip(last_->projection.volume, last_->size, std::span(std::as_const(transformed_)),
                  out_);
    } else if (!last_->view.empty()) {
      clips_.view(last_->projection, last_->size, std::span(last_->view).subspan(first, count),
                  out_);
    } else if (!last_->clip.empty()) {
      clips_.clip(last_->projection.volume, last_->size,
                  std::span(last_->clip).subspan(first, count), out_);
    }
  }

  Answers answers() const override {
    Answers answers(kFormat<T>, 4 + static_cast<std::size_t>(last_->attributes));
    for (std::size_t i = 0; i < out_.size(); ++i) add_polygon(out_[i], answers);
    answers.overflowed = out_.overflowed();
    return answers;
  }

 private:
  struct Part {
    Projection<T> projection = {};             // its volume is that of both spaces
    std::optional<MatrixRows<T>> matrix = {};  // instead of the projection
    PointSize<T> size = {};
    int attributes = 0;
    std::vector<Simplex<Space::view, T, K, N>> view = {};
    std::vector<Simplex<Space::clip, T, K, N>> clip = {};
  };

  BlockClips<T, K, N, kOut> clips_;
  std::vector<Part> parts_;
  const Part* last_ = nullptr;
  std::vector<Simplex<Space::clip, T, K, N>> transformed_;  // by the last matrix
  PolygonStream<T, K, kOut> out_;
};

// The scenes' number of attributes has code of its own, all others share some.
template <Scalar T, std::size_t N, Space kOut>
auto prepare_blocks(const BlockClips<T, kSceneAttributes, N, kOut>& scenes,
                    const BlockClips<T, kRunTime, N, kOut>& others) {
  return [scenes, others](std::span<const Batch> batches) -> std::unique_ptr<Runner> {
    const bool is_scene = std::all_of(batches.begin(), batches.end(), [](const Batch& b) {
      return b.attributes == kSceneAttributes && b.planes.empty();
    });
    if (is_scene) {
      return std::make_unique<BlockRunner<T, kSceneAttributes, N, kOut>>(scenes, batches);
    }
    return std::make_unique<BlockRunner<T, kRunTime, N, kOut>>(others, batches);
  };
}

// Convex polygons of any size.
template <Scalar T>
class PolygonRunner final : public Runner {
 public:
  explicit PolygonRunner(std::span<const Batch> batches) : batches_(batches) {}

  void clip(std::size_t b, std::size_t first, std::size_t count) override {
    const Batch& batch = batches_[b];
    out_.clear();
    attributes_ = batch.attributes + static_cast<int>(batch.planes.size());
    const Projection<T> projection = projection_in<T>(batch);
    for (std::size_t i = first; i < first + count; ++i) {
      if (batch.matrix) {
        keep(clip_(projection.volume, transformed(batch, i)));
      } else if (batch.space == Space::view) {
        keep(clip_(projection, polygon<Space::view>(batch, i)));
      } else {
        keep(clip_(projection.volume, polygon<Space::clip>(batch, i)));
      }
    }
  }

  Answers answers() const override {
    Answers answers(kFormat<T>, 4 + static_cast<std::size_t>(attributes_));
    for (const auto& polygon : out_) add_polygon(polygon, answers);
    return answers;
  }

 private:
  using Vertices = std::vector<NdcVertex<T, kRunTime>>;

  template <Space S>
  static std::vector<Vertex<S, T, kRunTime>> polygon(const Batch& batch, std::size_t i) {
    const VertexReader<S, T, kRunTime> read(batch);
    std::vector<Vertex<S, T, kRunTime>> vertices;
    for (std::size_t v = i == 0 ? 0 : batch.ends[i - 1]; v < batch.ends[i]; ++v) {
      vertices.push_back(read(v));
    }
    return vertices;
  }
  static std::vector<ClipVertex<T, kRunTime>> transformed(const Batch& batch, std::size_t i) {
    const MatrixRows<T> matrix = matrix_from<T>(*batch.matrix);
    std::vector<ClipVertex<T, kRunTime>> vertices;
    for (const auto& v : polygon<Space::view>(batch, i)) vertices.push_back(to_clip(matrix, v));
    return vertices;
  }
  void keep(std::span<const NdcVertex<T, kRunTime>> polygon) {
    out_.emplace_back(polygon.begin(), polygon.end());
  }

  std::span<const Batch> batches_;
  HomogeneousPolygonClipper<T, kRunTime> clip_;
  std::vector<Vertices> out_;
  int attributes_ = 0;
};

template <class C, Scalar T, std::size_t N>
Contestant make_contestant() {
  Contestant contestant = describe<C>(kFormat<T>);
  contestant.vertices = N;
  contestant.takes_clip_space = ClipsClipSpace<C, T, kSceneAttributes, N>;
  contestant.prepare =
      prepare_blocks(clips_of<C, T, kSceneAttributes, N>(), clips_of<C, T, kRunTime, N>());
  return contestant;
}

template <Scalar T>
Contestant make_polygon_contestant() {
  Contestant contestant = describe<HomogeneousPolygonClipper<T, kRunTime>>(kFormat<T>);
  contestant.vertices = 0;
  contestant.takes_clip_space = true;
  contestant.prepare = [](std::span<const Batch> batches) -> std::unique_ptr<Runner> {
    return std::make_unique<PolygonRunner<T>>(batches);
  };
  return contestant;
}

// The clippers of a list that there are in the scalar.
template <Scalar T, std::size_t N, class... Cs>
void add_contestants(TypeList<Cs...>, std::vector<Contestant>& all) {
  const auto add = [&]<class C>() {
    if constexpr (ClipsViewSpace<C, T, kSceneAttributes, N>) {
      all.push_back(make_contestant<C, T, N>());
    }
  };
  (add.template operator()<Cs>(), ...);
}

template <Scalar T>
std::vector<Contestant> made_in() {
  std::vector<Contestant> all;
  add_contestants<T, 3>(AllClippers{}, all);
  add_contestants<T, 2>(AllSegmentClippers{}, all);
  add_contestants<T, 1>(AllPointClippers{}, all);
  all.push_back(make_polygon_contestant<T>());
  return all;
}

}  // namespace clipscope::experiments
