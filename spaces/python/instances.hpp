// SPDX-License-Identifier: MIT
//
// The clippers as they are compiled for Python: each for float and double, for some numbers of
// attributes, in the spaces that it takes. A number of attributes that is not there takes the next
// one that is, with zeros behind, or the one known at run time.
#pragma once

#include <string_view>
#include <vector>

#include "spaces/clippers.hpp"
#include "spaces/python/clip_range.hpp"

namespace clipscope::python {

template <class T>
struct Instance {
  std::string_view name;
  int vertices = 3;                                               // of a primitive
  int attributes = 0;                                             // or kRunTime
  ClipRange<T> in_clip_space = nullptr, in_view_space = nullptr;  // where it takes that space
};

// What is said of a clipper: of one that stands in several lists, by list.
struct Description {
  std::string_view name, summary, source;
  int vertices = 3;
  bool clip_space = false, in_double = false;
  Promise promise;
};

template <class C, class T, int K, std::size_t N>
Instance<T> instance_of() {
  Instance<T> instance{C::name, static_cast<int>(N), K};
  if constexpr (ClipsClipSpace<C, T, K, N>) {
    instance.in_clip_space = clip_range<C, Space::clip, T, K, N>;
  }
  if constexpr (N == 1) {  // whose size is one of clip space
    instance.in_view_space = instance.in_clip_space;
  } else {
    instance.in_view_space = clip_range<C, Space::view, T, K, N>;
  }
  return instance;
}

// Adds those of a list that exist in T.
template <class T, int K, std::size_t N, class... Cs>
void add_instances(TypeList<Cs...> clippers, std::vector<Instance<T>>& to) {
  for_each_type(clippers, [&]<class C>() {
    if constexpr (ClipsViewSpace<C, T, K, N>) to.push_back(instance_of<C, T, K, N>());
  });
}

// Those of triangles, each in a source of its own (triangles.cpp.in).
template <class T, int K>
void add_triangle_instances(std::vector<Instance<T>>& to);

template <class T>
const std::vector<Instance<T>>& all_instances();
std::vector<Description> all_descriptions();

// Clips convex polygons of any size (spaces/homogeneous/polygon.hpp): polygon i of the task has the
// vertices [ends[i - 1], ends[i]) of its arrays, whose `primitive` is then the way from vertex to
// vertex.
template <class T>
void clip_polygons(const Task<T>& task, const std::int64_t* ends, std::size_t first,
                   std::size_t last, Rows<T>& out);

}  // namespace clipscope::python
