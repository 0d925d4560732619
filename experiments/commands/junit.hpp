// SPDX-License-Identifier: GPL-3.0-or-later
//
// JUnit's XML, as CI systems read it: there is no standard, so this keeps to what all of them know
// (testsuites, testsuite, testcase, failure, skipped).
#pragma once

#include <span>
#include <string>

namespace clipscope::experiments::commands {

struct JUnitTest {
  std::string class_name, name;
  std::string failure = "", details = "";  // empty: it passed
  std::string skipped = "";                // why
};

// One suite of that name with the tests in their order. XML 1.0 in UTF-8.
std::string junit_text(const std::string& suite, std::span<const JUnitTest> tests);

}  // namespace clipscope::experiments::commands
