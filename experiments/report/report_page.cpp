// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/report/report_page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <string_view>

#include "experiments/report/html.hpp"
#include "experiments/report/page_assets.hpp"
#include "experiments/report/table_html.hpp"

namespace clipscope::experiments {
namespace {

constexpr std::size_t kFewPictures = 12;  // more are shown folded

constexpr std::string_view kClaims = "claims";

// Everything up to the root element goes: in a page there is no XML declaration. The picture gets a name
// for those who can't see it.
std::string inline_svg(const ReportFigure& figure) {
  const std::size_t begin = figure.bytes.find("<svg");
  if (begin == std::string::npos) return "";
  return fmt::format("<svg role=\"img\" aria-label=\"{}\"{}",
                     html_escape(figure.title + ". " + figure.caption),
                     figure.bytes.substr(begin + 4));
}

std::string unreadable(const ReportFigure& figure) {
  return fmt::format("<p class=\"missing\">{} can't be read.</p>\n", html_escape(figure.file));
}

std::string plot_html(const ReportFigure& figure) {
  const std::string svg = inline_svg(figure);
  if (svg.empty()) return unreadable(figure);
  return fmt::format(
      "<figure class=\"plot\"><div tabindex=\"0\">{}</div>\n<figcaption>{}</figcaption></figure>\n",
      svg, html_escape(figure.caption));
}

// Width and height of a PNG, so that the page needs not move when it is shown (PNG specification, 5.2 and
// 11.2.2: eight bytes of signature, length and name of IHDR, then two numbers of four bytes).
std::string size_attributes(const ReportFigure& figure) {
  if (figure.type != "image/png" || figure.bytes.size() < 24) return "";
  const auto number = [&](std::size_t at) {
    unsigned value = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      value = value << 8 | static_cast<unsigned char>(figure.bytes[at + i]);
    }
    return value;
  };
  return fmt::format(" width=\"{}\" height=\"{}\"", number(16), number(20));
}

std::string picture_html(const ReportFigure& figure) {
  if (figure.bytes.empty()) return unreadable(figure);
  return fmt::format(
      "<figure><button type=\"button\" title=\"Enlarge\"><img loading=\"lazy\" decoding=\"async\" "
      "alt=\"{0}\"{1} "
      "src=\"data:{2};base64,{3}\"></button>\n<figcaption>{0}</figcaption></figure>\n",
      html_escape(figure.caption.empty() ? figure.file : figure.caption), size_attributes(figure),
      html_escape(figure.type), base64(figure.bytes));
}

std::string pictures_html(const std::vector<ReportFigure>& figures) {
  std::string html;
  std::size_t count = 0;
  for (const ReportFigure& figure : figures) {
    if (figure.plot) continue;
    html += picture_html(figure);
    ++count;
  }
  if (count == 0) return "";
  html = "<div class=\"pictures\">\n" + html + "</div>\n";
  if (count <= kFewPictures) return "<h3>Pictures</h3>\n" + html;
  return fmt::format("<details class=\"album\"><summary>{} pictures</summary>\n{}</details>\n",
                     count, html);
}

std::string command_html(const std::string& command) {
  if (command.empty()) return "";
  return fmt::format(
      "<h3>Do it again</h3>\n<div class=\"command\"><pre><code>{}</code></pre>"
      "<button type=\"button\" hidden>Copy</button></div>\n",
      html_escape(command));
}

std::string finding_html(const ReportExperiment& experiment) {
  if (!experiment.finished) {
    return "<p class=\"missing\">The run ended, or is, in the middle of this experiment; what it "
           "had "
           "finished is below.</p>\n";
  }
  if (experiment.finding.empty()) return "<p class=\"missing\">This run left no finding.</p>\n";
  return fmt::format("<p class=\"finding\"><b>Finding</b>{}</p>\n",
                     html_escape(experiment.finding));
}

// How many claims got which verdict.
std::string tally_html(const ReportExperiment& claims) {
  std::map<std::string, int> counts;
  std::vector<std::string> order = {"confirmed", "true only when", "refuted", "undecided"};
  for (const Table& table : claims.tables) {
    if (table.name() != kClaims) continue;
    for (std::size_t c = 0; c < table.columns().size(); ++c) {
      if (table.columns()[c].key != "verdict") continue;
      for (const auto& row : table.rows()) {
        if (const auto* text = std::get_if<std::string>(&row[c])) ++counts[*text];
      }
    }
  }
  for (const auto& [verdict, count] : counts) {
    if (std::find(order.begin(), order.end(), verdict) == order.end()) order.push_back(verdict);
  }
  std::string html;
  for (const std::string& verdict : order) {
    if (counts[verdict] == 0) continue;
    html += fmt::format("<li>{} {}</li>", counts[verdict], verdict_html(verdict));
  }
  return html.empty() ? "" : "<ul class=\"tally\">" + html + "</ul>\n";
}

std::string section_html(const ReportExperiment& experiment, const std::set<std::string>& parts) {
  std::string html = fmt::format(
      "<section id=\"{0}\" aria-labelledby=\"{0}-head\">\n<h2 id=\"{0}-head\"><a class=\"anchor\" "
      "href=\"#{0}\">{0}</a></h2>\n<p class=\"question\">{1}</p>\n",
      html_escape(experiment.name), html_escape(experiment.question));
  if (experiment.name == kClaims) html += tally_html(experiment);
  html += finding_html(experiment);
  for (const ReportFigure& figure : experiment.figures) {
    if (figure.plot) html += plot_html(figure);
  }
  // The table that answers the question is called by the experiment's name.
  for (const bool main : {true, false}) {
    for (const Table& table : experiment.tables) {
      if ((table.name() == experiment.name) == main) html += table_html(table, parts);
    }
  }
  html += pictures_html(experiment.figures);
  for (const Table& table : experiment.more_tables) {
    html += fmt::format("<details><summary>{}</summary>\n{}</details>\n",
                        html_escape(table.title()), table_html(table));
  }
  return html + command_html(experiment.command) + "</section>\n";
}

std::string header_html(const ReportContent& content) {
  std::string html =
      "<header>\n<h1>Where should a triangle be clipped?</h1>\n<p class=\"subtitle\">Results of "
      "one "
      "run of clipscope: clippers in view space, clip space and the canonical view volume, judged "
      "by "
      "exact arithmetic.</p>\n<dl class=\"run\">\n";
  for (const auto& [name, value] : content.run) {
    if (value.empty()) continue;
    html += fmt::format("<dt>{}</dt><dd>{}</dd>\n", html_escape(name), html_escape(value));
  }
  return html + "</dl>\n</header>\n";
}

std::string contents_html(const std::vector<const ReportExperiment*>& experiments) {
  std::string html =
      "<nav aria-label=\"Contents\"><details open><summary>Contents</summary><ol>\n"
      "<li><a href=\"#findings\">Findings</a></li>\n";
  for (const ReportExperiment* e : experiments) {
    html += fmt::format("<li><a href=\"#{0}\">{0}</a></li>\n", html_escape(e->name));
  }
  return html + "</ol></details></nav>\n";
}

// Every experiment's finding in one place.
std::string findings_html(const std::vector<const ReportExperiment*>& experiments) {
  std::string html =
      "<section id=\"findings\" aria-labelledby=\"findings-head\">\n<h2 "
      "id=\"findings-head\">Findings</h2>\n";
  std::string items;
  for (const ReportExperiment* e : experiments) {
    if (e->finding.empty()) continue;
    items += fmt::format("<li><a href=\"#{0}\">{0}</a><span>{1}</span></li>\n",
                         html_escape(e->name), html_escape(e->finding));
  }
  if (items.empty())
    return html + "<p class=\"missing\">This run left no finding.</p>\n</section>\n";
  return html + "<ul class=\"findings\">\n" + items + "</ul>\n</section>\n";
}

// The template with each {{name}} replaced; what replaces it is not looked at again.
std::string filled(std::string_view text, const std::map<std::string, std::string>& values) {
  std::string result;
  for (std::size_t open = text.find("{{"); open != std::string_view::npos; open = text.find("{{")) {
    const std::size_t close = text.find("}}", open);
    result += text.substr(0, open);
    result += values.at(std::string(text.substr(open + 2, close - open - 2)));
    text.remove_prefix(close + 2);
  }
  return result.append(text);
}

}  // namespace

std::string report_page(const ReportContent& content) {
  std::vector<const ReportExperiment*> experiments;
  std::set<std::string> parts;
  for (const ReportExperiment& e : content.experiments) {
    experiments.push_back(&e);
    parts.insert(e.name);
  }
  std::stable_partition(experiments.begin(), experiments.end(),
                        [](const ReportExperiment* e) { return e->name == kClaims; });
  std::string body = contents_html(experiments) + header_html(content) + "<main id=\"content\">\n";
  auto rest = experiments.begin();
  if (rest != experiments.end() && (*rest)->name == kClaims) body += section_html(**rest++, parts);
  body += findings_html(experiments);
  for (; rest != experiments.end(); ++rest) body += section_html(**rest, parts);
  body +=
      "</main>\n<footer>Written by <span class=\"name\">clipscope report</span> from the run's "
      "results.sqlite; it needs no other file.</footer>\n";
  return filled(kPageHtml, {{"title", "clipscope: where should a triangle be clipped?"},
                            {"style", kPageCss},
                            {"script", kPageJs},
                            {"body", std::move(body)}});
}

void write_report_page(const ReportContent& content, const std::filesystem::path& path) {
  write_file(path, report_page(content));
}

}  // namespace clipscope::experiments
