// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/report/explorer_link.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstddef>
#include <sstream>
#include <string_view>
#include <vector>

#include "experiments/contestants/contestant.hpp"
#include "experiments/report/html.hpp"

namespace clipscope::experiments {
namespace {

constexpr std::size_t kExplorerAttributes = 4;
constexpr std::string_view kExplorerScalars[] = {"float", "double"};

// What a replay_text (selection/replay_text.hpp) says.
struct Question {
  std::string options;  // "&space=clip&depth=gl"
  std::size_t dimension = 3, attributes = 0, clip_distances = 0;
  std::vector<std::string> numbers;
};

std::vector<std::string> words_of(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> words;
  for (std::string word; stream >> word;) words.push_back(word);
  return words;
}

std::size_t count_of(const std::string& word) {
  std::size_t count = 0;
  std::from_chars(word.data(), word.data() + word.size(), count);
  return count;
}

// Takes one option in; returns false if the explorer has none such. value: the word that follows.
bool take(const std::string& word, const std::string& value, Question& question) {
  constexpr std::array kSame = {"--space", "--frustum", "--ortho", "--depth", "--clip-distances"};
  if (word == "--attributes") {
    question.attributes = count_of(value);
  } else if (std::ranges::find(kSame, word) != kSame.end()) {
    question.options += "&" + word.substr(2) + "=" + value;
  } else {
    return false;
  }
  if (word == "--space" && value == "clip") question.dimension = 4;
  if (word == "--clip-distances") question.clip_distances = count_of(value);
  return true;
}

// Those whose value, if there is one, is in the word itself.
bool take_flag(const std::string& word, Question& question) {
  if (word == "--depth-clamp") {
    question.options += "&depth-clamp=both";
    return true;
  }
  if (!word.starts_with("--depth-clamp=") && !word.starts_with("--half-open=")) return false;
  question.options += "&" + word.substr(2);
  return true;
}

bool can_be_shown(const Question& q) {
  const auto is_finite = [](const std::string& x) { return x.find("0x") != std::string::npos; };
  return q.clip_distances <= kExplorerAttributes &&
         q.numbers.size() == 3 * (q.dimension + q.attributes) &&
         std::ranges::all_of(q.numbers, is_finite);
}

// Returns false if the explorer does not have such a question.
bool read(const std::string& input, Question& question) {
  const std::size_t colon = input.find(" : ");
  if (colon == std::string::npos) return false;
  const std::vector<std::string> words = words_of(input.substr(0, colon));
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (take_flag(words[i], question)) continue;
    if (i + 1 == words.size() || !take(words[i], words[i + 1], question)) return false;
    ++i;
  }
  question.numbers = words_of(input.substr(colon + 3));
  return can_be_shown(question);
}

bool is_in_explorer(const WorstInput& worst) {
  if (std::ranges::find(kExplorerScalars, worst.scalar) == std::end(kExplorerScalars)) return false;
  return std::ranges::any_of(all_contestants(), [&](const Contestant& c) {
    return c.clipper == worst.clipper && c.scalar() == worst.scalar && !c.is_guest &&
           c.contract == Contract::full && c.vertices == 3;
  });
}

// "&a=X,Y,Z;A,B": attributes beyond those that the explorer has are left out.
std::string vertex_text(const Question& q, std::size_t vertex) {
  const std::size_t first = vertex * (q.dimension + q.attributes);
  const std::size_t size = q.dimension + std::min(q.attributes, kExplorerAttributes);
  std::string text = fmt::format("&{}=", "abc"[vertex]);
  for (std::size_t i = 0; i < size; ++i) {
    text += (i == 0 ? "" : i == q.dimension ? ";" : ",") + q.numbers[first + i];
  }
  return text;
}

}  // namespace

std::string explorer_fragment(const std::string& experiment, const WorstInput& worst) {
  Question question;
  if (!is_in_explorer(worst) || !read(worst.input, question)) return "";
  std::string text = "v1" + question.options;
  for (std::size_t vertex = 0; vertex < 3; ++vertex) text += vertex_text(question, vertex);
  const std::string_view other = worst.clipper == "barycentric/distance_matrix"
                                     ? "homogeneous/sutherland_hodgman"
                                     : "barycentric/distance_matrix";
  const std::string source =
      fmt::format("{}: worst input of {} in {}", experiment, worst.clipper, worst.scalar);
  return text + fmt::format("&scalar={}&clippers={},{}&source={}", worst.scalar, worst.clipper,
                            other, url_of(source));
}

}  // namespace clipscope::experiments
