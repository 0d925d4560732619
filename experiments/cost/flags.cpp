// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/cost/flags.hpp"

#include <fmt/format.h>

#include <bit>
#include <memory>

#include "experiments/contestants/same_bits.hpp"
#include "experiments/cost/builds/build.hpp"
#include "experiments/machine/machine.hpp"
#include "experiments/selection/select.hpp"
#include "experiments/survey/contest_clock.hpp"

namespace clipscope::experiments::cost {
namespace {

static_assert(builds::kAttributes == kSceneAttributes);

// A build's clipper as a contestant has it: of one batch.
class BuildRunner final : public Runner {
 public:
  BuildRunner(const builds::Clipper& clipper, const Format& format, const Batch& batch)
      : format_(format),
        runner_(clipper.prepare({std::bit_cast<builds::FrustumBytes>(batch.frustum),
                                 std::get<std::span<const float>>(batch.numbers)})) {}

  void clip(std::size_t, std::size_t first, std::size_t count) override {
    runner_->clip(first, count);
  }
  Answers answers() const override {
    struct Keeper final : builds::Reader {
      explicit Keeper(const Format& format) : kept(format, 4 + kSceneAttributes) {}
      void number(double x) override { kept.add(x); }
      void end_polygon() override { kept.end_polygon(); }
      Answers kept;
    } keeper(format_);
    runner_->read_answers(keeper);
    return std::move(keeper.kept);
  }

 private:
  const Format& format_;
  std::unique_ptr<builds::Runner> runner_;
};

Contestant contestant_of(const builds::Clipper& clipper) {
  Contestant contestant = find_contestant(clipper.clipper, clipper.scalar);
  contestant.prepare = [&clipper, format = contestant.format](std::span<const Batch> batches) {
    return std::make_unique<BuildRunner>(clipper, *format, batches.front());
  };
  return contestant;
}

std::int64_t count_other_bits(const Answers& a, const Answers& b) {
  std::int64_t count = 0;
  for (std::size_t i = 0; i < b.size(); ++i) count += !has_same_bits(a[i], b[i]);
  return count;
}

// One clipper in all builds. Those with the contestant's bits are timed in the same rounds.
void measure_clipper(const FlagRow& row, std::size_t clipper, const Batch& batch, int rounds,
                     TableOf<FlagRow>& table, PieceRecord& record) {
  const Answers expected = clip(find_contestant(row.clipper, row.scalar), batch);
  const auto runnable = builds::runnable();
  std::vector<Contestant> contestants;
  for (const builds::Build& build : runnable) {
    contestants.push_back(contestant_of(build.clippers()[clipper]));
  }
  std::vector<FlagRow> rows(runnable.size(), row);
  std::vector<Task> tasks;
  for (std::size_t i = 0; i < runnable.size(); ++i) {
    rows[i].flags = i == 0 ? kNoFlags : runnable[i].flags;
    rows[i].differ = count_other_bits(clip(contestants[i], batch), expected);
    tasks.push_back(contest_task(contestants[i], std::span(&batch, 1), 0));
    tasks.back().check = [&other = rows[i].differ] { return other == 0 ? "" : "other bits"; };
  }
  const std::vector<Timing> timings = time_in_turn(tasks, {.rounds = rounds, .baseline = 0});
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (timings[i].is_timed() && timings[0].is_timed()) {
      rows[i].ns = timings[i].ns;
      rows[i].ratio = median_interval(ratios(timings[i].samples_ns, timings[0].samples_ns));
    }
    table.add(rows[i]);
    record.add(fmt::format("{} {} {} {}", row.mix, row.clipper, row.scalar, rows[i].flags),
               timings[i]);
  }
}

}  // namespace

void measure_flags(const std::string& mix, const SampledView& view, int rounds,
                   TableOf<FlagRow>& table, PieceRecord& record) {
  const Batch batch = batch_of(view.view, view.triangles);
  const std::span<const builds::Clipper> clippers = builds::runnable().front().clippers();
  for (std::size_t i = 0; i < clippers.size(); ++i) {
    const FlagRow row{mix, clippers[i].clipper, clippers[i].scalar, "",
                      static_cast<std::int64_t>(batch.size())};
    measure_clipper(row, i, batch, rounds, table, record);
  }
}

void run_flags(const ExperimentContext& context) {
  const Selection& selection = context.selection();
  TableOf<FlagRow> table;
  for (const std::string name : {"soup", "soup_straddling"}) {
    context.piece("flags " + name, {&table}, [&](PieceRecord& record) {
      const Scene scene = load_selected_scene(selection, name);
      const auto views = sampled_views(scene, selection.quick ? 500 : 20000);
      measure_flags(name, views.front(), contest_clock(selection.quick).rounds, table, record);
    });
  }
  table.add_note(timing_description());
  context.emit(table);
}

}  // namespace clipscope::experiments::cost
