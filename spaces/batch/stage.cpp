// SPDX-License-Identifier: MIT
//
// The stage's entry points: chooses the instruction set at run time, then the method and the number of
// attributes, which are template parameters below it.
// 0 and 4 attributes have code of their own; other numbers share one.
#include "spaces/batch/plain.hpp"

// SSE4, AVX2, AVX-512 and NEON remain: these gain nothing over them, or have vectors of no fixed size.
#define HWY_DISABLED_TARGETS \
  (HWY_SSSE3 | HWY_AVX3_DL | HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128 | HWY_RVV)
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "spaces/batch/stage.cpp"
#include <hwy/foreach_target.h>  // IWYU pragma: keep
#include <hwy/highway.h>

// Without vectors the plain version is the best that there is.
#define CLIPSCOPE_BATCH_HAS_SIMD (HWY_TARGET != HWY_SCALAR && HWY_TARGET != HWY_EMU128)

#if CLIPSCOPE_BATCH_HAS_SIMD
#include "spaces/batch/stage-inl.hpp"
#endif

HWY_BEFORE_NAMESPACE();
namespace clipscope::batch::HWY_NAMESPACE {

const char* target() { return hwy::TargetName(HWY_TARGET); }

#if !CLIPSCOPE_BATCH_HAS_SIMD

using plain::copy;
using plain::indexed;
using plain::reference;

#else

template <int K>
void copy_with(Method method, const ClipVolume& volume, const VertexArray& in, Output& out) {
  switch (method) {
    case Method::homogeneous_double:
      return clip_copy<Method::homogeneous_double, K>(volume, in, out);
    case Method::barycentric: return clip_copy<Method::barycentric, K>(volume, in, out);
    case Method::correctly_rounded: return clip_copy<Method::correctly_rounded, K>(volume, in, out);
    default: return clip_copy<Method::homogeneous, K>(volume, in, out);
  }
}

template <int K>
void reference_with(Method method, const ClipVolume& volume, const TriangleStreams& in,
                    Output& out) {
  switch (method) {
    case Method::homogeneous_double:
      return clip_reference<Method::homogeneous_double, K>(volume, in, out);
    case Method::barycentric: return clip_reference<Method::barycentric, K>(volume, in, out);
    case Method::correctly_rounded:
      return clip_reference<Method::correctly_rounded, K>(volume, in, out);
    default: return clip_reference<Method::homogeneous, K>(volume, in, out);
  }
}

template <int K>
void indexed_with(Method method, const ClipVolume& volume, const IndexedMesh& in, Output& out) {
  switch (method) {
    case Method::homogeneous_double:
      return clip_indexed<Method::homogeneous_double, K>(volume, in, out);
    case Method::barycentric: return clip_indexed<Method::barycentric, K>(volume, in, out);
    case Method::correctly_rounded:
      return clip_indexed<Method::correctly_rounded, K>(volume, in, out);
    default: return clip_indexed<Method::homogeneous, K>(volume, in, out);
  }
}

void copy(Method method, const ClipVolume& volume, const VertexArray& in, Output& out) {
  if (in.attributes == 4) return copy_with<4>(method, volume, in, out);
  if (in.attributes == 0) return copy_with<0>(method, volume, in, out);
  copy_with<kRunTime>(method, volume, in, out);
}

void reference(Method method, const ClipVolume& volume, const TriangleStreams& in, Output& out) {
  if (in.attribute_count == 4) return reference_with<4>(method, volume, in, out);
  if (in.attribute_count == 0) return reference_with<0>(method, volume, in, out);
  reference_with<kRunTime>(method, volume, in, out);
}

void indexed(Method method, const ClipVolume& volume, const IndexedMesh& in, Output& out) {
  if (in.vertices.attributes == 4) return indexed_with<4>(method, volume, in, out);
  if (in.vertices.attributes == 0) return indexed_with<0>(method, volume, in, out);
  indexed_with<kRunTime>(method, volume, in, out);
}

#endif

}  // namespace clipscope::batch::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace clipscope::batch {

HWY_EXPORT(copy);
HWY_EXPORT(reference);
HWY_EXPORT(indexed);
HWY_EXPORT(target);

namespace {

bool needs_plain(const ClipVolume& volume, Build build) {
  return build == Build::plain || volume.depth_clamp || volume.clip_distances != 0;
}

}  // namespace

void clip(Method method, const ClipVolume& volume, const VertexArray& triangles, Output& out,
          Build build) {
  if (needs_plain(volume, build)) return plain::copy(method, volume, triangles, out);
  HWY_DYNAMIC_DISPATCH(copy)(method, volume, triangles, out);
}

void clip(Method method, const ClipVolume& volume, const TriangleStreams& triangles, Output& out,
          Build build) {
  if (needs_plain(volume, build)) return plain::reference(method, volume, triangles, out);
  HWY_DYNAMIC_DISPATCH(reference)(method, volume, triangles, out);
}

void clip(Method method, const ClipVolume& volume, const IndexedMesh& mesh, Output& out,
          Build build) {
  if (needs_plain(volume, build)) return plain::indexed(method, volume, mesh, out);
  HWY_DYNAMIC_DISPATCH(indexed)(method, volume, mesh, out);
}

std::string target_name() { return HWY_DYNAMIC_DISPATCH(target)(); }

std::string_view name(Method method) {
  switch (method) {
    case Method::view: return "view";
    case Method::homogeneous: return "homogeneous";
    case Method::homogeneous_double: return "homogeneous_double";
    case Method::barycentric: return "barycentric";
    case Method::correctly_rounded: return "correctly_rounded";
  }
  return "";
}

}  // namespace clipscope::batch
#endif
