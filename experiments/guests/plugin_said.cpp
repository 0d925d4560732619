// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/guests/plugin_said.hpp"

#include <fmt/format.h>
#include <sys/wait.h>

#include <string_view>
#include <utility>

#include "experiments/guests/child.hpp"
#include "experiments/table/utf8.hpp"

namespace clipscope::experiments {
namespace {

template <class E, std::size_t N>
std::string_view word_for(const E& shared, const std::string_view (&words)[N]) {
  const auto place = static_cast<std::size_t>(read_once(shared));
  return place < N ? words[place] : "";
}

std::string reach_text(const plugin::Reach& reach) {
  constexpr std::string_view kAccesses[] = {"reached", "read", "wrote"};
  constexpr std::string_view kSides[] = {"in front of", "into", "beyond the end of"};
  constexpr std::string_view kThings[] = {"", "its input", "the ends of its input", "its output",
                                          "the ends of its output"};
  const std::string_view access = word_for(reach.access, kAccesses),
                         side = word_for(reach.side, kSides), thing = word_for(reach.use, kThings);
  if (access.empty() || side.empty() || thing.empty()) return "reached beyond its memory";
  return fmt::format("{} {} {}", access, side, thing);
}

}  // namespace

std::string text_of(const plugin::Text& text) {
  std::string copy;
  for (const char& shared : text) {
    const char c = read_once(shared);
    if (c == '\0') break;
    copy += c;
  }
  return valid_utf8(copy);
}

std::optional<Failure> malformed(const plugin::Control& said) {
  using plugin::Fault;
  const auto failure = [](std::string reason) {
    return Failure{Failure::Kind::malformed, std::move(reason)};
  };
  switch (read_once(said.fault)) {
    case Fault::returned_error: return failure(fmt::format("returns error {}", said.code));
    case Fault::wrote_before_output: return failure("wrote in front of its output");
    case Fault::ends_descend:
      return failure(fmt::format("leaves ends that descend at primitive {}", said.at));
    case Fault::too_many_vertices:
      return failure(fmt::format("leaves a polygon of {} vertices", said.vertices));
    default: return {};
  }
}

bool says_why_it_ends(const plugin::Control& said) {
  const plugin::Fault fault = read_once(said.fault);
  return fault == plugin::Fault::out_of_bounds || fault == plugin::Fault::signal;
}

Failure failure_of_end(const plugin::Control& said, int status) {
  const plugin::Fault fault = read_once(said.fault);
  std::string reason;
  if (fault == plugin::Fault::out_of_bounds) {
    reason = reach_text(said.reach);
  } else if (fault == plugin::Fault::signal) {
    reason = fmt::format("was ended by {}", signal_text(read_once(said.code)));
  } else if (WIFSIGNALED(status)) {
    reason = fmt::format("was ended by {}", signal_text(WTERMSIG(status)));
  } else {
    reason = fmt::format("ended its process with exit code {}", WEXITSTATUS(status));
  }
  return {Failure::Kind::crashed, reason};
}

}  // namespace clipscope::experiments
