// SPDX-License-Identifier: GPL-3.0-or-later
#include <set>

#include "experiments/claims/claim.hpp"
#include "tests/catch.hpp"
#include "tests/experiments/claims/fabricated.hpp"

using namespace clipscope::experiments;

namespace {

// A run in which every claim is confirmed, each table as small as its judges allow.
TableTexts all_confirmed() {
  TableTexts t;
  t["cost"] =
      "mix;clipper;scalar;ns_per_triangle;speedup_to_textbook;speedup_low;speedup_high\n"
      "soup;view/sutherland_hodgman;float;50;2;1.9;2.1\n"
      "soup;view/exact_sign;float;60;1.6;1.5;1.7\n"
      "soup;homogeneous/sutherland_hodgman;float;25;4;3.9;4.1\n"
      "soup;homogeneous/pipeline;float;26;3.9;3.8;4\n"
      "soup;cvv/near_first;float;33;3;2.9;3.1\n"
      "soup;cvv/naive;float;30;3;2.9;3.1\n"
      "soup;cvv/perspective;float;33;3;2.9;3.1\n"
      "soup;barycentric/distance_matrix;float;30;3;2.9;3.1\n"
      "soup;view/batch;float;10;10;9.9;10.1\n"
      "soup;homogeneous/batch;float;5;20;19.9;20.1\n"
      "soup;barycentric/batch;float;6;17;16.9;17.1\n"
      "soup;whole/any_outside;float;12;8;7.9;8.1\n";
  t["cost_operations"] =
      "mix;clipper;additions;multiplications;divisions;comparisons\n"
      "soup;view/sutherland_hodgman;20;30;4;20\n"
      "soup;homogeneous/sutherland_hodgman;10;10;4;20\n"
      "soup;cvv/near_first;12;10;8;20\n"
      "soup;cvv/naive;12;10;12;20\n";
  t["accuracy"] =
      "scene;clipper;scalar;max_px\n"
      "teapot;view/sutherland_hodgman;float;0\n"
      "teapot;homogeneous/sutherland_hodgman;float;0\n";
  t["perspective_clip"] =
      "clipper;scalar;max_error\ncvv/naive;exact;0.4\ncvv/perspective;exact;0\n";
  t["frontier"] =
      "set;contract;clipper;scalar;ns_per_triangle;correctly_rounded_percent;wrong_percent\n"
      "soup;full;homogeneous/sutherland_hodgman;float;25;80;0\n"
      "soup;full;homogeneous/sutherland_hodgman;exact;2500;100;0\n"
      "soup;copy;homogeneous/batch;float;5;80;0\n"
      "soup;copy;barycentric/correctly_rounded_batch;float;50;100;0\n";
  t["pictures"] = "scene;clipper;holes_px\nfloor;whole/any_outside;900\n";
  t["hard_cases"] =
      "primitive;clipper;scalar;failures\n"
      "triangle;homogeneous/sutherland_hodgman;float;20\n"
      "triangle;homogeneous/w_first_1_16384;float;20\n"
      "triangle;homogeneous/w_first_1e-5;float;19\n";
  t["w_sign_prevented"] =
      "clipper;zero_w\nhomogeneous/sutherland_hodgman;7\nhomogeneous/w_first_1e-5;0\n";
  t["w_sign_epsilon"] = "clipper;lost_percent\nhomogeneous/w_first_1e-5;0\n";
  t["plane_order"] =
      "set;exact_triangles;exact_mixed_w;exact_differs;exact_wrong;float_differs;"
      "float_differs_percent;max_px;float_wrong_near_first;float_wrong_near_last\n"
      "all;1000;400;0;3;0;0;0;10;10\n";
  t["segments"] =
      "mix;clipper;scalar;speedup_to_cohen_sutherland;speedup_low;speedup_high\n"
      "inside;homogeneous/liang_barsky;float;1;0.9;1.1\n"
      "outside;homogeneous/liang_barsky;float;1;0.9;1.1\n";
  t["segments_operations"] =
      "mix;clipper;rejected_percent;rejected_free_percent;divisions_per_accepted;"
      "divisions_per_rejected;divisions_per_shortened;moved_ends_per_shortened\n"
      "window_1_64;homogeneous/cohen_sutherland;90;90;0;0.1;1.2;1\n"
      "cross_several;homogeneous/cohen_sutherland;0;-;0;-;2.5;1.5\n"
      "window_1_64;homogeneous/liang_barsky;90;90;0;0;1.2;1\n";
  t["segments_intersection"] =
      "form;multiplications;divisions\n"
      "any plane: n . (x - p) >= 0;6;1\n"
      "side of the frustum in view space: near x + left z >= 0;4;1\n"
      "clip space, perspective: w + x >= 0;0;1\n"
      "clip space, oblique parallel;0;1\n";
  t["bounds"] = "scene;bound;closer_percent;visible_lost\nteapots;box;20;0\nteapots;sphere;30;0\n";
  t["guard_band_points"] = "scene;drawn;differ\nfloor;1000;0\n";
  t["guard_band_pictures"] = "scene;vertices;holes_px;extra_px\nfloor;float;0;0\n";
  t["depth"] =
      "convention;buffer;transform;far_near_ratio;misordered_percent;tied_percent\n"
      "reversed;float32;float;1000;0;1\n"
      "zero_to_one;float32;float;1000;2;10\n"
      "gl;float32;float;1000;2;12\n";
  t["depth_monotone"] =
      "form;property;arithmetic;violations\n"
      "linear;monotone;exact;0\n"
      "linear;lines stay straight;exact;0\n"
      "quadratic;lines stay straight;exact;99\n"
      "quadratic;nearer wins;exact;12\n";
  t["claims_clipless"] = "scene;speedup\nfloor;1.5\n";
  t["claims_counts"] =
      "quantity;cases;count\n"
      "disagrees, depth [-1, 1];100;0\n"
      "disagrees, depth [0, 1];100;0\n"
      "disagrees, depth reversed;100;0\n"
      "fan triangles wound the other way, cut in clip space;100;0\n"
      "fan triangles wound the other way, divided first;100;0\n"
      "leaves 4 vertices;100;100\n"
      "leaves fewer: another vertex is on the plane;100;0\n"
      "leaves anything else;100;0\n"
      "attribute at t in clip space is wrong;100;0\n"
      "attribute at t after the divide is wrong;100;0\n"
      "corners off the plane, aspect 1;5;0\n"
      "corners off the plane, aspect not 1;20;0\n"
      "a convex polygon leaves one that is not;100;0\n"
      "a concave polygon leaves several;100;30\n"
      "t in clip space is not t in view space;100;0\n"
      "t after the divide is not t in view space;100;99\n"
      "denominator 0;100;0\n"
      "denominator overflows;100;1\n"
      "9 vertices;100;5\n"
      "more than 9 vertices;100;0\n"
      "view/sutherland_hodgman differs;100;0\n"
      "homogeneous/sutherland_hodgman differs;100;0\n"
      "cvv/near_first differs;100;0\n"
      "clip coordinates are (1, 1, -20/9, 0);1;1\n";
  return t;
}

// What one changed row makes of a claim.
struct Alteration {
  int claim;
  std::string table, before, after;
  ClaimVerdict verdict;
};

constexpr auto kConditional = ClaimVerdict::conditional;
constexpr auto kRefuted = ClaimVerdict::refuted;
constexpr auto kConfirmed = ClaimVerdict::confirmed;

const std::vector<Alteration>& alterations() {
  static const std::vector<Alteration> all = {
      {1, "cost", "view/sutherland_hodgman;float;50;2;1.9;2.1",
       "view/sutherland_hodgman;float;20;5;4.9;5.1", kConditional},
      {1, "cost", "view/batch;float;10;10;9.9;10.1", "view/batch;float;5;20;19.9;20.1",
       kConditional},
      {2, "cost", "cvv/near_first;float;33;3;2.9;3.1", "cvv/near_first;float;25;4;3.9;4.1",
       kConditional},
      {2, "cost", "homogeneous/batch;float;5;20;19.9;20.1",
       "homogeneous/batch;float;10;10;9.9;10.1", kConditional},
      {3, "cost", "cvv/near_first;float;33;3;2.9;3.1", "cvv/near_first;float;20;5;4.9;5.1",
       kRefuted},
      {4, "perspective_clip", "naive;exact;0.4", "naive;exact;0", kRefuted},
      {4, "perspective_clip", "perspective;exact;0", "perspective;exact;0.1", kRefuted},
      {5, "claims_counts", "depth [0, 1];100;0", "depth [0, 1];100;8", kConditional},
      {5, "claims_counts", "depth [-1, 1];100;0", "depth [-1, 1];100;1", kRefuted},
      {6, "claims_counts", "divided first;100;0", "divided first;100;4", kConditional},
      {6, "claims_counts", "cut in clip space;100;0", "cut in clip space;100;4", kRefuted},
      {7, "pictures", "any_outside;900", "any_outside;0", kRefuted},
      {7, "cost", "any_outside;float;12;8;7.9;8.1", "any_outside;float;26;3.9;3.8;4", kConditional},
      {8, "claims_counts", "on the plane;100;0", "on the plane;100;3", kConditional},
      {8, "claims_counts", "anything else;100;0", "anything else;100;3", kRefuted},
      {9, "claims_counts", "after the divide is wrong;100;0", "after the divide is wrong;100;9",
       kConditional},
      {10, "claims_counts", "aspect not 1;20;0", "aspect not 1;20;20", kConditional},
      {11, "w_sign_epsilon", "1e-5;0", "1e-5;33", kConditional},
      {11, "w_sign_prevented", "sutherland_hodgman;7", "sutherland_hodgman;0", kRefuted},
      {12, "claims_counts", "homogeneous/sutherland_hodgman differs;100;0",
       "homogeneous/sutherland_hodgman differs;100;1", kRefuted},
      {13, "segments_operations", "cohen_sutherland;90;90", "cohen_sutherland;90;20", kConditional},
      {14, "segments_operations", "liang_barsky;90;90;0;0;", "liang_barsky;90;90;0;0.5;",
       kConditional},
      {15, "cost", "pipeline;float;26;3.9;3.8;4", "pipeline;float;50;2;1.9;2.1", kRefuted},
      {16, "claims_counts", "leaves several;100;30", "leaves several;100;0", kRefuted},
      {17, "bounds", "box;20;0", "box;80;0", kConditional},
      {17, "bounds", "box;20;0", "box;20;1", kRefuted},
      {18, "segments_intersection", "oblique parallel;0;1", "oblique parallel;2;1", kRefuted},
      {19, "cost_operations", "cvv/naive;12;10;12;20", "cvv/naive;12;10;4;20", kRefuted},
      {20, "plane_order", "400;0;3", "400;0;0", kRefuted},
      {20, "plane_order", "400;0;3;0;0;0;10;10", "400;0;0;0;0;0;10;12", kConditional},
      {21, "plane_order", "400;0;3;0;", "400;0;3;8;", kConditional},
      {21, "plane_order", "400;0;3", "400;3;3", kRefuted},
      {22, "guard_band_pictures", "float;0;0", "float;0;2", kConditional},
      {22, "guard_band_points", "1000;0", "1000;1", kRefuted},
      {23, "depth_monotone", "linear;lines stay straight;exact;0",
       "linear;lines stay straight;exact;1", kRefuted},
      {24, "claims_counts", "t in clip space is not t in view space;100;0",
       "t in clip space is not t in view space;100;1", kRefuted},
      {25, "claims_counts", "denominator 0;100;0", "denominator 0;100;1", kRefuted},
      {26, "claims_counts", "more than 9 vertices;100;0", "more than 9 vertices;100;1", kRefuted},
      {26, "claims_counts", "\n9 vertices;100;5", "\n9 vertices;100;0", ClaimVerdict::undecided},
      {27, "accuracy", "homogeneous/sutherland_hodgman;float;0",
       "homogeneous/sutherland_hodgman;float;0.1", kConditional},
      {28, "claims_counts", "(1, 1, -20/9, 0);1;1", "(1, 1, -20/9, 0);1;0", kRefuted},
      {29, "claims_clipless", "floor;1.5", "floor;1.1", kRefuted},
      {30, "depth", "reversed;float32;float;1000;0;1", "reversed;float32;float;1000;0;20",
       kRefuted},
      {31, "cost", "exact_sign;float;60;1.6;1.5;1.7", "exact_sign;float;160;0.6;0.5;0.7", kRefuted},
      {32, "frontier", "exact;2500;100;0", "exact;27;100;0", kConditional},
      {32, "frontier", "rounded_batch;float;50;100;0", "rounded_batch;float;5.2;100;0",
       kConditional},
      {32, "frontier", "rounded_batch;float;50;100;0", "rounded_batch;float;-;100;0", kConfirmed},
      {33, "hard_cases", "1e-5;float;19", "1e-5;float;34", kRefuted},
  };
  return all;
}

const Claim& claim_number(int number) {
  for (const Claim& claim : all_claims()) {
    if (claim.number == number) return claim;
  }
  throw std::out_of_range("no such claim");
}

}  // namespace

TEST_CASE("claims: there are 33, numbered in order, each with a statement and an experiment") {
  REQUIRE(all_claims().size() == 33);
  for (std::size_t i = 0; i < all_claims().size(); ++i) {
    CHECK(all_claims()[i].number == static_cast<int>(i) + 1);
    CHECK_FALSE(all_claims()[i].statement.empty());
    CHECK_FALSE(all_claims()[i].experiment.empty());
  }
}

TEST_CASE("claims: figures in favour confirm every claim") {
  const Results results = results_from(all_confirmed());
  for (const Claim& claim : all_claims()) {
    INFO("claim " << claim.number << ": " << judge(claim, results).because);
    CHECK(judge(claim, results).verdict == kConfirmed);
  }
}

TEST_CASE("claims: altered figures change the verdict") {
  for (const Alteration& a : alterations()) {
    INFO("claim " << a.claim << ": " << a.before << " -> " << a.after);
    TableTexts tables = all_confirmed();
    std::string& text = tables.at(a.table);
    const std::size_t at = text.find(a.before);
    REQUIRE(at != std::string::npos);
    text.replace(at, a.before.size(), a.after);
    const Finding finding = judge(claim_number(a.claim), results_from(tables));
    INFO(finding.because);
    CHECK(finding.verdict == a.verdict);
  }
}

TEST_CASE("claims: every claim has a figure that changes its verdict") {
  std::set<int> altered;
  for (const Alteration& a : alterations()) altered.insert(a.claim);
  CHECK(altered.size() == all_claims().size());
}

TEST_CASE("claims: without its figures every claim is undecided and says what is missing") {
  for (const Claim& claim : all_claims()) {
    const Finding finding = judge(claim, results_from({}));
    INFO("claim " << claim.number);
    CHECK(finding.verdict == ClaimVerdict::undecided);
    CHECK(finding.because.find("table ") != std::string::npos);
  }
}
