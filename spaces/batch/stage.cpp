// SPDX-License-Identifier: MIT
//
// The stage's entry points: chooses the instruction set at run time, then the method and the number of
// attributes, which are template parameters below it.
// 0 and 4 attributes have code of their own; other numbers share one.
#include "spaces/batch/plain.hpp"
#include "spaces/batch/targets.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "spaces/batch/stage.cpp"
#include <hwy/foreach_target.h>  // IWYU pragma: keep
#include <hwy/highway.h>

#if CLIPSCOPE_BATCH_HAS_SIMD
#include "spaces/batch/stage-inl.hpp"
#endif

HWY_BEFORE_NAMESPACE();
namespace clipscope::batch::HWY_NAMESPACE {

const char* target() { return CLIPSCOPE_BATCH_HAS_SIMD ? hwy::TargetName(HWY_TARGET) : "plain"; }

#if !CLIPSCOPE_BATCH_HAS_SIMD

using plain::copy;
using plain::indexed;
using plain::reference;

#else

// A method and a number of attributes as types.
template <Method kMethod, int K>
struct Kind {
  static constexpr Method method = kMethod;
  static constexpr int attributes = K;
};

template <int K, class F>
void with_method(Method method, F&& f) {
  switch (method) {
    case Method::homogeneous_double: return f(Kind<Method::homogeneous_double, K>());
    case Method::barycentric: return f(Kind<Method::barycentric, K>());
    case Method::correctly_rounded: return f(Kind<Method::correctly_rounded, K>());
    default: return f(Kind<Method::homogeneous, K>());
  }
}

template <class F>
void with_kind(Method method, int attributes, F&& f) {
  if (attributes == 4) return with_method<4>(method, f);
  if (attributes == 0) return with_method<0>(method, f);
  with_method<kRunTime>(method, f);
}

void copy(Method method, const ClipVolume& volume, const VertexArray& in, Output& out) {
  with_kind(method, in.attributes, [&]<class K>(K) {
    Stage<K::method, K::attributes>(volume, in.attributes, out).copy(in);
  });
}

void reference(Method method, const ClipVolume& volume, const TriangleStreams& in, Output& out) {
  with_kind(method, in.attribute_count, [&]<class K>(K) {
    Stage<K::method, K::attributes>(volume, in.attribute_count, out).reference(in);
  });
}

void indexed(Method method, const ClipVolume& volume, const IndexedMesh& in, Output& out) {
  with_kind(method, in.vertices.attributes, [&]<class K>(K) {
    Stage<K::method, K::attributes>(volume, in.vertices.attributes, out).indexed(in);
  });
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
