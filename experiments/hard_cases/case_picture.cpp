// SPDX-License-Identifier: GPL-3.0-or-later
//
// The page: title, panels, table of the vertices, legend.
#include "experiments/hard_cases/case_picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "experiments/hard_cases/case_sketch.hpp"
#include "experiments/report/table.hpp"

namespace clipscope::experiments {
namespace {

constexpr double kMargin = 24, kRow = 18;
constexpr double kColumn = kSmallPanel + kTickRoom;
constexpr double kWidth = kMargin + 2 * kColumn + kTickRoom + kLargePanel + kMargin;
constexpr double kPanels = 2 * kSmallPanel + kUnderPanel;
constexpr double kNumber = 112;  // width of a column of the table
constexpr std::size_t kMaxTableRows = 10, kMaxWhyLines = 3;
constexpr Lettering kTitleText = {.size = 18, .bold = true};
constexpr Lettering kText = {.size = 13};
constexpr Lettering kTableText = {.size = 12};

// ---- The title ----------------------------------------------------------------------------------

std::string volume_text(const HardCase& c) {
  std::string text = c.space == Space::view ? "view space" : "clip space";
  switch (c.volume.depth) {
    case DepthRange::minus_one_to_one: break;
    case DepthRange::zero_to_one: text += ", depth 0 to 1"; break;
    case DepthRange::reversed: text += ", depth reversed"; break;
  }
  if (c.volume.depth_clamp) text += ", depth clamp";
  if (c.volume.clip_distances > 0) {
    text += fmt::format(", {} clip distance{}", c.volume.clip_distances,
                        c.volume.clip_distances == 1 ? "" : "s");
  }
  return text;
}

std::string title_text(const CasePicture& p) {
  return fmt::format("{}: a {} in {}", p.hard_case.name, to_string(p.hard_case.primitive),
                     volume_text(p.hard_case));
}

// "textbook in float: visible; 4 vertices, exact 4; errors up to 0.02 px, 12 ulp".
std::string verdict_text(const CasePicture& p) {
  const Comparison& c = p.answer.comparison;
  std::string text = fmt::format("{} in {}: {}", p.clipper, p.scalar, outcome_name(c.outcome));
  if (c.outcome == Outcome::not_applicable) return text;
  const std::size_t found = p.answer.polygon.size(), exact = p.truth.exact.vertices.size();
  text += fmt::format("; {} {}, exact {}", found, found == 1 ? "vertex" : "vertices", exact);
  if (c.outcome <= Outcome::visible && exact > 0) {
    text += fmt::format("; errors up to {} px", short_number(c.position_px, 3));
    if (std::isfinite(c.position_ulp)) {
      text += fmt::format(", {} ulp in x, y, z and 1/w", short_number(c.position_ulp, 3));
    }
  }
  return text;
}

struct Heading {
  std::string title;
  std::vector<std::string> why;
  std::string verdict;

  double height() const { return 26 + kRow * static_cast<double>(why.size()) + kRow + 8; }
};

Heading heading_of(VectorPage& page, const CasePicture& p) {
  const double width = kWidth - 2 * kMargin;
  Heading h{page.wrap(title_text(p), width, 1, kTitleText).front(),
            page.wrap(p.hard_case.why, width, kMaxWhyLines, kText), verdict_text(p)};
  if (p.hard_case.why.empty()) h.why.clear();
  return h;
}

void draw_heading(VectorPage& page, const Heading& h) {
  double y = kMargin + 14;
  page.text({kMargin, y}, h.title, kTitleText);
  y += 24;
  for (const std::string& line : h.why) {
    page.text({kMargin, y}, line, kText);
    y += kRow;
  }
  page.text({kMargin, y}, h.verdict, {.size = 13, .bold = true});
}

// ---- The table of the vertices ------------------------------------------------------------------

std::size_t table_rows(const CaseSketch& s) {
  return std::min(s.geometry.input_clip.size(), kMaxTableRows);
}

// Enough digits to tell a float from its neighbours: "0.99999994".
std::string full_number(double value) {
  const auto rounded = static_cast<float>(value);
  return rounded == value ? fmt::format("{}", rounded) : short_number(value, 9);
}

// The coordinates as given; of view space w too, since its sign matters.
std::vector<std::string> table_row(const CaseSketch& s, std::size_t i) {
  std::vector<std::string> cells;
  const auto& given = s.picture.hard_case.vertices[i].position;
  for (std::size_t c = 0; c < 3; ++c) cells.push_back(full_number(given[c]));
  cells.push_back(s.in_view_space() ? short_number(CGAL::to_double(s.geometry.input_clip[i][3]))
                                    : full_number(given[3]));
  return cells;
}

void draw_table(CaseSketch& s, Spot corner) {
  const std::size_t rows = table_rows(s);
  double y = corner.y;
  s.page.text({corner.x, y}, "Vertex", {.size = 12, .bold = true});
  // The computed w has fewer digits.
  const auto column = [&](std::size_t c) {
    return corner.x + 30 + kNumber * double(c + 1) - (c == 3 && s.in_view_space() ? 34 : 0);
  };
  const std::vector<std::string> names = {"x", "y", "z", s.in_view_space() ? "w (clip)" : "w"};
  for (std::size_t c = 0; c < names.size(); ++c) {
    s.page.text({column(c), y}, names[c], {.size = 12, .bold = true, .anchor = Anchor::right});
  }
  for (std::size_t i = 0; i < rows; ++i) {
    y += kRow;
    s.page.text({corner.x + 6, y}, std::to_string(i), {.size = 12, .bold = true});
    const std::vector<std::string> cells = table_row(s, i);
    for (std::size_t c = 0; c < cells.size(); ++c) {
      s.page.text({column(c), y}, cells[c], {.size = 12, .anchor = Anchor::right});
    }
    s.page.text({column(3) + 16, y}, s.geometry.places[i] + (s.geometry.behind[i] ? ", w ≤ 0" : ""),
                kTableText);
  }
  if (s.geometry.input_clip.size() > rows) {
    s.page.text({corner.x + 6, y + kRow},
                fmt::format("and {} more", s.geometry.input_clip.size() - rows), kTableText);
  }
}

// ---- The legend ---------------------------------------------------------------------------------

// Draws a sample around the spot, 30 px wide.
struct LegendEntry {
  void (*draw)(VectorPage&, Spot);
  std::string text;
};

std::array<Spot, 4> sample_box(Spot s) {
  return {Spot{s.x - 15, s.y - 6}, Spot{s.x + 15, s.y - 6}, Spot{s.x + 15, s.y + 6},
          Spot{s.x - 15, s.y + 6}};
}

void draw_line_sample(VectorPage& page, Spot s, const Pen& pen) {
  page.stroke(std::array{Spot{s.x - 15, s.y}, Spot{s.x + 15, s.y}}, pen, false);
}

std::vector<LegendEntry> legend_of(const CaseSketch& s) {
  const std::string primitive = to_string(s.picture.hard_case.primitive);
  std::vector<LegendEntry> entries = {
      {[](VectorPage& page, Spot at) {
         draw_line_sample(page, at, kInputPen);
         page.circle(at, 4, {0xffffff}, {kBlack, 1.5});
       },
       fmt::format("the {} as given", primitive)},
      {[](VectorPage& page, Spot at) {
         page.circle(at, 4, kBlack, {kBlack, 1.5});
       },
       "a vertex with w ≤ 0: it has no place in NDC"},
      {[](VectorPage& page, Spot at) {
         page.fill(sample_box(at), kVolumeFill);
         page.stroke(sample_box(at), kPlanePen, true);
       },
       "the view volume and its planes"},
      {[](VectorPage& page, Spot at) { page.hatch(sample_box(at), kHatch); },
       "behind the eye: w < 0"},
      {[](VectorPage& page, Spot at) {
         page.fill(sample_box(at), kExactFill);
         page.stroke(sample_box(at), kExactPen, true);
       },
       "the exact result: the part inside"},
      {[](VectorPage& page, Spot at) {
         draw_line_sample(page, at, kAnswerPen);
         const std::array diamond = {Spot{at.x - 5.6, at.y}, Spot{at.x, at.y - 5.6},
                                     Spot{at.x + 5.6, at.y}, Spot{at.x, at.y + 5.6}};
         page.stroke(diamond, {kAnswer, 1.5}, true);
       },
       "the clipper's answer"},
  };
  const HardCase& c = s.picture.hard_case;
  if (c.vertices.size() > 1) {
    entries.push_back({[](VectorPage& page, Spot at) { draw_line_sample(page, at, kDividedPen); },
                       fmt::format("the whole {} after the divide", primitive)});
  }
  if (c.space == Space::view && c.frustum.kind == ProjectionKind::perspective) {
    entries.push_back({draw_eye, "the eye"});
  }
  return entries;
}

void draw_legend(CaseSketch& s, Spot corner) {
  double y = corner.y;
  for (const LegendEntry& entry : legend_of(s)) {
    entry.draw(s.page, {corner.x + 15, y - 4});
    s.page.text({corner.x + 40, y}, entry.text, kTableText);
    y += kRow + 4;
  }
}

double legend_height(const CaseSketch& s) {
  return (kRow + 4) * static_cast<double>(legend_of(s).size());
}

// ---- The page -----------------------------------------------------------------------------------

// The legend stands beneath the panels if view space takes its place among them.
double page_height(const CaseSketch& s, const Heading& heading) {
  const bool more = s.geometry.input_clip.size() > table_rows(s);
  const double table = kRow * static_cast<double>(table_rows(s) + 1 + more);
  const double beneath = s.in_view_space() ? std::max(table, legend_height(s)) : table;
  return kMargin + heading.height() + 24 + kPanels + kUnderPanel + beneath + kMargin;
}

void draw_page(CaseSketch& s, const Heading& heading) {
  draw_heading(s.page, heading);
  const double top = kMargin + heading.height() + 24;
  const double lower = top + kSmallPanel + kUnderPanel;
  const double first = kMargin + kTickRoom, second = first + kColumn, third = second + kColumn;
  const double beneath = top + kPanels + kUnderPanel;
  if (s.in_view_space()) {
    draw_view_space(s, {first, top});
    draw_clip_space(s, {second, top}, 0);
    draw_clip_space(s, {second, lower}, 1);
    draw_legend(s, {third + 56, beneath});
  } else {
    draw_clip_space(s, {first, top}, 0);
    draw_clip_space(s, {first, lower}, 1);
    draw_clip_space(s, {second, top}, 2);
    draw_legend(s, {second - 20, lower + 8});
  }
  draw_ndc(s, {third, top});
  draw_table(s, {kMargin, beneath});
}

}  // namespace

void check_picture_path(const std::filesystem::path& path) { page_format(path); }

void write_case_picture(const std::filesystem::path& path, const CasePicture& picture) {
  const PageFormat format = page_format(path);
  // Lines can only be broken on a page, and the page's height depends on their number.
  VectorPage ruler(PageFormat::png, 1, 1, "");
  const Heading heading = heading_of(ruler, picture);
  CaseSketch measured{picture, ruler,
                      case_geometry(picture.hard_case, picture.truth, picture.answer)};
  VectorPage page(format, kWidth, page_height(measured, heading), heading.title);
  CaseSketch sketch{picture, page, std::move(measured.geometry)};
  draw_page(sketch, heading);
  write_file(path, page.finish());
}

}  // namespace clipscope::experiments
