// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/contestants/spoken.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>

#include "experiments/contestants/contestant.hpp"

namespace clipscope::experiments {
namespace {

struct Spoken {
  std::string_view name, words;
};

constexpr std::array kClippers = {
    Spoken{"textbook", "the textbook clipper"},
    Spoken{"view/sutherland_hodgman", "view space"},
    Spoken{"view/exact_sign", "view space with exact signs"},
    Spoken{"view/unit_normals", "view space with unit normals"},
    Spoken{"view/batch", "the view-space batch clipper"},
    Spoken{"homogeneous/sutherland_hodgman", "clip space"},
    Spoken{"homogeneous/near_last", "clip space with the near plane last"},
    Spoken{"homogeneous/w_first_0", "clip space behind a plane w >= 0"},
    Spoken{"homogeneous/w_first_flt_min", "clip space behind a plane at the smallest float"},
    Spoken{"homogeneous/w_first_1_16384", "clip space behind a plane w >= 2^-14"},
    Spoken{"homogeneous/w_first_1e-5", "clip space behind a plane w >= 1e-5"},
    Spoken{"homogeneous/pipeline", "the pipeline of planes"},
    Spoken{"homogeneous/blinn_newell", "Blinn-Newell"},
    Spoken{"homogeneous/guard_band", "the guard band"},
    Spoken{"homogeneous/mcguire", "McGuire's clipper"},
    Spoken{"homogeneous/mcguire_batch", "McGuire's batch clipper"},
    Spoken{"homogeneous/from_inside", "clip space from the inner end"},
    Spoken{"homogeneous/from_outside", "clip space from the outer end"},
    Spoken{"homogeneous/weighted_ends", "clip space with weighted ends"},
    Spoken{"homogeneous/opposite_planes", "clip space by pairs of planes"},
    Spoken{"homogeneous/polygon", "the polygon clipper in clip space"},
    Spoken{"homogeneous/batch", "the clip-space batch clipper"},
    Spoken{"homogeneous/batch_double", "the double batch clipper"},
    Spoken{"cvv/naive", "dividing first with affine attributes"},
    Spoken{"cvv/perspective", "dividing first"},
    Spoken{"cvv/near_first", "dividing behind a near cut"},
    Spoken{"barycentric/distance_matrix", "the distance matrix"},
    Spoken{"barycentric/batch", "the distance-matrix batch clipper"},
    Spoken{"barycentric/correctly_rounded", "the correctly rounded clipper"},
    Spoken{"barycentric/correctly_rounded_batch", "the correctly rounded batch clipper"},
    Spoken{"whole/any_outside", "dropping triangles that reach out"},
    Spoken{"whole/all_outside", "keeping triangles whole"},
    Spoken{"window/liang_barsky_polygon", "Liang-Barsky's polygon clipper"},
    Spoken{"window/maillot", "Maillot's clipper"},
    Spoken{"homogeneous/blinn", "Blinn's line clipper"},
    Spoken{"cvv/liang_barsky_naive", "Liang-Barsky behind a naive divide"},
    Spoken{"cvv/skala_polyhedron", "Skala's polyhedron clipper"},
    Spoken{"window/skala", "Skala's line clipper"},
    Spoken{"window/ray", "Ray's line clipper"},
    Spoken{"convex/extreme_vertices", "Chazelle-Dobkin"},
    Spoken{"convex/skala", "Skala's walk along the boundary"},
    Spoken{"convex/skala_homogeneous", "Skala's homogeneous clipper"},
    Spoken{"convex/skala_logarithmic", "Skala's logarithmic clipper"},
    Spoken{"convex/dual_subdivision", "the prepared dual plane"},
    Spoken{"point/pop", "points that pop"},
    Spoken{"point/pop_free", "points that do not pop"}};

// Methods that several spaces have, or whose names have hyphens.
constexpr std::array kMethods = {
    Spoken{"cohen_sutherland", "Cohen-Sutherland"},
    Spoken{"cyrus_beck", "Cyrus-Beck"},
    Spoken{"cyrus_beck_unit_normals", "Cyrus-Beck with unit normals"},
    Spoken{"kodituwakku_wijeweera_chamikara", "Kodituwakku-Wijeweera-Chamikara"},
    Spoken{"liang_barsky", "Liang-Barsky"},
    Spoken{"liang_barsky_division_free", "Liang-Barsky by products"},
    Spoken{"matthes_drakopoulos", "Matthes-Drakopoulos"},
    Spoken{"nicholl_lee_nicholl", "Nicholl-Lee-Nicholl"},
    Spoken{"sobkow_pospisil_yang", "Sobkow-Pospisil-Yang"},
    Spoken{"sutherland_hodgman", "Sutherland-Hodgman"}};

constexpr std::array kPlaces = {Spoken{"barycentric", "in barycentric coordinates"},
                                Spoken{"cvv", "after the divide"},
                                Spoken{"homogeneous", "in clip space"},
                                Spoken{"view", "in view space"}, Spoken{"window", "in the window"}};

constexpr std::array kScalars = {Spoken{"double_double", "double-double"},
                                 Spoken{"exact", "exact arithmetic"}};

constexpr std::array kSets = {Spoken{"teapot", "the teapot"},
                              Spoken{"floor", "the floor"},
                              Spoken{"corridor", "the corridor"},
                              Spoken{"terrain", "the terrain"},
                              Spoken{"soup", "the game-like mix"},
                              Spoken{"soup_inside", "triangles inside the volume"},
                              Spoken{"soup_outside", "triangles outside the volume"},
                              Spoken{"soup_straddling", "straddling triangles"},
                              Spoken{"soup_behind", "triangles that reach behind the eye"},
                              Spoken{"soup_several_planes", "triangles across several planes"},
                              Spoken{"teapot field", "the field of teapots"},
                              Spoken{"telephoto", "the telephoto view"},
                              Spoken{"overlay", "the overlay"},
                              Spoken{"flat_terrain", "the flat terrain"},
                              Spoken{"game_like", "the game-like mix"},
                              Spoken{"inside", "triangles inside the volume"},
                              Spoken{"outside", "triangles outside the volume"},
                              Spoken{"straddling", "straddling triangles"},
                              Spoken{"several_planes", "triangles across several planes"}};

std::string in_words(std::string_view name) {
  std::string words(name);
  std::ranges::replace(words, '_', ' ');
  std::ranges::replace(words, '/', ' ');
  return words;
}

template <std::size_t N>
std::string words_for(const std::array<Spoken, N>& known, std::string_view name) {
  const auto spoken = std::ranges::find(known, name, &Spoken::name);
  return spoken == known.end() ? in_words(name) : std::string(spoken->words);
}

bool has_one_scalar(std::string_view clipper) {
  std::set<std::string_view> scalars;
  for (const Contestant& c : all_contestants()) {
    if (c.clipper == clipper && c.scalar() != "counting") scalars.insert(c.scalar());
  }
  return scalars.size() == 1;
}

}  // namespace

bool is_guest(std::string_view clipper) {
  return std::ranges::any_of(
      all_contestants(), [&](const Contestant& c) { return c.is_guest && c.clipper == clipper; });
}

std::string spoken_clipper(std::string_view clipper) {
  const auto spoken = std::ranges::find(kClippers, clipper, &Spoken::name);
  if (spoken != kClippers.end()) return std::string(spoken->words);
  if (is_guest(clipper)) return std::string(clipper);
  const std::size_t slash = clipper.find('/');
  if (slash == clipper.npos) return in_words(clipper);
  const std::string method = words_for(kMethods, clipper.substr(slash + 1));
  const auto place = std::ranges::find(kPlaces, clipper.substr(0, slash), &Spoken::name);
  return place == kPlaces.end() ? method : fmt::format("{} {}", method, place->words);
}

std::string spoken_scalar(std::string_view scalar) { return words_for(kScalars, scalar); }

std::string spoken_contestant(std::string_view clipper, std::string_view scalar) {
  const std::string name = spoken_clipper(clipper);
  return has_one_scalar(clipper) ? name : fmt::format("{} in {}", name, spoken_scalar(scalar));
}

std::string spoken_set(std::string_view set) { return words_for(kSets, set); }

}  // namespace clipscope::experiments
