// SPDX-License-Identifier: GPL-3.0-or-later
//
// Steps of a clipper that are no contestant's, compiled as contestants are: without CGAL.
#include "experiments/cost/steps.hpp"

#include <memory>
#include <vector>

#include "experiments/contestants/typed.hpp"

namespace clipscope::experiments::cost {
namespace {

template <class T>
using Block = std::span<const ViewTriangle<T, kSceneAttributes>>;
template <class T>
using Positions = std::vector<ClipTriangle<T, 0>>;
template <class T>
using ClipPolygons = PolygonStream<T, kSceneAttributes, Space::clip>;

// Positions alone, to clip space or on to NDC.
template <class T, bool kDivide>
void transform(const Projection<T>& projection, Block<T> block, Positions<T>& out) {
  out.resize(block.size());
  for (std::size_t i = 0; i < block.size(); ++i) {
    for (std::size_t v = 0; v < 3; ++v) {
      const Vec4<T> clip = to_clip(projection, block[i][v].position);
      out[i][v].position = kDivide ? to_ndc(clip) : clip;
    }
  }
}

template <class T>
void cut_and_transform(const Projection<T>& projection, Block<T> block, ClipPolygons<T>& out) {
  ClipPolygon<T, kSceneAttributes> polygon;
  out.clear();
  for (const auto& triangle : block) {
    polygon.clear();
    for (const auto& v : ViewSutherlandHodgman::cut(projection, triangle)) {
      polygon.push_back(to_clip(projection, v));
    }
    out.append(polygon);
  }
}

// A run of steps that are not a contestant's. Its answers are positions alone.
template <class T, class Out>
class StepRunner final : public Runner {
 public:
  using Steps = void (*)(const Projection<T>&, Block<T>, Out&);

  StepRunner(Steps steps, std::span<const Batch> batches) : steps_(steps) {
    for (const Batch& batch : batches) {
      projections_.push_back(projection_in<T>(batch));
      triangles_.push_back(simplices_in<Space::view, T, kSceneAttributes, 3>(batch));
    }
  }
  void clip(std::size_t batch, std::size_t first, std::size_t count) override {
    steps_(projections_[batch], Block<T>(triangles_[batch]).subspan(first, count), out_);
  }
  Answers answers() const override {
    Answers answers(kFormat<T>, 4);
    for (std::size_t i = 0; i < out_.size(); ++i) {
      for (const auto& v : out_[i]) {
        for (int c = 0; c < 4; ++c) answers.add(v.position[c]);
      }
      answers.end_polygon();
    }
    return answers;
  }

 private:
  Steps steps_;
  std::vector<Projection<T>> projections_;
  std::vector<std::vector<ViewTriangle<T, kSceneAttributes>>> triangles_;
  Out out_;
};

template <class T, class Out>
Contestant contestant_of(void (*steps)(const Projection<T>&, Block<T>, Out&)) {
  return {.prepare = [=](std::span<const Batch> batches) -> std::unique_ptr<Runner> {
    return std::make_unique<StepRunner<T, Out>>(steps, batches);
  }};
}

}  // namespace

template <class T>
Contestant transforming(Space space) {
  return space == Space::ndc ? contestant_of(transform<T, true>)
                             : contestant_of(transform<T, false>);
}
template Contestant transforming<float>(Space);
template Contestant transforming<double>(Space);

template <class T>
Contestant cutting_and_transforming() {
  return contestant_of(cut_and_transform<T>);
}
template Contestant cutting_and_transforming<float>();
template Contestant cutting_and_transforming<double>();

}  // namespace clipscope::experiments::cost
