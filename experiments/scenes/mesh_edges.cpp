// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/scenes/mesh_edges.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <boost/geometry/algorithms/intersects.hpp>
#include <boost/geometry/geometries/box.hpp>
#include <boost/geometry/geometries/point.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <cmath>
#include <glm/geometric.hpp>
#include <iterator>
#include <numeric>
#include <set>
#include <utility>

#include "experiments/scenes/text_file.hpp"

namespace clipscope::experiments {
namespace {

// For each vertex the lowest index of those with its position.
std::vector<std::uint32_t> welded(const Mesh& mesh) {
  std::vector<std::pair<std::array<float, 3>, std::uint32_t>> order;
  order.reserve(mesh.positions.size());
  for (std::uint32_t i = 0; i < mesh.positions.size(); ++i) {
    order.emplace_back(mesh.positions[i], i);
  }
  std::ranges::sort(order);
  std::vector<std::uint32_t> first(order.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    const auto& [position, vertex] = order[i];
    const bool same = i > 0 && position == order[i - 1].first;
    first[vertex] = same ? first[order[i - 1].second] : vertex;
  }
  return first;
}

std::uint32_t first_vertex(const HalfEdge& side) { return side.ends[0]; }
std::uint32_t first_vertex(const std::array<std::uint32_t, 3>& corners) { return corners[0]; }

// Vertices [first, last).
struct VertexRange {
  std::size_t first, last;
};

// Calls f(range) with all vertices, some at once, so that what is sorted takes little memory.
template <class F>
void for_each_range(std::size_t vertices, const F& f) {
  constexpr std::size_t kRange = std::size_t{1} << 18;
  for (std::size_t first = 0; first < vertices; first += kRange) {
    f(VertexRange{first, std::min(vertices, first + kRange)});
  }
}

// Those that for_each(f) calls f with and whose first vertex is in the range, sorted: a counting
// sort by that vertex, after which each has few to be compared with.
template <class Item, class ForEach>
std::vector<Item> sorted(const VertexRange& range, const ForEach& for_each) {
  const std::size_t vertices = range.last - range.first;
  std::vector<std::size_t> end(vertices + 1);
  const auto for_each_in_range = [&](const auto& f) {
    for_each([&](const Item& item) {
      const std::size_t v = first_vertex(item) - range.first;  // huge where it comes before
      if (v < vertices) f(item, v);
    });
  };
  for_each_in_range([&](const Item&, std::size_t v) { ++end[v + 1]; });
  std::partial_sum(end.begin(), end.end(), end.begin());
  std::vector<Item> items(end.back());
  for_each_in_range([&](const Item& item, std::size_t v) { items[end[v]++] = item; });
  std::size_t begin = 0;
  for (std::size_t v = 0; v < vertices; begin = end[v++]) {
    std::sort(items.begin() + static_cast<std::ptrdiff_t>(begin),
              items.begin() + static_cast<std::ptrdiff_t>(end[v]));
  }
  return items;
}

std::int64_t count_repeated_triangles(const Mesh& mesh, const std::vector<std::uint32_t>& vertex) {
  using Corners = std::array<std::uint32_t, 3>;
  const auto for_each_triangle = [&](const auto& f) {
    for (const auto& [a, b, c] : mesh.triangles) {
      Corners corners = {vertex[a], vertex[b], vertex[c]};
      std::ranges::sort(corners);
      f(corners);
    }
  };
  std::int64_t repeated = 0;
  for_each_range(vertex.size(), [&](const VertexRange& range) {
    auto triangles = sorted<Corners>(range, for_each_triangle);
    repeated += triangles.end() - std::unique(triangles.begin(), triangles.end());
  });
  return repeated;
}

std::vector<HalfEdge> half_edges_of(const Mesh& mesh, const std::vector<std::uint32_t>& vertex,
                                    const VertexRange& range) {
  return sorted<HalfEdge>(range, [&](const auto& f) {
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
      for (int opposite = 0; opposite < 3; ++opposite) {
        const auto [i, j] = ends_of(opposite);
        const auto [a, b] = std::minmax(vertex[mesh.triangles[t][i]], vertex[mesh.triangles[t][j]]);
        if (a != b) f(HalfEdge{{a, b}, t, opposite});
      }
    }
  });
}

using Ends = std::array<std::uint32_t, 2>;

// The vertices of open edges, to be asked which of them lie near a place.
class OpenVertices {
 public:
  OpenVertices(const Mesh& mesh, const std::vector<Ends>& open) {
    std::set<std::uint32_t> vertices;
    for (const Ends& ends : open) vertices.insert(ends.begin(), ends.end());
    std::vector<Entry> entries;
    for (const std::uint32_t v : vertices) entries.emplace_back(corner_of(point_of(mesh, v)), v);
    tree_ = Tree(entries);
  }

  // Those in the box around two points, widened by r.
  std::vector<std::uint32_t> near(const glm::dvec3& a, const glm::dvec3& b, double r) const {
    const IndexBox box(corner_of(glm::min(a, b) - r), corner_of(glm::max(a, b) + r));
    std::vector<std::uint32_t> found;
    for (auto it = tree_.qbegin(boost::geometry::index::intersects(box)); it != tree_.qend();
         ++it) {
      found.push_back(it->second);
    }
    return found;
  }

 private:
  using Corner = boost::geometry::model::point<double, 3, boost::geometry::cs::cartesian>;
  using IndexBox = boost::geometry::model::box<Corner>;
  using Entry = std::pair<Corner, std::uint32_t>;
  using Tree = boost::geometry::index::rtree<Entry, boost::geometry::index::quadratic<16>>;

  static Corner corner_of(const glm::dvec3& p) { return {p.x, p.y, p.z}; }

  Tree tree_;
};

// How far rounding can take a vertex off a place: r of MeshEdges.
double rounding_of(const glm::dvec3& a, const glm::dvec3& b) {
  const glm::dvec3 size = glm::max(glm::abs(a), glm::abs(b));
  return std::sqrt(3.0) * 0x1p-23 * std::max({size.x, size.y, size.z});
}

// How far a point is from the interior of the segment; none if it is as near to an end as `r`, or
// beyond one.
std::optional<double> distance_within(const glm::dvec3& p, const glm::dvec3& a, const glm::dvec3& b,
                                      double r) {
  if (glm::distance(p, a) <= r || glm::distance(p, b) <= r) return std::nullopt;
  const double t = glm::dot(p - a, b - a) / glm::dot(b - a, b - a);
  if (!(0 < t && t < 1)) return std::nullopt;
  return glm::length(glm::cross(p - a, b - a)) / glm::distance(a, b);
}

void count_t_junctions(const Mesh& mesh, const OpenVertices& vertices, const Ends& ends,
                       MeshEdges& edges) {
  const glm::dvec3 a = point_of(mesh, ends[0]), b = point_of(mesh, ends[1]);
  const double r = rounding_of(a, b);
  for (const std::uint32_t v : vertices.near(a, b, r)) {
    if (v == ends[0] || v == ends[1]) continue;
    const std::optional<double> distance = distance_within(point_of(mesh, v), a, b, r);
    if (!distance || *distance > r) continue;
    ++edges.t_junctions;
    edges.t_distance = std::max(edges.t_distance, *distance);
  }
}

// Whether another open edge has the same ends but for rounding.
bool is_split(const Mesh& mesh, const OpenVertices& vertices, const std::vector<Ends>& open,
              const Ends& ends) {
  const glm::dvec3 a = point_of(mesh, ends[0]), b = point_of(mesh, ends[1]);
  const double r = rounding_of(a, b);
  const std::vector<std::uint32_t> near_b = vertices.near(b, b, r);
  for (const std::uint32_t u : vertices.near(a, a, r)) {
    for (const std::uint32_t v : near_b) {
      const auto [low, high] = std::minmax(u, v);
      const Ends other = {low, high};
      if (u == v || other == ends || !std::ranges::binary_search(open, other)) continue;
      return true;
    }
  }
  return false;
}

}  // namespace

std::vector<HalfEdge> half_edges(const Mesh& mesh) {
  return half_edges_of(mesh, welded(mesh), {0, mesh.positions.size()});
}

MeshEdges edges_of(const Mesh& mesh) {
  const std::vector<std::uint32_t> vertex = welded(mesh);
  MeshEdges edges{.repeated_triangles = count_repeated_triangles(mesh, vertex)};
  std::vector<Ends> open;
  for_each_range(vertex.size(), [&](const VertexRange& range) {
    for_each_edge(half_edges_of(mesh, vertex, range), [&](std::span<const HalfEdge> sides) {
      ++edges.edges;
      edges.crowded += sides.size() > 2;
      if (sides.size() == 1) open.push_back(sides[0].ends);
    });
  });
  edges.open = static_cast<std::int64_t>(open.size());
  const OpenVertices vertices(mesh, open);
  for (const Ends& ends : open) {
    count_t_junctions(mesh, vertices, ends, edges);
    edges.split += is_split(mesh, vertices, open, ends);
  }
  return edges;
}

std::string crack_text(const MeshEdges& edges) {
  std::vector<std::string> parts;
  if (edges.t_junctions > 0) {
    parts.push_back(fmt::format("{}, up to {:.2g} off the edge",
                                counted(edges.t_junctions, "T-junction", "T-junctions"),
                                edges.t_distance));
  }
  if (edges.split > 0) {
    parts.push_back(counted(edges.split, "open edge", "open edges") +
                    " beside another one that is the same but for rounding");
  }
  if (edges.crowded > 0) {
    parts.push_back(counted(edges.crowded, "edge", "edges") + " of more than two triangles");
  }
  if (edges.repeated_triangles > 0) {
    parts.push_back(counted(edges.repeated_triangles, "triangle", "triangles") + " given again");
  }
  return fmt::format("{}", fmt::join(parts, "; "));
}

}  // namespace clipscope::experiments
