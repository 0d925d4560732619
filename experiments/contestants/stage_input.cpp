// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/contestants/stage_input.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <map>
#include <numeric>
#include <random>
#include <span>
#include <utility>

#include "experiments/scenes/builtin.hpp"
#include "experiments/scenes/scene.hpp"
#include "spaces/planes.hpp"

namespace clipscope::experiments {
namespace {

constexpr std::size_t kSampledOfMesh = 100'000;  // triangles for clippers that take no mesh

// Vertices in clip space, and as many attributes as wanted: the scene's, again and again.
void append_triangle(const Projection<float>& projection, const SceneTriangle& triangle,
                     int attributes, std::vector<float>& out) {
  for (const auto& vertex : triangle) {
    const Vec4<float> clip = to_clip(projection, vertex.position);
    for (int c = 0; c < 4; ++c) out.push_back(clip[c]);
    for (int k = 0; k < attributes; ++k) out.push_back(vertex.attributes[k % kSceneAttributes]);
  }
}

void set_streams(StageInput& input) {
  const std::size_t triangles = input.array_size();
  for (std::size_t v = 0; v < 3; ++v) {
    for (std::size_t c = 0; c < 4; ++c) {
      std::vector<float>& stream = input.positions[v][c];
      stream.resize(triangles);
      for (std::size_t t = 0; t < triangles; ++t) stream[t] = input.vertex(Contract::copy, t, v)[c];
    }
  }
  input.stream_attributes.reserve(3 * triangles * static_cast<std::size_t>(input.attributes));
  for (std::size_t t = 0; t < 3 * triangles; ++t) {
    const float* vertex = input.vertices.data() + t * input.stride();
    input.stream_attributes.insert(input.stream_attributes.end(), vertex + 4,
                                   vertex + input.stride());
  }
}

}  // namespace

std::size_t StageInput::size(Contract contract) const {
  if (contract == Contract::indexed) return indices.size() / 3;
  return indices.empty() ? array_size() : 0;
}

batch::VertexArray StageInput::array(std::size_t first, std::size_t count) const {
  return {vertices.data() + 3 * first * stride(), 3 * count, attributes};
}

batch::TriangleStreams StageInput::streams(std::size_t first, std::size_t count) const {
  batch::TriangleStreams result{
      .positions = {},
      .count = count,
      .attributes = stream_attributes.data() + 3 * first * static_cast<std::size_t>(attributes),
      .attribute_count = attributes};
  for (std::size_t v = 0; v < 3; ++v) {
    for (std::size_t c = 0; c < 4; ++c) result.positions[v][c] = positions[v][c].data() + first;
  }
  return result;
}

std::span<const float> StageInput::draw_vertices(std::size_t triangle) const {
  const std::span<const float> all(mesh_vertices);
  if (draw_triangles == 0) return all;
  const std::size_t draw = triangle / draw_triangles, begin = draw_begins[draw];
  const std::size_t end =
      draw + 1 < draw_begins.size() ? draw_begins[draw + 1] : all.size() / stride();
  return all.subspan(begin * stride(), (end - begin) * stride());
}

batch::IndexedMesh StageInput::mesh(std::size_t first, std::size_t count) const {
  assert(draw_triangles == 0 || first % draw_triangles + count <= draw_triangles);
  const std::span<const float> of_draw = draw_vertices(first);
  return {{of_draw.data(), of_draw.size() / stride(), attributes},
          std::span(indices).subspan(3 * first, 3 * count)};
}

const float* StageInput::vertex(Contract contract, std::size_t triangle, std::size_t v) const {
  if (contract == Contract::indexed) {
    return draw_vertices(triangle).data() + indices[3 * triangle + v] * stride();
  }
  return vertices.data() + (3 * triangle + v) * stride();
}

StageInput soup_input(std::string name, const ClipVolume& volume, int attributes,
                      std::vector<float> vertices) {
  StageInput input{.name = std::move(name),
                   .volume = volume,
                   .attributes = attributes,
                   .vertices = std::move(vertices)};
  set_streams(input);
  return input;
}

StageInput random_input(const std::string& name, const SoupShares& shares, std::size_t triangles,
                        int attributes, std::uint64_t seed) {
  Scene scene;
  scene.views = {identity_view()};
  const View& view = scene.views.front();
  scene.mesh = make_soup(shares, triangles, seed, view.frustum);
  const Projection<float> projection(view.frustum);
  std::vector<float> vertices;
  vertices.reserve(3 * triangles * static_cast<std::size_t>(4 + attributes));
  std::vector<SceneTriangle> some(1024);
  for (std::size_t first = 0; first < triangles; first += some.size()) {
    some.resize(std::min(some.size(), triangles - first));
    view_triangles(scene, view, first, some);
    for (const SceneTriangle& t : some) append_triangle(projection, t, attributes, vertices);
  }
  return soup_input(name, projection.volume, attributes, std::move(vertices));
}

StageInput scene_input(const Scene& scene, std::size_t limit) {
  std::vector<float> vertices;
  std::vector<std::pair<const SampledView*, std::size_t>> order;
  const std::vector<SampledView> views = sampled_views(scene, limit);
  for (const SampledView& batch : views) {
    for (std::size_t i = 0; i < batch.triangles.size(); ++i) order.emplace_back(&batch, i);
  }
  std::mt19937_64 generator(1);
  for (std::size_t i = order.size(); i > 1; --i) std::swap(order[i - 1], order[generator() % i]);
  for (const auto& [batch, i] : order) {
    append_triangle(Projection<float>(batch->view.frustum), batch->triangles[i], kSceneAttributes,
                    vertices);
  }
  const ClipVolume volume{.depth = scene.views.front().frustum.depth};
  return soup_input(scene.name, volume, kSceneAttributes, std::move(vertices));
}

StageInput mesh_input(const Scene& scene, const View& view) {
  const Projection<float> projection(view.frustum);
  StageInput input{.name = scene.name + ": " + view.label, .volume = projection.volume};
  const std::size_t stride = input.stride();
  input.mesh_vertices.resize(scene.mesh.positions.size() * stride);
  const Spacing spacing = spacing_of(scene, kSampledOfMesh);
  std::vector<SceneTriangle> some(1);
  for (std::size_t t = 0; t < scene.mesh.triangles.size(); ++t) {
    view_triangles(scene, view, t, some);
    std::vector<float> vertices;
    append_triangle(projection, some.front(), kSceneAttributes, vertices);
    for (std::size_t v = 0; v < 3; ++v) {
      const std::uint32_t index = scene.mesh.triangles[t][v];
      input.indices.push_back(index);
      std::copy_n(vertices.begin() + static_cast<std::ptrdiff_t>(v * stride), stride,
                  input.mesh_vertices.begin() + static_cast<std::ptrdiff_t>(index * stride));
    }
    if (t % spacing.stride == 0) {
      input.vertices.insert(input.vertices.end(), vertices.begin(), vertices.end());
    }
  }
  return input;
}

StageInput in_draws(const StageInput& mesh, std::size_t triangles) {
  assert(mesh.draw_triangles == 0 && mesh.size(Contract::indexed) > 0 && triangles > 0);
  StageInput draws = mesh;
  draws.draw_triangles = triangles;
  draws.mesh_vertices.clear();
  std::map<std::uint32_t, std::uint32_t> numbers;  // in the draw, by those in the mesh
  for (std::size_t i = 0; i < mesh.indices.size(); ++i) {
    if (i % (3 * triangles) == 0) {
      draws.draw_begins.push_back(draws.mesh_vertices.size() / mesh.stride());
      numbers.clear();
    }
    const auto next = static_cast<std::uint32_t>(numbers.size());
    const auto [number, is_new] = numbers.try_emplace(mesh.indices[i], next);
    draws.indices[i] = number->second;
    if (!is_new) continue;
    const auto vertex =
        std::span(mesh.mesh_vertices).subspan(mesh.indices[i] * mesh.stride(), mesh.stride());
    draws.mesh_vertices.insert(draws.mesh_vertices.end(), vertex.begin(), vertex.end());
  }
  return draws;
}

StageInput shuffled_copies(const StageInput& soup, std::size_t triangles, std::uint64_t seed) {
  assert(soup.size(Contract::copy) > 0);
  const std::size_t floats = 3 * soup.stride();
  std::vector<std::size_t> order(soup.array_size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::vector<float> vertices;
  vertices.reserve((triangles + order.size()) * floats);
  Random random(seed);
  while (vertices.size() < triangles * floats) {
    random.shuffle(std::span(order));
    for (const std::size_t t : order) {
      const auto triangle = std::span(soup.vertices).subspan(t * floats, floats);
      vertices.insert(vertices.end(), triangle.begin(), triangle.end());
    }
  }
  return soup_input(soup.name, soup.volume, soup.attributes, std::move(vertices));
}

StageShares shares_of(const StageInput& input, Contract contract) {
  std::size_t inside = 0, outside = 0, behind = 0;
  std::array<std::size_t, 3> by_planes{};  // 1, 2, more
  const std::size_t triangles = input.size(contract);
  for (std::size_t t = 0; t < triangles; ++t) {
    Outcode all = ~Outcode{0}, any = 0;
    bool is_behind = false;
    for (std::size_t v = 0; v < 3; ++v) {
      const float* p = input.vertex(contract, t, v);
      const Outcode code = clip_outcode(input.volume.depth, Vec4<float>(p[0], p[1], p[2], p[3]));
      all &= code;
      any |= code;
      is_behind |= p[3] < 0;
    }
    inside += any == 0;
    outside += all != 0;
    if (any == 0 || all != 0) continue;
    ++by_planes[static_cast<std::size_t>(std::min(std::popcount(any), 3)) - 1];
    behind += is_behind;
  }
  const auto percent = [](std::size_t part, std::size_t whole) {
    return 100 * static_cast<double>(part) / static_cast<double>(std::max<std::size_t>(1, whole));
  };
  const std::size_t cut = triangles - inside - outside;
  return {.inside = percent(inside, triangles),
          .outside = percent(outside, triangles),
          .straddling = percent(cut, triangles),
          .one_plane = percent(by_planes[0], cut),
          .two_planes = percent(by_planes[1], cut),
          .more_planes = percent(by_planes[2], cut),
          .behind_eye = percent(behind, cut)};
}

}  // namespace clipscope::experiments
