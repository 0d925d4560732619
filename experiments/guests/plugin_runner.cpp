// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/guests/plugin_runner.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <optional>
#include <utility>

#include "experiments/guests/bisect.hpp"
#include "experiments/guests/plugin_said.hpp"
#include "experiments/guests/plugin_task.hpp"

namespace clipscope::experiments {

namespace {

// Parts of a block that does not end get this much of its time. Who is blamed had all of it.
constexpr double kPartOfTime = 0.1;
// For all blocks together: enough for 400 primitives far apart, or for eight that do not end.
constexpr Retries kPluginRetries{.left = 10'000, .endless_price = 50};

// A batch as the plug-in is asked about it. Its input is an area of its own.
struct Part {
  const Batch* batch = nullptr;
  bool is_taken = true;
  plugin::Request request = {};
  std::size_t numbers = 0;  // of its input
};

template <class T>
class TypedPluginRunner final : public PluginRunner {
 public:
  TypedPluginRunner(Plugin& plugin, const Contestant& contestant, std::span<const Batch> batches)
      : plugin_(plugin), channel_(plugin.take()), kept_(kFormat<T>, 4) {
    for (const Batch& batch : batches) {
      add_part(batch);
      parts_.back().is_taken = contestant.takes(batch);
    }
  }
  ~TypedPluginRunner() override { plugin_.give_back(std::move(channel_)); }

  void clip(std::size_t batch, std::size_t first, std::size_t count) override {
    part_ = &parts_[batch];
    kept_ = Answers(kFormat<T>, stride());
    in_place_ = 0;
    if (!part_->is_taken) return refuse(count);
    for (const std::size_t end = first + count; first < end;) {
      const std::size_t size = std::min(end - first, kMostAtOnce);
      keep_answer();
      if (const auto failure = ask(first, size, time_of_block())) {
        bisect({first, size}, *failure);
      } else {
        in_place_ = size;
      }
      first += size;
    }
  }

  // The last block's answer is still where the plug-in left it.
  Answers answers() const override {
    Answers all = kept_;
    read_answer(0, in_place_, all);
    return all;
  }

  void enter_clock() override { channel_->enter_clock(); }
  void leave_clock() override { channel_->leave_clock(); }
  std::int64_t interruptions() override { return channel_->lost_processor(); }

  bool is_thread_safe() const override { return plugin_.can(CLIPSCOPE_THREAD_SAFE); }
  void start_anew() override { channel_->start_anew(); }

  void fill_output(unsigned char byte) override {
    for (const SharedArea* area : {&channel_->output(0, 0), &channel_->output_ends(0, 0)}) {
      std::fill(area->begin(), area->end(), byte);
    }
  }

  Answers clip_twice(std::size_t batch, std::size_t first, std::size_t count) override {
    part_ = &parts_[batch];
    reserve_output(1, *part_);
    kept_ = Answers(kFormat<T>, stride());
    const auto failure = channel_->clip(request_of(first, count), plugin_.seconds(), true);
    if (failure) fail_all(count, *failure, kept_);
    in_place_ = failure ? 0 : count;
    Answers second = kept_;
    read_answer(1, in_place_, second);
    return second;
  }

 private:
  std::size_t stride() const { return 4 + part_->request.task.attributes; }

  void add_part(const Batch& batch) {
    Part part{.batch = &batch};
    plugin::Request& request = part.request;
    request.task = task_of<T>(batch);
    request.by_matrix = batch.matrix.has_value();
    request.projects = batch.space == Space::view &&
                       (request.by_matrix || !takes_in_view_space(plugin_, batch.frustum));
    request.most_vertices = most_vertices(batch, request.task);
    request.input = static_cast<std::uint32_t>(parts_.size() + 1);  // 0 is that of `ask_apart`
    const std::size_t vertices = first_vertex(batch, batch.size());
    part.numbers = vertices * request.task.stride;
    T* const to = channel_->input(request.input, std::max<std::size_t>(1, part.numbers * sizeof(T)))
                      .template last<T>(part.numbers);
    write_vertices(batch, to);
    reserve_output(0, part);
    parts_.push_back(part);
  }

  void reserve_output(std::size_t thread, const Part& part) {
    const std::size_t count = std::min(std::max<std::size_t>(1, part.batch->size()), kMostAtOnce);
    const std::size_t numbers =
        count * part.request.most_vertices * (4 + part.request.task.attributes);
    channel_->output(thread, numbers * sizeof(T));
    channel_->output_ends(thread, count * sizeof(std::size_t));
  }

  // About primitives of the part, whose input lies where it was prepared.
  plugin::Request request_of(std::size_t first, std::size_t count) {
    plugin::Request request = part_->request;
    const SharedArea& input = channel_->input(request.input, 0);
    const std::size_t vertex = first_vertex(*part_->batch, first);
    request.task.count = count;
    request.task.vertices = first_vertex(*part_->batch, first + count) - vertex;
    request.input_at = input.size() - (part_->numbers - vertex * request.task.stride) * sizeof(T);
    if (part_->batch->vertices == 0) write_ends(first, count, vertex);
    return request;
  }

  void write_ends(std::size_t first, std::size_t count, std::size_t vertex) {
    auto* ends =
        channel_->input_ends(count * sizeof(std::size_t)).template last<std::size_t>(count);
    for (std::size_t i = 0; i < count; ++i) {
      ends[i] = first_vertex(*part_->batch, first + i + 1) - vertex;
    }
  }

  std::optional<Failure> ask(std::size_t first, std::size_t count, double seconds) {
    return channel_->clip(request_of(first, count), seconds);
  }

  // The same, with an input that ends where its memory does.
  std::optional<Failure> ask_apart(const Range& range) {
    plugin::Request request = request_of(range.first, range.count);
    const std::size_t bytes = request.task.vertices * request.task.stride * sizeof(T);
    SharedArea& apart = channel_->input(0, std::max<std::size_t>(1, bytes));
    std::memcpy(apart.end() - bytes, channel_->input(request.input, 0).begin() + request.input_at,
                bytes);
    request.input = 0;
    request.input_at = apart.size() - bytes;
    const double seconds = range.count == 1 ? time_of_block() : plugin_.seconds() * kPartOfTime;
    return channel_->clip(request, seconds);
  }

  // Keeps the answers to all of a block that failed but those who are to blame.
  void bisect(const Range& block, const Failure& failure) {
    Bisection([this](const Range& range) { return ask_apart(range); },
              [this](const Range& range) { read_answer(0, range.count, kept_); }, kept_, retries_)
        .look_into(block, failure);
  }

  void read_answer(std::size_t thread, std::size_t count, Answers& answers) const {
    if (count == 0) return;
    const std::size_t capacity = count * part_->request.most_vertices * stride();
    read_polygons<T>({.numbers = channel_->output(thread, 0).template last<T>(capacity),
                      .ends = channel_->output_ends(thread, 0).template last<std::size_t>(count),
                      .count = count,
                      .most_vertices = static_cast<std::size_t>(part_->request.most_vertices),
                      .stride = stride()},
                     answers);
  }

  void refuse(std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) {
      kept_.fail({Failure::Kind::malformed, "is not asked, since it does not take such input"});
    }
  }

  void keep_answer() {
    read_answer(0, in_place_, kept_);
    in_place_ = 0;
  }

  // Who fails again and again is not waited for as long.
  double time_of_block() const {
    return plugin_.seconds() * (retries_.are_spent() ? kPartOfTime : 1);
  }

  Plugin& plugin_;
  std::unique_ptr<PluginChannel> channel_;
  std::vector<Part> parts_;
  const Part* part_ = nullptr;
  Answers kept_;
  std::size_t in_place_ = 0;  // primitives of the last block
  Retries retries_ = kPluginRetries;
};

}  // namespace

std::unique_ptr<PluginRunner> make_plugin_runner(Plugin& plugin, const Contestant& contestant,
                                                 std::span<const Batch> batches) {
  if (contestant.format->is_float()) {
    return std::make_unique<TypedPluginRunner<float>>(plugin, contestant, batches);
  }
  return std::make_unique<TypedPluginRunner<double>>(plugin, contestant, batches);
}

}  // namespace clipscope::experiments
