// SPDX-License-Identifier: GPL-3.0-or-later
//
// Contestants that are a stage of a renderer: clip-space triangles in, clip-space polygons out, no
// divide.
//
//   textbook                       the baseline: vectors copied at each plane; copy
//   homogeneous/sutherland_hodgman the scalar clipper up to its divide, in float and double; copy
//   homogeneous/batch and so on     spaces/batch, plain and SIMD, in every layout
//
// What comes out is float, rounded once where a method computes in another format.
#include <fmt/format.h>

#include <memory>
#include <stdexcept>

#include "experiments/contestants/made.hpp"
#include "experiments/contestants/stage_runner.hpp"
#include "spaces/batch/methods.hpp"
#include "spaces/homogeneous/sutherland_hodgman.hpp"
#include "spaces/homogeneous/textbook.hpp"

namespace clipscope::experiments {
namespace {

// Calls f.template operator()<K>() for the attribute count given.
template <class F>
void with_attribute_count(int attributes, F&& f) {
  switch (attributes) {
    case 0: return f.template operator()<0>();
    case 1: return f.template operator()<1>();
    case 2: return f.template operator()<2>();
    case 4: return f.template operator()<4>();
    case 8: return f.template operator()<8>();
    case 16: return f.template operator()<16>();
    case 32: return f.template operator()<32>();
    default:
      throw std::logic_error(
          fmt::format("stage: no scalar clipper for {} attributes; 0 1 2 4 8 16 32", attributes));
  }
}

template <class T, int K>
ClipTriangle<T, K> load(const float* in) {
  ClipTriangle<T, K> triangle;
  for (auto& v : triangle) {
    for (int c = 0; c < 4; ++c) v.position[c] = T(*in++);
    for (int k = 0; k < K; ++k) v.attributes[k] = T(*in++);
  }
  return triangle;
}

// A scalar clipper over an array of vertices.
template <class C, class T>
class ScalarRunner final : public StageRunner {
 public:
  explicit ScalarRunner(const StageInput& input) : StageRunner(Contract::copy, input) {}

 private:
  void clip_stage(std::size_t first, std::size_t count) override {
    polygons_.clear();
    used_ = 0;
    const batch::VertexArray array = input().array(first, count);
    with_attribute_count(input().attributes, [&]<int K>() {
      for (std::size_t t = 0; t < count; ++t) {
        append(t, C::cut(input().volume, load<T, K>(array.data + t * 3 * (4 + K))));
      }
    });
  }
  StageAnswer answer() const override {
    return {{}, polygons_, std::span(vertices_).first(used_ * input().stride())};
  }

  template <int K>
  void append(std::size_t triangle, const ClipPolygon<T, K>& polygon) {
    if (polygon.empty()) return;
    const std::size_t room = (used_ + static_cast<std::size_t>(polygon.size())) * (4 + K);
    if (vertices_.size() < room) vertices_.resize(2 * room);
    float* out = vertices_.data() + used_ * (4 + K);
    for (const ClipVertex<T, K>& v : polygon) {
      for (int c = 0; c < 4; ++c) *out++ = static_cast<float>(v.position[c]);
      for (int k = 0; k < K; ++k) *out++ = static_cast<float>(v.attributes[k]);
    }
    used_ += static_cast<std::size_t>(polygon.size());
    polygons_.push_back({static_cast<std::uint32_t>(triangle), static_cast<std::uint32_t>(used_)});
  }

  std::vector<float> vertices_;  // used again
  std::vector<batch::PolygonEnd> polygons_;
  std::size_t used_ = 0;  // vertices
};

class BatchStageRunner final : public StageRunner {
 public:
  BatchStageRunner(batch::Method method, Contract contract, batch::Build build,
                   const StageInput& input)
      : StageRunner(contract, input), method_(method), build_(build) {}

 private:
  void clip_stage(std::size_t first, std::size_t count) override {
    const ClipVolume& volume = input().volume;
    switch (contract()) {
      case Contract::number:
        return batch::clip(method_, volume, input().streams(first, count), out_, build_);
      case Contract::indexed:
        return batch::clip(method_, volume, input().mesh(first, count), out_, build_);
      default: return batch::clip(method_, volume, input().array(first, count), out_, build_);
    }
  }
  StageAnswer answer() const override { return {out_.inside(), out_.polygons(), out_.vertices()}; }

  batch::Method method_;
  batch::Build build_;
  batch::Output out_;
};

template <class C, class Prepare>
Contestant stage(const Format& format, Contract contract, StagePromise promise, Prepare prepare) {
  Contestant contestant = describe<C>(format);
  contestant.contract = contract;
  contestant.stage_promise = promise;
  contestant.takes_clip_space = true;
  contestant.prepare_stage = prepare;
  return contestant;
}

template <class C, class T>
Contestant scalar_stage(StagePromise promise) {
  return stage<C>(kFormat<T>, Contract::copy, promise, [](const StageInput& input) {
    return std::make_unique<ScalarRunner<C, T>>(input);
  });
}

template <class M>
constexpr StagePromise stage_promise() {
  if (requires { typename M::BitsOf; }) return StagePromise::bits_of_scalar;
  if (M::promise.correctly_rounded) return StagePromise::correctly_rounded;
  return std::same_as<typename M::Number, float> ? StagePromise::float_chain
                                                 : StagePromise::rounded_once;
}

template <class M>
Contestant batch_stage(Contract contract, batch::Build build) {
  Contestant contestant =
      stage<M>(kFormat<float>, contract, stage_promise<M>(), [=](const StageInput& input) {
        return std::make_unique<BatchStageRunner>(batch::kMethod<M>, contract, build, input);
      });
  contestant.build = build == batch::Build::simd ? "simd" : "plain";
  return contestant;
}

}  // namespace

std::vector<Contestant> made_for_stages() {
  std::vector<Contestant> all = {
      scalar_stage<Textbook, float>(StagePromise::float_chain),
      scalar_stage<HomogeneousSutherlandHodgman, float>(StagePromise::float_chain),
      scalar_stage<HomogeneousSutherlandHodgman, double>(StagePromise::rounded_once)};
  for (const Contract contract : kStageContracts) {
    for_each_type(batch::AllMethods{}, [&]<class M>() {
      if constexpr (batch::HasStage<M>) {
        all.push_back(batch_stage<M>(contract, batch::Build::plain));
        all.push_back(batch_stage<M>(contract, batch::Build::simd));
      }
    });
  }
  return all;
}

}  // namespace clipscope::experiments
