// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/draw/vector_page.hpp"

#include "experiments/machine/errors.hpp"
#include "tests/catch.hpp"

namespace clipscope::experiments {
namespace {

TEST_CASE("vector page: the extension decides the format, in any case") {
  CHECK(page_format("a/b.svg") == PageFormat::svg);
  CHECK(page_format("a.PDF") == PageFormat::pdf);
  CHECK(page_format("a.b.Png") == PageFormat::png);
  CHECK_THROWS_AS(page_format("svg"), UsageError);
  CHECK_THROWS_AS(page_format("a.svgz"), UsageError);
}

TEST_CASE("vector page: a title may hold anything and stands escaped in the file") {
  VectorPage page(PageFormat::svg, 10, 10, "a<b> \xff\x01\xe2\x82\xac");
  CHECK(page.finish().find("<title>a&lt;b&gt; ? \xe2\x82\xac</title>") != std::string::npos);
}

TEST_CASE("vector page: lines are as wide as they may be, and what is too much is left out") {
  VectorPage page(PageFormat::png, 10, 10, "");
  const Lettering style = {.size = 13};
  const std::string words = "one two three four five";
  const double width = page.text_width("one two three", style);
  CHECK(page.wrap(words, width, 5, style) ==
        std::vector<std::string>{"one two three", "four five"});
  CHECK(page.wrap(words, width, 1, style) == std::vector<std::string>{"one two three …"});
  CHECK(page.wrap("unbreakable word", 1, 5, style) ==
        std::vector<std::string>{"unbreakable", "word"});
}

}  // namespace
}  // namespace clipscope::experiments
