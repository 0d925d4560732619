// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/guests/plugin_runner.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <numeric>
#include <optional>
#include <type_traits>
#include <utility>

#include "experiments/contestants/typed_input.hpp"

namespace clipscope::experiments {

std::uint32_t primitive_bit(int vertices) {
  if (vertices == 0) return CLIPSCOPE_POLYGONS;
  return static_cast<std::uint32_t>(CLIPSCOPE_POINTS) << (vertices - 1);
}
std::uint32_t depth_bit(DepthRange depth) {
  return static_cast<std::uint32_t>(CLIPSCOPE_DEPTH_MINUS_ONE_TO_ONE) << static_cast<int>(depth);
}

bool takes_in_view_space(const Plugin& plugin, const Frustum<double>& f) {
  const bool is_parallel = f.kind == ProjectionKind::parallel;
  const bool is_centred = f.left == -f.right && f.bottom == -f.top;
  const bool is_oblique = f.shear_x != 0 || f.shear_y != 0;
  return plugin.can(CLIPSCOPE_VIEW_SPACE) && (is_centred || plugin.can(CLIPSCOPE_OFF_CENTRE)) &&
         (!is_parallel || plugin.can(CLIPSCOPE_ORTHOGRAPHIC)) &&
         (!is_oblique || plugin.can(CLIPSCOPE_OBLIQUE)) &&
         (!f.infinite_far || plugin.can(CLIPSCOPE_INFINITE_FAR));
}

namespace {

constexpr std::size_t kMostAtOnce = 4096;  // primitives of a block
// Parts of a block that does not end get this much of its time. Who is blamed had all of it.
constexpr double kPartOfTime = 0.1;
// Blocks that are not answered are looked into as long as so little was found; then all of a block
// is to blame.
constexpr int kMostEndless = 16, kMostFound = 512;

template <class T>
clipscope_frustum frustum_of(const Frustum<T>& f) {
  clipscope_frustum to{};
  to.left = f.left;
  to.right = f.right;
  to.bottom = f.bottom;
  to.top = f.top;
  to.z_near = f.near;
  to.z_far = f.infinite_far ? T(0) : f.far;
  to.shear_x = f.shear_x;
  to.shear_y = f.shear_y;
  to.is_orthographic = f.kind == ProjectionKind::parallel;
  to.is_infinite = f.infinite_far;
  return to;
}

void set_volume_of(const ClipVolume& volume, clipscope_task& task) {
  const DepthClamp& clamp = volume.depth_clamp;
  const OpenSides& open = volume.open_sides;
  task.depth = depth_bit(volume.depth);
  task.depth_clamp =
      (clamp.near ? CLIPSCOPE_CLAMP_NEAR : 0) | (clamp.far ? CLIPSCOPE_CLAMP_FAR : 0);
  task.open_sides = (open.left ? CLIPSCOPE_OPEN_LEFT : 0) |
                    (open.right ? CLIPSCOPE_OPEN_RIGHT : 0) |
                    (open.bottom ? CLIPSCOPE_OPEN_BOTTOM : 0) | (open.top ? CLIPSCOPE_OPEN_TOP : 0);
  task.clip_distances = static_cast<std::uint32_t>(volume.clip_distances);
}

// What the tasks of a batch have in common.
template <class T>
clipscope_task task_of_batch(const Batch& batch) {
  const Projection<T> projection = projection_in<T>(batch);
  clipscope_task task{};
  task.struct_size = sizeof task;
  task.scalar = std::is_same_v<T, float> ? CLIPSCOPE_FLOAT : CLIPSCOPE_DOUBLE;
  task.space = batch.space == Space::view ? CLIPSCOPE_VIEW_SPACE : CLIPSCOPE_CLIP_SPACE;
  task.primitive = primitive_bit(batch.vertices);
  task.attributes = static_cast<std::uint32_t>(batch.attributes) +
                    static_cast<std::uint32_t>(batch.planes.size());
  task.stride = static_cast<std::uint32_t>(batch.dimension()) + task.attributes;
  set_volume_of(projection.volume, task);
  if (batch.space == Space::view) {
    if (!batch.matrix) task.frustum = frustum_of(projection.frustum);
    const MatrixRows<T> rows = batch.matrix ? matrix_from<T>(*batch.matrix) : rows_of(projection);
    for (std::size_t i = 0; i < 16; ++i) task.matrix[i] = rows[i / 4][static_cast<int>(i % 4)];
  }
  const PointSize<T> size = point_size_in<T>(batch);
  task.point_half_size[0] = size.half_width;
  task.point_half_size[1] = size.half_height;
  return task;
}

std::size_t first_vertex(const Batch& batch, std::size_t primitive) {
  if (batch.vertices > 0) return primitive * static_cast<std::size_t>(batch.vertices);
  return primitive == 0 ? 0 : batch.ends[primitive - 1];
}

// Of one primitive: see clipscope_answer.
std::size_t most_vertices(const Batch& batch, const clipscope_task& task) {
  if (batch.vertices == 1 || batch.vertices == 2) return static_cast<std::size_t>(batch.vertices);
  std::size_t largest = 3;
  for (std::size_t i = 0; i < batch.ends.size(); ++i) {
    largest = std::max(largest, first_vertex(batch, i + 1) - first_vertex(batch, i));
  }
  return largest + 7 + task.clip_distances;
}

template <Space S, class T>
void write_vertices(const Batch& batch, std::size_t vertices, T* to) {
  const VertexReader<S, T, kRunTime> read(batch);
  for (std::size_t v = 0; v < vertices; ++v) {
    const Vertex<S, T, kRunTime> vertex = read(v);
    for (int i = 0; i < vertex.kDimension; ++i) *to++ = vertex.position[i];
    for (int k = 0; k < vertex.attributes.size(); ++k) *to++ = vertex.attributes[k];
  }
}

// A batch as the plug-in is asked about it. Its input is an area of its own.
struct Part {
  const Batch* batch = nullptr;
  plugin::Request request = {};
  std::size_t numbers = 0;  // of its input
};

template <class T>
class TypedPluginRunner final : public PluginRunner {
 public:
  TypedPluginRunner(Plugin& plugin, std::span<const Batch> batches)
      : plugin_(plugin), channel_(plugin.take()), kept_(kFormat<T>, 4) {
    for (const Batch& batch : batches) add_part(batch);
  }
  ~TypedPluginRunner() override { plugin_.give_back(std::move(channel_)); }

  void clip(std::size_t batch, std::size_t first, std::size_t count) override {
    part_ = &parts_[batch];
    kept_ = Answers(kFormat<T>, stride());
    in_place_ = 0;
    for (const std::size_t end = first + count; first < end;) {
      const std::size_t size = std::min(end - first, kMostAtOnce);
      keep_answer();
      if (const auto failure = ask(first, size, time_of_block())) {
        look_into(first, size, *failure);
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

  std::int64_t interruptions() override {
    channel_->stay_awake(true);
    return channel_->lost_processor();
  }

  void start_anew() override { channel_->start_anew(); }

  void fill_output(unsigned char byte) override {
    for (const SharedArea* area : {&channel_->output(0, 0), &channel_->output_ends(0, 0)}) {
      std::fill(area->begin(), area->end(), byte);
    }
  }

  Answers clip_twice(std::size_t batch, std::size_t first, std::size_t count) override {
    clip(batch, first, count);
    Answers second(kFormat<T>, stride());
    count = std::min(count, kMostAtOnce);
    reserve_output(1, *part_);
    const plugin::Request request = request_of(first, count);
    if (const auto failure = channel_->clip(request, plugin_.seconds(), true)) {
      for (std::size_t i = 0; i < count; ++i) second.fail(*failure);
      return second;
    }
    kept_ = Answers(kFormat<T>, stride());
    in_place_ = count;
    read_answer(1, count, second);
    return second;
  }

 private:
  std::size_t stride() const { return 4 + part_->request.task.attributes; }

  void add_part(const Batch& batch) {
    Part part{.batch = &batch};
    plugin::Request& request = part.request;
    request.task = task_of_batch<T>(batch);
    request.by_matrix = batch.matrix.has_value();
    request.projects = batch.space == Space::view &&
                       (request.by_matrix || !takes_in_view_space(plugin_, batch.frustum));
    request.most_vertices = most_vertices(batch, request.task);
    request.input = static_cast<std::uint32_t>(parts_.size() + 1);  // 0 is that of `ask_apart`
    const std::size_t vertices = first_vertex(batch, batch.size());
    part.numbers = vertices * request.task.stride;
    T* const to = channel_->input(request.input, std::max<std::size_t>(1, part.numbers * sizeof(T)))
                      .template last<T>(part.numbers);
    if (batch.space == Space::view) {
      write_vertices<Space::view>(batch, vertices, to);
    } else {
      write_vertices<Space::clip>(batch, vertices, to);
    }
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
  std::optional<Failure> ask_apart(std::size_t first, std::size_t count, double seconds) {
    plugin::Request request = request_of(first, count);
    const std::size_t bytes = request.task.vertices * request.task.stride * sizeof(T);
    SharedArea& apart = channel_->input(0, std::max<std::size_t>(1, bytes));
    std::memcpy(apart.end() - bytes, channel_->input(request.input, 0).begin() + request.input_at,
                bytes);
    request.input = 0;
    request.input_at = apart.size() - bytes;
    return channel_->clip(request, seconds);
  }

  void read_answer(std::size_t thread, std::size_t count, Answers& answers) const {
    if (count == 0) return;
    const std::size_t capacity = count * part_->request.most_vertices * stride();
    const T* number = channel_->output(thread, 0).template last<T>(capacity);
    const auto* ends = channel_->output_ends(thread, 0).template last<std::size_t>(count);
    const T* const start = number;
    for (std::size_t i = 0; i < count; ++i) {
      while (number < start + ends[i] * stride()) answers.add(*number++);
      answers.end_polygon();
    }
  }

  void keep_answer() {
    read_answer(0, in_place_, kept_);
    in_place_ = 0;
  }

  // Who does not end again and again is not waited for as long.
  double time_of_block() const {
    return plugin_.seconds() * (endless_ < kMostEndless ? 1 : kPartOfTime);
  }
  double time_of_part() const { return plugin_.seconds() * kPartOfTime; }

  void settle(std::size_t first, std::size_t count) {
    if (count == 0) return;
    if (const auto failure = ask_apart(first, count, time_of_part())) {
      look_into(first, count, *failure);
    } else {
      read_answer(0, count, kept_);
    }
  }

  // Finds who is to blame that [first, first + count) are not answered, and keeps the answers to
  // all others.
  void look_into(std::size_t first, std::size_t count, const Failure& failure) {
    if (count == 1) return blame_one(first, failure);
    if (endless_ >= kMostEndless || found_ >= kMostFound) return blame_all(count, failure);
    const std::size_t half = count / 2;
    if (const auto left = ask_apart(first, half, time_of_part())) {
      look_into(first, half, *left);
      return settle(first + half, count - half);
    }
    if (const auto right = ask_apart(first + half, count - half, time_of_part())) {
      settle(first, half);
      return look_into(first + half, count - half, *right);
    }
    blame_last_of_shortest(first, count, failure);
  }

  // It had a part of the time alone; now it gets all of it.
  void blame_one(std::size_t primitive, const Failure& failure) {
    const auto again = ask_apart(primitive, 1, time_of_block());
    if (!again) return read_answer(0, 1, kept_);
    ++found_;
    endless_ += failure.kind == Failure::Kind::timed_out;
    kept_.fail(*again);
  }

  void blame_all(std::size_t count, const Failure& failure) {
    for (std::size_t i = 0; i < count; ++i) {
      kept_.fail({failure.kind, fmt::format("{}, in a batch of {} that was not looked into further",
                                            failure.reason, count)});
    }
  }

  // Both halves are answered by themselves.
  void blame_last_of_shortest(std::size_t first, std::size_t count, const Failure& failure) {
    std::size_t answered = count / 2, fails = count;
    Failure last = failure;
    while (fails - answered > 1) {
      const std::size_t middle = answered + (fails - answered) / 2;
      const auto found = ask_apart(first, middle, time_of_part());
      (found ? fails : answered) = middle;
      if (found) last = *found;
    }
    ++found_;
    endless_ += last.kind == Failure::Kind::timed_out;
    settle(first, answered);
    last.reason += fmt::format(" after the {} before it, not alone", answered);
    kept_.fail(last);
    settle(first + fails, count - fails);
  }

  Plugin& plugin_;
  std::unique_ptr<PluginChannel> channel_;
  std::vector<Part> parts_;
  const Part* part_ = nullptr;
  Answers kept_;
  std::size_t in_place_ = 0;  // primitives of the last block
  int endless_ = 0, found_ = 0;
};

}  // namespace

std::unique_ptr<PluginRunner> make_plugin_runner(Plugin& plugin, const Format& format,
                                                 std::span<const Batch> batches) {
  if (format.is_float()) return std::make_unique<TypedPluginRunner<float>>(plugin, batches);
  return std::make_unique<TypedPluginRunner<double>>(plugin, batches);
}

}  // namespace clipscope::experiments
