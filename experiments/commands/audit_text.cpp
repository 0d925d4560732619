// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/commands/audit_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "experiments/audit/draw_text.hpp"
#include "experiments/audit/finding_folder.hpp"
#include "experiments/audit/rows.hpp"
#include "experiments/commands/junit.hpp"
#include "experiments/machine/errors.hpp"
#include "experiments/scenes/text_file.hpp"
#include "experiments/table/terminal.hpp"
#include "experiments/table/utf8.hpp"

namespace clipscope::experiments::commands {
namespace {

constexpr std::size_t kWhatWidth = 30, kCasesWidth = 7;

std::string draw_calls(std::size_t n) { return counted(n, "draw call", "draw calls"); }

std::string verdict_text(const Audit& audit) {
  switch (exit_code(audit)) {
    case kExitNothingJudged: return "NOTHING JUDGED";
    case kExitOk: return fmt::format("no violation in {}", draw_calls(audit.cases));
    default: break;
  }
  return fmt::format("the specification is VIOLATED in {} of {}, in {}", audit.violating,
                     draw_calls(audit.cases), counted(audit.findings.size(), "way", "ways"));
}

// Lines side by side: a number, what, how many cases, and what to look at.
std::string finding_lines(std::size_t number, const DriverFinding& finding) {
  const DrawExample& example = finding.example();
  const std::vector<std::string> what = wrapped(finding_text(finding.key), kWhatWidth - 2);
  const std::size_t left = 5 + kWhatWidth + kCasesWidth + 2;
  std::vector<std::string> right = wrapped(draw_text(example.call), kTextWidth - left);
  const Violation& v = example.violation;
  const std::string shown = v.pixels == 0 ? example.reason : pixel_text(v);
  for (const std::string& text : {shown, section_text(finding.clause)}) {
    const auto lines = wrapped(text, kTextWidth - left);
    right.insert(right.end(), lines.begin(), lines.end());
  }
  std::string text;
  for (std::size_t i = 0; i < std::max(what.size(), right.size()); ++i) {
    const std::string line = fmt::format(
        "{:>3}  {:<{}}{:>{}}  {}", i == 0 ? std::to_string(number) : "",
        i < what.size() ? what[i] : "", kWhatWidth, i == 0 ? std::to_string(finding.cases) : "",
        kCasesWidth, i < right.size() ? right[i] : "");
    text += line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
  }
  return text;
}

std::string findings_text(const Audit& audit) {
  if (audit.findings.empty()) return "";
  std::string text = fmt::format("{:>3}  {:<{}}{:>{}}  {}\n", "", "what", kWhatWidth, "cases",
                                 kCasesWidth, "smallest example, its worst pixel, the clause");
  for (std::size_t i = 0; i < audit.findings.size(); ++i) {
    text += finding_lines(i + 1, audit.findings[i]);
  }
  return text + "\n";
}

std::string errors_text(const Audit& audit) {
  TableOf<QuantityRow> table;
  for (const QuantityRow& row : quantity_rows(audit)) table.add(row);
  return table.rows().empty() ? "" : table.to_text() + "\n";
}

std::string counts_text(const std::string& what, const Counts& counts) {
  std::string text;
  for (const auto& [reason, count] : counts) {
    text += indented(fmt::format("{}: {}, {}", what, draw_calls(count), reason));
  }
  return text;
}

// What was not judged, or accuses nobody.
std::string rest_text(const Audit& audit) {
  std::string text = fmt::format(
      "judged: {} pixels; undecided, within the margin of an edge: {}; covered inexactly: {}\n",
      audit.pixels, audit.undecided, audit.inexact);
  return text + counts_text("scored apart", audit.apart) + counts_text("refused", audit.refused) +
         counts_text("left out, for the driver", audit.unable);
}

std::string places_text(const AuditReport& report) {
  if (report.audit.findings.empty()) return "";
  if (report.folders.empty()) {
    return "--out FOLDER writes a picture, reproductions and a case to replay for each finding\n";
  }
  std::string text = "pictures, reproductions and, to see each again:\n";
  for (std::size_t i = 0; i < report.folders.size(); ++i) {
    text += fmt::format("{:>3}  {}\n     {}\n", i + 1, report.folders[i].string(),
                        replay_command(report.source, report.audit.findings[i].example(),
                                       report.folders[i] / kCasesFile));
  }
  return text;
}

// --- JSON ----------------------------------------------------------------------------------------

nlohmann::json number(double x) {
  if (std::isfinite(x)) return x;
  return std::isnan(x) ? "nan" : x > 0 ? "inf" : "-inf";
}

nlohmann::json worst_json(const Violation& v) {
  if (v.pixels == 0) return nullptr;
  return {{"x", v.worst.x},
          {"y", v.worst.y},
          {"channel", v.worst.channel},
          {"exact", number(v.worst.exact)},
          {"returned", number(v.worst.returned)}};
}

nlohmann::json vertices_json(const DrawCall& call) {
  nlohmann::json vertices = nlohmann::json::array();
  for (const DrawVertex& v : call.vertices) vertices.push_back(v.position);
  return vertices;
}

nlohmann::json example_json(const DrawExample& example) {
  return {{"case", example.call.name},
          {"draw", draw_text(example.call)},
          {"vertices", vertices_json(example.call)},
          {"size", example.call.width},
          {"pixels", example.violation.pixels},
          {"excess", number(example.violation.size)},
          {"worst", worst_json(example.violation)}};
}

nlohmann::json finding_json(const DriverFinding& finding) {
  const DrawExample& worst = finding.worst;
  nlohmann::json json = example_json(worst);
  json["primitive"] = name_of(finding.key.circumstances.primitive);
  json["quantity"] = name_of(finding.key.quantity);
  json["class"] = name_of(finding.key.kind);
  json["clause"] = section_text(finding.clause);
  json["meaning"] = finding.clause.meaning;
  json["circumstances"] = to_string(finding.key.circumstances);
  json["cases"] = finding.cases;
  if (!worst.reason.empty()) json["reason"] = worst.reason;
  json["smallest"] = finding.smallest ? example_json(*finding.smallest) : nlohmann::json(nullptr);
  return json;
}

// --- JUnit ---------------------------------------------------------------------------------------

JUnitTest test_of(const AuditReport& report, const DriverFinding& finding) {
  const DrawExample& example = finding.example();
  return {
      report.audit.driver + "." + std::string(name_of(finding.key.kind)), finding_text(finding.key),
      fmt::format("{}: {}", section_text(finding.clause), finding.clause.meaning),
      fmt::format("in {} of {}\n{}\n{}\n", finding.cases, draw_calls(report.audit.cases),
                  draw_text(example.call),
                  example.violation.pixels == 0 ? example.reason : pixel_text(example.violation))};
}

}  // namespace

int exit_code(const Audit& audit) {
  if (!audit.findings.empty()) return kExitPromiseBroken;
  return audit.pixels == 0 ? kExitNothingJudged : kExitOk;
}

std::string text_of(const AuditReport& report) {
  const Audit& audit = report.audit;
  std::string text = indented(fmt::format("{}: {}", audit.driver, driver_text(audit.info)));
  text = text.substr(std::min(text.find_first_not_of(' '), text.size()));
  return text + verdict_text(audit) + "\n\n" + findings_text(audit) + errors_text(audit) +
         rest_text(audit) + places_text(report);
}

nlohmann::json json_of(const AuditReport& report) {
  const Audit& audit = report.audit;
  nlohmann::json json = {{"driver", audit.driver},
                         {"version", audit.info.version},
                         {"renderer", audit.info.renderer},
                         {"api", name_of(audit.info.api)},
                         {"api_version", audit.info.api_version},
                         {"subpixel_bits", audit.info.subpixel_bits},
                         {"cases", audit.cases},
                         {"violating", audit.violating},
                         {"pixels", audit.pixels},
                         {"undecided", audit.undecided},
                         {"inexact", audit.inexact},
                         {"apart", audit.apart},
                         {"refused", audit.refused},
                         {"unable", audit.unable},
                         {"findings", nlohmann::json::array()}};
  for (std::size_t i = 0; i < audit.findings.size(); ++i) {
    json["findings"].push_back(finding_json(audit.findings[i]));
    if (report.folders.empty()) continue;
    json["findings"].back()["folder"] = report.folders[i].string();
  }
  TableOf<QuantityRow> errors;
  for (const QuantityRow& row : quantity_rows(audit)) errors.add(row);
  json["quantities"] = errors.to_json()["rows"];
  return json;
}

std::string junit_of(const AuditReport& report) {
  const Audit& audit = report.audit;
  std::vector<JUnitTest> tests;
  for (const DriverFinding& finding : audit.findings) tests.push_back(test_of(report, finding));
  for (const std::string_view kind : names_of(ViolationKind{})) {
    const bool is_clean = std::ranges::none_of(audit.findings, [&](const DriverFinding& finding) {
      return name_of(finding.key.kind) == kind;
    });
    if (is_clean) tests.push_back({audit.driver + "." + std::string(kind), "no violation"});
  }
  if (exit_code(audit) == kExitNothingJudged) {
    tests.push_back(
        {audit.driver, "something was judged", "no pixel was judged", rest_text(audit)});
  }
  return junit_text("clipscope audit " + audit.driver, tests);
}

}  // namespace clipscope::experiments::commands
