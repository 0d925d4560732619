// SPDX-License-Identifier: MIT
//
// The full contract's entry point: chooses the instruction set at run time, then the method and the
// number of attributes (see stage.cpp).
#include "spaces/batch/methods.hpp"
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

template <class M, int K>
void full_with(const Projection<float>& projection, const ViewVertexArray& in, Output& out) {
  if constexpr (!M::promise.correctly_rounded) {
    FullClipper<M, K>(projection, in.attributes)(in, out);
  } else if (FullRoundedClipper<M, K>::takes(projection.frustum)) {
    FullRoundedClipper<M, K>(projection, in.attributes)(in, out);
  } else {
    plain::full(kMethod<M>, projection, in, out);
  }
}

void full(Method method, const Projection<float>& projection, const ViewVertexArray& in,
          Output& out) {
  with_method(method, [&]<class M>() {
    if constexpr (HasFull<M> && M::simd != Simd::none) {
      if (in.attributes == 4) return full_with<M, 4>(projection, in, out);
      full_with<M, kRunTime>(projection, in, out);
    }
  });
}

#else

using plain::full;

#endif

}  // namespace clipscope::batch::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace clipscope::batch {

HWY_EXPORT(full);

void clip(Method method, const Projection<float>& projection, const ViewVertexArray& triangles,
          Output& out, Build build) {
  if (build == Build::plain || !is_plain(projection.volume) || !has_simd(method)) {
    return plain::full(method, projection, triangles, out);
  }
  HWY_DYNAMIC_DISPATCH(full)(method, projection, triangles, out);
}

}  // namespace clipscope::batch
#endif
