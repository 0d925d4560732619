// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/report/report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <string_view>

#include "experiments/machine/files.hpp"
#include "experiments/report/explorer_link.hpp"
#include "experiments/report/page_assets.hpp"
#include "experiments/report/page_source.hpp"
#include "experiments/store/run_folder.hpp"
#include "experiments/table/utf8.hpp"

namespace clipscope::experiments {

namespace {

constexpr std::size_t kFewPictures = 12;  // more are shown folded

// What people ask of a run; the store keeps more, to compare runs by.
constexpr const char* kShown[] = {"machine", "measuring", "compiler", "flags",  "version",
                                  "commit",  "seed",      "started",  "command"};

// What a page may load that has files beside it (CSP level 3, 2.3.1), from a disk or a server.
constexpr const char* kBeside = "'self' file:";

using Experiments = std::vector<StoredExperiment>;

auto is_called(const char* name) {
  return [name](const StoredExperiment& e) { return e.name == name; };
}

std::string album_html(const std::string& pictures, std::size_t count) {
  if (count == 0) return "";
  const std::string html = "<div class=\"pictures\">\n" + pictures + "</div>\n";
  if (count <= kFewPictures) return "<h3>Pictures</h3>\n" + html;
  return fmt::format("<details class=\"album\"><summary>{} pictures</summary>\n{}</details>\n",
                     count, html);
}

std::string command_html(const std::string& command) {
  if (command.empty()) return "";
  return fmt::format(
      "<h3>Do it again</h3>\n<div class=\"command\"><pre><code>{}</code></pre><button type=\"button\" hidden>Copy</button></div>\n",
      xml_escaped(command));
}

std::string finding_html(const StoredExperiment& experiment) {
  if (!experiment.finished) {
    return "<p class=\"missing\">The run ended, or is, in the middle of this experiment; what it had finished is below.</p>\n";
  }
  if (experiment.finding.empty()) return "<p class=\"missing\">This run left no finding.</p>\n";
  return fmt::format("<p class=\"finding\"><b>Finding</b>{}</p>\n",
                     xml_escaped(experiment.finding));
}

Table worst_inputs_table(const std::string& experiment, const std::vector<WorstInput>& inputs) {
  Table table(experiment + "_worst_inputs", "Inputs on which each contestant was farthest off",
              {{"clipper", "clipper"},
               {"scalar", "scalar"},
               {"measure", "measure"},
               {"error", "error"},
               {"input", "input"},
               {"replay", "command that shows it"}});
  for (const WorstInput& w : inputs) {
    table.add_row({w.clipper, w.scalar, w.measure, w.error, w.input, w.replay});
  }
  return table;
}

// Folded away. The inputs lead to the explorer where it is there.
std::string worst_inputs_html(const PageSource& source, const std::string& experiment) {
  const std::vector<WorstInput> inputs = source.store().worst_inputs(experiment);
  if (inputs.empty()) return "";
  const Table table = worst_inputs_table(experiment, inputs);
  TableSetting setting;
  if (source.has_explorer()) {
    setting.more = [&](std::size_t row, std::size_t column) -> std::string {
      if (table.columns()[column].key != "input") return "";
      const std::string fragment = explorer_fragment(experiment, inputs[row]);
      if (fragment.empty()) return "";
      return fmt::format(" <a class=\"explore\" href=\"{}#{}\">see it in the explorer</a>",
                         kExplorerFile, xml_escaped(fragment));
    };
  }
  return fmt::format("<details><summary>{}</summary>\n{}</details>\n", xml_escaped(table.title()),
                     source.table(table, experiment, setting));
}

std::string section_html(const PageSource& source, const StoredExperiment& experiment) {
  const std::string& name = experiment.name;
  std::string html = fmt::format(
      "<section id=\"{0}\" aria-labelledby=\"{0}-head\">\n<h2 id=\"{0}-head\"><a class=\"anchor\" href=\"#{0}\">{0}</a></h2>\n<p class=\"question\">{1}</p>\n",
      xml_escaped(name), xml_escaped(experiment.question));
  std::string plots, pictures, tally, main_table, tables;
  std::size_t count = 0;  // of pictures
  for (const StoredFigure& figure : source.store().figures(name)) {
    if (figure.kind == FigureKind::plot) {
      plots += source.plot(figure);
    } else {
      pictures += source.picture(figure);
      ++count;
    }
  }
  for (const StoredTable& stored : source.store().tables()) {
    if (stored.experiment != name) continue;
    const Table table = source.store().table(stored.name);
    // The table that answers the question is called by the experiment's name.
    const bool is_claims = stored.name == kClaims;
    (stored.name == name ? main_table : tables) +=
        is_claims ? claims_html(source, table) : source.table(table, name);
    if (is_claims) tally = tally_html(table);
  }
  html += tally + finding_html(experiment) + plots + main_table + tables;
  html += album_html(pictures, count);
  return html + worst_inputs_html(source, name) + command_html(experiment.command) + "</section>\n";
}

std::string run_html(const ResultsStore& store) {
  RunInfo shown;
  const RunInfo run = store.run_info();
  for (const char* name : kShown) shown.emplace_back(name, value_of(run, name));
  const Interruptions runs = store.interruptions();
  if (runs.runs > 0) shown.emplace_back("timing", runs.text());
  std::string html = "<dl class=\"run\">\n";
  for (const auto& [name, value] : shown) {
    if (value.empty()) continue;
    html += fmt::format("<dt>{}</dt><dd>{}</dd>\n", name, xml_escaped(value));
  }
  return html + "</dl>\n";
}

// A first pass says so before anything else, and so does a run on a machine that was busy.
std::string header_html(const PageSource& source) {
  const ResultsStore& store = source.store();
  const RunInfo run = store.run_info();
  const Interruptions runs = store.interruptions();
  std::string html = fmt::format("<header>\n<h1>{}</h1>\n", kPageQuestion);
  if (value_of(run, "pass") == "first") {
    html +=
        "<p class=\"banner\"><b>First pass.</b> Times are of few rounds, and figures may still move. The full pass replaces this page when it ends.</p>\n";
  }
  if (runs.is_busy()) {
    html += fmt::format(
        "<p class=\"banner\"><b>Not settled.</b> The machine was busy: {}. Times and ratios may move.</p>\n",
        runs.text());
  }
  html +=
      "<p class=\"subtitle\">Results of one run of clipscope: clippers in view space, clip space and the canonical view volume, judged by exact arithmetic.";
  if (source.has_explorer()) {
    html += fmt::format(
        " <a href=\"{}\">The explorer</a> shows what they do to one triangle, and the worst inputs below open in it.",
        kExplorerFile);
  }
  return html + "</p>\n</header>\n";
}

std::string contents_html(const Experiments& experiments, bool has_answers) {
  std::string html = "<nav aria-label=\"Contents\"><details open><summary>Contents</summary><ol>\n";
  if (has_answers) html += "<li><a href=\"#answers\">Answers</a></li>\n";
  html += "<li><a href=\"#findings\">Findings</a></li>\n";
  for (const StoredExperiment& e : experiments) {
    html += fmt::format("<li><a href=\"#{0}\">{0}</a></li>\n", xml_escaped(e.name));
  }
  return html + "</ol></details></nav>\n";
}

// Every experiment's finding in one place.
std::string findings_html(const Experiments& experiments) {
  std::string html =
      "<section id=\"findings\" aria-labelledby=\"findings-head\">\n<h2 id=\"findings-head\">Findings</h2>\n";
  std::string items;
  for (const StoredExperiment& e : experiments) {
    if (e.finding.empty()) continue;
    items += fmt::format("<li><a href=\"#{0}\">{0}</a><span>{1}</span></li>\n", xml_escaped(e.name),
                         xml_escaped(e.finding));
  }
  if (items.empty()) {
    return html + "<p class=\"missing\">This run left no finding.</p>\n</section>\n";
  }
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

ReportPage report_page(const ResultsStore& store, const std::filesystem::path& directory,
                       PageForm form) {
  const PageSource source(store, directory, form);
  const std::string answers = answers_html(source);
  Experiments experiments = store.experiments();
  if (!answers.empty()) std::erase_if(experiments, is_called(kAnswers));
  std::stable_partition(experiments.begin(), experiments.end(), is_called(kClaims));
  std::string body = contents_html(experiments, !answers.empty()) + header_html(source) +
                     "<main id=\"content\">\n" + answers + "<details" +
                     (answers.empty() ? " open" : "") + "><summary>The run</summary>\n" +
                     run_html(store) + "</details>\n";
  auto rest = experiments.begin();
  if (source.parts().contains(kClaims)) body += section_html(source, *rest++);
  body += findings_html(experiments);
  for (; rest != experiments.end(); ++rest) body += section_html(source, *rest);
  body += fmt::format(
      "</main>\n<footer>Written by <span class=\"name\">clipscope report</span> from the run's results.sqlite; {}</footer>\n",
      form == PageForm::folder ? "pictures and long tables lie in the files beside it."
                               : "it needs no other file.");
  return {filled(kPageHtml, {{"title", "clipscope: where should a triangle be clipped?"},
                             {"scripts", form == PageForm::folder ? kBeside : ""},
                             {"pictures", form == PageForm::folder ? kBeside : "data:"},
                             {"style", kPageCss},
                             {"script", kPageJs},
                             {"body", std::move(body)}}),
          source.scripts()};
}

void write_report(const ResultsStore& store, const std::filesystem::path& directory,
                  PageForm form) {
  const ReportPage page = report_page(store, directory, form);
  for (const auto& [file, script] : page.scripts) write_file(directory / file, script);
  write_file(directory / kReportFile, page.html);
}

}  // namespace clipscope::experiments
