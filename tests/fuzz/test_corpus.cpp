// SPDX-License-Identifier: GPL-3.0-or-later
//
// The inputs that were kept, among them each that ever led to a finding, through the harnesses.
#include <algorithm>
#include <filesystem>

#include "experiments/machine/files.hpp"
#include "tests/catch.hpp"
#include "tests/fuzz/harness.hpp"

namespace clipscope::fuzz {
namespace {

struct Harness {
  const char* name;
  void (*run)(Bytes bytes);
};
constexpr Harness kHarnesses[] = {
    {"obj", obj},
    {"ply", ply},
    {"stl", stl},
    {"gltf", gltf},
    {"clip_text", clip_text},
    {"cases", cases},
    {"store", store},
    {"clip_space", clip_space},
    {"view_space", view_space},
    {"batches", batches},
    {"plugin", plugin},
    {"program", program},
};

TEST_CASE("fuzz: no harness finds anything in the inputs that were kept") {
  const Harness harness = GENERATE(from_range(std::begin(kHarnesses), std::end(kHarnesses)));
  INFO(harness.name);
  harness.run({});
  int inputs = 0;
  const std::filesystem::path folder = std::filesystem::path(CLIPSCOPE_FUZZ_CORPUS) / harness.name;
  for (const auto& file : std::filesystem::directory_iterator(folder)) {
    INFO(file.path());
    const std::string content = experiments::read_bytes(file);
    const auto* bytes = reinterpret_cast<const std::uint8_t*>(content.data());
    CHECK_NOTHROW(harness.run({bytes, content.size()}));
    ++inputs;
  }
  CHECK(inputs > 0);
}

TEST_CASE("fuzz: every folder of inputs has a harness") {
  for (const auto& folder : std::filesystem::directory_iterator(CLIPSCOPE_FUZZ_CORPUS)) {
    INFO(folder.path());
    CHECK(std::ranges::count_if(kHarnesses, [&](const Harness& harness) {
            return folder.path().filename() == harness.name;
          }) == 1);
  }
}

}  // namespace
}  // namespace clipscope::fuzz
