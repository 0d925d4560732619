// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/claims/words.hpp"

#include "experiments/segments/clip_segments.hpp"
#include "experiments/segments/mixes.hpp"
#include "tests/catch.hpp"

namespace clipscope::experiments::claims {
namespace {

using Names = std::vector<std::string>;

TEST_CASE("claims: a pace is told as people say it") {
  CHECK(pace_text(1.27) == "is 27 % faster than");
  CHECK(pace_text(1.27, "up to ") == "is up to 27 % faster than");
  CHECK(pace_text(2.5) == "is 2.5 times as fast as");
  CHECK(pace_text(0.8) == "takes 25 % longer than");
  CHECK(pace_text(0.25) == "takes 4 times as long as");
  CHECK(pace_text(1.004) == "is as fast as");
  CHECK(pace_text(1 / 1.004) == "is as fast as");
}

TEST_CASE("claims: numbers keep three digits, and all before the point") {
  CHECK(number_text(0.8712) == "0.871");
  CHECK(number_text(94.6) == "94.6");
  CHECK(number_text(129510.4) == "129510");
}

TEST_CASE("claims: every mix of segments has words") {
  Names mixes = segments::plane_mixes();
  for (const std::string& mix : segments::builtin_mixes()) mixes.push_back(mix);
  for (const std::string& mix : mixes) {
    INFO(mix);
    CHECK(spoken_lines(mix).find("line") != std::string::npos);
    CHECK(spoken_lines(mix).find('_') == std::string::npos);
  }
  CHECK(spoken_lines("8 edges") == "lines in a polygon of 8 edges");
  CHECK(spoken_triangles("soup in batches") == "the game-like mix in batches");
}

TEST_CASE("claims: a condition names the cases that are fewer") {
  CHECK(where_text({"inside", "beside"}, {"past_corner", "one_end_out"}, spoken_lines) ==
        "The input consists of lines inside or lines beside the window");
  CHECK(where_text({"inside", "beside"}, {"one_end_out"}, spoken_lines) ==
        "The input is anything but lines with one end out");
  CHECK(where_text({"soup"}, {"slivers"}, spoken_triangles) ==
        "The input consists of the game-like mix");
}

TEST_CASE("claims: a mix alone and in batches is one case of a condition") {
  CHECK(where_text({"soup", "slivers in batches", "soup in batches"},
                   {"slivers", "teapot", "teapot in batches"}, spoken_triangles) ==
        "The input consists of the game-like mix alone and in batches or slivers in batches");
}

TEST_CASE("claims: methods of one place are called without it") {
  CHECK(spoken_methods("window/cohen_sutherland", {"window/cyrus_beck"}) ==
        Names{"Cohen-Sutherland", "Cyrus-Beck"});
  CHECK(spoken_methods("window/cohen_sutherland", {"window/skala"}) ==
        Names{"Cohen-Sutherland", "Skala's line clipper"});
  CHECK(spoken_methods("window/cohen_sutherland", {"cvv/cyrus_beck"}) ==
        Names{"Cohen-Sutherland in the window", "Cyrus-Beck after the divide"});
}

TEST_CASE("claims: neighbours on a scale are one case of a condition") {
  const Names low = {"4 edges", "8 edges"}, high = {"16 edges", "32 edges"};
  CHECK(where_text(low, high, spoken_lines) ==
        "The input consists of lines in polygons of up to 8 edges");
  CHECK(where_text(high, low, spoken_lines) ==
        "The input consists of lines in polygons of 16 or more edges");
  CHECK(where_text({"8 edges", "16 edges"}, {"4 edges", "32 edges"}, spoken_lines) ==
        "The input consists of lines in polygons of 8 to 16 edges");
  CHECK(where_text({"box_4", "box_10", "beside"}, {"box_1", "box_2", "inside"}, spoken_lines) ==
        "The input consists of lines in boxes of 4 or more windows or lines beside the window");
  CHECK(where_text({"4 edges", "16 edges"}, {"8 edges", "32 edges"}, spoken_lines) ==
        "The input consists of lines in a polygon of 4 edges or lines in a polygon of 16 edges");
}

TEST_CASE("claims: a condition that would be long counts") {
  const Names holding = {"past_corner", "one_end_out", "both_ends_out", "cross_several"};
  const Names failing = {"window_1_64", "window_1_8", "window_1_1"};
  CHECK(where_text(holding, failing, spoken_lines) == "The input suits it, as 4 of 7 cases do");
}

}  // namespace
}  // namespace clipscope::experiments::claims
