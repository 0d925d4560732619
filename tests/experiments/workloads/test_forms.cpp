// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <set>

#include "experiments/catalogue/catalogue.hpp"
#include "experiments/workloads/forms.hpp"
#include "experiments/workloads/plain_call.hpp"
#include "tests/catch.hpp"
#include "tests/experiments/workloads/drivers.hpp"

namespace clipscope::experiments {
namespace {

HardCase case_of(const char* text) {
  return parse_catalogue("some.cases", std::string("case one\nsource us\nwhy it is plain\n") + text)
      .front();
}

HardCase triangle_case() {
  return case_of(
      "primitive triangle\nspace clip gl\nvertex 0 0 0 1\nvertex 4 0 0 1\nvertex 0 4 1 2\n");
}

DrawCall form(const std::vector<DrawCall>& forms, std::string_view label) {
  const auto found =
      std::ranges::find(forms, "some/one (" + std::string(label) + ")", &DrawCall::name);
  REQUIRE(found != forms.end());
  return *found;
}

std::vector<std::array<float, 4>> positions_of(const DrawCall& call) {
  std::vector<std::array<float, 4>> positions;
  for (const DrawVertex& v : call.vertices) positions.push_back(v.position);
  return positions;
}

}  // namespace

TEST_CASE("forms: a clip-space triangle is drawn first as it is given") {
  const DrawCall plain = forms_of(triangle_case(), able_driver()).front();
  CHECK(plain.name == "some/one");
  CHECK(plain.topology == Topology::triangles);
  CHECK(positions_of(plain) ==
        std::vector<std::array<float, 4>>{{0, 0, 0, 1}, {4, 0, 0, 1}, {0, 4, 1, 2}});
  CHECK(plain.volume == ClipVolume{});
  CHECK(plain.quantities[bit(Quantity::noperspective)]);
  CHECK_FALSE(plain.quantities[bit(Quantity::primitive_id)]);
}

TEST_CASE("forms: a strip has the triangle and another one at its last edge") {
  const DrawCall strip = form(forms_of(triangle_case(), able_driver()), "strip");
  const auto primitives = primitives_of(strip);
  REQUIRE(primitives.size() == 2);
  CHECK(primitives[0] == std::vector<std::uint32_t>{0, 1, 2});
  CHECK(primitives[1] == std::vector<std::uint32_t>{2, 1, 3});
  CHECK(strip.vertices[3].position == std::array<float, 4>{4, 4, 1, 2});
}

TEST_CASE("forms: the other depth range shows the same part of the volume") {
  const DrawCall other = form(forms_of(triangle_case(), able_driver()), "depth 0 to 1");
  CHECK(other.volume.depth == DepthRange::zero_to_one);
  // (z + w) / 2
  CHECK(other.vertices[0].position[2] == 0.5f);
  CHECK(other.vertices[2].position[2] == 1.5f);
}

TEST_CASE("forms: a quantity alone is all that is asked for") {
  const std::vector<DrawCall> forms = forms_of(triangle_case(), able_driver());
  CHECK(form(forms, "primitive_id alone").quantities ==
        Quantities().set(bit(Quantity::primitive_id)));
  CHECK(form(forms, "noperspective alone").quantities ==
        Quantities().set(bit(Quantity::noperspective)));
}

TEST_CASE("forms: a large viewport has the target in its middle and its corners") {
  const std::vector<DrawCall> forms = forms_of(triangle_case(), able_driver());
  CHECK(form(forms, "middle of a large viewport").viewport == Viewport{-4080, -4080, 8192, 8192});
  CHECK(form(forms, "last corner of a large viewport").viewport ==
        Viewport{-8160, -8160, 8192, 8192});
}

TEST_CASE("forms: a view-space triangle is drawn by its clip coordinates") {
  const HardCase c = case_of(
      "primitive triangle\nspace view perspective -1 1 -1 1 1 3 gl\n"
      "vertex 0 0 -1\nvertex 1 0 -2\nvertex 0 1 -3\n");
  // z_clip = -2 z - 3, w = -z.
  CHECK(positions_of(forms_of(c, able_driver()).front()) ==
        std::vector<std::array<float, 4>>{{0, 0, -1, 1}, {1, 0, 1, 2}, {0, 1, 3, 3}});
}

TEST_CASE("forms: clip distances of the case are those of the call") {
  const HardCase c = case_of(
      "primitive triangle\nspace clip gl\nclip_distances 1\n"
      "vertex 0 0 0 1 | 1\nvertex 1 0 0 1 | -2\nvertex 0 1 0 1 | 3\n");
  const DrawCall plain = forms_of(c, able_driver()).front();
  CHECK(plain.volume.clip_distances == 1);
  CHECK(plain.quantities[bit(Quantity::clip_distances)]);
  CHECK(plain.vertices[1].clip_distances[0] == -2);
}

TEST_CASE("forms: a polygon is drawn as triangles and as a fan") {
  const HardCase c = case_of(
      "primitive polygon\nspace clip gl\nvertex 0 0 0 1\nvertex 1 0 0 1\nvertex 1 1 0 1\nvertex 0 1 0 1\n");
  const std::vector<DrawCall> forms = forms_of(c, able_driver());
  CHECK(primitives_of(forms.front()) == primitives_of(form(forms, "fan")));
  CHECK(primitives_of(forms.front()).size() == 2);
}

TEST_CASE("forms: a driver without a case's depth range draws it in the other") {
  const DrawCall plain = forms_of(triangle_case(), poor_driver()).front();
  CHECK(plain.volume.depth == DepthRange::zero_to_one);
  CHECK(plain.vertices[0].position[2] == 0.5f);
  CHECK(plain.provoking == ProvokingVertex::first);
  CHECK(inability(poor_driver(), plain).empty());
}

TEST_CASE("forms: every case of the catalogue has forms of different names, all of numbers") {
  std::set<std::string> names;
  std::size_t count = 0;
  for (const HardCase& c : builtin_catalogue()) {
    for (const DrawCall& call : forms_of(c, able_driver())) {
      names.insert(call.name);
      ++count;
      CHECK(is_finite(call));
      CHECK_FALSE(primitives_of(call).empty());
    }
  }
  CHECK(names.size() == count);
  CHECK(count > 15 * builtin_catalogue().size());
}

TEST_CASE("forms: the vertices of a call differ in their values") {
  std::set<float> seen;
  for (std::size_t i = 0; i < 17; ++i) {
    seen.insert(varying_of(i)[0]);
    CHECK(varying_of(i)[3] == 1);
    for (const float x : varying_of(i)) CHECK((-4 <= x && x <= 4));
  }
  CHECK(seen.size() == 17);
}

}  // namespace clipscope::experiments
