// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/guests/texts.hpp"

#include <list>
#include <utility>

namespace clipscope::experiments {

std::string_view kept_text(std::string text) {
  static std::list<std::string> kept;
  return kept.emplace_back(std::move(text));
}

}  // namespace clipscope::experiments
