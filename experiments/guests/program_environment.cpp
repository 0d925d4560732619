// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/guests/program_environment.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <utility>

namespace clipscope::experiments {
namespace {

// Numbers of the scalar as the lines have them, separated by commas.
class NumberList {
 public:
  explicit NumberList(const ProgramForm& form) : form_(form) {}
  NumberList& add(double x) {
    text_ += (text_.empty() ? "" : ",") + number_text(x, form_);
    return *this;
  }
  const std::string& text() const { return text_; }

 private:
  const ProgramForm& form_;
  std::string text_;
};

std::string names_where(std::initializer_list<std::pair<bool, std::string_view>> names) {
  std::string text;
  for (const auto& name : names) {
    if (name.first) text += (text.empty() ? "" : ",") + std::string(name.second);
  }
  return text;
}

// The matrix that our own clippers compute from the frustum in the scalar.
template <class T>
std::string matrix_text(const Frustum<double>& frustum, const ProgramForm& form) {
  NumberList numbers(form);
  for (const Vec4<T>& row : rows_of(projection_from<T>(frustum))) {
    for (int k = 0; k < 4; ++k) numbers.add(row[k]);
  }
  return numbers.text();
}

void add_frustum(const Frustum<double>& f, const ProgramForm& form,
                 std::vector<std::string>& variables) {
  const double far = f.infinite_far ? HUGE_VAL : f.far;
  NumberList numbers(form), shear(form);
  for (const double x : {f.left, f.right, f.bottom, f.top, f.near, far}) numbers.add(x);
  shear.add(f.shear_x).add(f.shear_y);
  const bool perspective = f.kind == ProjectionKind::perspective;
  variables.push_back(
      fmt::format("CLIPSCOPE_{}={}", perspective ? "FRUSTUM" : "ORTHO", numbers.text()));
  variables.push_back("CLIPSCOPE_SHEAR=" + shear.text());
  variables.push_back("CLIPSCOPE_MATRIX=" + (form.format->is_float()
                                                 ? matrix_text<float>(f, form)
                                                 : matrix_text<double>(f, form)));
}

}  // namespace

std::vector<std::string> program_environment(const Batch& batch, const GuestInput& input,
                                             const ProgramForm& form) {
  constexpr std::array<std::string_view, 3> kDepths = {"gl", "zero_to_one", "reversed"};
  const ClipVolume& volume = input.volume;
  const OpenSides& open = volume.open_sides;
  const auto [width, height] = batch.point ? batch.point->viewport : std::array{1.0, 1.0};
  std::vector<std::string> variables = {
      fmt::format("CLIPSCOPE_SPACE={}", input.space == Space::view ? "view" : "clip"),
      fmt::format("CLIPSCOPE_PRIMITIVE={}", to_string(form.primitive)),
      fmt::format("CLIPSCOPE_SCALAR={}", form.format->name),
      fmt::format("CLIPSCOPE_DEPTH={}", kDepths[static_cast<std::size_t>(volume.depth)]),
      fmt::format("CLIPSCOPE_ATTRIBUTES={}", input.attributes),
      fmt::format("CLIPSCOPE_CLIP_DISTANCES={}", volume.clip_distances),
      fmt::format("CLIPSCOPE_DEPTH_CLAMP={}", names_where({{volume.depth_clamp.near, "near"},
                                                           {volume.depth_clamp.far, "far"}})),
      fmt::format("CLIPSCOPE_HALF_OPEN={}", names_where({{open.left, "left"},
                                                         {open.right, "right"},
                                                         {open.bottom, "bottom"},
                                                         {open.top, "top"}})),
      fmt::format("CLIPSCOPE_POINT_SIZE={}", batch.point ? batch.point->size : 0),
      fmt::format("CLIPSCOPE_VIEWPORT={}x{}", width, height)};
  if (input.space == Space::view) add_frustum(batch.frustum, form, variables);
  return variables;
}

}  // namespace clipscope::experiments
