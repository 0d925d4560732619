// SPDX-License-Identifier: GPL-3.0-or-later
//
// Sources: The OpenGL Graphics System, version 4.6 core profile, May 5, 2022; OpenGL ES 3.2, May 5,
// 2022, for WebGL 2, whose own OpenGL ES 3.0 has the same sentences under other numbers (named in
// brackets where they differ in meaning, in values.hpp); Vulkan 1.3, chapters Fixed-Function Vertex
// Post-Processing, Rasterization and Fragment Operations.
#include <array>

#include "experiments/pixels/judgement.hpp"

namespace clipscope::experiments {
namespace {

constexpr std::array<std::string_view, 3> kDocuments = {"OpenGL 4.6 core", "Vulkan 1.3",
                                                        "OpenGL ES 3.2"};

// What is broken, and where each document says so, in the order of GraphicsApi.
struct Sentence {
  std::array<std::string_view, 3> sections;
  std::string_view meaning;
};

enum class Shape : std::uint8_t { point, line, polygon };
Shape shape_of(Topology topology) {
  switch (list_of(topology)) {
    case Topology::points: return Shape::point;
    case Topology::lines: return Shape::line;
    default: return Shape::polygon;
  }
}

constexpr Sentence kPointCoverage = {
    {"14.4.1", "Basic Point Rasterization", "13.5.1"},
    "A point has a fragment for each pixel whose centre lies inside of the square around it."};
constexpr Sentence kPointClipping = {
    {"13.7 and 14.4.1",
     "Primitive Clipping (VkPointClippingBehavior) and Basic Point Rasterization",
     "12.5 and 13.5.1"},
    "A point outside of the clip volume is discarded, and another one stays in its square."};
constexpr Sentence kPointValues = {{"14.4.1", "Basic Point Rasterization", "13.5.1"},
                                   "All fragments of a point have the values of its vertex."};
constexpr Sentence kLineCoverage = {
    {"14.5.1", "Basic Line Segment Rasterization", "13.6.1"},
    "A line's fragments are at most a px from those of the ideal rule, at most one more or less."};
constexpr Sentence kLineValues = {
    {"14.5.1", "Basic Line Segment Rasterization", "13.6.1"},
    "Values along a line lie between those of its ends, by the projection of the pixel's centre."};
constexpr Sentence kClipping = {
    {"13.7", "Primitive Clipping", "12.5"},
    "A primitive is clipped to the clip volume: what lies in it is drawn, nothing else is."};
constexpr Sentence kInside = {
    {"14.6.1", "Basic Polygon Rasterization", "13.7.1"},
    "Exactly the pixels whose centres lie inside of the projected polygon have a fragment."};
constexpr Sentence kSharedEdge = {
    {"14.6.1", "Basic Polygon Rasterization", "13.7.1"},
    "A centre on the common edge of two polygons, one on either side, belongs to exactly one."};
constexpr Sentence kConvex = {
    {"14.6.1", "Basic Polygon Rasterization", "13.7.1"},
    "Each value is a convex combination of the values at the polygon's vertices."};
constexpr Sentence kSmooth = {
    {"14.6.1", "Basic Polygon Rasterization, perspective interpolation", "13.7.1"},
    "In a triangle that is not clipped values are interpolated with perspective (a/w over 1/w)."};
constexpr Sentence kLinear = {
    {"14.6.1", "Basic Polygon Rasterization, linear interpolation", "13.7.1"},
    "In a triangle that is not clipped depths and noperspective values are linear in the window."};
constexpr Sentence kFlat = {{"13.6", "Flat Shading", "12.4"},
                            "A flat value is that of the primitive's provoking vertex."};
constexpr Sentence kFragCoord = {
    {"15.2.2", "Built-In Variables, FragCoord", "14.2.2"},
    "FragCoord is the window position of the fragment, and 1 over its w in clip coordinates."};
constexpr Sentence kDepth = {
    {"14.6.1 and 17.3.4", "Basic Polygon Rasterization; Depth Clamping and Range Adjustment",
     "13.7.1"},
    "A depth lies between those of the polygon's vertices, clamped where depth clamp is on."};
constexpr Sentence kFacing = {
    {"14.6.1 and 15.2.2", "Basic Polygon Rasterization", "13.7.1 and 14.2.2"},
    "A polygon faces by the sign of its area in the window."};
constexpr Sentence kFrontFacing = {{"15.2.2", "Built-In Variables, FrontFacing", "14.2.2"},
                                   "Fragments that come from no triangle are front-facing."};
constexpr Sentence kPrimitiveId = {
    {"15.2.2", "Built-In Variables, PrimitiveId", "14.2.2"},
    "The first primitive of a draw is number 0, and each one counts."};
constexpr Sentence kCrash = {
    {"2.3.4.1", "Fundamentals, Valid Usage", "2.3.4.1"},
    "Whatever numbers a valid command brings, they don't end or stall the program."};

Sentence coverage_sentence(Shape shape) {
  switch (shape) {
    case Shape::point: return kPointCoverage;
    case Shape::line: return kLineCoverage;
    case Shape::polygon: break;
  }
  return kInside;
}

Sentence exact_value_sentence(Shape shape, Quantity quantity) {
  const bool is_place = quantity == Quantity::frag_coord;
  if (shape == Shape::point) return is_place ? kFragCoord : kPointValues;
  if (shape == Shape::line) return is_place ? kFragCoord : kLineValues;
  switch (quantity) {
    case Quantity::smooth:
    case Quantity::clip_distances: return kSmooth;
    case Quantity::frag_coord: return kFragCoord;
    default: return kLinear;
  }
}

Sentence hull_sentence(Shape shape, Quantity quantity) {
  if (shape == Shape::point) return kPointValues;
  if (shape == Shape::line) return kLineValues;
  return quantity == Quantity::depth ? kDepth : kConvex;
}

// A pixel that is hit twice, or one where nothing is to be seen.
Sentence extra_sentence(Shape shape, Quantity quantity) {
  if (quantity != Quantity::covered) return coverage_sentence(shape);
  return shape == Shape::point ? kPointClipping : kClipping;
}

Sentence sentence_of(Shape shape, ViolationKind kind, Quantity quantity) {
  switch (kind) {
    case ViolationKind::not_finite:
    case ViolationKind::outside_hull: return hull_sentence(shape, quantity);
    case ViolationKind::wrong_value: return exact_value_sentence(shape, quantity);
    case ViolationKind::extra: return extra_sentence(shape, quantity);
    case ViolationKind::missing:
    case ViolationKind::primitive_lost:
    case ViolationKind::zero_area: return coverage_sentence(shape);
    case ViolationKind::shared_edge: return kSharedEdge;
    case ViolationKind::flat_value: return kFlat;
    case ViolationKind::facing: return shape == Shape::polygon ? kFacing : kFrontFacing;
    case ViolationKind::primitive_id: return kPrimitiveId;
    case ViolationKind::crashed:
    case ViolationKind::timed_out: return kCrash;
  }
  return kInside;
}

}  // namespace

Clause clause_of(GraphicsApi api, Topology topology, ViolationKind kind, Quantity quantity) {
  const Sentence sentence = sentence_of(shape_of(topology), kind, quantity);
  if (api == GraphicsApi::webgl && quantity == Quantity::noperspective) {
    // Which OpenGL ES has by this extension alone; its sections are those of OpenGL ES 3.1.
    const bool is_line = shape_of(topology) == Shape::line;
    return {"NV_shader_noperspective_interpolation", is_line ? "13.4.1" : "13.5.1",
            sentence.meaning};
  }
  const auto document = static_cast<std::size_t>(api);
  return {kDocuments[document], sentence.sections[document], sentence.meaning};
}

}  // namespace clipscope::experiments
