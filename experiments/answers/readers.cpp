// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>

#include "experiments/answers/rows.hpp"
#include "experiments/contestants/spoken.hpp"
#include "experiments/guard_band/rows.hpp"
#include "experiments/judge/outcome.hpp"
#include "experiments/plane_order/rows.hpp"
#include "experiments/selection/select.hpp"
#include "experiments/table/prose.hpp"

namespace clipscope::experiments::answers {
namespace {

// What somebody can't do without. All of it is asked of the run, but `confined`, which the tests
// prove (spaces/clipper.hpp).
struct Needs {
  bool right_on_game = false;   // no wrong triangle and nothing that shows on the game-like mix
  bool right_on_hard = false;   // no wrong triangle on hard ones
  bool confined = false;        // no vertex outside the volume, to the bit
  bool nearest_floats = false;  // every coordinate correctly rounded
  std::vector<std::string> themes = {};  // no failure on these; "all": on none
};

struct Evidence {
  const Results& results;
  Contest contest;
  Catalogue catalogue;
};

struct Reader {
  std::string name, needs_text;
  Contract contract;
  Needs needs;
  Name often_used;
  std::string picture;
};

std::vector<Reader> all_readers() {
  return {{"a stage like a graphics card's",
           "no error that shows on triangles as games have them",
           Contract::copy,
           {.right_on_game = true},
           {"whole/any_outside", "float"},
           "pictures/floor-whole-any_outside.png"},
          {"a software rasteriser that indexes memory by the result",
           "no vertex outside the volume, no triangle wrong",
           Contract::copy,
           {.right_on_game = true, .right_on_hard = true, .confined = true},
           {"homogeneous/batch", "float"},
           "watertight/watertight_crack.png"},
          {"CAD and maps: large coordinates",
           "no failure where magnitudes differ or the far plane is far, no triangle wrong",
           Contract::full,
           {.right_on_hard = true, .themes = {"scale", "far"}},
           {"homogeneous/sutherland_hodgman", "float"},
           "hard_cases/signs_far_of_deep_frustum.png"},
          {"a compositor: rectangles with w <= 0",
           "no failure where w changes its sign",
           Contract::copy,
           {.right_on_game = true, .themes = {"w_sign"}},
           {"cvv/perspective", "float"},
           "w_sign/w_sign.png"},
          {"offline rendering and verification",
           "no failure on any hard case, every float the nearest one",
           Contract::full,
           {.right_on_hard = true, .nearest_floats = true, .themes = {"all"}},
           {"textbook", "float"},
           "hard_cases/signs_edge_of_volume.png"}};
}

bool is_confined(const Name& name) {
  const Contestant* c = find_in_contract(name.first, name.second, Contract::full);
  return c != nullptr && c->promise.confined;
}

Tally tally_on(const Evidence& evidence, const Name& name, const std::string& theme) {
  return theme == "all" ? evidence.catalogue.tally(name) : evidence.catalogue.tally(name, theme);
}

// What of the needs a contestant lacks, as the end of a sentence that begins with its name; empty
// if it has all.
std::string lacking(const Evidence& evidence, const Needs& needs, const Offer& offer) {
  const Name judged = judged_as(offer.clipper, offer.scalar);
  const Quality& q = offer.quality;
  for (const std::string& theme : needs.themes) {
    const Tally tally = tally_on(evidence, judged, theme);
    if (tally.cases == 0) return "was not asked about these cases";
    if (tally.failures == 0) continue;
    const std::string words = theme == "all" ? "hard cases" : "hard cases of " + spoken_set(theme);
    return fmt::format("fails on {}", some_of(tally.failures, tally.cases, words));
  }
  if (needs.right_on_game && q.game_wrong > 0) return wrong_text(q.game_wrong, "game-like");
  if (needs.right_on_game && q.game_px >= kSubpixel) {
    return fmt::format("is off by {:.2g} px", q.game_px);
  }
  if (needs.right_on_hard && q.hard_wrong > 0) return wrong_text(q.hard_wrong, "hard");
  if (needs.confined && !is_confined(judged)) return "may leave a vertex outside the volume";
  if (needs.nearest_floats && q.hard_misrounded > 0) return misrounded_text(q.hard_misrounded);
  return "";
}

std::string otherwise(const Evidence& evidence, const Reader& reader) {
  try {
    const std::string what =
        lacking(evidence, reader.needs, evidence.contest.offer(reader.often_used, reader.contract));
    return fmt::format(
        "{} {}.", capitalised(spoken_contestant(reader.often_used.first, reader.often_used.second)),
        what.empty() ? "would do as well" : what);
  } catch (const MissingFigure& missing) {
    return fmt::format("{}.", capitalised(missing.what()));
  }
}

// Which place of the near plane is the fastest. Barycentric clippers compute nothing from an
// earlier cut.
std::string order_text(const Results& results, const std::string& clipper,
                       const std::string& scalar) {
  using R = plane_order::TimeRow;
  if (clipper.starts_with("barycentric/")) return "no order";
  const std::optional<MedianInterval>& last =
      results.row<R>(&R::mix, kGameLike, &R::clipper, "homogeneous/near_last", &R::scalar, scalar)
          .ratio;
  if (!last) throw MissingFigure("homogeneous/near_last was not timed");
  if (last->low > 1) return "near plane first";
  return last->high < 1 ? "near plane last" : "near plane first or last";
}

std::string guard_text(const Results& results) {
  using R = guard_band::WorkRow;
  const R* best = nullptr;
  for (const R& row : results.rows<R>()) {
    if (row.scene != kGameLike || row.method != guard_band::Method::band || !row.timing) continue;
    if (!best || row.timing->speedup->median > best->timing->speedup->median) best = &row;
  }
  if (best == nullptr) throw MissingFigure("no guard band was timed");
  if (best->timing->speedup->low <= 1) return "no guard band";
  return best->band ? fmt::format("a guard band of {} screens", format_number(*best->band))
                    : "sides never cut";
}

// The text, or that the run does not say.
template <class F>
std::string if_known(F&& text) {
  try {
    return text();
  } catch (const MissingFigure&) {
    return "not in this run";
  }
}

ReaderRow row_for(const Evidence& evidence, const Reader& reader) {
  ReaderRow row{.reader = reader.name, .needs = reader.needs_text};
  row.otherwise = otherwise(evidence, reader);
  const std::vector<Offer> offers = evidence.contest.offers(reader.contract);
  const auto found = std::ranges::find_if(
      offers, [&](const Offer& o) { return lacking(evidence, reader.needs, o).empty(); });
  if (found == offers.end()) {
    row.recommended = "none of those that were timed";
    return row;
  }
  const Name judged = judged_as(found->clipper, found->scalar);
  row.recommended = spoken_contestant(found->clipper, found->scalar);
  row.clipper = found->clipper;
  row.scalar = found->scalar;
  row.order = if_known([&] { return order_text(evidence.results, found->clipper, judged.second); });
  row.guard = if_known([&] { return guard_text(evidence.results); });
  row.ns = found->ns.median;
  row.over_fastest_percent = 100 * (found->ns.median / offers.front().ns.median - 1);
  return row;
}

}  // namespace

std::vector<ReaderRow> readers(const Results& results,
                               const std::function<bool(const std::string&)>& has_file) {
  const Evidence evidence{results, Contest(results), Catalogue(results)};
  std::vector<ReaderRow> rows;
  for (const Reader& reader : all_readers()) {
    ReaderRow& row = rows.emplace_back(row_for(evidence, reader));
    if (has_file(reader.picture)) row.picture = reader.picture;
  }
  return rows;
}

}  // namespace clipscope::experiments::answers
