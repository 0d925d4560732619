// SPDX-License-Identifier: GPL-3.0-or-later
//
// One build: some clippers in float and double, view space in, NDC polygons out, as contestants do
// it (contestants/typed.hpp). CLIPSCOPE_BUILD is its name.
#include "experiments/cost/builds/build.hpp"

#include <bit>
#include <vector>

#include "experiments/contestants/polygon_stream.hpp"
#include "spaces/barycentric/correctly_rounded.hpp"
#include "spaces/cvv/sutherland_hodgman.hpp"
#include "spaces/homogeneous/sutherland_hodgman.hpp"
#include "spaces/homogeneous/textbook.hpp"
#include "spaces/view/sutherland_hodgman.hpp"

namespace clipscope::experiments {
namespace {

constexpr int K = builds::kAttributes;

template <class C, class T>
class BuiltRunner final : public builds::Runner {
 public:
  explicit BuiltRunner(const builds::Input& input)
      : projection_(frustum_cast<T>(std::bit_cast<Frustum<double>>(input.frustum))),
        triangles_(input.numbers.size() / (3 * (3 + K))) {
    const float* next = input.numbers.data();
    for (ViewTriangle<T, K>& triangle : triangles_) {
      for (ViewVertex<T, K>& v : triangle) {
        for (int c = 0; c < 3; ++c) v.position[c] = T(*next++);
        for (int k = 0; k < K; ++k) v.attributes[k] = T(*next++);
      }
    }
  }

  void clip(std::size_t first, std::size_t count) override {
    out_.clear();
    NdcPolygon<T, K> polygon;
    for (std::size_t i = first; i < first + count; ++i) {
      C{}(projection_, triangles_[i], polygon);
      out_.append(polygon);
    }
  }

  void read_answers(builds::Reader& reader) const override {
    for (std::size_t i = 0; i < out_.size(); ++i) {
      for (const NdcVertex<T, K>& v : out_[i]) {
        for (int c = 0; c < 4; ++c) reader.number(v.position[c]);
        for (int k = 0; k < K; ++k) reader.number(v.attributes[k]);
      }
      reader.end_polygon();
    }
  }

 private:
  Projection<T> projection_;
  std::vector<ViewTriangle<T, K>> triangles_;
  PolygonStream<T, K> out_;
};

template <class C, class T>
constexpr builds::Clipper clipper_in(const char* scalar) {
  return {C::name.data(), scalar, [](const builds::Input& input) -> builds::Runner* {
            return new BuiltRunner<C, T>(input);
          }};
}

constexpr builds::Clipper kClippers[] = {
    clipper_in<Textbook, float>("float"),
    clipper_in<Textbook, double>("double"),
    clipper_in<ViewSutherlandHodgman, float>("float"),
    clipper_in<ViewSutherlandHodgman, double>("double"),
    clipper_in<HomogeneousSutherlandHodgman, float>("float"),
    clipper_in<HomogeneousSutherlandHodgman, double>("double"),
    clipper_in<CvvNearFirst, float>("float"),
    clipper_in<CvvNearFirst, double>("double"),
    clipper_in<CorrectlyRounded, float>("float"),
};

}  // namespace
}  // namespace clipscope::experiments

namespace builds::CLIPSCOPE_BUILD {
std::span<const Clipper> clippers() { return clipscope::experiments::kClippers; }
}  // namespace builds::CLIPSCOPE_BUILD
