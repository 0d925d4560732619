// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/guests/plugin_channel.hpp"

#include <utility>

#include "experiments/guests/plugin_said.hpp"
#include "experiments/machine/measuring.hpp"

namespace clipscope::experiments {
PluginChannel::PluginChannel(std::string library, std::vector<int> processors)
    : library_(std::move(library)), processors_(std::move(processors)) {}

PluginHost& PluginChannel::host() {
  if (!host_) {
    host_ = std::make_unique<PluginHost>(library_, processors_);
    for (Shared& input : inputs_) input.is_known = false;
    for (Shared* s :
         {&input_ends_, &outputs_[0], &outputs_[1], &output_ends_[0], &output_ends_[1]}) {
      s->is_known = false;
    }
  }
  return *host_;
}

SharedArea& PluginChannel::reserved(Shared& shared, std::size_t bytes) {
  if (shared.area.reserve(bytes)) shared.is_known = false;
  return shared.area;
}

SharedArea& PluginChannel::input(std::size_t index, std::size_t bytes) {
  while (inputs_.size() <= index) inputs_.push_back({plugin::Use::input, inputs_.size()});
  return reserved(inputs_[index], bytes);
}
SharedArea& PluginChannel::output(std::size_t thread, std::size_t bytes) {
  return reserved(outputs_[thread], bytes);
}
SharedArea& PluginChannel::output_ends(std::size_t thread, std::size_t bytes) {
  return reserved(output_ends_[thread], bytes);
}

std::optional<Failure> PluginChannel::hand_over_all() {
  const auto hand_over = [&](Shared& shared) -> std::optional<Failure> {
    if (shared.is_known || shared.area.size() == 0) return {};
    shared.is_known = true;
    return host_->hand_over(shared.use, shared.index, shared.area);
  };
  for (Shared& input : inputs_) {
    if (auto failure = hand_over(input)) return failure;
  }
  for (Shared* s : {&input_ends_, &outputs_[0], &outputs_[1], &output_ends_[0], &output_ends_[1]}) {
    if (auto failure = hand_over(*s)) return failure;
  }
  return {};
}

std::optional<Failure> PluginChannel::clip(const plugin::Request& request, double seconds,
                                           bool twice) {
  host().request() = request;
  std::optional<Failure> failure = hand_over_all();
  const plugin::Order order = twice ? plugin::Order::clip_twice : plugin::Order::clip;
  if (!failure) failure = host_->ask(order, seconds);
  if (failure) {
    host_.reset();
    return failure;
  }
  return malformed(std::as_const(*host_).control());
}

Plugin::Plugin(std::string library, double seconds)
    : library_(std::move(library)), seconds_(seconds), processors_(allowed_processors()) {
  std::unique_ptr<PluginChannel> first = take();
  description_ = first->description();
  give_back(std::move(first));
}

std::unique_ptr<PluginChannel> Plugin::take() {
  const std::lock_guard lock(mutex_);
  if (idle_.empty()) return std::make_unique<PluginChannel>(library_, processors_);
  std::unique_ptr<PluginChannel> channel = std::move(idle_.back());
  idle_.pop_back();
  return channel;
}

void Plugin::give_back(std::unique_ptr<PluginChannel> channel) {
  const std::lock_guard lock(mutex_);
  idle_.push_back(std::move(channel));
}

}  // namespace clipscope::experiments
