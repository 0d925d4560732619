// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/machine/temporary_folder.hpp"

#include <cstdlib>
#include <fstream>
#include <optional>
#include <string>

#include "experiments/machine/errors.hpp"
#include "tests/catch.hpp"

namespace clipscope::experiments {
namespace {

namespace fs = std::filesystem;

TEST_CASE("temporary folder: each is new and empty, and goes away with what is in it") {
  std::optional<TemporaryFolder> one(std::in_place), other(std::in_place);
  const fs::path path = one->path();
  CHECK(path != other->path());
  REQUIRE(fs::is_directory(path));
  CHECK(fs::is_empty(path));
  fs::create_directories(*one / "deep" / "er");
  std::ofstream(*one / "deep" / "file") << "text";
  one.reset();
  CHECK_FALSE(fs::exists(path));
  CHECK(fs::is_directory(other->path()));
}

TEST_CASE("temporary folder: where none can be made the error names TMPDIR and what it is") {
  const TemporaryFolder folder;
  const char* const before = std::getenv("TMPDIR");
  const std::string kept = before == nullptr ? "" : before;
  setenv("TMPDIR", (folder / "missing").c_str(), 1);
  CHECK_THROWS_WITH(TemporaryFolder(), Catch::StartsWith("TMPDIR: ") && Catch::Contains("missing"));
  CHECK_THROWS_AS(TemporaryFolder(), OutputError);
  if (before == nullptr) {
    unsetenv("TMPDIR");
  } else {
    setenv("TMPDIR", kept.c_str(), 1);
  }
}

}  // namespace
}  // namespace clipscope::experiments
