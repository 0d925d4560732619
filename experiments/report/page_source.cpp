// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/report/page_source.hpp"

#include <fmt/format.h>

#include <utility>

#include "experiments/machine/files.hpp"
#include "experiments/render/webp.hpp"
#include "experiments/report/explorer_link.hpp"
#include "experiments/table/utf8.hpp"

namespace clipscope::experiments {
namespace {

namespace fs = std::filesystem;

constexpr const char* kScriptFolder = "report";  // beside report.html

std::string unreadable(const StoredFigure& figure) {
  return fmt::format("<p class=\"missing\">{} can't be read.</p>\n", xml_escaped(figure.file));
}

bool is_svg(const StoredFigure& figure) { return figure.file.ends_with(".svg"); }

// Attributes that keep a picture's place in the page until it is loaded.
std::string size_attributes(std::size_t width, std::size_t height) {
  return fmt::format(" width=\"{}\" height=\"{}\"", width, height);
}

// Of a PNG (PNG specification, 5.2 and 11.2.2: eight bytes of signature, length and name of IHDR,
// then two numbers of four bytes).
std::string png_size(const std::string& png) {
  if (png.size() < 24) return "";
  const auto number = [&](std::size_t at) {
    std::size_t value = 0;
    for (const char c : png.substr(at, 4)) value = value << 8 | static_cast<unsigned char>(c);
    return value;
  };
  return size_attributes(number(16), number(20));
}

// Of an SVG: that of its view box.
std::string svg_size(const std::string& svg) {
  const std::size_t at = svg.find("viewBox=\"0 0 ");
  double width = 0, height = 0;
  if (at == std::string::npos ||
      std::sscanf(svg.c_str() + at + 13, "%lf %lf", &width, &height) != 2) {
    return "";
  }
  return size_attributes(static_cast<std::size_t>(width), static_cast<std::size_t>(height));
}

// The picture itself as an address, for a page that needs no other file.
std::string data_address(const StoredFigure& figure, const fs::path& file,
                         const std::string& bytes) {
  if (is_svg(figure)) return "data:image/svg+xml;base64," + base64(bytes);
  return "data:image/webp;base64," + base64(lossless_webp(file));
}

// A plot within the page; nothing if that is no SVG. Everything up to the root element goes: in a
// page there is no XML declaration. The picture gets a name for those who can't see it.
std::string inline_plot(const std::string& svg, const std::string& text) {
  if (svg.find("<svg") == std::string::npos) return "";
  return fmt::format("<svg role=\"img\" aria-label=\"{}\"{}", text,
                     svg.substr(svg.find("<svg") + 4));
}

// A plot as files to take along.
std::string links_to(const StoredFigure& figure) {
  const std::string pdf = fs::path(figure.file).replace_extension(".pdf").string();
  return fmt::format("<a href=\"{}\">SVG</a> <a href=\"{}\">PDF</a>", url_of(figure.file),
                     url_of(pdf));
}

}  // namespace

PageSource::PageSource(const ResultsStore& store, fs::path directory, PageForm form)
    : store_(store), directory_(std::move(directory)), form_(form) {
  for (const StoredExperiment& e : store.experiments()) parts_.insert(e.name);
}

bool PageSource::has_explorer() const {
  std::error_code ignored;
  return form_ == PageForm::folder && fs::exists(directory_ / kExplorerFile, ignored);
}

std::string PageSource::table(const Table& table, const std::string& experiment,
                              TableSetting setting) const {
  setting.parts = parts_;
  if (form_ == PageForm::single_file) return table_html(table, setting);
  const std::string csv = fmt::format("{}/{}.csv", experiment, table.name());
  std::error_code ignored;
  if (fs::exists(directory_ / csv, ignored)) setting.csv = url_of(csv);
  if (table.rows().size() > kRowsInPage) {
    const std::string script = fmt::format("{}/{}.js", kScriptFolder, table.name());
    setting.script = url_of(script);
    scripts_[script] = rows_script(table, setting);
  }
  return table_html(table, setting);
}

std::string PageSource::plot(const StoredFigure& figure) const {
  const std::string text = xml_escaped(figure.title + ". " + figure.caption);
  const std::string drawing = form_ == PageForm::single_file
                                  ? inline_plot(read_if_there(directory_ / figure.file), text)
                                  : linked_plot(figure, text);
  if (drawing.empty()) return unreadable(figure);
  return fmt::format(
      "<figure class=\"plot\"><div tabindex=\"0\">{}</div>\n<figcaption>{}{}</figcaption></figure>\n",
      drawing, xml_escaped(figure.caption),
      form_ == PageForm::single_file ? "" : " " + links_to(figure));
}

// A browser draws a PNG sooner than an SVG.
std::string PageSource::linked_plot(const StoredFigure& figure, const std::string& text) const {
  const std::string file = fs::path(figure.file).replace_extension(".png").string();
  const std::string png = read_if_there(directory_ / file);
  if (png.empty()) return "";
  return fmt::format("<img loading=\"lazy\" decoding=\"async\" alt=\"{}\"{} src=\"{}\">", text,
                     png_size(png), url_of(file));
}

std::string PageSource::picture(const StoredFigure& figure) const {
  const fs::path file = directory_ / figure.file;
  const std::string bytes = read_if_there(file);
  if (bytes.empty()) return unreadable(figure);
  return fmt::format(
      "<figure><button type=\"button\" title=\"Enlarge\"><img loading=\"lazy\" decoding=\"async\" alt=\"{0}\"{1} src=\"{2}\"></button>\n<figcaption>{0}</figcaption></figure>\n",
      xml_escaped(figure.caption.empty() ? figure.file : figure.caption),
      is_svg(figure) ? svg_size(bytes) : png_size(bytes),
      form_ == PageForm::single_file ? data_address(figure, file, bytes) : url_of(figure.file));
}

}  // namespace clipscope::experiments
