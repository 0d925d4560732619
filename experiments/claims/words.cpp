// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/claims/words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>

#include "experiments/contestants/spoken.hpp"

namespace clipscope::experiments::claims {
namespace {

struct LineMix {
  std::string_view name, words;
};

constexpr std::array kLineMixes = {
    LineMix{"inside", "lines inside"},
    LineMix{"beside", "lines beside the window"},
    LineMix{"past_corner", "lines past a corner"},
    LineMix{"one_end_out", "lines with one end out"},
    LineMix{"both_ends_out", "lines with both ends out"},
    LineMix{"box_1", "lines in a box of one window"},
    LineMix{"window_1_64", "lines of which the window shows a tiny part"},
    LineMix{"window_1_8", "lines of which the window shows a small part"},
    LineMix{"window_1_1", "lines in a space as large as the window"},
    LineMix{"window_4_1", "lines in a space smaller than the window"},
    LineMix{"long_lines", "long lines"},
    LineMix{"outside", "lines outside"},
    LineMix{"cross_one", "lines across one plane"},
    LineMix{"cross_several", "lines across several planes"},
    LineMix{"cross_w0", "lines that reach behind the eye"}};

// Behind the name of a mix of which many triangles are cut at once.
constexpr std::string_view kInBatches = " in batches";

// Names with a number in them, and what one or several of these cases are called.
struct Scale {
  std::string_view before, after;
  std::string_view one, several;
};

constexpr std::array kScales = {
    Scale{"box_", "", "lines in a box of {} windows", "lines in boxes of {} windows"},
    Scale{"", " edges", "lines in a polygon of {} edges", "lines in polygons of {} edges"}};

// The number, as text, that a name has on a scale.
std::optional<std::string_view> number_on(const Scale& scale, std::string_view name) {
  if (!name.starts_with(scale.before) || !name.ends_with(scale.after)) return std::nullopt;
  name.remove_prefix(scale.before.size());
  name.remove_suffix(scale.after.size());
  const bool is_number =
      !name.empty() && std::ranges::all_of(name, [](char c) { return '0' <= c && c <= '9'; });
  return is_number ? std::optional(name) : std::nullopt;
}

int value_of(std::string_view digits) {
  int value = 0;
  std::from_chars(digits.data(), digits.data() + digits.size(), value);
  return value;
}

// Those of the names that are on a scale, from the least to the greatest number.
std::vector<std::string> on_scale(const Scale& scale, const std::vector<std::string>& names) {
  std::vector<std::string> found;
  for (const std::string& name : names) {
    if (number_on(scale, name)) found.push_back(name);
  }
  std::ranges::sort(found, {},
                    [&](const std::string& n) { return value_of(*number_on(scale, n)); });
  return found;
}

// "8 or more", "up to 8", "8 to 64": a run of at least two of all the names on a scale. Nothing if
// the names leave one out between them.
std::optional<std::string> range_text(const Scale& scale, const std::vector<std::string>& names,
                                      const std::vector<std::string>& all) {
  const auto first = std::ranges::find(all, names.front());
  const auto last = std::ranges::find(all, names.back());
  if (names.size() < 2 || last - first + 1 != std::ssize(names)) return std::nullopt;
  const std::string_view low = *number_on(scale, *first), high = *number_on(scale, *last);
  std::string range = fmt::format("{} to {}", low, high);
  if (last + 1 == all.end()) range = fmt::format("{} or more", low);
  if (first == all.begin()) range = fmt::format("up to {}", high);
  return fmt::format(fmt::runtime(scale.several), range);
}

bool is_there(const std::vector<std::string>& names, const std::string& name) {
  return std::ranges::find(names, name) != names.end();
}

std::string stem_of(const std::string& name) {
  return name.substr(0, name.size() - kInBatches.size());
}

// Some of all names in words; neighbours on a scale are one, and so are a mix alone and in batches.
std::vector<std::string> spoken_all(std::vector<std::string> names,
                                    const std::vector<std::string>& all, Speak speak) {
  std::vector<std::string> words;
  for (const Scale& scale : kScales) {
    const std::vector<std::string> some = on_scale(scale, names);
    if (some.empty()) continue;
    const auto range = range_text(scale, some, on_scale(scale, all));
    if (!range) continue;
    words.push_back(*range);
    std::erase_if(names, [&](const std::string& n) { return number_on(scale, n).has_value(); });
  }
  for (const std::string& name : names) {
    if (is_there(names, name + std::string(kInBatches))) {
      words.push_back(speak(name) + " alone and in batches");
    } else if (!name.ends_with(kInBatches) || !is_there(names, stem_of(name))) {
      words.push_back(speak(name));
    }
  }
  return words;
}

// " in the window" of "Cohen-Sutherland in the window"; empty if there is none.
std::string place_in(const std::string& name) {
  for (const char* before : {" in ", " after "}) {
    if (const std::size_t at = name.find(before); at != name.npos) return name.substr(at);
  }
  return "";
}

// "a", "a or b", "a, b or c".
std::string either(const std::vector<std::string>& words) {
  std::string text = words.front();
  for (std::size_t i = 1; i < words.size(); ++i) {
    text += (i + 1 == words.size() ? " or " : ", ") + words[i];
  }
  return text;
}

}  // namespace

std::string number_text(double number) {
  return number < 1000 ? fmt::format("{:.3g}", number) : fmt::format("{:.0f}", number);
}

std::string pace_text(double times_as_fast, std::string_view up_to) {
  const bool is_faster = times_as_fast > 1;
  const double factor = is_faster ? times_as_fast : 1 / times_as_fast;
  const double percent = 100 * (factor - 1);
  if (percent < 0.5) return "is as fast as";
  if (factor < 2) {
    return fmt::format("{} {}{:.0f} % {} than", is_faster ? "is" : "takes", up_to, percent,
                       is_faster ? "faster" : "longer");
  }
  return fmt::format("{} {}{} times as {} as", is_faster ? "is" : "takes", up_to,
                     number_text(factor), is_faster ? "fast" : "long");
}

std::vector<std::string> spoken_methods(std::string_view clipper,
                                        const std::vector<std::string_view>& others) {
  std::vector<std::string> names = {spoken_clipper(clipper)};
  for (const std::string_view other : others) names.push_back(spoken_clipper(other));
  const std::string place = place_in(names[0]);
  const bool is_shared = std::ranges::all_of(names, [&](const std::string& name) {
    const std::string other = place_in(name);
    return other.empty() || other == place;
  });
  if (!is_shared) return names;
  for (std::string& name : names) name.resize(name.size() - place_in(name).size());
  return names;
}

std::string edges_name(std::int64_t edges) { return fmt::format("{} edges", edges); }

std::string spoken_triangles(std::string_view name) {
  const std::size_t set = std::min(name.find(' '), name.size());
  return fmt::format("{}{}", spoken_set(name.substr(0, set)), name.substr(set));
}

std::string spoken_lines(std::string_view name) {
  const auto known = std::ranges::find(kLineMixes, name, &LineMix::name);
  if (known != kLineMixes.end()) return std::string(known->words);
  for (const Scale& scale : kScales) {
    if (const auto number = number_on(scale, name)) {
      return fmt::format(fmt::runtime(scale.one), *number);
    }
  }
  return spoken_set(name);
}

std::string where_text(const std::vector<std::string>& holding,
                       const std::vector<std::string>& failing, Speak speak) {
  constexpr std::size_t kLongest = 120;  // characters that a person takes in at once
  std::vector<std::string> all = holding;
  all.insert(all.end(), failing.begin(), failing.end());
  const std::vector<std::string> named = spoken_all(holding, all, speak);
  const std::vector<std::string> excepted = spoken_all(failing, all, speak);
  const std::string where = excepted.size() < named.size()
                                ? "The input is anything but " + either(excepted)
                                : "The input consists of " + either(named);
  if (where.size() <= kLongest) return where;
  return fmt::format("The input suits it, as {} of {} cases do", holding.size(), all.size());
}

}  // namespace clipscope::experiments::claims
