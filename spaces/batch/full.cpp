// SPDX-License-Identifier: MIT
//
// The full contract's entry point: chooses the instruction set at run time, then the method and the number of
// attributes (see stage.cpp).
#include "spaces/batch/plain.hpp"
#include "spaces/batch/targets.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "spaces/batch/full.cpp"
#include <hwy/foreach_target.h>  // IWYU pragma: keep
#include <hwy/highway.h>

#if CLIPSCOPE_BATCH_HAS_SIMD
#include "spaces/batch/full_rounded-inl.hpp"
#endif

HWY_BEFORE_NAMESPACE();
namespace clipscope::batch::HWY_NAMESPACE {

#if CLIPSCOPE_BATCH_HAS_SIMD

template <int K>
void full_with(Method method, const Projection<float>& projection, const ViewVertexArray& in,
               Output& out) {
  const int n = in.attributes;
  switch (method) {
    case Method::view: return FullClipper<Method::view, K>(projection, n)(in, out);
    case Method::homogeneous: return FullClipper<Method::homogeneous, K>(projection, n)(in, out);
    case Method::homogeneous_double:
      return FullClipper<Method::homogeneous_double, K>(projection, n)(in, out);
    case Method::barycentric: return FullClipper<Method::barycentric, K>(projection, n)(in, out);
    case Method::correctly_rounded: return FullRoundedClipper<K>(projection, n)(in, out);
  }
}

// Distances to the planes of a sheared volume are not exact in double.
bool needs_plain(Method method, const Frustum<float>& f) {
  return method == Method::correctly_rounded && (f.shear_x != 0 || f.shear_y != 0);
}

void full(Method method, const Projection<float>& projection, const ViewVertexArray& in,
          Output& out) {
  if (needs_plain(method, projection.frustum)) return plain::full(method, projection, in, out);
  if (in.attributes == 4) return full_with<4>(method, projection, in, out);
  full_with<kRunTime>(method, projection, in, out);
}

#else

void full(Method method, const Projection<float>& projection, const ViewVertexArray& in,
          Output& out) {
  plain::full(method, projection, in, out);
}

#endif

}  // namespace clipscope::batch::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace clipscope::batch {

HWY_EXPORT(full);

void clip(Method method, const Projection<float>& projection, const ViewVertexArray& triangles,
          Output& out, Build build) {
  const ClipVolume& volume = projection.volume;
  if (build == Build::plain || volume.depth_clamp || volume.clip_distances != 0) {
    return plain::full(method, projection, triangles, out);
  }
  HWY_DYNAMIC_DISPATCH(full)(method, projection, triangles, out);
}

}  // namespace clipscope::batch
#endif
