// SPDX-License-Identifier: GPL-3.0-or-later
//
// Where time goes: a clipper with a step left out computes what the whole one computes before that
// step.
#include "experiments/cost/rows.hpp"

#include "experiments/scenes/builtin.hpp"
#include "experiments/selection/select.hpp"
#include "experiments/survey/contest_clock.hpp"
#include "tests/catch.hpp"

using namespace clipscope;
using namespace clipscope::experiments;
using namespace clipscope::experiments::cost;

namespace {

std::vector<SampledView> views_of(const std::string& scene, std::size_t limit = 400) {
  return sampled_views(make_builtin_scene(scene, {.seed = 1, .quick = true}), limit);
}

// Checks that finish(projection, what the contestant cuts) has the bits of the whole answer.
template <class T, class Finish>
void check_bits(const char* clipper, Finish&& finish) {
  const std::string_view scalar = kFormat<T>.name;
  const Contestant& whole = find_contestant(clipper, scalar);
  const Contestant* cut = find_in_contract(clipper, scalar, Contract::cut);
  REQUIRE(cut != nullptr);
  for (const char* scene : {"soup", "soup_straddling", "soup_behind"}) {
    for (const SampledView& v : views_of(scene)) {
      const Projection<T> projection(frustum_cast<T>(v.view.frustum));
      const Batch batch = batch_of(v.view, v.triangles);
      const Answers before = clip(*cut, batch), after = clip(whole, batch);
      for (std::size_t i = 0; i < batch.size(); ++i) {
        REQUIRE(before[i].size() == after[i].size());
        for (std::size_t k = 0; k < after[i].size(); ++k) {
          const VertexView b = before[i][k], a = after[i][k];
          const Vec4<T> p =
              finish(projection, Vec4<T>(b[0].value, b[1].value, b[2].value, b[3].value));
          REQUIRE(p == Vec4<T>(a[0].value, a[1].value, a[2].value, a[3].value));
        }
      }
    }
  }
}

std::vector<Row> timed_rows(const std::vector<SampledView>& views, const Contestants& contestants) {
  const std::vector<Timing> timings =
      time_contestants(batches_of(views), contestants, find_contestant("textbook", "float"),
                       {.rounds = 5, .milliseconds_per_run = 0.1, .checked = 32});
  std::vector<Row> rows;
  for (std::size_t i = 0; i < contestants.size(); ++i) {
    rows.push_back({"soup", std::string(contestants[i]->clipper),
                    std::string(contestants[i]->scalar()), if_timed(timings[i])});
  }
  return rows;
}

}  // namespace

TEST_CASE("cost split: without its divide a clipper yields what the divide is given") {
  const char* clipper =
      GENERATE("textbook", "homogeneous/sutherland_hodgman", "homogeneous/pipeline",
               "homogeneous/blinn_newell", "homogeneous/near_last", "homogeneous/w_first_0");
  const auto divided = [](const auto&, const auto& clip) { return to_ndc(clip); };
  check_bits<float>(clipper, divided);
  check_bits<double>(clipper, divided);
}

TEST_CASE("cost split: a view-space cut alone yields what the transform is given") {
  const char* clipper = GENERATE("view/sutherland_hodgman", "view/exact_sign", "view/unit_normals");
  const auto projected = []<class T>(const Projection<T>& projection, const Vec4<T>& view) {
    return to_ndc(to_clip(projection, Vec3<T>(view)));
  };
  check_bits<float>(clipper, projected);
  check_bits<double>(clipper, projected);
}

TEST_CASE("cost split: the parts of a round sum to the whole of that round") {
  const auto views = views_of("soup");
  TableOf<SplitRow> table;
  PieceRecord record;
  measure_split(views, timed_rows(views, select_contestants("*", {"float", "double"})), 5, table,
                record);
  const std::vector<SplitRow> rows = table.rows();
  REQUIRE(rows.size() == 8 * 4);  // no clipper is refused
  REQUIRE(record.samples.size() == rows.size());
  for (std::size_t i = 0; i < rows.size(); i += 4) {
    CHECK(rows[i + 3].part == "whole");
    CHECK(rows[i + 3].share_percent.median == Approx(100));
    for (std::size_t round = 0; round < 5; ++round) {
      double sum = 0;
      for (std::size_t p = 0; p < 3; ++p) sum += record.samples[i + p].values[round];
      CHECK(sum == Approx(record.samples[i + 3].values[round]));
    }
  }
}

TEST_CASE("cost split: the parts come in the order of the clipper") {
  const auto views = views_of("soup", 100);
  const auto parts = [&](const char* clipper) {
    TableOf<SplitRow> table;
    PieceRecord record;
    measure_split(views, timed_rows(views, {&find_contestant(clipper, "float")}), 2, table, record);
    std::vector<std::string> parts;
    for (const SplitRow& row : table.rows()) parts.push_back(row.part);
    return parts;
  };
  using Parts = std::vector<std::string>;
  CHECK(parts("view/sutherland_hodgman") == Parts{"cut", "transform", "divide", "whole"});
  CHECK(parts("textbook") == Parts{"transform", "cut", "divide", "whole"});
  CHECK(parts("cvv/near_first") == Parts{"transform", "divide", "cut", "whole"});
}

TEST_CASE("cost split: who was not timed has none, nor has who was not asked for") {
  const auto views = views_of("soup", 100);
  std::vector<Row> rows =
      timed_rows(views, select_contestants("homogeneous/sutherland_hodgman", {"float"}));
  const auto splits = [&] {
    TableOf<SplitRow> table;
    PieceRecord record;
    measure_split(views, rows, 3, table, record);
    return table.rows().size() / 4;
  };
  CHECK(splits() == 1);
  rows[0].timing.reset();
  CHECK(splits() == 0);
}
