// SPDX-License-Identifier: GPL-3.0-or-later
//
// Dates in UTC: "2026-03-01T12:34:56Z" (ISO 8601).
#pragma once

#include <fmt/chrono.h>

#include <ctime>
#include <string>

namespace clipscope::experiments {

inline std::string date_of(std::time_t time) {
  return fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(time));
}

inline std::string date_now() { return date_of(std::time(nullptr)); }

}  // namespace clipscope::experiments
