// SPDX-License-Identifier: MIT
//
// The stage's entry points: chooses the instruction set at run time, then the method and the number
// of attributes, which are template parameters below it.
// 0 and 4 attributes have code of their own; other numbers share one.
#include <algorithm>
#include <cassert>

#include "spaces/batch/methods.hpp"
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

// Calls f.template operator()<M, K>() for the method and the number of attributes.
template <class F>
void with_kind(Method method, int attributes, F&& f) {
  with_method(method, [&]<class M>() {
    if constexpr (HasStage<M> && M::simd != Simd::none) {
      if (attributes == 4) return f.template operator()<M, 4>();
      if (attributes == 0) return f.template operator()<M, 0>();
      f.template operator()<M, kRunTime>();
    }
  });
}

void copy(Method method, const ClipVolume& volume, const VertexArray& in, Output& out) {
  with_kind(method, in.attributes,
            [&]<class M, int K>() { Stage<M, K>(volume, in.attributes, out).copy(in); });
}

void reference(Method method, const ClipVolume& volume, const TriangleStreams& in, Output& out) {
  with_kind(method, in.attribute_count,
            [&]<class M, int K>() { Stage<M, K>(volume, in.attribute_count, out).reference(in); });
}

void indexed(Method method, const ClipVolume& volume, const IndexedMesh& in, Output& out) {
  with_kind(method, in.vertices.attributes, [&]<class M, int K>() {
    Stage<M, K>(volume, in.vertices.attributes, out).indexed(in);
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

bool needs_plain(Method method, const ClipVolume& volume, Build build) {
  assert(std::count(kStageMethods.begin(), kStageMethods.end(), method) == 1);
  return build == Build::plain || !is_plain(volume) || !has_simd(method);
}

}  // namespace

void clip(Method method, const ClipVolume& volume, const VertexArray& triangles, Output& out,
          Build build) {
  if (needs_plain(method, volume, build)) return plain::copy(method, volume, triangles, out);
  HWY_DYNAMIC_DISPATCH(copy)(method, volume, triangles, out);
}

void clip(Method method, const ClipVolume& volume, const TriangleStreams& triangles, Output& out,
          Build build) {
  if (needs_plain(method, volume, build)) return plain::reference(method, volume, triangles, out);
  HWY_DYNAMIC_DISPATCH(reference)(method, volume, triangles, out);
}

void clip(Method method, const ClipVolume& volume, const IndexedMesh& mesh, Output& out,
          Build build) {
  if (needs_plain(method, volume, build)) return plain::indexed(method, volume, mesh, out);
  HWY_DYNAMIC_DISPATCH(indexed)(method, volume, mesh, out);
}

std::string target_name() { return HWY_DYNAMIC_DISPATCH(target)(); }

std::string_view name(Method method) {
  std::string_view name;
  with_method(method, [&]<class M>() { name = M::name; });
  return name;
}

}  // namespace clipscope::batch
#endif
