// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/backends/driver_process.hpp"

#include <fmt/format.h>

#include <utility>

#include "experiments/backends/host_process.hpp"
#include "experiments/drawcalls/wire.hpp"
#include "experiments/machine/errors.hpp"

namespace clipscope::experiments {
namespace {

constexpr double kStartSeconds = 60;  // a browser on a busy machine

[[noreturn]] void refuse(const KnownDriver& driver, const std::string& reason) {
  throw GuestError(fmt::format(
      "{}: {}{}", driver.name, reason,
      driver.package.empty() ? "" : fmt::format(" (Debian package: {})", driver.package)));
}

// Whether the pixels are those of the call, each quantity that was asked for among them.
bool is_answer_to(const DrawCall& call, const Pixels& pixels) {
  Quantities asked = call.quantities;
  asked.set(bit(Quantity::covered)).set(bit(Quantity::hits));
  for (std::size_t q = 0; q < kQuantities; ++q) {
    if (asked[q] == pixels.values[q].empty()) return false;
  }
  return pixels.width == call.width && pixels.height == call.height;
}

}  // namespace

DriverProcess::DriverProcess(const KnownDriver& driver, double seconds_per_draw)
    : driver_(driver), seconds_per_draw_(seconds_per_draw) {
  keep_memory_of_pixels();
  start();
}

DriverProcess::~DriverProcess() = default;

void DriverProcess::start() {
  auto host = std::make_unique<HostProcess>(driver_);
  const auto answer = host->answer({}, kStartSeconds);
  if (const auto* failure = std::get_if<DrawFailure>(&answer)) {
    refuse(driver_, fmt::format("{} {}", driver_.host, failure->reason));
  }
  const std::optional<Greeting> greeting = greeting_of(std::get<std::string>(answer));
  if (!greeting) {
    refuse(driver_, fmt::format("{} {}", driver_.host, host->fail_for_nonsense().reason));
  }
  if (const auto* reason = std::get_if<std::string>(&*greeting)) refuse(driver_, *reason);
  info_ = std::get<DriverInfo>(*greeting);
  if (info_.renderer.find(driver_.renderer) == std::string::npos) {
    refuse(driver_, fmt::format("another driver answers in its place: \"{}\"", info_.renderer));
  }
  host_ = std::move(host);
}

Drawn DriverProcess::draw(const DrawCall& call) {
  using Kind = DrawFailure::Kind;
  std::string reason = inability(info_, call);
  if (!reason.empty()) return DrawFailure{Kind::unable, std::move(reason)};
  try {
    if (!host_) start();
  } catch (const GuestError& error) {
    return DrawFailure{Kind::crashed, fmt::format("does not start again: {}", error.what())};
  }
  const auto answer = host_->answer(to_bytes(call), seconds_per_draw_);
  if (const auto* failure = std::get_if<DrawFailure>(&answer)) {
    host_.reset();
    return *failure;
  }
  std::optional<Drawn> drawn = drawn_of(std::get<std::string>(answer));
  const auto* pixels = drawn ? std::get_if<Pixels>(&*drawn) : nullptr;
  if (drawn && (!pixels || is_answer_to(call, *pixels))) return std::move(*drawn);
  const DrawFailure failure = host_->fail_for_nonsense();
  host_.reset();
  return failure;
}

}  // namespace clipscope::experiments
