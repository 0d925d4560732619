// SPDX-License-Identifier: GPL-3.0-or-later
//
// The page: title, panels, table of the vertices, legend.
#include "experiments/hard_cases/case_picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "experiments/hard_cases/case_panels.hpp"
#include "experiments/machine/files.hpp"
#include "experiments/report/outcode_text.hpp"
#include "experiments/scenes/text_file.hpp"
#include "experiments/survey/verdicts.hpp"
#include "experiments/table/row.hpp"

namespace clipscope::experiments::hard_cases {
namespace {

constexpr double kMargin = 24, kRow = 18, kLegendRow = kRow + 4;
constexpr double kColumn = kSmallPanel + kTickRoom;
constexpr double kWidth = kMargin + 2 * kColumn + kTickRoom + kLargePanel + kMargin;
constexpr double kPanels = 2 * kSmallPanel + kUnderPanel;
constexpr double kNumber = 112;  // width of a column of the table
constexpr std::size_t kMaxTableRows = 10, kMaxWhyLines = 3;
constexpr Lettering kTitleText = {.size = 18, .bold = true};
constexpr Lettering kText = {.size = 13};
constexpr Lettering kTableText = {.size = 12}, kTableHead = {.size = 12, .bold = true};

// ---- The title ----------------------------------------------------------------------------------

// Which plane alone is clamped; "" of both.
std::string clamped_plane(DepthClamp clamp) {
  if (clamp.near && clamp.far) return "";
  return clamp.near ? " (near)" : " (far)";
}

// " right bottom".
std::string open_sides_text(const ClipVolume& volume) {
  std::string text;
  for_each_plane(open_planes_of(volume), kAllPlanes,
                 [&](Plane side) { text += ' ' + plane_text(side); });
  return text;
}

std::string title_text(const HardCase& c) {
  const ClipVolume& volume = c.volume;
  std::string text = fmt::format("{}: a {} in {} space", c.name, to_string(c.primitive),
                                 c.space == Space::view ? "view" : "clip");
  if (c.matrix) text += ", by a matrix as given";
  if (!c.planes.empty()) text += ", " + counted(c.planes.size(), "user plane", "user planes");
  if (volume.depth == DepthRange::zero_to_one) text += ", depth 0 to 1";
  if (volume.depth == DepthRange::reversed) text += ", depth reversed";
  if (volume.depth_clamp) text += ", depth clamp" + clamped_plane(volume.depth_clamp);
  if (volume.open_sides) text += ", half-open:" + open_sides_text(volume);
  if (volume.clip_distances > 0) {
    text += ", " + counted(volume.clip_distances, "clip distance", "clip distances");
  }
  return text;
}

// "textbook in float: visible; 4 vertices, exact 4; errors up to 0.02 px, 12 ulp".
std::string verdict_text(const CasePicture& p) {
  const Comparison& c = p.comparison;
  std::string text = fmt::format("{} in {}: {}", p.clipper, p.format.name, name_of(c.outcome));
  if (c.outcome == Outcome::not_applicable) return text;
  const std::size_t exact = p.truth.exact.vertices.size();
  text += fmt::format("; {}, exact {}", counted(p.answer.size(), "vertex", "vertices"), exact);
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
  Heading h{page.wrap(title_text(p.hard_case), width, 1, kTitleText).front(), {}, verdict_text(p)};
  if (!p.hard_case.why.empty()) h.why = page.wrap(p.hard_case.why, width, kMaxWhyLines, kText);
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

// Enough digits to tell a float from its neighbours: "0.99999994".
std::string full_number(double value) {
  const auto rounded = static_cast<float>(value);
  return rounded == value ? fmt::format("{}", rounded) : short_number(value, 9);
}

// Coordinates as given; in view space w too, since its sign matters. The rest is counted.
void draw_table(CaseSketch& s, Spot corner) {
  const bool view = s.picture.hard_case.space == Space::view;
  const std::array<std::string, 4> names = {"x", "y", "z", view ? "w (clip)" : "w"};
  // The computed w has fewer digits.
  const auto column = [&](std::size_t c) {
    return corner.x + 30 + kNumber * double(c + 1) - (c == 3 && view ? 34 : 0);
  };
  const auto write = [&](std::size_t c, double y, const std::string& text, Lettering style) {
    style.anchor = Anchor::right;
    s.page.text({column(c), y}, text, style);
  };
  double y = corner.y;
  s.page.text({corner.x, y}, "Vertex", kTableHead);
  for (std::size_t c = 0; c < 4; ++c) write(c, y, names[c], kTableHead);
  const std::size_t all = s.geometry.input_clip.size(), rows = std::min(all, kMaxTableRows);
  for (std::size_t i = 0; i < rows; ++i) {
    y += kRow;
    s.page.text({corner.x + 6, y}, std::to_string(i), kTableHead);
    const auto& given = s.picture.hard_case.vertices[i].position;
    for (std::size_t c = 0; c < 4; ++c) {
      const bool computed = c == 3 && view;
      write(c, y,
            computed ? short_number(nearest_double(s.geometry.input_clip[i][3]))
                     : full_number(given[c]),
            kTableText);
    }
    s.page.text({column(3) + 16, y}, s.geometry.places[i] + (s.geometry.behind[i] ? ", w ≤ 0" : ""),
                kTableText);
  }
  if (all > rows) {
    s.page.text({corner.x + 6, y + kRow}, fmt::format("and {} more", all - rows), kTableText);
  }
}

double table_height(const CaseSketch& s) {
  // The head; the rows, and the count of the others in place of one more.
  return kRow *
         (1 + static_cast<double>(std::min(s.geometry.input_clip.size(), kMaxTableRows + 1)));
}

// ---- The legend ---------------------------------------------------------------------------------

// Draws a sample around the spot, 30 px wide.
struct LegendEntry {
  void (*draw)(VectorPage&, Spot);
  std::string text;
};

std::array<Spot, 4> sample_box(Spot s) { return Rect{s.x - 15, s.y - 6, 30, 12}.corners(); }

void draw_box_sample(VectorPage& page, Spot at, Colour fill, const Pen& rim) {
  page.fill(sample_box(at), fill);
  page.stroke(sample_box(at), rim, true);
}

void draw_line_sample(VectorPage& page, Spot s, const Pen& pen) {
  page.stroke(std::array{Spot{s.x - 15, s.y}, Spot{s.x + 15, s.y}}, pen, false);
}

std::vector<LegendEntry> legend_of(const HardCase& c) {
  const std::string primitive = to_string(c.primitive);
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
      {[](VectorPage& page, Spot at) { draw_box_sample(page, at, kVolumeFill, kPlanePen); },
       "the view volume and its planes"},
      {[](VectorPage& page, Spot at) { page.hatch(sample_box(at), kHatch); },
       "behind the eye: w < 0"},
      {[](VectorPage& page, Spot at) { draw_box_sample(page, at, kExactFill, kExactPen); },
       "the exact result: the part inside"},
      {[](VectorPage& page, Spot at) {
         draw_line_sample(page, at, kAnswerPen);
         const std::array diamond = {Spot{at.x - 5.6, at.y}, Spot{at.x, at.y - 5.6},
                                     Spot{at.x + 5.6, at.y}, Spot{at.x, at.y + 5.6}};
         page.stroke(diamond, {kAnswer, 1.5}, true);
       },
       "the clipper's answer"},
  };
  if (c.vertices.size() > 1) {
    entries.push_back({[](VectorPage& page, Spot at) { draw_line_sample(page, at, kDividedPen); },
                       fmt::format("the whole {} after the divide", primitive)});
  }
  if (has_frustum(c) && c.frustum.kind == ProjectionKind::perspective) {
    entries.push_back({draw_eye, "the eye"});
  }
  return entries;
}

void draw_legend(CaseSketch& s, Spot corner) {
  double y = corner.y;
  for (const LegendEntry& entry : legend_of(s.picture.hard_case)) {
    entry.draw(s.page, {corner.x + 15, y - 4});
    s.page.text({corner.x + 40, y}, entry.text, kTableText);
    y += kLegendRow;
  }
}

// ---- The page -----------------------------------------------------------------------------------

// The legend stands beneath the panels if view space takes its place among them.
double page_height(const CaseSketch& s, const Heading& heading) {
  const auto legend = static_cast<double>(legend_of(s.picture.hard_case).size());
  const double beneath = std::max(table_height(s), s.in_view_space() ? kLegendRow * legend : 0);
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

CasePicture picture_of(const HardCase& hard_case, const Contestant& contestant) {
  const TruthPolygon truth = truth_polygon(hard_case);
  CasePicture picture{hard_case,
                      truth,
                      judge_case(contestant, hard_case, truth),
                      {},
                      std::string(contestant.clipper),
                      *contestant.format};
  if (takes(contestant, hard_case)) {
    picture.answer = positions_of(clip_case(contestant, hard_case)[0]);
  }
  return picture;
}

void write_case_picture(const std::filesystem::path& path, const CasePicture& picture) {
  const PageFormat format = page_format(path);
  // Lines can only be broken on a page, and the page's height depends on their number.
  VectorPage ruler(PageFormat::png, 1, 1, "");
  const Heading heading = heading_of(ruler, picture);
  CaseSketch measured{picture, ruler,
                      case_geometry(picture.hard_case, picture.truth.exact, picture.answer)};
  VectorPage page(format, kWidth, page_height(measured, heading), heading.title);
  CaseSketch sketch{picture, page, std::move(measured.geometry)};
  draw_page(sketch, heading);
  write_file(path, page.finish());
}

}  // namespace clipscope::experiments::hard_cases
