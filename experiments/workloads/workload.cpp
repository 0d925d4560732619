// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/workloads/workload.hpp"

#include <limits>
#include <utility>
#include <vector>

#include "experiments/catalogue/catalogue.hpp"
#include "experiments/scenes/builtin.hpp"
#include "experiments/scenes/camera.hpp"
#include "experiments/workloads/forms.hpp"
#include "experiments/workloads/lattice_draws.hpp"
#include "experiments/workloads/plain_call.hpp"
#include "experiments/workloads/random_draws.hpp"
#include "experiments/workloads/scene_draws.hpp"

namespace clipscope::experiments {
namespace {

constexpr std::size_t kAllChunks = std::numeric_limits<std::size_t>::max();

class Workload {
 public:
  Workload(const WorkloadOptions& options, const DriverInfo& info,
           const std::function<void(const DrawCall&)>& f)
      : options_(options), info_(info), f_(f) {}

  LeftOut all() {
    if (!options_.cases.empty()) add_cases(load_catalogue(options_.cases));
    if (options_.catalogue) add_cases(builtin_catalogue());
    for (std::size_t i = 0; i < options_.lattice; ++i) add(lattice_draw(options_.seed, i, info_));
    for (std::size_t i = 0; i < options_.random; ++i) add(random_draw(options_.seed, i, info_));
    if (options_.scenes) add_scenes();
    if (!options_.scene.empty()) {
      add_scene(load_scene(options_.scene, {.seed = options_.seed}, CameraOptions{}), kAllChunks);
    }
    return std::move(left_out_);
  }

 private:
  void add_cases(const std::vector<HardCase>& cases) {
    for (const HardCase& c : cases) {
      for (DrawCall& form : forms_of(c, info_)) add(std::move(form));
    }
  }

  void add_scenes() {
    const SceneOptions options{.seed = options_.seed, .quick = true};
    for (const SceneInfo& scene : builtin_scenes()) {
      add_scene(make_builtin_scene(scene.name, options), 1);
    }
  }

  void add_scene(const Scene& scene, std::size_t most_chunks) {
    for (DrawCall& call : scene_draws(scene, info_, most_chunks)) add(std::move(call));
  }

  void add(DrawCall call) {
    if (options_.size > 0) resize(call);
    const std::string reason = inability(info_, call);
    if (reason.empty()) {
      f_(call);
    } else {
      ++left_out_[reason];
    }
  }

  // A viewport other than the target's stays where it is: it is what the call is about.
  void resize(DrawCall& call) const {
    const Viewport before = call.viewport;
    const bool is_whole = has_whole_viewport(call);
    set_size(call, options_.size, options_.size);
    if (!is_whole) call.viewport = before;
  }

  const WorkloadOptions& options_;
  const DriverInfo& info_;
  const std::function<void(const DrawCall&)>& f_;
  LeftOut left_out_;
};

}  // namespace

LeftOut for_each_draw_call(const WorkloadOptions& options, const DriverInfo& info,
                           const std::function<void(const DrawCall&)>& f) {
  return Workload(options, info, f).all();
}

}  // namespace clipscope::experiments
