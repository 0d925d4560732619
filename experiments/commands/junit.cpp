// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/commands/junit.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "experiments/table/utf8.hpp"

namespace clipscope::experiments::commands {
namespace {

// Text or the value of an attribute. What XML 1.0 can't hold at all, control characters, becomes
// U+FFFD; a line break in an attribute would be read as a blank.
std::string xml_escaped(const std::string& text) {
  std::string escaped;
  for (const char c : valid_utf8(text)) {
    switch (c) {
      case '&': escaped += "&amp;"; break;
      case '<': escaped += "&lt;"; break;
      case '>': escaped += "&gt;"; break;
      case '"': escaped += "&quot;"; break;
      case '\n': escaped += "&#10;"; break;
      case '\t': escaped += "&#9;"; break;
      default:
        if (static_cast<unsigned char>(c) < 0x20) {
          escaped += "\xEF\xBF\xBD";
        } else {
          escaped += c;
        }
    }
  }
  return escaped;
}

std::string xml_of(const JUnitTest& test) {
  const std::string head = fmt::format("    <testcase classname=\"{}\" name=\"{}\"",
                                       xml_escaped(test.class_name), xml_escaped(test.name));
  if (!test.failure.empty()) {
    return fmt::format("{}>\n      <failure message=\"{}\">{}</failure>\n    </testcase>\n", head,
                       xml_escaped(test.failure), xml_escaped(test.details));
  }
  if (test.skipped.empty()) return head + "/>\n";
  return fmt::format("{}>\n      <skipped message=\"{}\"/>\n    </testcase>\n", head,
                     xml_escaped(test.skipped));
}

}  // namespace

std::string junit_text(const std::string& suite, std::span<const JUnitTest> tests) {
  const auto count = [&](std::string JUnitTest::*what) {
    return std::ranges::count_if(tests, [&](const JUnitTest& t) { return !(t.*what).empty(); });
  };
  const std::string counts =
      fmt::format("tests=\"{}\" failures=\"{}\" errors=\"0\" skipped=\"{}\"", tests.size(),
                  count(&JUnitTest::failure), count(&JUnitTest::skipped));
  std::string text = fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites {}>\n  <testsuite name=\"{}\" {}>\n",
      counts, xml_escaped(suite), counts);
  for (const JUnitTest& test : tests) text += xml_of(test);
  return text + "  </testsuite>\n</testsuites>\n";
}

}  // namespace clipscope::experiments::commands
