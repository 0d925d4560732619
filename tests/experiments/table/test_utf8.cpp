// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/table/utf8.hpp"

#include "tests/catch.hpp"

namespace clipscope::experiments {
namespace {

TEST_CASE("visible text: what can't be seen or looks like ASCII is named, the rest stays") {
  CHECK(visible_utf8("v 1\xC2\xB5") == "v 1\xC2\xB5");
  CHECK(visible_utf8("\xC2\xA0v") == "<U+00A0 no-break space>v");
  CHECK(visible_utf8("\xEF\xBB\xBFv") == "<U+FEFF byte order mark>v");
  CHECK(visible_utf8("\xE2\x80\x8B") == "<U+200B zero-width space>");
  CHECK(visible_utf8("\xE2\x88\x92.5") == "<U+2212 minus sign>.5");
  CHECK(visible_utf8("a\tb") == "a<U+0009 control character>b");
  CHECK(visible_utf8(std::string_view("\0", 1)) == "<U+0000 control character>");
}

TEST_CASE("visible text: bytes of no character are given as numbers") {
  CHECK(visible_utf8("a\xFF") == "a<0xFF>");
  CHECK(visible_utf8("\xE2\x82") == "<0xE2><0x82>");
}

TEST_CASE("markup: what XML or HTML would read as markup is escaped") {
  CHECK(xml_escaped("<a href=\"x\">'&amp;'</a>") ==
        "&lt;a href=&quot;x&quot;&gt;&#39;&amp;amp;&#39;&lt;/a&gt;");
  CHECK(xml_escaped("naïve ≤ 1") == "naïve ≤ 1");
  CHECK(xml_escaped("a\tb\n") == "a&#9;b&#10;");
}

TEST_CASE("markup: what XML can't hold becomes the replacement character") {
  const std::string mark = "\xEF\xBF\xBD";
  CHECK(xml_escaped(std::string_view("a\0b\x1b\x7f\xff", 6)) ==
        "a" + mark + "b" + mark + mark + mark);
}

TEST_CASE("valid text: bytes that are no UTF-8 become the replacement character") {
  const std::string mark = "\xEF\xBF\xBD";
  CHECK(valid_utf8(std::string("a\xff") + "b") == "a" + mark + "b");
  CHECK(valid_utf8("\xc0\xaf") == mark + mark);                        // overlong /
  CHECK(valid_utf8("\xed\xa0\x80") == mark + mark + mark);             // a surrogate
  CHECK(valid_utf8("\xe2\x82") == mark + mark);                        // cut off
  CHECK(valid_utf8("\xf4\x90\x80\x80") == mark + mark + mark + mark);  // past U+10FFFF
  CHECK(valid_utf8("€ 𝄞 \xed\x9f\xbf") == "€ 𝄞 \xed\x9f\xbf");
}

TEST_CASE("wrapped text: lines break at blanks, and behind hyphens where a word is longer") {
  using Lines = std::vector<std::string>;
  CHECK(wrapped("one two three", 7) == Lines{"one two", "three"});
  CHECK(wrapped("of Liang-Barsky", 12) == Lines{"of", "Liang-Barsky"});
  CHECK(wrapped("of Nicholl-Lee-Nicholl", 14) == Lines{"of Nicholl-", "Lee-Nicholl"});
  CHECK(wrapped("of Nicholl-Lee-Nicholl", 0) == Lines{"of Nicholl-Lee-Nicholl"});
  CHECK(wrapped("unbreakable", 4) == Lines{"unbreakable"});
}

}  // namespace
}  // namespace clipscope::experiments
