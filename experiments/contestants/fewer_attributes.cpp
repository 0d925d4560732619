// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/contestants/fewer_attributes.hpp"

#include <algorithm>
#include <deque>
#include <utility>

namespace clipscope::experiments {
namespace {

int attributes_left(const Batch& batch, int most) {
  return std::min(batch.attributes, most - static_cast<int>(batch.planes.size()));
}

// A runner with its batches.
class NarrowRunner final : public Runner {
 public:
  NarrowRunner(const decltype(Contestant::prepare)& prepare, std::span<const Batch> batches,
               int most) {
    for (const Batch& batch : batches) batches_.push_back(owned_.emplace_back(batch, most).batch());
    runner_ = prepare(batches_);
  }

  void clip(std::size_t batch, std::size_t first, std::size_t count) override {
    runner_->clip(batch, first, count);
  }
  Answers answers() const override { return runner_->answers(); }
  std::int64_t interruptions() override { return runner_->interruptions(); }
  void enter_clock() override { runner_->enter_clock(); }
  void leave_clock() override { runner_->leave_clock(); }
  Runner& worker() override { return runner_->worker(); }

 private:
  std::deque<NarrowBatch> owned_;
  std::vector<Batch> batches_;
  std::unique_ptr<Runner> runner_;
};

}  // namespace

NarrowBatch::NarrowBatch(const Batch& batch, int most) : batch_(batch) {
  batch_.attributes = attributes_left(batch, most);
  std::visit(
      [&]<class T>(std::span<const T> all) {
        auto& kept = numbers_.emplace<std::vector<T>>();
        for (std::size_t v = 0; v + batch.stride() <= all.size(); v += batch.stride()) {
          const auto vertex = all.subspan(v, batch_.stride());
          kept.insert(kept.end(), vertex.begin(), vertex.end());
        }
        batch_.numbers = std::span<const T>(kept);
      },
      batch.numbers);
}

bool has_more_attributes(const Batch& batch, int most) {
  return attributes_left(batch, most) < batch.attributes;
}

Contestants with_attributes(Contestants contestants, int attributes) {
  std::erase_if(contestants, [=](const Contestant* c) { return c->most_attributes < attributes; });
  return contestants;
}

decltype(Contestant::prepare) with_fewer_attributes(decltype(Contestant::prepare) prepare,
                                                    int most) {
  return [prepare = std::move(prepare),
          most](std::span<const Batch> batches) -> std::unique_ptr<Runner> {
    const bool is_wide = std::ranges::any_of(
        batches, [most](const Batch& batch) { return has_more_attributes(batch, most); });
    if (is_wide) return std::make_unique<NarrowRunner>(prepare, batches, most);
    return prepare(batches);
  };
}

}  // namespace clipscope::experiments
