// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/report/plot_layout.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>

#include "experiments/table/utf8.hpp"

namespace clipscope::experiments {
namespace {

// page/page.css gives these and the first and sixth of the colours below another look in the dark.
constexpr const char* kInk = "#222222";
constexpr const char* kGrid = "#dddddd";
constexpr const char* kMuted = "#8c8c8c";
constexpr std::size_t kFewIntervals = 30;  // more on one curve are drawn as a band

struct Look {
  std::string colour;
  int mark = 0;  // gnuplot's point type: the same in all terminals used
  double mark_size = 1;
  const char* dashes = "";
};

// Okabe and Ito's colours, ordered so that neighbours differ in grey, too; yellow, too light for
// lines on white, comes last.
Look look_of(const Plot& plot, std::size_t index) {
  static constexpr std::array<const char*, 8> kColours = {
      "#0072B2", "#E69F00", "#009E73", "#CC79A7", "#222222", "#56B4E9", "#D55E00", "#F0E442"};
  static constexpr std::pair<int, double> kMarks[] = {{7, 0.8},   {5, 0.75}, {9, 0.95}, {13, 0.9},
                                                      {11, 0.95}, {6, 0.85}, {4, 0.8},  {8, 0.95},
                                                      {12, 0.9},  {10, 0.95}};
  static constexpr std::array<const char*, 5> kDashes = {"solid", "(10,4)", "(3,3)", "(12,4,3,4)",
                                                         "(18,5)"};
  const bool muted = plot.series[index].muted;
  const auto before = static_cast<std::size_t>(
      std::count_if(plot.series.begin(), plot.series.begin() + static_cast<std::ptrdiff_t>(index),
                    [&](const Series& s) { return s.muted == muted; }));
  const auto& [mark, size] = kMarks[(muted ? before + 5 : before) % std::size(kMarks)];
  return {muted ? kMuted : kColours[before % kColours.size()], mark, size,
          kDashes[before % kDashes.size()]};
}

class Script {
 public:
  explicit Script(const Plot& plot) : plot_(plot), layout_(lay_out(plot)) {}

  std::string text() {
    write_data();
    write_frame();
    write_axis("x", layout_.x);
    write_axis("y", layout_.y);
    write_categories();
    write_texts();
    write_key();
    write_point_labels();
    write_outputs();
    return text_;
  }

 private:
  bool bars() const { return !plot_.categories.empty(); }

  template <typename... Arguments>
  void line(fmt::format_string<Arguments...> format, Arguments&&... arguments) {
    text_ += fmt::format(format, std::forward<Arguments>(arguments)...) + "\n";
  }

  // A place on the canvas as gnuplot's fractions, upward.
  std::string screen(double x, double y) const {
    return fmt::format("screen {:.5f},{:.5f}", x / layout_.width, 1 - y / layout_.height);
  }

  // how: alignment, rotation and whether it lies in front.
  void label(const std::string& text, const std::string& at, const std::string& how, double size,
             const char* face = "", const char* colour = kInk) {
    line("set label {} at {} {} font '{},{}' textcolor rgb '{}'", gnuplot_string(text), at, how,
         face, size, colour);
  }

  // One block of numbers per series: x, y, low, high; an empty line where a line is to break.
  void write_data() {
    line("set encoding utf8");
    for (std::size_t i = 0; i < layout_.points.size(); ++i) {
      line("$series{} << END", i);
      for (const DrawnPoint& p : layout_.points[i]) {
        if (p.begins && &p != layout_.points[i].data()) line("");
        line("{:.9g} {:.9g} {:.9g} {:.9g}", p.x, p.y, p.low, p.high);
      }
      line("END");
      line("$intervals{} << END", i);
      for (const DrawnPoint& p : layout_.points[i]) {
        if (p.has_interval) line("{:.9g} {:.9g} {:.9g} {:.9g}", p.x, p.y, p.low, p.high);
      }
      line("END");
    }
  }

  void write_frame() {
    const LabelBox& a = layout_.area;
    line("set lmargin at screen {:.5f}\nset rmargin at screen {:.5f}", a.left / layout_.width,
         a.right / layout_.width);
    line("set tmargin at screen {:.5f}\nset bmargin at screen {:.5f}", 1 - a.top / layout_.height,
         1 - a.bottom / layout_.height);
    line("unset key\nset border 3 lc rgb '{}' lw 1", kInk);
    line("set grid {} lt 1 lc rgb '{}' lw 0.75", bars() ? "ytics" : "xtics ytics", kGrid);
  }

  void write_axis(const std::string& name, const Scale& scale) {
    if (scale.logarithmic) line("set logscale {}", name);
    line("set {}range [{:.12g}:{:.12g}] noextend", name, scale.low, scale.high);
    std::string tics;
    for (const Tic& tic : scale.tics) {
      tics += fmt::format("{}{} {:.12g} {}", tics.empty() ? "" : ", ", gnuplot_string(tic.label),
                          tic.at, tic.label.empty() ? 1 : 0);
    }
    line("set {}tics nomirror out scale 0.5,0.25 textcolor rgb '{}' ({})", name, kInk, tics);
  }

  void write_categories() {
    if (!bars()) return;
    line("unset xtics");
    const std::string how =
        layout_.slanted ? fmt::format("right rotate by {}", kCategoryAngle) : "center";
    for (std::size_t i = 0; i < plot_.categories.size(); ++i) {
      const double x = layout_.x_px(static_cast<double>(i)) + (layout_.slanted ? 4 : 0);
      label(plot_.categories[i], screen(x, layout_.area.bottom + 14), how, kFontSize);
    }
  }

  void write_texts() {
    for (const PlacedText& t : layout_.title) {
      label(t.text, screen(t.x, t.y), "left", kTitleSize, "sans-serif:Bold");
    }
    const LabelBox& a = layout_.area;
    const double middle_x = (a.left + a.right) / 2, middle_y = (a.top + a.bottom) / 2;
    label(plot_.x.label, screen(middle_x, layout_.height - 16), "center", kFontSize);
    label(plot_.y.label, screen(layout_.y_label_x, middle_y), "center rotate by 90", kFontSize);
    if (!layout_.empty()) return;
    label("no value can be shown", screen(middle_x, middle_y), "center", kFontSize, "", kMuted);
  }

  void write_key() {
    for (const KeyEntry& entry : layout_.key) {
      const Series& series = plot_.series[entry.series];
      const Look look = look_of(plot_, entry.series);
      const double right = entry.text.x - kKeyBlank, left = right - entry.sample, y = entry.text.y;
      if (bars()) {
        line(
            "set object rectangle from {} to {} front fillstyle solid 1 border lc rgb '{}' fillcolor rgb '{}' lw 0.5",
            screen(left, y + 6), screen(right, y - 6), kInk, look.colour);
      } else if (series.marks != Marks::points) {
        line("set arrow from {} to {} nohead front lc rgb '{}' lw 2 dashtype {}", screen(left, y),
             screen(right, y), look.colour, look.dashes);
      }
      if (!bars() && (series.marks == Marks::points || series.marks == Marks::line_and_points)) {
        line("set label '' at {} front point pt {} ps {} lc rgb '{}' lw 1.5",
             screen((left + right) / 2, y), look.mark, look.mark_size, look.colour);
      }
      label(entry.text.text, screen(entry.text.x, y), "left front", kFontSize);
    }
  }

  void write_point_labels() {
    for (const PlacedLabel& l : layout_.labels) {
      label(l.text.text, screen(l.text.x, l.text.y), "left front", kLabelSize);
      if (!l.distant) continue;
      line("set arrow from {} to {} nohead back lc rgb '{}' lw 0.75", screen(l.point_x, l.point_y),
           screen(l.line_x, l.line_y), kMuted);
    }
  }

  // What gnuplot draws of one series: its marks lie on its intervals, its bars beneath them.
  std::vector<std::string> clauses(std::size_t index) const {
    if (layout_.points[index].empty()) return {};
    const std::string intervals = interval_clause(index);
    if (bars()) {
      const std::string boxes = fmt::format(
          "$series{} using 1:2:({}) with boxes fillstyle solid 1 border lc rgb '{}' fillcolor rgb '{}' lw 0.5",
          index, layout_.bar_width * 0.94, kInk, look_of(plot_, index).colour);
      return {boxes, intervals};
    }
    return {intervals, marks_clause(index)};
  }

  std::string marks_clause(std::size_t index) const {
    const Series& series = plot_.series[index];
    const Look look = look_of(plot_, index);
    const std::string stroke =
        fmt::format("lc rgb '{}' lw {} dt {}", look.colour, series.muted ? 1.5 : 2.0, look.dashes);
    const std::string mark = fmt::format("pt {} ps {}", look.mark, look.mark_size);
    const std::string data = fmt::format("$series{} using 1:2 with ", index);
    switch (series.marks) {
      case Marks::line: return data + "lines " + stroke;
      case Marks::steps: return data + "steps " + stroke;
      case Marks::points:
        return data + fmt::format("points {} lc rgb '{}' lw 1.5", mark, look.colour);
      case Marks::line_and_points: break;
    }
    const std::size_t every = 1 + layout_.points[index].size() / 40;
    return data + fmt::format("linespoints {} {} pi {}", stroke, mark, every);
  }

  // Bars with ends, or a band about a curve of many points; empty without intervals.
  std::string interval_clause(std::size_t index) const {
    const auto& points = layout_.points[index];
    if (std::none_of(points.begin(), points.end(), [](const auto& p) { return p.has_interval; })) {
      return "";
    }
    const std::string colour = look_of(plot_, index).colour;
    const Marks marks = plot_.series[index].marks;
    const bool curve = !bars() && (marks == Marks::line || marks == Marks::steps);
    if (curve && points.size() > kFewIntervals) {
      return fmt::format(
          "$intervals{} using 1:3:4 with filledcurves fillstyle transparent solid 0.18 noborder fillcolor rgb '{}'",
          index, colour);
    }
    return fmt::format(
        "$intervals{} using 1:3:(0):($4-$3) with vectors heads size screen 0.005,90 fixed nofilled front lc rgb '{}' lw 1.25",
        index, bars() ? kInk : colour);
  }

  // Muted series first, so that the others lie on top.
  std::string plot_command() const {
    std::string command;
    for (const bool muted : {true, false}) {
      for (std::size_t i = 0; i < plot_.series.size(); ++i) {
        if (plot_.series[i].muted != muted) continue;
        for (const std::string& clause : clauses(i)) {
          if (clause.empty()) continue;
          command += (command.empty() ? "plot " : ", ") + clause + " notitle";
        }
      }
    }
    return command.empty() ? "plot NaN notitle" : command;
  }

  void write_outputs() {
    const double w = layout_.width, h = layout_.height;
    const std::string command = plot_command();
    line(
        "set terminal svg size {:.0f},{:.0f} dynamic noenhanced font 'sans-serif,{}' background '#ffffff'",
        w, h, kFontSize);
    line("set output 'plot.svg'\n{}\nunset output", command);
    // 125 px to the inch: 6.4 in wide, the text of a page with its margins. A font's point is 1/72
    // in, which this terminal takes for 1/96: 72 / 125 * 72 / 96 = 0.432.
    line(
        "set terminal pdfcairo size {:.3f}in,{:.3f}in noenhanced font 'sans-serif,{}' fontscale 0.432 linewidth 1.2 pointscale 0.6",
        w / 125, h / 125, kFontSize);
    line("set output 'plot.pdf'\n{}\nunset output", command);
    line(
        "set terminal pngcairo size {:.0f},{:.0f} noenhanced font 'sans-serif,{}' fontscale 1.5 linewidth 2 pointscale 2",
        2 * w, 2 * h, kFontSize);
    line("set output 'plot.png'\n{}\nunset output", command);
  }

  const Plot& plot_;
  PlotLayout layout_;
  std::string text_;
};

}  // namespace

std::string gnuplot_string(const std::string& text) {
  std::string quoted = "\"";
  bool escaped = false;  // the last character; gnuplot reads all digits that follow as part of it
  for (const char c : valid_utf8(text)) {
    const auto byte = static_cast<unsigned char>(c);
    const bool digit = std::isdigit(byte) != 0;
    const bool plain = byte >= 0x80 || std::isalpha(byte) != 0 || c == ' ' || (digit && !escaped);
    escaped = !plain && std::iscntrl(byte) == 0;
    if (escaped) {
      quoted += fmt::format("\\{:03o}", byte);
    } else {
      quoted += plain ? c : ' ';
    }
  }
  return quoted + '"';
}

std::string plot_script(const Plot& plot) { return Script(plot).text(); }

}  // namespace clipscope::experiments
