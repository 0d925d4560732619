// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/hard_cases/ulp_picture.hpp"

#include <unistd.h>

#include <filesystem>

#include "experiments/render/figure.hpp"
#include "tests/catch.hpp"

namespace clipscope::experiments::hard_cases {
namespace {

TEST_CASE("ulp picture: it has a panel for the truth and one for each predicate") {
  UlpGrid grid = edge_grid().grid;
  grid.size = 64;
  grid.predicates.resize(2);
  const SignMap exact = sign_map(grid, grid.exact);
  const Image panel = sign_image(exact, exact);
  CHECK(panel.width == 64);
  CHECK(panel.height == 64);
  // the last row of the picture is the first of the map
  CHECK(panel.pixels[63 * 64] == sign_colour(exact.at(0, 0), exact.at(0, 0)));
  const Image picture = ulp_picture(grid);
  CHECK(picture.width > 3 * 2 * 64);
  const auto path = std::filesystem::temp_directory_path() /
                    ("clipscope_ulp_" + std::to_string(getpid()) + ".png");
  write_png(path, picture, grid.title);
  CHECK(std::filesystem::file_size(path) > 1000);
  std::filesystem::remove(path);
}

}  // namespace
}  // namespace clipscope::experiments::hard_cases
