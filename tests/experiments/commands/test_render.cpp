// SPDX-License-Identifier: GPL-3.0-or-later
//
// clipscope render, as a user runs it.
#include <filesystem>

#include "tests/catch.hpp"
#include "tests/experiments/commands/program.hpp"

TEST_CASE("cli: render writes PNG and EXR, and says where it can't") {
  const Folder folder;
  for (const char* name : {"a.png", "a.exr"}) {
    const Result r = folder.run(
        "render --scene corridor --clipper cvv/naive --against exact --size 160,90 --out " +
        (folder.path() / name).string());
    INFO(r.err);
    CHECK(r.code == 0);
    CHECK(std::filesystem::file_size(folder.path() / name) > 1000);
    CHECK(contains(r.out, "holes"));
  }
  CHECK(
      folder
          .run(
              "render --scene corridor --clipper textbook --size 64,64 --out /no/such/folder/a.png")
          .code == 4);
}
