// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/table/prose.hpp"

#include "tests/catch.hpp"

using namespace clipscope::experiments;

namespace {

using Texts = std::vector<std::string>;

bool has_fault(std::string_view text, std::string_view fault) {
  for (const std::string& f : faults_of_prose(text)) {
    if (f.find(fault) != f.npos) return true;
  }
  return false;
}

}  // namespace

TEST_CASE("prose: words of sentences are put together as people say them") {
  CHECK(capitalised("the CVV") == "The CVV");
  CHECK(capitalised("") == "");
  CHECK(listed({}) == "");
  CHECK(listed({"a"}) == "a");
  CHECK(listed({"a", "b", "c"}) == "a, b and c");
  CHECK(some_of(0, 64, "pictures") == "none of the pictures");
  CHECK(some_of(8, 64, "pictures") == "8 of 64 pictures");
  CHECK(some_of(64, 64, "pictures") == "all pictures");
  CHECK(times_text(1.7299) == "1.73 times");
  CHECK(times_text(1.5) == "1.5 times");
  CHECK(number_word(0) == "no");
  CHECK(number_word(12) == "twelve");
  CHECK(number_word(13) == "13");
  CHECK(quantity(0) == "no");
  CHECK(quantity(0.1) == "few");
  CHECK(quantity(0.3) == "some");
  CHECK(quantity(0.5) == "most");
  CHECK(quantity(0.95) == "nearly all");
  CHECK(quantity(1) == "all");
  CHECK(times_text(12345) == "12345 times");
}

TEST_CASE("prose: a figure is a number, not a part of a name or of a condition") {
  CHECK(figures_in("It takes 1.73 times as long, 62.1 % of it (8661 edges).") ==
        Texts{"1.73", "62.1", "8661"});
  CHECK(figures_in("From -0.5 to 2.1e-07 px.") == Texts{"-0.5", "2.1e-07"});
  CHECK(figures_in("1, 2 and 3.") == Texts{"1", "2", "3"});
  CHECK(figures_in("2D and 24-bit at 4K, with float32, where w <= 0 or w = 1e-5.").empty());
}

TEST_CASE("prose: a claim with two figures has no fault") {
  CHECK(
      faults_of_prose(
          "View space is slower than clip space: it takes 1.73 times as long. The price depends on the mix (it is largest on slivers).")
          .empty());
}

TEST_CASE("prose: each fault is found") {
  CHECK(faults_of_prose("") == Texts{"it says nothing"});
  CHECK(has_fault("It takes 1, 2 or 3.", "3 figures, more than 2"));
  CHECK(has_fault("A. B. C. D. E.", "5 sentences, more than 4"));
  CHECK(has_fault("It is so", "no full stop"));
  CHECK(has_fault("It is so. but not here.", "no capital in front of it: \"but not here.\""));
  CHECK(has_fault("It is near/far.", "a slash"));
  CHECK(has_fault("It is near_first.", "an underscore"));
  CHECK(has_fault("It is 2 times as fast in 3 %.", "both a percentage and a factor"));
  CHECK(has_fault("It is (a) so (b).", "heaped parentheses"));
  CHECK(has_fault("It is: a: b.", "heaped colons"));
  CHECK(has_fault("It is; a; b.", "heaped semicolons"));
  std::string many = "Word";
  for (int i = 0; i < 40; ++i) many += " word";
  CHECK(has_fault(many + ".", "41 words, more than 40"));
}

TEST_CASE("prose: limits are the caller's") {
  CHECK(faults_of_prose("It takes 1, 2 or 3.", {.figures = 3}).empty());
  CHECK(faults_of_prose("A. B.", {.sentences = 1}).size() == 1);
}
