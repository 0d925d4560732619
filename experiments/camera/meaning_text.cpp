// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/camera/meaning_text.hpp"

#include <fmt/format.h>

#include <cmath>
#include <tuple>

#include "experiments/table/row.hpp"

namespace clipscope::experiments {
namespace {

constexpr std::array<std::string_view, 3> kConventions = {"gl", "zero_to_one", "reversed"};
constexpr std::array<std::string_view, kPlanes> kPlaneNames = {"left", "right", "bottom",
                                                               "top",  "near",  "far"};

// Six digits; "inf" and "-0" as 0.
std::string number(double x) { return fmt::format("{:.6g}", x == 0 ? 0.0 : x); }

std::string vector(const glm::dvec3& v) {
  return fmt::format("({}, {}, {})", number(v.x), number(v.y), number(v.z));
}

// ---- Tables -----------------------------------------------------------------------------------

std::string range_text(const DepthReading& reading, const Ranged& r) {
  if (!reading.encloses_volume) return "";
  if (r.low == r.high) return "exact";
  return fmt::format("{:.7g} to {:.7g}", r.low, r.high);
}

struct ConventionRow {
  std::string convention, near, near_range, far, far_range, verdict;

  static constexpr std::string_view kName = "depth", kTitle = "Near and far, by depth convention";
  static constexpr std::array<std::string_view, 1> kNotes = {
      "One entry off: what near and far become when one entry of the matrix is the next float (or double) below or above. gl and zero_to_one can't be told apart by a matrix: --depth says which is meant (gl: z from -1 to 1; zero_to_one: 0 to 1; reversed: 1 to 0)."};
  static constexpr auto columns() {
    using R = ConventionRow;
    return std::tuple(column("convention", &R::convention), column("near", &R::near),
                      column("near_range", "one entry off", &R::near_range), column("far", &R::far),
                      column("far_range", "one entry off", &R::far_range),
                      column("verdict", "", &R::verdict));
  }
};

TableOf<ConventionRow> convention_table(const MatrixMeaning& m, bool is_chosen) {
  TableOf<ConventionRow> table;
  for (const DepthReading& r : m.readings) {
    const std::string verdict = !r.encloses_volume   ? "no volume"
                                : r.depth != m.depth ? ""
                                : is_chosen          ? "asked for"
                                                     : "taken here";
    table.add({std::string(kConventions[static_cast<std::size_t>(r.depth)]), number(r.near.value),
               range_text(r, r.near), number(r.far.value), range_text(r, r.far), verdict});
  }
  return table;
}

std::string digits_text(const PlaneReading& p) {
  if (p.at_infinity) return p.rounded[3] >= 0 ? "at infinity" : "rejects all";
  if (std::isinf(p.digits)) return "all";
  return p.digits <= 0 ? "lost" : fmt::format("{:.1f}", p.digits);
}

struct PlaneRow {
  std::string plane, a, b, c, d, sum, digits;

  static constexpr std::string_view kName = "planes",
                                    kTitle = "The six planes: a x + b y + c z + d >= 0 is inside";
  static constexpr std::array<std::string_view, 1> kNotes = {
      "Sum: whether the sum of two rows is exact in the format. Digits: decimal digits that are left of the plane's direction when each entry but 0, 1 and -1 is known to half an ulp; lost: none."};
  static constexpr auto columns() {
    using R = PlaneRow;
    return std::tuple(column("plane", &R::plane), column("a", &R::a), column("b", &R::b),
                      column("c", &R::c), column("d", &R::d), column("sum", &R::sum),
                      column("digits", &R::digits));
  }
};

TableOf<PlaneRow> plane_table(const MatrixMeaning& m) {
  TableOf<PlaneRow> table;
  for (const PlaneReading& p : m.planes) {
    table.add({std::string(kPlaneNames[static_cast<std::size_t>(p.plane)]),
               fmt::format("{:.9g}", p.rounded[0]), fmt::format("{:.9g}", p.rounded[1]),
               fmt::format("{:.9g}", p.rounded[2]), fmt::format("{:.9g}", p.rounded[3]),
               p.is_exact ? "exact" : "rounded", digits_text(p)});
  }
  return table;
}

struct DigitsRow {
  std::string distance, z;
  std::array<std::string, kDepthBuffers> buffers = {};
  std::string left16 = "", left24 = "";

  static constexpr std::string_view kName = "depth_digits",
                                    kTitle = "What depth can tell apart, by distance";
  static constexpr std::array<std::string_view, 1> kNotes = {
      "16 bits, 24 bits, float: the smallest step of distance that such a buffer tells apart there, and in brackets the decimal digits that this leaves of the distance (of a parallel projection, of the whole depth). Values: how many a buffer has left from there to far."};
  static constexpr auto columns() {
    using R = DigitsRow;
    constexpr std::array<std::string_view, kDepthBuffers> kKeys = {"16 bits", "24 bits", "float"};
    return std::tuple(
        column("distance", &R::distance), column("z", &R::z), columns_of_array(&R::buffers, kKeys),
        column("values16", "values 16", &R::left16), column("values24", "values 24", &R::left24));
  }
};

TableOf<DigitsRow> digits_table(const MatrixMeaning& m) {
  TableOf<DigitsRow> table;
  for (const DepthDigits& d : depth_digits(m)) {
    DigitsRow row{.distance = number(d.distance), .z = fmt::format("{:.7g}", d.depth)};
    for (std::size_t i = 0; i < d.step.size(); ++i) {
      row.buffers[i] = fmt::format("{:.2g} ({:.1f})", d.step[i], std::max(0.0, d.digits[i]));
    }
    row.left16 = fmt::format("{:.0f}", d.values_left[0]);
    row.left24 = fmt::format("{:.0f}", d.values_left[1]);
    table.add(std::move(row));
  }
  return table;
}

// ---- Sentences --------------------------------------------------------------------------------

std::string singular_text(const Singular& s) {
  const glm::dvec3 lost(s.lost[0], s.lost[1], s.lost[2]);
  return fmt::format(
      "The matrix is singular (rank {} of 4): it flattens space.\n{} {} goes to (0, 0, 0, 0), exactly.\n",
      s.rank, s.lost[3] == 0 ? "The direction" : "The point", vector(lost));
}

std::string hand_text(const MatrixMeaning& m) {
  const char* up = m.right_handed ? "right-handed" : "left-handed";
  const char* down = m.right_handed ? "left-handed" : "right-handed";
  return fmt::format(
      "{} where y of NDC goes up (OpenGL, Direct3D), {} where it goes\n              down (Vulkan); for a space of the other hand the picture is mirrored",
      up, down);
}

// "sides: left ..., as tangents".
std::string sides_text(const MatrixMeaning& m) {
  const auto sides = [&](double scale) {
    return fmt::format("left {}, right {}, bottom {}, top {}", number(scale * m.left),
                       number(scale * m.right_side), number(scale * m.bottom),
                       number(scale * m.top));
  };
  if (!m.perspective) {
    return fmt::format("frustum:      {}, near {}, far {}\n", sides(1),
                       number(m.reading().near.value), number(m.reading().far.value));
  }
  std::string text = fmt::format(
      "view:         {:.6g}° wide, {:.6g}° high; sides per unit of distance:\n              {}\n",
      m.horizontal_degrees(), m.vertical_degrees(), sides(1));
  if (m.reading().encloses_volume) {
    const double near = m.reading().near.value;
    text += fmt::format("frustum:      {},\n              near {}, far {}\n", sides(near),
                        number(near), number(m.reading().far.value));
  }
  return text;
}

std::string remarks(const MatrixMeaning& m) {
  std::string text;
  if (m.is_skewed) {
    text += fmt::format("skewed:       the axes of the picture are {:.4g}° off a right angle\n",
                        m.skew_degrees);
  }
  if (m.is_oblique) {
    text +=
        m.perspective
            ? "oblique:      the depth planes are not perpendicular to the view direction; near and far\n              are those on the line through the eye\n"
            : "oblique:      a parallel projection with a shear\n";
  }
  if (m.has_negative_w) text += "negative w:   w < 0 everywhere, so that every point is outside\n";
  if (!m.reading().encloses_volume) {
    text += fmt::format("no volume:    as {} near and far enclose nothing in front of the eye\n",
                        kConventions[static_cast<std::size_t>(m.depth)]);
  }
  return text;
}

nlohmann::json json_number(double x) {
  if (std::isfinite(x)) return x;
  return x > 0 ? "inf" : "-inf";
}

nlohmann::json json_of(const Ranged& r) {
  return {
      {"value", json_number(r.value)}, {"low", json_number(r.low)}, {"high", json_number(r.high)}};
}

nlohmann::json json_of(const glm::dvec3& v) { return {v.x, v.y, v.z}; }

}  // namespace

std::string meaning_text(const MatrixMeaning& m, bool is_chosen) {
  if (m.singular) return singular_text(*m.singular);
  std::string text =
      fmt::format("projection:   {}{}\n", m.perspective ? "perspective" : "orthographic",
                  m.is_projection_alone ? ", alone: the space is the camera's own"
                                        : ", with a place in the world");
  if (m.perspective) text += fmt::format("eye:          {}\n", vector(m.eye));
  text += fmt::format("looks along:  {}\nright:        {}\nup:           {}\n", vector(m.forward),
                      vector(m.right), vector(m.up));
  text += fmt::format("handedness:   {}\n", hand_text(m));
  text += sides_text(m);
  text += fmt::format("aspect:       {:.6g}\n", m.aspect());
  text += remarks(m);
  text += '\n' + convention_table(m, is_chosen).to_text();
  text += '\n' + plane_table(m).to_text();
  if (m.reading().encloses_volume) text += '\n' + digits_table(m).to_text();
  return text;
}

nlohmann::json meaning_json(const MatrixMeaning& m) {
  if (m.singular) {
    return {{"singular", true}, {"rank", m.singular->rank}, {"lost", m.singular->lost}};
  }
  nlohmann::json json = {
      {"singular", false},
      {"kind", m.perspective ? "perspective" : "orthographic"},
      {"projection_alone", m.is_projection_alone},
      {"forward", json_of(m.forward)},
      {"right", json_of(m.right)},
      {"up", json_of(m.up)},
      {"right_handed_if_y_up", m.right_handed},
      {"sides", {{"left", m.left}, {"right", m.right_side}, {"bottom", m.bottom}, {"top", m.top}}},
      {"aspect", m.aspect()},
      {"skewed", m.is_skewed},
      {"oblique", m.is_oblique},
      {"negative_w", m.has_negative_w}};
  if (m.perspective) {
    json["eye"] = json_of(m.eye);
    json["horizontal_degrees"] = m.horizontal_degrees();
    json["vertical_degrees"] = m.vertical_degrees();
  }
  json["depth"] = kConventions[static_cast<std::size_t>(m.depth)];
  for (const DepthReading& r : m.readings) {
    json["conventions"][std::string(kConventions[static_cast<std::size_t>(r.depth)])] = {
        {"near", json_of(r.near)}, {"far", json_of(r.far)}, {"encloses_volume", r.encloses_volume}};
  }
  for (const PlaneReading& p : m.planes) {
    json["planes"].push_back({{"plane", kPlaneNames[static_cast<std::size_t>(p.plane)]},
                              {"coefficients", p.rounded},
                              {"exact", p.is_exact},
                              {"digits", json_number(p.digits)},
                              {"at_infinity", p.at_infinity}});
  }
  json["depth_digits"] = nlohmann::json::array();
  for (const DepthDigits& d : depth_digits(m)) {
    json["depth_digits"].push_back({{"distance", d.distance},
                                    {"z", d.depth},
                                    {"step", d.step},
                                    {"digits", d.digits},
                                    {"values_left", d.values_left}});
  }
  return json;
}

}  // namespace clipscope::experiments
