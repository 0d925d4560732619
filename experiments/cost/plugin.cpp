// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/cost/plugin.hpp"

#include <dlfcn.h>
#include <fmt/format.h>

#include <memory>
#include <type_traits>
#include <vector>

#include "experiments/contestants/same_bits.hpp"
#include "experiments/guests/plugin_runner.hpp"
#include "experiments/guests/plugin_task.hpp"
#include "experiments/machine/errors.hpp"
#include "experiments/machine/machine.hpp"
#include "experiments/selection/select.hpp"
#include "experiments/survey/contest_clock.hpp"

namespace clipscope::experiments::cost {
namespace {

constexpr const char* kOwnPlugin = "clipscope_own_plugin.so";
constexpr const char* kItsClipper = "homogeneous/sutherland_hodgman";
constexpr std::size_t kMostInCall = 4096;  // triangles; the clock asks about 1,024 at once

std::string library() { return file_of_program(kOwnPlugin).string(); }

// Our own plug-in, loaded into this process: nobody else's is. Errors: GuestError.
const clipscope_plugin& loaded_here() {
  static const clipscope_plugin* plugin = [] {
    void* handle = dlopen(library().c_str(), RTLD_NOW | RTLD_LOCAL);
    if (handle == nullptr) throw GuestError(dlerror());
    const auto entry = reinterpret_cast<decltype(&clipscope_plugin_entry)>(
        dlsym(handle, "clipscope_plugin_entry"));
    if (entry == nullptr) throw GuestError(dlerror());
    return entry(CLIPSCOPE_PLUGIN_ABI);
  }();
  return *plugin;
}

// Calls it as a renderer would that has linked it: on memory of this process. Of one batch.
template <class T>
class DirectRunner final : public Runner {
 public:
  DirectRunner(const clipscope_plugin& plugin, const Batch& batch)
      : plugin_(plugin), task_(task_of<T>(batch)), most_(most_vertices(batch, task_)) {
    input_.resize(first_vertex(batch, batch.size()) * task_.stride);
    write_vertices(batch, input_.data());
    output_.resize(kMostInCall * most_ * stride());
    ends_.resize(kMostInCall);
  }

  void clip(std::size_t, std::size_t first, std::size_t count) override {
    task_.count = count_ = count;
    task_.vertices = 3 * count;
    clipscope_answer answer{};
    answer.struct_size = sizeof answer;
    answer.stride = static_cast<std::uint32_t>(stride());
    answer.most_vertices = most_;
    answer.capacity = count * most_;
    answer.ends = ends_.data();
    const T* const input = input_.data() + 3 * first * task_.stride;
    if constexpr (std::is_same_v<T, float>) {
      task_.floats = input;
      answer.floats = output_.data();
    } else {
      task_.doubles = input;
      answer.doubles = output_.data();
    }
    plugin_.clip(&task_, &answer);
  }

  Answers answers() const override {
    Answers answers(kFormat<T>, stride());
    const T* number = output_.data();
    for (std::size_t i = 0; i < count_; ++i) {
      while (number < output_.data() + ends_[i] * stride()) answers.add(*number++);
      answers.end_polygon();
    }
    return answers;
  }

 private:
  std::size_t stride() const { return 4 + task_.attributes; }

  const clipscope_plugin& plugin_;
  clipscope_task task_;
  std::size_t most_, count_ = 0;
  std::vector<T> input_, output_;
  std::vector<std::size_t> ends_;
};

std::unique_ptr<Runner> make_direct_runner(const Format& format, const Batch& batch) {
  if (format.is_float()) return std::make_unique<DirectRunner<float>>(loaded_here(), batch);
  return std::make_unique<DirectRunner<double>>(loaded_here(), batch);
}

// Both as contestants: called directly, and through a host.
std::vector<Contestant> both_ways(Plugin& plugin, const Contestant& clipper) {
  std::vector<Contestant> both(2, clipper);
  both[0].prepare = [&format = *clipper.format](std::span<const Batch> batches) {
    return make_direct_runner(format, batches.front());
  };
  both[1].prepare = [&format = *clipper.format, &plugin](std::span<const Batch> batches) {
    return make_plugin_runner(plugin, format, batches);
  };
  return both;
}

std::string first_difference(const Contestant& contestant, const Contestant& clipper,
                             const Batch& batch) {
  const std::unique_ptr<Runner> runner = contestant.prepare(std::span(&batch, 1));
  const std::size_t count = std::min(batch.size(), kMostInCall);
  runner->clip(0, 0, count);
  const Answers answers = runner->answers(), expected = clip(clipper, batch);
  for (std::size_t i = 0; i < count; ++i) {
    if (!has_same_bits(answers[i], expected[i])) {
      return fmt::format("triangle {}: other bits than the clipper's own", i);
    }
  }
  return "";
}

void measure_scalar(const std::string& mix, Plugin& plugin, const Contestant& clipper,
                    const Batch& batch, int rounds, TableOf<PluginRow>& table,
                    PieceRecord& record) {
  const std::vector<Contestant> both = both_ways(plugin, clipper);
  std::vector<Task> tasks;
  for (const Contestant& contestant : both) {
    tasks.push_back(contest_task(contestant, std::span(&batch, 1), 0));
    tasks.back().check = [&] { return first_difference(contestant, clipper, batch); };
  }
  const std::vector<Timing> timings = time_in_turn(tasks, {.rounds = rounds, .baseline = 0});
  for (std::size_t i = 0; i < timings.size(); ++i) {
    PluginRow row{mix, std::string(clipper.clipper), std::string(clipper.scalar()),
                  std::string(i == 0 ? kDirectCall : kThroughHost),
                  static_cast<std::int64_t>(batch.size())};
    if (timings[i].is_timed() && timings[0].is_timed()) {
      row.ns = timings[i].ns;
      row.ratio = median_interval(ratios(timings[i].samples_ns, timings[0].samples_ns));
    }
    table.add(row);
    record.add(fmt::format("{} {} {} {}", row.mix, row.clipper, row.scalar, row.way), timings[i]);
  }
}

}  // namespace

void measure_plugin(const std::string& mix, const SampledView& view, int rounds,
                    TableOf<PluginRow>& table, PieceRecord& record) {
  const Batch batch = batch_of(view.view, view.triangles);
  Plugin plugin(library(), kPluginSeconds);
  for (const char* scalar : {"float", "double"}) {
    measure_scalar(mix, plugin, find_contestant(kItsClipper, scalar), batch, rounds, table, record);
  }
}

void run_plugin(const ExperimentContext& context) {
  const Selection& selection = context.selection();
  TableOf<PluginRow> table;
  for (const std::string name : {"soup_straddling", "soup"}) {
    context.piece("plug-in " + name, {&table}, [&](PieceRecord& record) {
      const Scene scene = load_selected_scene(selection, name);
      const auto views = sampled_views(scene, selection.quick ? 2048 : 20480);
      measure_plugin(name, views.front(), selection.quick ? 9 : 101, table, record);
    });
  }
  table.add_note(timing_description());
  context.emit(table);
}

}  // namespace clipscope::experiments::cost
