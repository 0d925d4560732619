// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/guests/texts.hpp"

#include <list>
#include <utility>

namespace clipscope::experiments {

std::string_view kept_text(std::string text) {
  static std::list<std::string> kept;
  return kept.emplace_back(std::move(text));
}

std::string shell_word(const std::string& text) {
  constexpr std::string_view kPlain =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_./-+=:,@%";
  if (!text.empty() && text.find_first_not_of(kPlain) == std::string::npos) return text;
  std::string quoted = "'";
  for (const char c : text) quoted += c == '\'' ? "'\\''" : std::string(1, c);
  return quoted + "'";
}

}  // namespace clipscope::experiments
