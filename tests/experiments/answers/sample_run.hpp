// SPDX-License-Identifier: GPL-3.0-or-later
//
// A run of a few contestants, made by hand, whose answers can be told by looking.
#pragma once

#include <string>
#include <vector>

#include "experiments/answers/rows.hpp"
#include "experiments/cost/rows.hpp"
#include "experiments/effects/rows.hpp"
#include "experiments/frontier/rows.hpp"
#include "experiments/guard_band/rows.hpp"
#include "experiments/hard_cases/rows.hpp"
#include "experiments/plane_order/rows.hpp"
#include "tests/experiments/claims/fabricated.hpp"

namespace clipscope::experiments::answers {

// Rows of the frontier for the game-like mix and for hard triangles.
inline void add_offer(std::vector<frontier::Row>& rows, const Offer& offer) {
  for (const bool is_hard : {false, true}) {
    const Quality& q = offer.quality;
    using R = frontier::Row;
    rows.push_back(row_with<R>(&R::set, is_hard ? kHard : kGameLike, &R::contract, offer.contract,
                               &R::clipper, offer.clipper, &R::scalar, offer.scalar, &R::timing,
                               timing(offer.ns.median), &R::max_px, is_hard ? q.hard_px : q.game_px,
                               &R::misrounded_percent, is_hard ? q.hard_misrounded : 0,
                               &R::wrong_percent, (is_hard ? q.hard_wrong : q.game_wrong) / 1e4));
  }
}

inline const std::string kClip = "homogeneous/sutherland_hodgman",
                         kView = "view/sutherland_hodgman", kCvv = "cvv/near_first",
                         kDivided = "cvv/perspective", kBatch = "homogeneous/batch",
                         kRounded = "barycentric/correctly_rounded",
                         kRoundedBatch = "barycentric/correctly_rounded_batch";

inline const Quality kFloatQuality{4, 4000, 0, 8000, 40}, kCertain{1e-4, 1e-4, 0, 0, 0};

inline std::vector<frontier::Row> frontier_rows() {
  std::vector<frontier::Row> rows;
  const auto add = [&](Contract contract, const std::string& clipper, const char* scalar, double ns,
                       const Quality& quality) {
    add_offer(rows, {contract, clipper, scalar, {ns, ns, ns}, quality});
  };
  add(Contract::full, kClip, "float", 40, kFloatQuality);
  add(Contract::full, kView, "float", 80, {0.001, 4000, 0, 2000, 40});
  add(Contract::full, kCvv, "float", 60, {4, 4000, 300, 50000, 40});
  add(Contract::full, kDivided, "float", 60, {4, 4000, 300, 300000, 40});
  add(Contract::full, kBatch, "float", 16, kFloatQuality);
  add(Contract::full, kRoundedBatch, "float", 36, kCertain);
  add(Contract::full, "whole/any_outside", "float", 42, {1000, 4000, 70000, 600000, 80});
  add(Contract::full, kClip, "exact", 12000, {});
  add(Contract::copy, kBatch, "float", 16, {3e-4, 4000, 0, 8000, 40});
  add(Contract::copy, kRoundedBatch, "float", 20, kCertain);
  return rows;
}

inline std::vector<hard_cases::VerdictRow> verdicts() {
  std::vector<hard_cases::VerdictRow> rows;
  const auto add = [&](const std::string& theme, const std::string& clipper, const char* scalar,
                       int cases, int failures) {
    for (int i = 0; i < cases; ++i) {
      rows.push_back({.hard_case = theme + "/" + std::to_string(i),
                      .clipper = clipper,
                      .scalar = scalar,
                      .outcome = i < failures ? Outcome::missing : Outcome::exact,
                      .errors = {},
                      .broken_promise = ""});
    }
  };
  for (const char* theme : {"w_sign", "scale", "far"}) {
    add(theme, kClip, "float", 10, theme[0] == 'w' ? 1 : 4);
    add(theme, kClip, "exact", 10, 0);
    add(theme, kDivided, "float", 10, 6);
    add(theme, kRounded, "float", 10, 0);
  }
  add("scale", kView, "float", 2, 0);
  return rows;
}

inline Fabricated sample_run() {
  Fabricated run;
  run.set(frontier_rows());
  run.set(verdicts());
  std::vector<cost::Row> times;
  times.push_back({kGameLike, kClip, "float", timing(40)});
  times.push_back({kGameLike, kView, "float", timing(80)});
  times.push_back({kGameLike, kCvv, "float", timing(60)});
  run.set(times);
  effects::Row teapot{
      .scene = "teapot", .times = effects::Times(), .harm = {}, .called_for = "near"};
  teapot.times->to_full = {0.75, 0.7, 0.8};
  run.set(std::vector{teapot});
  effects::PlanRow near{.scene = "teapot", .line = {"near plane", "cut", "", 1}};
  effects::PlanRow far{.scene = "teapot", .line = {"far plane", "no", "", 0}};
  run.set(std::vector{near, far});
  run.set(std::vector{plane_order::TimeRow{.mix = kGameLike,
                                           .clipper = "homogeneous/near_last",
                                           .scalar = "float",
                                           .ratio = MedianInterval{1.02, 1.01, 1.03}}});
  using Band = guard_band::WorkRow;
  run.set(
      std::vector{row_with<Band>(&Band::scene, kGameLike, &Band::method, guard_band::Method::band,
                                 &Band::band, 16.0, &Band::timing, timing(50, 0.8))});
  return run;
}

}  // namespace clipscope::experiments::answers
