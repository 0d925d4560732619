// SPDX-License-Identifier: MIT
//
// The clippers of segments, points and convex polygons for Python, and the lists of all of them.
#include <span>

#include "spaces/homogeneous/polygon.hpp"
#include "spaces/python/instances.hpp"

namespace clipscope::python {
namespace {

template <class T>
std::vector<Instance<T>> make_instances() {
  std::vector<Instance<T>> all;
  add_triangle_instances<T, 0>(all);
  add_triangle_instances<T, 2>(all);
  add_triangle_instances<T, 3>(all);
  add_triangle_instances<T, 4>(all);
  add_triangle_instances<T, 8>(all);
  add_triangle_instances<T, kRunTime>(all);
  add_instances<T, 4, 2>(AllSegmentClippers{}, all);
  add_instances<T, kRunTime, 2>(AllSegmentClippers{}, all);
  add_instances<T, 4, 1>(AllPointClippers{}, all);
  add_instances<T, kRunTime, 1>(AllPointClippers{}, all);
  return all;
}

template <std::size_t N, class... Cs>
void add_descriptions(TypeList<Cs...> clippers, std::vector<Description>& to) {
  for_each_type(clippers, [&]<class C>() {
    to.push_back({C::name, C::summary, C::source, static_cast<int>(N),
                  ClipsClipSpace<C, float, 4, N>, ClipsViewSpace<C, double, 4, N>, C::promise});
  });
}

// The vertices [first, last) of the arrays, in clip space.
template <class T>
void read_polygon(const Task<T>& task, std::size_t first, std::size_t last,
                  std::vector<ClipVertex<T, kRunTime>>& to) {
  Reader<Space::clip, T, kRunTime, 1> read(task);
  to.clear();
  for (std::size_t v = first; v < last; ++v) to.push_back(read(v, 1)[0][0]);
}

// As a list of vertices that knows its size.
template <class T>
struct Found {
  std::span<const NdcVertex<T, kRunTime>> vertices;
  std::size_t size() const { return vertices.size(); }
  auto begin() const { return vertices.begin(); }
  auto end() const { return vertices.end(); }
};

}  // namespace

template <class T>
const std::vector<Instance<T>>& all_instances() {
  static const std::vector<Instance<T>> all = make_instances<T>();
  return all;
}
template const std::vector<Instance<float>>& all_instances();
template const std::vector<Instance<double>>& all_instances();

std::vector<Description> all_descriptions() {
  std::vector<Description> all;
  add_descriptions<3>(AllClippers{}, all);
  add_descriptions<2>(AllSegmentClippers{}, all);
  add_descriptions<1>(AllPointClippers{}, all);
  return all;
}

template <class T>
void clip_polygons(const Task<T>& task, const std::int64_t* ends, std::size_t first,
                   std::size_t last, Rows<T>& out) {
  HomogeneousPolygonClipper<T, kRunTime> clip;
  std::vector<ClipVertex<T, kRunTime>> polygon;
  for (std::size_t i = first; i < last; ++i) {
    const auto begin = static_cast<std::size_t>(i == 0 ? 0 : ends[i - 1]);
    read_polygon(task, begin, static_cast<std::size_t>(ends[i]), polygon);
    const Found<T> found{clip(task.volume, std::span<const ClipVertex<T, kRunTime>>(polygon))};
    if (found.size() > 0) add_polygon<kRunTime>(found, i, task.numbers(), out);
  }
}
template void clip_polygons(const Task<float>&, const std::int64_t*, std::size_t, std::size_t,
                            Rows<float>&);
template void clip_polygons(const Task<double>&, const std::int64_t*, std::size_t, std::size_t,
                            Rows<double>&);

}  // namespace clipscope::python
