// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/report/table_html.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "experiments/report/html.hpp"

namespace clipscope::experiments {
namespace {

constexpr std::size_t kLongText = 40;  // characters from which a text may break into lines

// What the texts of a column need, and whether it has any.
struct Look {
  bool text = false;
  bool long_text = false;
};

Look look_of(const Table& table, std::size_t column) {
  Look look;
  for (const auto& row : table.rows()) {
    const auto* text = std::get_if<std::string>(&row[column]);
    look.text = look.text || text != nullptr;
    look.long_text = look.long_text || (text != nullptr && text->size() > kLongText);
  }
  return look;
}

std::string class_of(const Look& look) {
  if (!look.text) return "n";
  return look.long_text ? "long" : "short";
}

// As JavaScript's Number() reads it.
std::string script_number(double value) {
  if (std::isnan(value)) return "NaN";
  if (std::isinf(value)) return value > 0 ? "Infinity" : "-Infinity";
  return fmt::format("{}", value);
}

std::string text_html(const std::string& text, const std::string& key,
                      const std::set<std::string>& parts) {
  if (key == "verdict") return verdict_html(text);
  if (key != "experiment" || !parts.contains(text)) return html_escape(text);
  return fmt::format("<a href=\"#{0}\">{0}</a>", html_escape(text));
}

// What stands between the tags of a cell, and its attributes.
struct CellHtml {
  std::string attributes, content;
};

CellHtml cell_html(const Cell& cell, const std::string& css, const std::string& key,
                   const std::set<std::string>& parts) {
  if (const auto* text = std::get_if<std::string>(&cell)) {
    return {fmt::format(" class=\"{}\"", css), text_html(*text, key, parts)};
  }
  if (const auto* count = std::get_if<std::int64_t>(&cell)) {
    return {fmt::format(" class=\"n\" data-v=\"{}\"", *count), fmt::format("{}", *count)};
  }
  if (const auto* number = std::get_if<double>(&cell)) {
    return {fmt::format(" class=\"n\" data-v=\"{}\"", script_number(*number)),
            format_number(*number)};
  }
  return {fmt::format(" class=\"{} nothing\"", css), "–"};
}

}  // namespace

std::string verdict_html(const std::string& verdict) {
  const char* css = "";
  if (verdict == "confirmed") css = " confirmed";
  if (verdict == "refuted") css = " refuted";
  if (verdict == "true only when") css = " partly";
  return fmt::format("<span class=\"verdict{}\">{}</span>", css, html_escape(verdict));
}

std::string table_html(const Table& table, const std::set<std::string>& parts) {
  const std::string id = "table-" + html_escape(table.name());
  std::string html = fmt::format(
      "<div class=\"table\">\n<p class=\"caption\" id=\"{0}\">{1}</p>\n"
      "<div class=\"tools\" hidden><label>Filter <input type=\"search\" aria-describedby=\"{0}\">"
      "</label><span class=\"count\" aria-live=\"polite\"></span>"
      "<button type=\"button\">Copy as CSV</button></div>\n"
      "<div class=\"box\" role=\"region\" aria-labelledby=\"{0}\" tabindex=\"0\">"
      "<table aria-labelledby=\"{0}\">\n<thead><tr>",
      id, html_escape(table.title()));
  std::vector<std::string> css;
  for (std::size_t c = 0; c < table.columns().size(); ++c) {
    const Column& column = table.columns()[c];
    css.push_back(class_of(look_of(table, c)));
    html += fmt::format(
        "<th scope=\"col\" class=\"{}\" data-key=\"{}\"><button type=\"button\">{}</button></th>",
        css.back(), html_escape(column.key), html_escape(column.head));
  }
  html += "</tr></thead>\n<tbody>\n";
  for (const auto& row : table.rows()) {
    html += "<tr>";
    for (std::size_t c = 0; c < row.size(); ++c) {
      const CellHtml cell = cell_html(row[c], css[c], table.columns()[c].key, parts);
      html += c == 0 ? fmt::format("<th scope=\"row\"{}>{}</th>", cell.attributes, cell.content)
                     : fmt::format("<td{}>{}</td>", cell.attributes, cell.content);
    }
    html += "</tr>\n";
  }
  html += "</tbody></table></div>\n<button type=\"button\" class=\"more\" hidden></button>\n";
  for (const std::string& note : table.notes()) {
    html += fmt::format("<p class=\"note\">{}</p>\n", html_escape(note));
  }
  return html + "</div>\n";
}

}  // namespace clipscope::experiments
