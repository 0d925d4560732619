// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/workloads/hunted.hpp"

#include <algorithm>
#include <utility>

#include "experiments/hunt/breeding.hpp"
#include "experiments/workloads/plain_call.hpp"

namespace clipscope::experiments {
namespace {

// Up to as many vertices in a row as a prey has, from a random one on.
struct Window {
  std::size_t first, count;
};

Window random_window(const DrawCall& call, Random& random) {
  const std::size_t count = std::min(call.vertices.size(), hunt::Prey::kVertices);
  return {random.below(call.vertices.size() - count + 1), count};
}

hunt::Prey prey_of(const DrawCall& call, const Window& window) {
  hunt::Prey prey;
  for (std::size_t i = 0; i < prey.position.size(); ++i) {
    prey.position[i] = call.vertices[window.first + i % window.count].position;
  }
  return prey;
}

DrawCall with_prey(DrawCall call, const Window& window, const hunt::Prey& prey) {
  for (std::size_t i = 0; i < window.count; ++i) {
    call.vertices[window.first + i].position = prey.position[i];
  }
  return call;
}

class Lines {
 public:
  Lines(std::span<const DrawCall> beginnings, const DrawError& error, const HuntedOptions& options)
      : error_(error), random_(options.seed) {
    for (const DrawCall& call :
         beginnings.first(std::min(beginnings.size(), options.evaluations))) {
      lines_.push_back({.call = call, .error = error_(call)});
    }
    sort();
  }

  // One evaluation. Pre-condition: there is a line.
  void step() {
    constexpr int kTries = 16;
    HuntedDraw& line = lines_[preferred()];
    DrawCall changed = change(line.call);
    for (int i = 1; i < kTries && !is_another(changed, line.call); ++i) changed = change(line.call);
    const double error = is_another(changed, line.call) ? error_(changed) : 0;
    if (!(error > line.error)) return;
    line = {.call = std::move(changed), .error = error, .is_beginning = false};
    sort();
  }

  std::vector<HuntedDraw> all() { return std::move(lines_); }

 private:
  void sort() {
    std::ranges::stable_sort(
        lines_, [](const HuntedDraw& a, const HuntedDraw& b) { return a.error > b.error; });
  }

  // The lower of two places: the worse come more often.
  std::size_t preferred() {
    const std::size_t a = random_.below(lines_.size()), b = random_.below(lines_.size());
    return std::min(a, b);
  }

  DrawCall change(const DrawCall& call) {
    const hunt::Setting setting{.volume = {.depth = call.volume.depth}};
    const Window window = random_window(call, random_);
    hunt::Prey prey = prey_of(call, window);
    if (random_.chance(0.1)) {
      const DrawCall& other = lines_[preferred()].call;
      prey = hunt::crossed(prey, prey_of(other, random_window(other, random_)), random_);
    } else {
      prey = hunt::mutated(setting, prey, 0, random_);
    }
    return with_prey(call, window, prey);
  }

  static bool is_another(const DrawCall& a, const DrawCall& b) {
    return a.vertices != b.vertices && is_finite(a);
  }

  const DrawError& error_;
  Random random_;
  std::vector<HuntedDraw> lines_;
};

}  // namespace

std::vector<HuntedDraw> hunted_draws(std::span<const DrawCall> beginnings, const DrawError& error,
                                     const HuntedOptions& options) {
  Lines lines(beginnings, error, options);
  for (std::size_t i = beginnings.size(); !beginnings.empty() && i < options.evaluations; ++i) {
    lines.step();
  }
  return lines.all();
}

}  // namespace clipscope::experiments
