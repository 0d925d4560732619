// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/table/prose.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <iterator>
#include <sstream>
#include <utility>

namespace clipscope::experiments {
namespace {

bool is_capital(char c) { return c >= 'A' && c <= 'Z'; }

// A full stop ends a sentence where a blank follows; that of a number does not.
std::vector<std::string> sentences_of(const std::string& text) {
  std::vector<std::string> sentences;
  std::size_t from = 0;
  while (from < text.size()) {
    const std::size_t stop = text.find(". ", from);
    sentences.push_back(text.substr(from, stop == std::string::npos ? stop : stop + 1 - from));
    if (stop == std::string::npos) break;
    from = text.find_first_not_of(' ', stop + 1);
  }
  return sentences;
}

// "(8661," is 8661.
std::string without_punctuation(const std::string& word) {
  const std::size_t from = word.find_first_not_of("([\"");
  const std::size_t to = word.find_last_not_of(")]\".,:;");
  if (from == std::string::npos || to == std::string::npos || to < from) return "";
  return word.substr(from, to + 1 - from);
}

bool is_number(const std::string& word) {
  double value = 0;
  const char* const from = word.data() + (word.starts_with('+') ? 1 : 0);
  const char* const end = word.data() + word.size();
  return word.find_first_of("0123456789") != std::string::npos &&
         std::from_chars(from, end, value).ptr == end;
}

bool is_relation(const std::string& word) {
  return !word.empty() && word.find_first_not_of("<>=") == std::string::npos;
}

std::size_t count_words(const std::string& sentence) {
  const auto blanks = std::ranges::count(sentence, ' ');
  return static_cast<std::size_t>(blanks) + 1;
}

std::vector<std::string> faults_of_sentence(const std::string& sentence, std::size_t most_words) {
  std::vector<std::string> faults;
  if (!is_capital(sentence.front())) faults.push_back("no capital in front of it");
  if (const std::size_t words = count_words(sentence); words > most_words) {
    faults.push_back(fmt::format("{} words, more than {}", words, most_words));
  }
  for (const auto& [mark, what] :
       {std::pair{'(', "parentheses"}, std::pair{':', "colons"}, std::pair{';', "semicolons"}}) {
    if (std::ranges::count(sentence, mark) > 1) faults.push_back(fmt::format("heaped {}", what));
  }
  for (std::string& fault : faults) fault += fmt::format(": \"{}\"", sentence);
  return faults;
}

}  // namespace

std::string capitalised(std::string text) {
  if (!text.empty() && text.front() >= 'a' && text.front() <= 'z') {
    text.front() = static_cast<char>(text.front() - 'a' + 'A');
  }
  return text;
}

std::string listed(const std::vector<std::string>& things) {
  std::string text;
  for (std::size_t i = 0; i < things.size(); ++i) {
    if (i > 0) text += i + 1 == things.size() ? " and " : ", ";
    text += things[i];
  }
  return text;
}

std::string some_of(std::int64_t count, std::int64_t of, std::string_view things) {
  if (count == 0) return fmt::format("none of the {}", things);
  if (count == of) return fmt::format("all {}", things);
  return fmt::format("{} of {} {}", count, of, things);
}

std::string times_text(double factor) {
  return factor < 1000 ? fmt::format("{:.3g} times", factor) : fmt::format("{:.0f} times", factor);
}

std::string number_word(std::int64_t n) {
  constexpr std::array<std::string_view, 13> kWords = {"no",   "one",    "two",   "three", "four",
                                                       "five", "six",    "seven", "eight", "nine",
                                                       "ten",  "eleven", "twelve"};
  const auto place = static_cast<std::size_t>(n);
  return place < kWords.size() ? std::string(kWords[place]) : fmt::format("{}", n);
}

std::string_view quantity(double share) {
  if (share <= 0) return "no";
  if (share <= 0.2) return "few";
  if (share < 0.5) return "some";
  if (share < 0.9) return "most";
  return share < 1 ? "nearly all" : "all";
}

std::vector<std::string> figures_in(std::string_view text) {
  std::istringstream words{std::string(text)};
  std::vector<std::string> figures;
  std::string before;
  for (std::string word; words >> word; before = word) {
    const std::string number = without_punctuation(word);
    if (is_number(number) && !is_relation(before)) figures.push_back(number);
  }
  return figures;
}

std::vector<std::string> faults_of_prose(std::string_view text, const ProseLimits& limits) {
  if (text.empty()) return {"it says nothing"};
  std::vector<std::string> faults;
  const auto fault_if = [&](bool is_fault, std::string what) {
    if (is_fault) faults.push_back(std::move(what));
  };
  const std::vector<std::string> figures = figures_in(text);
  const std::vector<std::string> sentences = sentences_of(std::string(text));
  fault_if(figures.size() > limits.figures,
           fmt::format("{} figures, more than {}", figures.size(), limits.figures));
  fault_if(sentences.size() > limits.sentences,
           fmt::format("{} sentences, more than {}", sentences.size(), limits.sentences));
  fault_if(text.back() != '.', "no full stop at its end");
  fault_if(text.find('/') != text.npos, "a slash");
  fault_if(text.find('_') != text.npos, "an underscore");
  fault_if(text.find('%') != text.npos && text.find("times ") != text.npos,
           "both a percentage and a factor");
  for (const std::string& sentence : sentences) {
    std::ranges::move(faults_of_sentence(sentence, limits.words), std::back_inserter(faults));
  }
  return faults;
}

}  // namespace clipscope::experiments
