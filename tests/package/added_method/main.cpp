// SPDX-License-Identifier: MIT
//
// Looks up the batch method named on the command line in the list of all, and clips by it: a
// triangle that the right plane cuts to four vertices, in the stage and in the full contract.
#include <algorithm>
#include <cstdio>
#include <spaces/batch/methods.hpp>
#include <string_view>

namespace {

using namespace clipscope;

constexpr std::size_t kStride = 4;

// Whether there is one polygon of four vertices, the rightmost at x = right.
bool is_cut(const batch::Output& out, float right) {
  float rightmost = -1;
  for (std::size_t i = 0; i < out.vertices().size(); i += kStride) {
    rightmost = std::max(rightmost, out.vertices()[i]);
  }
  std::printf("%zu floats, rightmost x = %g\n", out.vertices().size(), rightmost);
  return out.polygons().size() == 1 && out.vertices().size() == 4 * kStride && rightmost == right;
}

bool clips(batch::Method method, batch::Build build) {
  batch::Output out;
  const float in_clip_space[] = {0, -1, 1, 2, 4, 0, 1, 2, 0, 1, 1, 2};
  batch::clip(method, ClipVolume{}, batch::VertexArray{in_clip_space, 3, 0}, out, build);
  const bool stage = is_cut(out, 2);
  const float in_view_space[] = {0, -1, -2, 4, 0, -2, 0, 1, -2};
  batch::clip(method, Projection<float>(Frustum<float>{}),
              batch::ViewVertexArray{in_view_space, 3, 0}, out, build);
  return stage && is_cut(out, 1);
}

}  // namespace

int main(int, char** argv) {
  const std::string_view wanted = argv[1];
  bool found = false, ok = true;
  for_each_type(batch::AllMethods{}, [&]<class M>() {
    const batch::Method method = batch::kMethod<M>;
    if (M::name != wanted || batch::name(method) != wanted) return;
    found = true;
    ok = clips(method, batch::Build::plain) && clips(method, batch::Build::simd);
  });
  const auto has = [](const auto& methods, batch::Method method) {
    return std::count(methods.begin(), methods.end(), method) == 1;
  };
  for_each_type(batch::AllMethods{}, [&]<class M>() {
    ok = ok && has(batch::kStageMethods, batch::kMethod<M>) == batch::HasStage<M> &&
         has(batch::kFullMethods, batch::kMethod<M>) == batch::HasFull<M>;
  });
  return found && ok ? 0 : 1;
}
