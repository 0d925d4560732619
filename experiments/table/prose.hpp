// SPDX-License-Identifier: GPL-3.0-or-later
//
// Sentences for people: words that findings and answers are made of, and what makes a text hard to
// read.
//
// The checker knows form alone; whether a sentence is true is up to the code that writes it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace clipscope::experiments {

// With a capital in front; only ASCII letters have one.
std::string capitalised(std::string text);

// "a", "a and b", "a, b and c"; empty of nothing.
std::string listed(const std::vector<std::string>& things);

// "none of the pictures", "all pictures", "8 of 64 pictures".
// Pre-condition: 0 <= count <= of.
std::string some_of(std::int64_t count, std::int64_t of, std::string_view things);

// A factor with three digits at most, without zeros at its end: "1.73 times", "25 times".
std::string times_text(double factor);

// "no", "one", "two" ... "twelve", then digits.
std::string number_word(std::int64_t n);

// A share in words, in front of things: "no", "few" (up to a fifth), "some" (less than half),
// "most", "nearly all" (from nine tenths on), "all". Pre-condition: 0 <= share <= 1.
std::string_view quantity(double share);

// What a reader takes in at once.
struct ProseLimits {
  std::size_t figures = 2, sentences = 4;  // of the whole text
  std::size_t words = 40;                  // of a sentence
};

// The numbers in a text, from left to right, but for those that belong to a name (24-bit, 2D, 4K)
// or to a condition (w <= 0).
std::vector<std::string> figures_in(std::string_view text);

// What is wrong with a text as prose, one phrase each; nothing if it can be read at once: at most
// so many figures, sentences and words; every sentence has a capital in front and one pair of
// parentheses, one colon and one semicolon at most; a full stop ends the text; no slashes or
// underscores, which lists and names of the program have; not both a percentage and a factor.
std::vector<std::string> faults_of_prose(std::string_view text, const ProseLimits& limits = {});

}  // namespace clipscope::experiments
