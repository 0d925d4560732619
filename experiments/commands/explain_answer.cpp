// SPDX-License-Identifier: GPL-3.0-or-later
//
// A clipper's answer beside the exact one, digit by digit.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <optional>

#include "experiments/commands/explanation.hpp"
#include "experiments/report/decimal.hpp"
#include "experiments/scenes/text_file.hpp"
#include "experiments/table/hex_float.hpp"
#include "experiments/table/row.hpp"

namespace clipscope::experiments::commands {
namespace {

// The exact vertex nearest to a vertex of the answer, on the screen.
const reference::ExactVertex& nearest_vertex(const TruthPolygon& truth, const VertexView& v) {
  const auto distance = [&](const std::vector<double>& a) {
    return std::hypot(v[0].value - a[0], v[1].value - a[1]);
  };
  const auto nearest = std::ranges::min_element(truth.approximation, std::less(), distance);
  return truth.exact.vertices[static_cast<std::size_t>(nearest - truth.approximation.begin())];
}

std::string coordinate_name(std::size_t i) {
  static constexpr std::array<const char*, 4> kNames = {"x", "y", "z", "1/w"};
  return i < 4 ? kNames[i] : fmt::format("a{}", i - 4);
}

// Digits that tell the format's numbers apart, or as many as two columns have room for.
int digits_of(const Format& format) {
  constexpr int kMost = 32;
  return format.is_exact() ? kMost : std::min(kMost, (format.precision * 302) / 1000 + 3);
}

// A number beside the exact one.
struct Coordinate {
  std::string name, digits = "", exact, error = "";
  std::optional<double> absolute = {}, ulp = {};  // none where the number is not finite
};

// Two numbers in the room of one: "1e-09 = 0.25 ulp"; the wide formats have room for one.
std::string error_text(const Format& format, double error, double ulp) {
  if (error == 0) return "0";
  if (format.is_exact()) return fmt::format("{:.2g}", error);
  const std::string in_ulp = fmt::format("{:.3g} ulp", ulp);
  if (format.precision > kFormat<double>.precision) return in_ulp;
  return fmt::format("{:.2g} = {}", error, in_ulp);
}

Coordinate coordinate_beside(const Format& format, std::size_t i, const Number& value,
                             const reference::Fraction& exact) {
  const int digits = digits_of(format);
  const Exact right = reference::to_rational(exact);
  Coordinate c{.name = coordinate_name(i), .exact = decimal(right, digits)};
  if (!is_finite(value)) {
    c.digits = fmt::format("{}", value.value);
    c.error = "not finite";
    return c;
  }
  const Exact found = to_exact(value);
  c.digits = marked_decimal(found, right, digits);
  c.absolute = reference::error_of(found, exact);
  const double ulp = format.ulp_at(reference::approximate(exact));
  if (ulp > 0) c.ulp = std::abs(*c.absolute) / ulp;
  c.error = error_text(format, *c.absolute, c.ulp.value_or(0));
  return c;
}

std::vector<Coordinate> coordinates_of(const Explanation& e, std::size_t vertex) {
  const VertexView v = e.answer[vertex];
  const reference::ExactVertex& exact = nearest_vertex(e.truth, v);
  std::vector<Coordinate> coordinates;
  for (std::size_t i = 0; i < v.size(); ++i) {
    coordinates.push_back(
        coordinate_beside(e.answer.format(), i, v[i], coordinate(exact, static_cast<int>(i))));
  }
  return coordinates;
}

// What the category means, in words.
std::string meaning_of(const Explanation& e) {
  const std::size_t exact = e.truth.exact.vertices.size();
  switch (e.comparison.outcome) {
    case Outcome::exact:
      if (exact == 0) return "nothing is visible, and nothing was drawn";
      if (!e.truth.is_visible()) {
        return fmt::format("only a {} without area is visible, nothing to draw",
                           exact == 1 ? "point" : "line");
      }
      return "each coordinate is the nearest number that there is";
    case Outcome::faithful: return "each coordinate within one ulp";
    case Outcome::subpixel:
      return fmt::format("up to {:.2g} px of 3840 x 2160 off, which nobody sees",
                         e.comparison.position_px);
    case Outcome::visible:
      return fmt::format("up to {:.3g} px of 3840 x 2160 off", e.comparison.position_px);
    case Outcome::vertex_count: return "another number of vertices, repeated ones counted once";
    case Outcome::missing: return "nothing was drawn where something is visible";
    case Outcome::extra: return "something was drawn where nothing is visible";
    case Outcome::flipped: return "the winding is reversed";
    case Outcome::not_finite: return "some coordinate is NaN or infinite";
    case Outcome::crashed:
    case Outcome::timed_out:
    case Outcome::malformed: return e.answer.failure()->reason;
    case Outcome::not_applicable: return "the method does not take such input";
  }
  return "";
}

// Rows of one cell are headings and need no room in the first column.
void print_columns(std::string_view indent, const std::vector<std::array<std::string, 4>>& rows) {
  std::array<std::size_t, 3> widths = {3, 0, 0};
  for (const auto& row : rows) {
    if (row[1].empty()) continue;
    for (std::size_t c = 0; c < 3; ++c) widths[c] = std::max(widths[c], row[c].size());
  }
  for (const auto& [name, digits, exact, error] : rows) {
    std::string line = fmt::format("{}{:{}}  {:{}}  {:{}}  {}", indent, name, widths[0], digits,
                                   widths[1], exact, widths[2], error);
    line.erase(line.find_last_not_of(' ') + 1);
    fmt::print("{}\n", line);
  }
}

// What an empty answer lacks.
void print_exact_vertices(const Format& format, const TruthPolygon& truth) {
  for (std::size_t v = 0; v < truth.exact.vertices.size(); ++v) {
    fmt::print("  exact vertex {}\n", v);
    for (std::size_t i = 0; i < truth.approximation[v].size(); ++i) {
      const Exact value =
          reference::to_rational(coordinate(truth.exact.vertices[v], static_cast<int>(i)));
      fmt::print("    {:3}  {}\n", coordinate_name(i), decimal(value, digits_of(format)));
    }
  }
}

}  // namespace

void print_answer(const Explanation& e) {
  fmt::print("\nAnswer of {} in {}\n", e.contestant.clipper, e.contestant.scalar());
  const std::size_t exact = e.truth.exact.vertices.size();
  fmt::print("  {}, exact {}; outcome: {}: {}\n", counted(e.answer.size(), "vertex", "vertices"),
             exact, name_of(e.comparison.outcome), meaning_of(e));
  if (exact == 0) return;
  if (e.answer.empty()) return print_exact_vertices(e.answer.format(), e.truth);
  // All vertices share the widths of the columns, so that they are aligned.
  std::vector<std::array<std::string, 4>> rows = {
      {"", "digits, the first wrong one in []", "exact", "error"}};
  for (std::size_t v = 0; v < e.answer.size(); ++v) {
    rows.push_back({fmt::format("vertex {}", v), "", "", ""});
    for (const Coordinate& c : coordinates_of(e, v)) {
      rows.push_back({"  " + c.name, c.digits, c.exact, c.error});
    }
  }
  print_columns("  ", rows);
}

nlohmann::json answer_json(const Explanation& e) {
  nlohmann::json vertices = nlohmann::json::array(), exact = nlohmann::json::array();
  const bool is_comparable = !e.truth.exact.vertices.empty();
  for (std::size_t v = 0; v < e.answer.size(); ++v) {
    nlohmann::json& vertex = vertices.emplace_back();
    for (std::size_t i = 0; i < e.answer[v].size(); ++i) {
      const double value = e.answer[v][i].value;
      vertex[coordinate_name(i)] = {{"value", value}, {"hex", hex_float(value)}};
    }
    if (!is_comparable) continue;
    for (const Coordinate& c : coordinates_of(e, v)) {
      vertex[c.name]["exact"] = c.exact;
      if (c.absolute) vertex[c.name]["error"] = *c.absolute;
      if (c.ulp) vertex[c.name]["ulp"] = *c.ulp;
    }
  }
  for (const reference::ExactVertex& v : e.truth.exact.vertices) {
    nlohmann::json& vertex = exact.emplace_back();
    for (std::size_t i = 0; i < 4 + v.attributes.size(); ++i) {
      vertex[coordinate_name(i)] =
          decimal(reference::to_rational(coordinate(v, static_cast<int>(i))), 34);
    }
  }
  return {{"clipper", e.contestant.clipper},
          {"scalar", e.contestant.scalar()},
          {"outcome", name_of(e.comparison.outcome)},
          {"meaning", meaning_of(e)},
          {"vertices", vertices},
          {"exact_vertices", exact}};
}

}  // namespace clipscope::experiments::commands
