// SPDX-License-Identifier: MIT
//
// Looks up the clipper named on the command line in the list of all, and runs it in float and
// double.
#include <cstdio>
#include <spaces/clippers.hpp>
#include <string_view>

namespace {

using namespace clipscope;

// A triangle that crosses the right plane: the part inside has four vertices.
template <class C, class T>
bool clips_at_the_right() {
  const Projection<T> projection(Frustum<T>{});
  const ViewTriangle<T, 1> triangle = {{{{T(0), T(-1), T(-2)}, {{T(0)}}},
                                        {{T(4), T(0), T(-2)}, {{T(1)}}},
                                        {{T(0), T(1), T(-2)}, {{T(0)}}}}};
  NdcPolygon<T, 1> polygon;
  C{}(projection, triangle, polygon);
  T right(-2);
  for (const NdcVertex<T, 1>& v : polygon) right = larger(right, v.position[0]);
  std::printf("%.*s: %d vertices, rightmost x = %g\n", static_cast<int>(C::name.size()),
              C::name.data(), polygon.size(), static_cast<double>(right));
  return polygon.size() == 4 && right == T(1);
}

// A clipper that there is not in T has nothing to show.
template <class C, class T>
bool clips() {
  if constexpr (!ClipsViewSpace<C, T, 1>) {
    return true;
  } else {
    return clips_at_the_right<C, T>();
  }
}

template <class... Cs>
bool find_and_clip(std::string_view name, TypeList<Cs...>) {
  bool found = false;
  const bool ok =
      ((Cs::name != name || (found = true, clips<Cs, float>() && clips<Cs, double>())) && ...);
  return found && ok;
}

}  // namespace

int main(int, char** argv) { return find_and_clip(argv[1], AllClippers{}) ? 0 : 1; }
