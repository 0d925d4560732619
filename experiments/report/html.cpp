// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/report/html.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <nlohmann/json.hpp>

#include "experiments/table/json_text.hpp"
#include "experiments/table/utf8.hpp"

namespace clipscope::experiments {

std::string url_of(std::string_view path) {
  static constexpr std::string_view kPlain =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-._~/";
  std::string address;
  for (const char c : path) {
    const bool plain = kPlain.find(c) != std::string_view::npos;
    address += plain ? std::string(1, c) : fmt::format("%{:02X}", static_cast<unsigned char>(c));
  }
  return address;
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

// The look of a column: numbers, texts that may break into lines, or, empty, short texts.
std::string class_of(const Table& table, std::size_t column) {
  std::string look = "n";
  for (const auto& row : table.rows()) {
    const auto* text = std::get_if<std::string>(&row[column]);
    if (text != nullptr && look != "long") look = text->size() > kLongText ? "long" : "";
  }
  return look;
}

// What a cell's tag has beside its name; one without a class has nothing, since there are many.
std::string class_attribute(const std::string& css) {
  return css.empty() ? "" : fmt::format(" class=\"{}\"", css);
}
std::string joined(const std::string& css, const std::string& more) {
  return css.empty() || more.empty() ? css + more : css + " " + more;
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
  if (key != "experiment" || !parts.contains(text)) return xml_escaped(text);
  return fmt::format("<a href=\"#{0}\">{0}</a>", xml_escaped(text));
}

// A number as people read it, and its value where that is another text.
std::string number_html(double value, const std::string& look) {
  const std::string shown = format_number(value), full = script_number(value);
  return fmt::format("{}{}>{}", class_attribute(joined("n", look)),
                     shown == full ? "" : fmt::format(" data-v=\"{}\"", full), shown);
}

// A cell from its attributes on, without its closing tag. css: of its column; look: its own.
std::string cell_html(const Cell& cell, const std::string& css, const std::string& look,
                      const std::string& key, const std::set<std::string>& parts) {
  if (const auto* text = std::get_if<std::string>(&cell)) {
    return class_attribute(joined(css, look)) + ">" + text_html(*text, key, parts);
  }
  if (const auto* count = std::get_if<std::int64_t>(&cell)) {
    return fmt::format("{}>{}", class_attribute(joined("n", look)), *count);
  }
  if (const auto* number = std::get_if<double>(&cell)) return number_html(*number, look);
  return class_attribute(joined(css, "nothing")) + ">–";
}

// The looks of all columns.
std::vector<std::string> classes_of(const Table& table) {
  std::vector<std::string> css;
  for (std::size_t c = 0; c < table.columns().size(); ++c) css.push_back(class_of(table, c));
  return css;
}

std::string row_html(const Table& table, const std::vector<std::string>& css, std::size_t r,
                     const TableSetting& setting) {
  const std::vector<Cell>& row = table.rows()[r];
  std::string html = "<tr>";
  for (std::size_t c = 0; c < row.size(); ++c) {
    const std::string look = setting.look ? setting.look(r, c) : "";
    const std::string cell = cell_html(row[c], css[c], look, table.columns()[c].key, setting.parts);
    const std::string more = setting.more ? setting.more(r, c) : "";
    html += (c == 0 ? "<th scope=\"row\"" : "<td") + cell + more + (c == 0 ? "</th>" : "</td>");
  }
  return html + "</tr>\n";
}

std::string rows_html(const Table& table, std::size_t count, const TableSetting& setting) {
  const std::vector<std::string> css = classes_of(table);
  std::string html;
  for (std::size_t r = 0; r < count; ++r) html += row_html(table, css, r, setting);
  return html;
}

std::string head_html(const Table& table) {
  const std::vector<std::string> css = classes_of(table);
  std::string html = "<thead><tr>";
  for (std::size_t c = 0; c < css.size(); ++c) {
    const Column& column = table.columns()[c];
    html +=
        fmt::format("<th scope=\"col\"{} data-key=\"{}\"><button type=\"button\">{}</button></th>",
                    class_attribute(css[c]), xml_escaped(column.key), xml_escaped(column.head));
  }
  return html + "</tr></thead>\n";
}

// What stands for the rows that are not in the page: where they are, and, for who has no scripts,
// that they are elsewhere.
std::string absent_rows_html(const Table& table, const std::string& csv) {
  return fmt::format("<noscript><p class=\"note\">The first {} of {} rows{}</p></noscript>\n",
                     kFirstRows, table.rows().size(),
                     csv.empty() ? "." : "; the CSV has all of them.");
}

}  // namespace

std::string verdict_html(const std::string& verdict) {
  const char* css = "";
  if (verdict == "confirmed") css = " confirmed";
  if (verdict == "refuted") css = " refuted";
  if (verdict == "true only when") css = " partly";
  return fmt::format("<span class=\"verdict{}\">{}</span>", css, xml_escaped(verdict));
}

std::string table_html(const Table& table, const TableSetting& setting) {
  const std::string id = "table-" + xml_escaped(table.name());
  const std::size_t all = table.rows().size();
  const bool has_script = !setting.script.empty();
  std::string html = fmt::format(
      "<div class=\"table{3}\"{0}>\n<p class=\"caption\" id=\"{1}\">{2}</p>\n"
      "<div class=\"tools\" hidden><label>Filter <input type=\"search\" aria-describedby=\"{1}\"></label><span class=\"count\" aria-live=\"polite\"></span><button type=\"button\">Copy as CSV</button></div>\n"
      "<div class=\"box\" role=\"region\" aria-labelledby=\"{1}\" tabindex=\"0\"><table aria-labelledby=\"{1}\">\n",
      has_script ? fmt::format(" data-rows=\"{}\" data-script=\"{}\"", all, setting.script) : "",
      id, xml_escaped(table.title()), setting.css.empty() ? "" : " " + setting.css);
  html += head_html(table) + "<tbody>\n";
  html += rows_html(table, has_script ? std::min(all, kFirstRows) : all, setting);
  html += "</tbody></table></div>\n<button type=\"button\" class=\"more\" hidden></button>\n";
  if (has_script) html += absent_rows_html(table, setting.csv);
  for (const std::string& note : table.notes()) {
    html += fmt::format("<p class=\"note\">{}</p>\n", xml_escaped(note));
  }
  if (!setting.csv.empty()) {
    html += fmt::format("<p class=\"note\"><a href=\"{0}\">{0}</a></p>\n", setting.csv);
  }
  return html + "</div>\n";
}

std::string plain_table_html(const Table& table) {
  std::string html = "<table>\n<thead><tr>";
  for (const Column& column : table.columns()) {
    html += fmt::format("<th scope=\"col\">{}</th>", xml_escaped(column.head));
  }
  return html + "</tr></thead>\n<tbody>\n" + rows_html(table, table.rows().size(), {}) +
         "</tbody></table>\n";
}

std::string rows_script(const Table& table, const TableSetting& setting) {
  const nlohmann::json name = table.name(), rows = rows_html(table, table.rows().size(), setting);
  return fmt::format("clipscopeRows({}, {});\n", json_text(name), json_text(rows));
}

}  // namespace clipscope::experiments
