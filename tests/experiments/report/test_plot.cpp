// SPDX-License-Identifier: GPL-3.0-or-later
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <thread>

#include "experiments/machine/errors.hpp"
#include "experiments/machine/temporary_folder.hpp"
#include "experiments/report/plot.hpp"
#include "experiments/report/plot_layout.hpp"
#include "tests/catch.hpp"

using namespace clipscope::experiments;
namespace fs = std::filesystem;

namespace {

// The variable PATH for as long as the object lives.
class SearchPath {
 public:
  explicit SearchPath(const std::string& path) : before_(std::getenv("PATH")) {
    setenv("PATH", path.c_str(), 1);
  }
  ~SearchPath() { setenv("PATH", before_.c_str(), 1); }
  SearchPath(const SearchPath&) = delete;
  SearchPath& operator=(const SearchPath&) = delete;

 private:
  std::string before_;
};

std::string read(const fs::path& path) {
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t n = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++n;
  return n;
}

Plot small_plot() {
  return {.name = "small",
          .title = "A title",
          .caption = "What is to be seen",
          .x = {.label = "n"},
          .y = {.label = "t [ns]"},
          .series = {{.name = "a", .x = {1, 2, 3}, .y = {1, 4, 9}}}};
}

std::vector<std::string> labels(const Scale& scale) {
  std::vector<std::string> texts;
  for (const Tic& tic : scale.tics) {
    if (!tic.label.empty()) texts.push_back(tic.label);
  }
  return texts;
}

std::string message(const Plot& plot, const fs::path& folder) {
  try {
    write_plot(plot, folder);
  } catch (const OutputError& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("plot: all three files are written whole, and nothing else") {
  const TemporaryFolder folder;
  write_plot(small_plot(), folder.path() / "deep");
  CHECK(contains(read(folder.path() / "deep" / "small.svg"), "</svg>"));
  CHECK(read(folder.path() / "deep" / "small.pdf").starts_with("%PDF"));
  CHECK(read(folder.path() / "deep" / "small.png").starts_with("\x89PNG"));
  CHECK(std::distance(fs::directory_iterator(folder.path() / "deep"), {}) == 3);
}

TEST_CASE("plot: the same plot gives the same bytes") {
  const TemporaryFolder folder;
  write_plot(small_plot(), folder.path() / "a");
  std::this_thread::sleep_for(std::chrono::milliseconds(1100));  // PDF dates count seconds
  write_plot(small_plot(), folder.path() / "b");
  for (const char* file : {"small.svg", "small.pdf", "small.png"}) {
    CHECK(read(folder.path() / "a" / file) == read(folder.path() / "b" / file));
  }
}

TEST_CASE("plot: quotes, markup and commands in names are shown as they are and do nothing") {
  const TemporaryFolder folder;
  const fs::path trap = folder.path() / "trap";
  const std::vector<std::string> texts = {
      "'; set output '" + trap.string() + "' #\\",
      "\"; system('touch " + trap.string() + "') #",
      "`touch " + trap.string() + "` $(touch " + trap.string() + ")",
      "\\",
      "a_b^2 {/Symbol a} @x 100% 7",
      "-2",
      "line\nbreak\t\x01",
      "naïve × 10⁻³"};
  for (const std::string& text : texts) {
    Plot plot = small_plot();
    plot.title = plot.caption = plot.x.label = plot.y.label = plot.series[0].name = text;
    plot.series[0].labels = {text, text, text};
    write_plot(plot, folder.path());
    plot.name = "bars";
    plot.categories = {text, text, text};
    plot.series[0].labels.clear();
    write_plot(plot, folder.path());
    CHECK_FALSE(fs::exists(trap));
  }
  const std::string svg = read(folder.path() / "bars.svg");
  CHECK(count(svg, ">naïve × 10⁻³<") >= 5);
}

TEST_CASE("plot: a name becomes a gnuplot string of letters, digits and octal escapes") {
  CHECK(gnuplot_string("a b1") == "\"a b1\"");
  // gnuplot reads all digits after a backslash: the 2 would be part of the minus.
  CHECK(gnuplot_string("-2") == "\"\\055\\062\"");
  CHECK(gnuplot_string("'\"\\`") == "\"\\047\\042\\134\\140\"");
  CHECK(gnuplot_string("a\nb") == "\"a b\"");
  CHECK(gnuplot_string("\xff") == "\"\xEF\xBF\xBD\"");
}

TEST_CASE("plot: a title with quotes and brackets is a well-formed name of the SVG") {
  const TemporaryFolder folder;
  Plot plot = small_plot();
  plot.title = "\"a\" < b & 'c'";
  write_plot(plot, folder.path());
  CHECK(contains(read(folder.path() / "small.svg"),
                 "<title>&quot;a&quot; &lt; b &amp; &#39;c&#39;</title>"));
}

TEST_CASE("plot: two plots in one page share no id") {
  const TemporaryFolder folder;
  Plot plot = small_plot();
  write_plot(plot, folder.path());
  plot.name = "other-plot";
  write_plot(plot, folder.path());
  const std::string a = read(folder.path() / "small.svg"),
                    b = read(folder.path() / "other-plot.svg");
  CHECK(count(a, "id='") + count(a, "id=\"") == count(a, "id='small_") + count(a, "id=\"small_"));
  CHECK(count(a, "href='#") == count(a, "href='#small_"));
  CHECK(count(a, "href='#") > 0);
  CHECK(count(b, "id='other_plot_") == count(a, "id='small_"));
}

TEST_CASE("plot: points that can't be shown on a logarithmic axis are left out") {
  Plot plot = small_plot();
  plot.x.logarithmic = plot.y.logarithmic = true;
  plot.series[0].x = {-1, 0, 1, 10, 100, 1000};
  plot.series[0].y = {1, 1, 5, 0, INFINITY, 7};
  const PlotLayout layout = lay_out(plot);
  REQUIRE(layout.points[0].size() == 2);
  CHECK(layout.points[0][0].x == 1);
  CHECK(layout.points[0][1].x == 1000);
  // The line is not drawn across what is missing.
  CHECK(layout.points[0][1].begins);
  const TemporaryFolder folder;
  CHECK_NOTHROW(write_plot(plot, folder.path()));
}

TEST_CASE("plot: an interval that reaches to zero ends where a logarithmic axis ends") {
  Plot plot = small_plot();
  plot.y.logarithmic = true;
  plot.series[0].low = {0, -3, 8};
  plot.series[0].high = {2, 5, 10};
  const PlotLayout layout = lay_out(plot);
  CHECK(layout.points[0][0].low == layout.y.low);
  CHECK(layout.points[0][1].low == layout.y.low);
  CHECK(layout.points[0][2].low == 8);
  CHECK(layout.y.low > 0);
}

TEST_CASE("plot: without a point that can be shown it says so") {
  const TemporaryFolder folder;
  Plot plot = small_plot();
  plot.y.logarithmic = GENERATE(true, false);
  plot.series[0].y = {NAN, INFINITY, -INFINITY};
  write_plot(plot, folder.path());
  CHECK(contains(read(folder.path() / "small.svg"), "no value can be shown"));
  plot.series.clear();
  CHECK_NOTHROW(write_plot(plot, folder.path()));
  plot.categories = {"a", "b"};
  CHECK_NOTHROW(write_plot(plot, folder.path()));
}

TEST_CASE("plot: extreme values end in a plot, not in an endless loop") {
  const TemporaryFolder folder;
  Plot plot = small_plot();
  plot.x.logarithmic = plot.y.logarithmic = GENERATE(true, false);
  plot.series[0].x = {1e-300, 1, 1e300};
  plot.series[0].y = GENERATE(values<std::vector<double>>(
      {{1, 1 + 1e-16, 1}, {5e-324, 1, 1e300}, {1e-300, 2e-300, 3e-300}, {7, 7, 7}}));
  CHECK_NOTHROW(write_plot(plot, folder.path()));
}

TEST_CASE("plot: columns that differ in length are refused by the name of their series") {
  Plot plot = small_plot();
  SECTION("x and y") { plot.series[0].x.pop_back(); }
  SECTION("intervals") { plot.series[0].low = {1, 2}; }
  SECTION("only one end of the intervals") { plot.series[0].low = {1, 2, 3}; }
  SECTION("labels") { plot.series[0].labels = {"a"}; }
  SECTION("categories") { plot.categories = {"a"}; }
  CHECK_THROWS_WITH(lay_out(plot), Catch::Contains("'a'"));
  CHECK_THROWS_AS(lay_out(plot), std::invalid_argument);
}

TEST_CASE("plot: a folder that is a file is an error that names it") {
  const TemporaryFolder folder;
  std::ofstream(folder.path() / "file") << "in the way";
  const std::string text = message(small_plot(), folder.path() / "file");
  CHECK(contains(text, (folder.path() / "file" / "small.svg").string()));
  CHECK(read(folder.path() / "file") == "in the way");
}

TEST_CASE("plot: a missing gnuplot is an error that says what to install") {
  const TemporaryFolder folder;
  const SearchPath path(folder.path().string());
  CHECK(contains(message(small_plot(), folder.path()), "gnuplot-nox"));
  CHECK_FALSE(fs::exists(folder.path() / "small.svg"));
}

TEST_CASE("plot: what a failing gnuplot says is in the error, and no file is left") {
  const TemporaryFolder folder;
  const fs::path fake = folder.path() / "gnuplot";
  std::ofstream(fake) << "#!/bin/sh\necho 'line 3: out of ink' >&2\nexit " << GENERATE(0, 1)
                      << "\n";
  fs::permissions(fake, fs::perms::owner_all);
  const SearchPath path(folder.path().string());
  CHECK(contains(message(small_plot(), folder.path()), "out of ink"));
  CHECK_FALSE(fs::exists(folder.path() / "small.svg"));
}

TEST_CASE("axis: tics are round numbers in the range, a few of them") {
  const std::vector<double> values = {0.13, 7.9};
  const Scale scale = make_scale({}, values, {});
  CHECK(scale.low == 0);
  CHECK(scale.high > 7.9);
  CHECK(labels(scale) == std::vector<std::string>{"0", "2", "4", "6", "8"});
}

TEST_CASE("axis: signs and small numbers are written as people write them") {
  CHECK(labels(make_scale({}, std::vector<double>{-1, 1}, {.most_tics = 5})) ==
        std::vector<std::string>{"−1.0", "−0.5", "0", "0.5", "1.0"});
  const auto small = labels(make_scale({}, std::vector<double>{1e-6, 4e-6}, {.most_tics = 5}));
  CHECK(small == std::vector<std::string>{"0", "10⁻⁶", "2×10⁻⁶", "3×10⁻⁶", "4×10⁻⁶"});
}

TEST_CASE("axis: a logarithmic one has powers of ten, or 1, 2 and 5 times them where few fit") {
  const Axis axis{.label = "", .logarithmic = true};
  CHECK(labels(make_scale(axis, std::vector<double>{1e-9, 1}, {.most_tics = 6})) ==
        std::vector<std::string>{"10⁻⁸", "10⁻⁶", "10⁻⁴", "10⁻²", "10⁰"});
  CHECK(labels(make_scale(axis, std::vector<double>{1, 1000}, {})) ==
        std::vector<std::string>{"1", "10", "100", "1000"});
  CHECK(labels(make_scale(axis, std::vector<double>{10, 80}, {})) ==
        std::vector<std::string>{"10", "20", "50"});
}

TEST_CASE("axis: the lowest labelled tic can have a name") {
  const Axis axis{.label = "", .logarithmic = true, .lowest = "none"};
  CHECK(labels(make_scale(axis, std::vector<double>{1, 1000}, {})) ==
        std::vector<std::string>{"none", "10", "100", "1000"});
}

TEST_CASE("axis: limits that are asked for hold unless they are impossible") {
  const std::vector<double> values = {1, 100};
  const Scale limited =
      make_scale({.label = "", .logarithmic = false, .from = -5, .to = 50}, values, {});
  CHECK(limited.low == -5);
  CHECK(limited.high == 50);
  const Scale kept = make_scale({.label = "", .logarithmic = true, .from = 0}, values, {});
  CHECK(kept.low > 0);
  const Scale crossed =
      make_scale({.label = "", .logarithmic = false, .from = 9, .to = 3}, values, {});
  CHECK(crossed.low < crossed.high);
}

TEST_CASE("axis: bars stand on zero, or on a power of ten beneath the shortest") {
  CHECK(make_scale({}, std::vector<double>{90, 100}, {.bars = true}).low == 0);
  CHECK(make_scale({.label = "", .logarithmic = true}, std::vector<double>{30, 100}, {.bars = true})
            .low == Approx(10));
  CHECK(
      make_scale({.label = "", .logarithmic = true}, std::vector<double>{10.5, 100}, {.bars = true})
          .low == Approx(1));
}

TEST_CASE("labels: texts beside crowded points do not cover each other") {
  std::vector<PointLabel> wanted;
  for (int i = 0; i < 12; ++i) wanted.push_back({300.0 + 4 * (i % 4), 200.0 + 5 * (i / 4), 60, 12});
  const auto places = place_labels(wanted, {}, {0, 0, 600, 400});
  int placed = 0;
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (!places[i]) continue;
    ++placed;
    const LabelBox& a = places[i]->box;
    CHECK((a.left >= 0 && a.top >= 0 && a.right <= 600 && a.bottom <= 400));
    for (std::size_t k = 0; k < i; ++k) {
      if (!places[k]) continue;
      const LabelBox& b = places[k]->box;
      const double width = std::min(a.right, b.right) - std::max(a.left, b.left);
      const double height = std::min(a.bottom, b.bottom) - std::max(a.top, b.top);
      CHECK((width <= 0 || height <= 0 || width * height <= 0.25 * 60 * 12));
    }
  }
  CHECK(placed >= 10);
}

TEST_CASE("labels: a text for which there is no room is left out") {
  const std::vector<PointLabel> wanted = {{50, 50, 200, 12}};
  CHECK_FALSE(place_labels(wanted, {}, {0, 0, 100, 100})[0]);
  CHECK(place_labels(wanted, {}, {0, 0, 300, 100})[0]);
}
