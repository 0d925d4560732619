// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/measure/stage_contestants.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "experiments/measure/staged.hpp"
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

float value_of(float x) { return x; }
template <class T, Skip kSkip>
float value_of(const Staged<T, kSkip>& x) {
  return static_cast<float>(x.value());
}

// Polygons as they are written, in memory that is used again.
class PolygonBuffer {
 public:
  void begin(std::size_t stride) {
    stride_ = stride;
    polygons_.clear();
    used_ = 0;
  }
  // List: vertices of clip space with size(), begin and end.
  template <class List>
  void append(std::size_t triangle, const List& list) {
    const std::size_t room = (used_ + list.size()) * stride_;
    if (vertices_.size() < room) vertices_.resize(2 * room);
    float* out = vertices_.data() + used_ * stride_;
    std::size_t count = 0;
    for (const auto& v : list) {
      if (!(0.0f < value_of(v.position[3]))) continue;
      for (int c = 0; c < 4; ++c) *out++ = value_of(v.position[c]);
      for (int k = 0; k < v.attributes.size(); ++k) *out++ = value_of(v.attributes[k]);
      ++count;
    }
    if (count < 3) return;
    used_ += count;
    polygons_.push_back({static_cast<std::uint32_t>(triangle), static_cast<std::uint32_t>(used_)});
  }
  StageAnswer answer() const {
    return {{}, polygons_, std::span(vertices_).first(used_ * stride_), stride_};
  }

 private:
  std::vector<float> vertices_;
  std::vector<batch::PolygonEnd> polygons_;
  std::size_t stride_ = 4, used_ = 0;
};

// A scalar clipper over an array of vertices. Cut: cut(volume, triangle) gives the list of vertices.
template <class T, class Cut>
class ScalarStage final : public StageContestant {
 public:
  using StageContestant::StageContestant;

  void clip(const StageInput& input, std::size_t first, std::size_t count) override {
    out_.begin(input.stride());
    const batch::VertexArray array = input.array(first, count);
    with_attribute_count(input.attributes, [&]<int K>() {
      Cut cut;
      for (std::size_t t = 0; t < count; ++t) {
        out_.append(t, cut(input.volume, load<T, K>(array.data + t * 3 * (4 + K))));
      }
    });
  }
  StageAnswer answer() const override { return out_.answer(); }

 private:
  PolygonBuffer out_;
};

struct TextbookCut {
  template <class T, int K>
  auto operator()(const ClipVolume& volume, const ClipTriangle<T, K>& triangle) const {
    return Textbook::cut(volume, triangle);
  }
};

// The clipper in a scalar that leaves out the divide.
struct UndividedCut {
  template <class T, int K>
  NdcPolygon<T, K> operator()(const ClipVolume& volume, const ClipTriangle<T, K>& triangle) const {
    NdcPolygon<T, K> polygon;
    HomogeneousSutherlandHodgman{}(volume, triangle, polygon);
    return polygon;
  }
};

// What the stage of a batch method promises.
template <class M>
constexpr StagePromise stage_promise() {
  if (requires { typename M::BitsOf; }) return StagePromise::bits_of_scalar;
  if (M::promise.correctly_rounded) return StagePromise::correctly_rounded;
  return std::same_as<typename M::Number, float> ? StagePromise::float_chain
                                                 : StagePromise::rounded_once;
}

class BatchStage final : public StageContestant {
 public:
  BatchStage(batch::Method method, StageContract contract, batch::Build build, StagePromise promise)
      : StageContestant(std::string(batch::name(method)), "float",
                        build == batch::Build::simd ? "simd" : "plain", contract, promise),
        clips_by_(method),
        build_(build) {}

  void clip(const StageInput& input, std::size_t first, std::size_t count) override {
    switch (contract()) {
      case StageContract::copy:
        return batch::clip(clips_by_, input.volume, input.array(first, count), out_, build_);
      case StageContract::reference:
        return batch::clip(clips_by_, input.volume, input.streams(first, count), out_, build_);
      case StageContract::indexed:
        return batch::clip(clips_by_, input.volume, input.mesh(first, count), out_, build_);
    }
  }
  StageAnswer answer() const override {
    return {out_.inside(), out_.polygons(), out_.vertices(), out_.stride()};
  }

 private:
  batch::Method clips_by_;
  batch::Build build_;
  batch::Output out_;
};

}  // namespace

std::string StageContestant::name() const {
  return fmt::format("{} {} {} {}", method_, scalar_, build_, contract_name(contract_));
}

std::unique_ptr<StageContestant> stage_textbook() {
  return std::make_unique<ScalarStage<float, TextbookCut>>(
      "textbook", "float", "scalar", StageContract::copy, StagePromise::float_chain);
}

std::unique_ptr<StageContestant> stage_sutherland_hodgman(std::string_view scalar) {
  const std::string method(HomogeneousSutherlandHodgman::name);
  if (scalar == "double") {
    return std::make_unique<ScalarStage<Staged<double, Skip::divide>, UndividedCut>>(
        method, "double", "scalar", StageContract::copy, StagePromise::rounded_once);
  }
  return std::make_unique<ScalarStage<Staged<float, Skip::divide>, UndividedCut>>(
      method, "float", "scalar", StageContract::copy, StagePromise::float_chain);
}

std::unique_ptr<StageContestant> stage_batch(batch::Method method, StageContract contract,
                                             batch::Build build) {
  StagePromise promise = StagePromise::float_chain;
  batch::with_method(method, [&]<class M>() { promise = stage_promise<M>(); });
  return std::make_unique<BatchStage>(method, contract, build, promise);
}

StageContestants stage_contestants(const StageInput& input) {
  StageContestants all;
  all.push_back(stage_textbook());
  if (input.size(StageContract::copy) > 0) {
    for (const char* scalar : {"float", "double"}) all.push_back(stage_sutherland_hodgman(scalar));
  }
  for (const StageContract contract : kStageContracts) {
    if (input.size(contract) == 0) continue;
    for (const batch::Method method : batch::kStageMethods) {
      for (const batch::Build build : {batch::Build::plain, batch::Build::simd}) {
        all.push_back(stage_batch(method, contract, build));
      }
    }
  }
  return all;
}

}  // namespace clipscope::experiments
