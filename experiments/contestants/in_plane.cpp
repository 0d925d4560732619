// SPDX-License-Identifier: GPL-3.0-or-later
//
// The segment clippers of the window as they are published: in the plane, without depth and
// attributes. A source of their own, as the cuts have one (cuts.cpp).
#include <optional>
#include <span>
#include <type_traits>
#include <vector>

#include "experiments/contestants/made.hpp"
#include "spaces/clippers.hpp"

namespace clipscope::experiments {
namespace {

// The method of a clipper that cuts in the window, after the divide.
template <class Method>
std::type_identity<Method> method_in_window(const StartsInClipSpace<DepthCutThenWindow<Method>>&);

template <class C, class T>
concept ClipsInThePlane = requires(const C& clipper) {
  method_in_window(clipper);
  requires SegmentMethod<typename decltype(method_in_window(clipper))::type, RectangleSpace<T>>;
};

// Segments between (x, y, z, 1), of which x and y are clipped by the window in NDC; z is 0 in the
// answers.
template <class Method, Scalar T>
class PlaneRunner final : public Runner {
 public:
  explicit PlaneRunner(std::span<const Batch> batches) {
    for (const Batch& batch : batches) {
      std::vector<Segment2<T>>& segments = parts_.emplace_back(batch.size());
      const std::size_t stride = batch.stride();
      for (std::size_t i = 0; i < 2 * segments.size(); ++i) {
        segments[i / 2][i % 2] = {scalar_from<T>(batch.number(i * stride)),
                                  scalar_from<T>(batch.number(i * stride + 1))};
      }
    }
  }

  void clip(std::size_t batch, std::size_t first, std::size_t count) override {
    const std::span segments = std::span(parts_[batch]).subspan(first, count);
    if (kept_.size() < count) kept_.resize(count), numbers_.resize(count);
    std::size_t visible = 0;
    for (std::size_t i = 0; i < count; ++i) {
      const auto rest = window::clip(Method{}, Rectangle<T>{}, segments[i]);
      if (!rest) continue;
      kept_[visible] = *rest;
      numbers_[visible++] = i;
    }
    visible_ = visible;
    count_ = count;
  }

  Answers answers() const override {
    Answers answers(kFormat<T>, 4);
    for (std::size_t i = 0, next = 0; i < count_; ++i) {
      if (next < visible_ && numbers_[next] == i) {
        for (const Vec2<T>& p : kept_[next]) {
          for (const T& coordinate : {p[0], p[1], T(0), T(1)}) answers.add(coordinate);
        }
        ++next;
      }
      answers.end_polygon();
    }
    return answers;
  }

 private:
  std::vector<std::vector<Segment2<T>>> parts_;
  std::vector<Segment2<T>> kept_;     // what the last call left, one after the other
  std::vector<std::size_t> numbers_;  // of which segment
  std::size_t visible_ = 0, count_ = 0;
};

template <class C, Scalar T>
Contestant make_plane_contestant() {
  using Method = typename decltype(method_in_window(C{}))::type;
  Contestant contestant = describe<C>(kFormat<T>);
  contestant.contract = Contract::plane;
  contestant.vertices = 2;
  contestant.takes_clip_space = true;
  contestant.prepare = [](std::span<const Batch> batches) -> std::unique_ptr<Runner> {
    return std::make_unique<PlaneRunner<Method, T>>(batches);
  };
  return contestant;
}

template <Scalar T, class... Cs>
void add_plane(TypeList<Cs...>, std::vector<Contestant>& all) {
  const auto add = [&]<class C>() {
    if constexpr (ClipsInThePlane<C, T>) all.push_back(make_plane_contestant<C, T>());
  };
  (add.template operator()<Cs>(), ...);
}

}  // namespace

std::vector<Contestant> made_in_plane() {
  std::vector<Contestant> all;
  add_plane<float>(AllSegmentClippers{}, all);
  add_plane<double>(AllSegmentClippers{}, all);
  add_plane<Exact>(AllSegmentClippers{}, all);
  add_plane<Counted>(AllSegmentClippers{}, all);
  return all;
}

}  // namespace clipscope::experiments
