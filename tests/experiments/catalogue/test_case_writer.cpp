// SPDX-License-Identifier: GPL-3.0-or-later
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "experiments/catalogue/catalogue.hpp"
#include "experiments/machine/errors.hpp"
#include "experiments/machine/files.hpp"
#include "tests/catch.hpp"

using namespace clipscope;
using namespace clipscope::experiments;

namespace {

bool same_numbers(const HardCase& a, const HardCase& b) {
  const bool same_size =
      a.vertices.size() == b.vertices.size() && a.attribute_count == b.attribute_count;
  if (!same_size) return false;
  for (std::size_t i = 0; i < a.vertices.size(); ++i) {
    if (a.vertices[i].position != b.vertices[i].position ||
        a.vertices[i].attributes != b.vertices[i].attributes) {
      return false;
    }
  }
  return true;
}

// A file in a folder of its own, gone afterwards.
struct TemporaryFile {
  std::filesystem::path folder =
      std::filesystem::temp_directory_path() / ("clipscope-cases-" + std::to_string(getpid()));
  std::filesystem::path file = folder / "new" / "mine.cases";

  ~TemporaryFile() { std::filesystem::remove_all(folder); }
};

}  // namespace

TEST_CASE("case writer: what is written is read again, to the bit") {
  for (const HardCase& c : builtin_catalogue()) {
    const std::string text = case_text(c);
    CAPTURE(text);
    const std::vector<HardCase> read = read_cases("theme.cases", text);
    REQUIRE(read.size() == 1);
    CHECK("theme" + c.name.substr(c.name.find('/')) == read[0].name);
    CHECK(same_numbers(c, read[0]));
    CHECK(read[0].volume == c.volume);
    CHECK(read[0].space == c.space);
    if (c.space == Space::view) CHECK(read[0].frustum == c.frustum);
    CHECK(read[0].expected == c.expected);
    CHECK(read[0].source == c.source);
    CHECK(read[0].why == c.why);
  }
}

TEST_CASE("case writer: attributes that the reader fills in are left out, others stay") {
  HardCase c = find_case(builtin_catalogue(), "w_sign/w_3_to_minus_3");
  CHECK(case_text(c).find('|') == std::string::npos);
  c.vertices[1].attributes[0] = 5;
  CHECK(case_text(c).find("vertex 4 0 0 -3 | 5") != std::string::npos);
}

TEST_CASE(
    "case writer: a case is added to a file, under a name that is free, and nothing is lost") {
  const TemporaryFile temporary;
  HardCase c = find_case(builtin_catalogue(), "w_sign/w_3_to_minus_3");
  CHECK(append_case(temporary.file, c).name == "mine/w_3_to_minus_3");
  std::ofstream(temporary.file, std::ios::app) << "# a comment without an end of line";
  CHECK(append_case(temporary.file, c).name == "mine/w_3_to_minus_3_2");
  c.name = "w_sign/w_3_to_minus_3 (scaled by 2^-1)";
  CHECK(append_case(temporary.file, c).name == "mine/w_3_to_minus_3_(scaled_by_2^-1)");
  const std::vector<HardCase> all = load_catalogue(temporary.file);
  CHECK(all.size() == 3);
  CHECK(same_numbers(all[1], c));
  CHECK(read_bytes(temporary.file).find("# a comment") != std::string::npos);
}

TEST_CASE("case writer: nothing is added to a file that holds something else") {
  const TemporaryFile temporary;
  std::filesystem::create_directories(temporary.file.parent_path());
  std::ofstream(temporary.file) << "to be kept\n";
  CHECK_THROWS_AS(append_case(temporary.file, builtin_catalogue().front()), InputError);
  CHECK(read_bytes(temporary.file) == "to be kept\n");
}
