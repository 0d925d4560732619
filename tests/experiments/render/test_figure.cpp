// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/render/figure.hpp"

#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <memory>

#include "experiments/machine/errors.hpp"
#include "experiments/machine/temporary_folder.hpp"
#include "experiments/render/webp.hpp"
#include "tests/catch.hpp"
#include "tests/experiments/render/shapes.hpp"

namespace clipscope::experiments {
namespace {

namespace fs = std::filesystem;

std::ptrdiff_t files_in(const TemporaryFolder& folder) {
  return std::distance(fs::directory_iterator(folder.path()), fs::directory_iterator());
}

// A tested buffer that lacks the right quarter of the truth, and the map of it.
struct Example {
  FrameBuffer tested = empty_buffer(64, 36), truth = tested;
  HeatMap map;
  Figure figure;

  Example() {
    draw_polygon(tested, rectangle(-1, -1, 0.5, 1), 5);
    draw_polygon(truth, kWholeScreen, 5);
    map = compare(tested, truth);
    figure = {&tested, &map, {"a scene", "a/clipper", "float", "exact"}, {}};
  }
};

struct Read {
  OIIO::ImageSpec spec;
  std::vector<float> values;

  explicit Read(const fs::path& path) {
    const std::unique_ptr<OIIO::ImageInput> input = OIIO::ImageInput::open(path.string());
    REQUIRE(input);
    spec = input->spec();
    values.resize(spec.image_pixels() * static_cast<std::size_t>(spec.nchannels));
    REQUIRE(input->read_image(0, 0, 0, spec.nchannels, OIIO::TypeDesc::FLOAT, values.data()));
  }
  float at(int x, int y, const std::string& channel) const {
    const int index = spec.channelindex(channel);
    REQUIRE(index >= 0);
    return values[static_cast<std::size_t>((y * spec.width + x) * spec.nchannels + index)];
  }
};

template <class Error, class Action>
std::string message_of(const Action& action) {
  try {
    action();
  } catch (const Error& error) {
    return error.what();
  }
  return "no error";
}

TEST_CASE("figure: a PNG holds the composed figure in 8 bits") {
  const Example example;
  const TemporaryFolder folder;
  write_image(folder / "figure.png", example.figure);
  const Image composed = compose(example.figure);
  const Read png(folder / "figure.png");
  CHECK(png.spec.width == composed.width);
  CHECK(png.spec.height == composed.height);
  CHECK(png.spec.nchannels == 3);
  CHECK(png.spec.format == OIIO::TypeDesc::UINT8);
  CHECK(files_in(folder) == 1);
}

TEST_CASE("figure: as WebP it has every pixel of the PNG, in fewer bytes") {
  const Example example;
  const TemporaryFolder folder;
  write_image(folder / "figure.png", example.figure);
  const std::string bytes = lossless_webp(folder / "figure.png");
  CHECK(bytes.size() < fs::file_size(folder / "figure.png"));
  std::ofstream(folder / "figure.webp", std::ios::binary) << bytes;
  const Read png(folder / "figure.png"), webp(folder / "figure.webp");
  CHECK(webp.spec.width == png.spec.width);
  CHECK(webp.values == png.values);
  CHECK_THROWS_AS(lossless_webp(folder / "absent.png"), OutputError);
}

TEST_CASE("figure: an EXR holds the data pixel for pixel") {
  const Example example;
  const TemporaryFolder folder;
  write_image(folder / "data.EXR", example.figure);
  const Read exr(folder / "data.EXR");
  CHECK(exr.spec.width == 64);
  CHECK(exr.spec.height == 36);
  CHECK(exr.at(10, 10, "u") == static_cast<float>(example.tested.attributes[10 * 64 + 10][0]));
  CHECK(exr.at(10, 10, "v") == static_cast<float>(example.tested.attributes[10 * 64 + 10][1]));
  CHECK(exr.at(10, 10, "triangle") == 5);
  CHECK(exr.at(10, 10, "facing") == 1);
  CHECK(exr.at(60, 10, "triangle") == -1);
  CHECK(exr.at(60, 10, "depth") == 1);
  CHECK(exr.at(60, 10, "fate") == static_cast<float>(PixelFate::hole));
  CHECK(exr.at(60, 10, "heat.R") == fate_colour(PixelFate::hole)[0]);
  CHECK(exr.at(10, 10, "error") == static_cast<float>(example.map.error[10 * 64 + 10]));
  CHECK(exr.at(10, 10, "G") == shade(example.tested).pixels[10 * 64 + 10][1]);
}

TEST_CASE("figure: without a heat map the picture stands alone") {
  const Example example;
  const Figure alone{&example.tested, nullptr, example.figure.titles, {}};
  CHECK(compose(alone).width < compose(example.figure).width);
  const TemporaryFolder folder;
  write_image(folder / "alone.exr", alone);
  CHECK(Read(folder / "alone.exr").spec.channelindex("error") == -1);
}

TEST_CASE("figure: hostile values and titles still make a figure") {
  FrameBuffer buffer = empty_buffer(GENERATE(1, 3, 700), GENERATE(1, 5));
  Quad quad = kWholeScreen;
  quad[0].attributes[0] = 1e308;
  quad[1].inv_w = -1;
  quad[2].z = 1e300;
  draw_polygon(buffer, quad, 0);
  const HeatMap map = compare(buffer, buffer);
  const Figure figure{&buffer, &map, {std::string(300, 'W'), "", "\xc3\xa9\n\x01", "%s"}, {}};
  const Image image = compose(figure);
  CHECK(std::ranges::all_of(image.pixels, [](const Rgb& p) {
    return std::ranges::all_of(p, [](float c) { return 0 <= c && c <= 1.001f; });
  }));
}

TEST_CASE("figure: an unknown extension is an error that names the option and what it takes") {
  const Example example;
  const TemporaryFolder folder;
  const std::string name = GENERATE("figure.jpg", "figure", "png");
  const std::string message =
      message_of<UsageError>([&] { write_image(folder / name, example.figure); });
  CHECK_THAT(message, Catch::Contains("--out") && Catch::Contains(".png") &&
                          Catch::Contains(".exr") && Catch::Contains(name));
  CHECK(files_in(folder) == 0);
}

TEST_CASE("figure: a place that can't be written is an error that names it, and nothing is left") {
  const Example example;
  const TemporaryFolder folder;
  std::ofstream(folder / "file") << "not a folder";
  const std::string name = GENERATE("absent/f.png", "absent/f.exr", "file/f.png", "file/f.exr");
  const std::string message =
      message_of<OutputError>([&] { write_image(folder / name, example.figure); });
  CHECK_THAT(message, Catch::StartsWith("can't write " + (folder / name).string() + ": ") &&
                          !Catch::EndsWith(": "));
  CHECK(files_in(folder) == 1);
}

TEST_CASE("figure: what can't be renamed into place leaves no partial file") {
  const Example example;
  const TemporaryFolder folder;
  fs::create_directories(folder / "taken.png" / "inside");
  CHECK_THROWS_AS(write_image(folder / "taken.png", example.figure), OutputError);
  CHECK(files_in(folder) == 1);
}

}  // namespace
TEST_CASE("figure: a row holds every panel beside the others") {
  const FrameBuffer buffer = empty_buffer(320, 180);
  const HeatMap map = compare(buffer, buffer);
  const std::array<CaptionedImage, 2> panels = {{{"left", shade(buffer)}, {"error", map.image}}};
  const Image image = compose_row("two panels", panels, map);
  CHECK(image.width > 2 * 320);
  CHECK(image.height > 180);
}

}  // namespace clipscope::experiments
