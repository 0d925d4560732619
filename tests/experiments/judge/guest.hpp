// SPDX-License-Identifier: GPL-3.0-or-later
//
// Guests made by hand: one of our clippers, float, that spoils what it answers, or fails to.
#pragma once

#include <functional>
#include <memory>
#include <utility>

#include "experiments/selection/select.hpp"
#include "tests/experiments/contestants/handmade.hpp"

namespace clipscope::experiments {

// What a guest makes of the honest answer to a primitive, the call's number and the primitive's
// place in it given.
struct GuestCall {
  std::size_t call, primitive;
  const Batch& batch;
};
using Spoil = std::function<void(const GuestCall&, Numbers&)>;
using Fails = std::function<bool(const GuestCall&)>;

class GuestRunner final : public Runner {
 public:
  GuestRunner(std::unique_ptr<Runner> honest, const Batch& batch,
              std::shared_ptr<std::size_t> calls, Spoil spoil, Fails fails)
      : honest_(std::move(honest)),
        batch_(batch),
        calls_(std::move(calls)),
        spoil_(std::move(spoil)),
        fails_(std::move(fails)) {}

  void clip(std::size_t batch, std::size_t first, std::size_t count) override {
    call_ = (*calls_)++;
    honest_->clip(batch, first, count);
  }
  Answers answers() const override {
    const Answers honest = honest_->answers();
    Answers answers(honest.format(), honest.stride());
    for (std::size_t i = 0; i < honest.size(); ++i) {
      const GuestCall call{call_, i, batch_};
      if (fails_ && fails_(call)) {
        answers.fail({Failure::Kind::crashed, "the process ended by signal 11"});
        continue;
      }
      Numbers polygon = numbers_of(honest[i]);
      if (spoil_) spoil_(call, polygon);
      add_polygon(polygon, answers);
    }
    return answers;
  }

 private:
  std::unique_ptr<Runner> honest_;
  const Batch& batch_;
  std::shared_ptr<std::size_t> calls_;  // of all its runners
  std::size_t call_ = 0;
  Spoil spoil_;
  Fails fails_;
};

// A guest that clips as the clipper does, but for what `spoil` does to its polygons, and that gives
// no answer where `fails` says so. It states nothing.
inline Contestant guest_like(std::string_view clipper, Spoil spoil, Fails fails = {}) {
  const Contestant& honest = find_contestant(clipper, "float");
  Contestant guest = honest;
  guest.clipper = "guest/by_hand";
  guest.is_guest = true;
  guest.promise = no_promise();
  const auto calls = std::make_shared<std::size_t>(0);
  guest.prepare = [&honest, spoil, fails,
                   calls](std::span<const Batch> batches) -> std::unique_ptr<Runner> {
    return std::make_unique<GuestRunner>(honest.prepare(batches), batches[0], calls, spoil, fails);
  };
  return guest;
}

}  // namespace clipscope::experiments
