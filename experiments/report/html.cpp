// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/report/report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "experiments/table/utf8.hpp"

namespace clipscope::experiments {

std::string html_escape(std::string_view text) {
  std::string escaped;
  for (const char c : valid_utf8(text)) {
    switch (c) {
      case '&': escaped += "&amp;"; break;
      case '<': escaped += "&lt;"; break;
      case '>': escaped += "&gt;"; break;
      case '"': escaped += "&quot;"; break;
      case '\'': escaped += "&#39;"; break;
      case '\n':
      case '\t': escaped += c; break;
      default: escaped += static_cast<unsigned char>(c) < 0x20 || c == 0x7F ? ' ' : c;
    }
  }
  return escaped;
}

std::string base64(std::string_view bytes) {
  static constexpr std::string_view kDigits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t group = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      group = group << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0U);
    }
    for (std::size_t k = 0; k < 4; ++k) {
      const bool padding = i + k > bytes.size();
      text += padding ? '=' : kDigits[group >> (18 - 6 * k) & 63];
    }
  }
  return text;
}

namespace {

constexpr std::size_t kLongText = 40;  // characters from which a text may break into lines

// The look of a column: numbers, short texts, or texts that may break into lines.
std::string class_of(const Table& table, std::size_t column) {
  std::string look = "n";
  for (const auto& row : table.rows()) {
    const auto* text = std::get_if<std::string>(&row[column]);
    if (text != nullptr && look != "long") look = text->size() > kLongText ? "long" : "short";
  }
  return look;
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

// A cell from its attributes on, without its closing tag.
std::string cell_html(const Cell& cell, const std::string& css, const std::string& key,
                      const std::set<std::string>& parts) {
  if (const auto* text = std::get_if<std::string>(&cell)) {
    return fmt::format(" class=\"{}\">{}", css, text_html(*text, key, parts));
  }
  if (const auto* count = std::get_if<std::int64_t>(&cell)) {
    return fmt::format(" class=\"n\" data-v=\"{0}\">{0}", *count);
  }
  if (const auto* number = std::get_if<double>(&cell)) {
    return fmt::format(" class=\"n\" data-v=\"{}\">{}", script_number(*number),
                       format_number(*number));
  }
  return fmt::format(" class=\"{} nothing\">–", css);
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
      "<div class=\"tools\" hidden><label>Filter <input type=\"search\" aria-describedby=\"{0}\"></label><span class=\"count\" aria-live=\"polite\"></span><button type=\"button\">Copy as CSV</button></div>\n"
      "<div class=\"box\" role=\"region\" aria-labelledby=\"{0}\" tabindex=\"0\"><table aria-labelledby=\"{0}\">\n<thead><tr>",
      id, html_escape(table.title()));
  std::vector<std::string> css;
  for (std::size_t c = 0; c < table.columns().size(); ++c) {
    const Column& column = table.columns()[c];
    css.push_back(class_of(table, c));
    html += fmt::format(
        "<th scope=\"col\" class=\"{}\" data-key=\"{}\"><button type=\"button\">{}</button></th>",
        css.back(), html_escape(column.key), html_escape(column.head));
  }
  html += "</tr></thead>\n<tbody>\n";
  for (const auto& row : table.rows()) {
    html += "<tr>";
    for (std::size_t c = 0; c < row.size(); ++c) {
      const std::string cell = cell_html(row[c], css[c], table.columns()[c].key, parts);
      html += (c == 0 ? "<th scope=\"row\"" : "<td") + cell + (c == 0 ? "</th>" : "</td>");
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
