// SPDX-License-Identifier: GPL-3.0-or-later
//
// clipscope audit: what does a graphics driver do to every case, and where does it violate its
// specification?
#include "experiments/audit/audit.hpp"

#include <fmt/ranges.h>

#include <chrono>
#include <optional>

#include "experiments/audit/draw_cases.hpp"
#include "experiments/audit/draw_text.hpp"
#include "experiments/audit/driver_source.hpp"
#include "experiments/audit/finding_folder.hpp"
#include "experiments/audit/rows.hpp"
#include "experiments/catalogue/catalogue.hpp"
#include "experiments/commands/audit_text.hpp"
#include "experiments/commands/options.hpp"
#include "experiments/machine/files.hpp"
#include "experiments/machine/shell_word.hpp"
#include "experiments/store/run_folder.hpp"
#include "experiments/store/run_recorder.hpp"
#include "experiments/table/json_text.hpp"
#include "experiments/workloads/workload.hpp"

namespace clipscope::experiments::commands {
namespace {

struct AuditOptions {
  std::string driver = "default";
  std::string icd;
  WorkloadOptions workload;
  std::optional<std::size_t> lattice, random;
  double seconds = kSecondsPerDraw;
  AuditLimits limits;
  bool json = false;
  std::optional<std::string> junit, out, corpus_out;
};

DriverSource source_of(const AuditOptions& options) {
  return options.icd.empty() ? driver_source(options.driver, options.seconds)
                             : driver_source_of_icd(options.icd, options.seconds);
}

// Cases or a scene that are given are drawn alone, unless more is asked for.
WorkloadOptions workload_of(const AuditOptions& options) {
  WorkloadOptions workload = options.workload;
  if (!workload.cases.empty() || !workload.scene.empty()) {
    workload.catalogue = workload.scenes = false;
    workload.lattice = workload.random = 0;
  }
  if (options.lattice) workload.lattice = *options.lattice;
  if (options.random) workload.random = *options.random;
  return workload;
}

Audit audit_of(const DriverSource& source, DriverPool& drivers, const AuditOptions& options) {
  std::vector<DrawCall> calls;
  const WorkloadOptions workload = workload_of(options);
  const LeftOut left_out = for_each_draw_call(workload, drivers.info(),
                                              [&](const DrawCall& call) { calls.push_back(call); });
  AuditLimits limits = options.limits;
  limits.hunted = workload.random;
  limits.seed = workload.seed;
  Audit audit = audit_driver(source.name, drivers, calls, limits);
  for (const auto& [reason, count] : left_out) audit.unable[reason] += count;
  return audit;
}

// What the store says of itself.
std::string whole_command(const DriverSource& source, const AuditOptions& options) {
  const WorkloadOptions workload = workload_of(options);
  std::string command =
      fmt::format("clipscope audit {} --lattice {} --random {} --seed {}", source.options,
                  workload.lattice, workload.random, workload.seed);
  if (!workload.cases.empty()) command += " --cases " + shell_word(workload.cases.string());
  if (!workload.scene.empty()) command += " --scene " + shell_word(workload.scene);
  if (workload.size > 0) command += fmt::format(" --size {}", workload.size);
  return command;
}

// The tables of the audit in a store of their own, so that `clipscope diff` compares two.
void store_audit(const AuditReport& report, const AuditOptions& options, double seconds) {
  make_folder(*options.out);
  const FolderLock lock(*options.out);
  const std::string command = whole_command(report.source, options);
  const RunInfo info = run_info_of(default_run_selection(), command);
  const OpenedStore opened = start_store(*options.out, info);
  tell_kept(opened);
  RunRecorder recorder(opened.database, opened.file);
  recorder.begin({"audit", "What does this driver do to every case?", command, ""}, 0);
  TableOf<QuantityRow> quantities;
  for (const QuantityRow& row : quantity_rows(report.audit)) quantities.add(row);
  TableOf<FindingRow> findings;
  for (const FindingRow& row : finding_rows(report.audit)) findings.add(row);
  quantities.add_note(driver_text(report.audit.info));
  recorder.add(quantities);
  recorder.add(findings);
  recorder.finish(seconds);
}

void append_smallest(const std::string& file, const Audit& audit) {
  for (const DriverFinding& finding : audit.findings) {
    for (const HardCase& c : cases_of(audit, finding)) append_case(file, c);
  }
}

int run_audit(const AuditOptions& options) {
  const auto start = std::chrono::steady_clock::now();
  const DriverSource source = source_of(options);
  DriverPool drivers(source.make);
  AuditReport report{source, audit_of(source, drivers, options)};
  if (options.out) {
    const std::filesystem::path folder = std::filesystem::path(*options.out) / "findings";
    for (const DriverFinding& finding : report.audit.findings) {
      report.folders.push_back(write_finding(folder, source, drivers, report.audit, finding));
    }
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
    store_audit(report, options, seconds.count());
  }
  if (options.corpus_out) append_smallest(*options.corpus_out, report.audit);
  if (options.junit) write_file(*options.junit, junit_of(report));
  fmt::print("{}", options.json ? json_text(json_of(report), 2) + "\n" : text_of(report));
  return exit_code(report.audit);
}

void add_driver_options(CLI::App& command, AuditOptions& options) {
  std::vector<std::string> names;
  for (const KnownDriver& driver : known_drivers()) names.push_back(driver.name);
  CLI::Option* const driver = add_option(
      command, "--driver", options.driver, "NAME",
      fmt::format(
          "{}, see `clipscope list drivers`; or own, our own rasteriser, own/FAULT with a fault [{}]",
          fmt::join(names, ", "), options.driver));
  add_option(command, "--icd", options.icd, "FILE",
             "A Vulkan driver by its manifest, as VK_ICD_FILENAMES takes it")
      ->excludes(driver);
  add_option(command, "--time-limit", options.seconds, "SECONDS",
             fmt::format("What a draw call may take [{:g}]", kSecondsPerDraw))
      ->check(CLI::Range(0.01, 86400.0));
}

void add_workload_options(CLI::App& command, AuditOptions& options) {
  WorkloadOptions& workload = options.workload;
  add_option(
      command, "--cases", workload.cases, "FILE",
      "Of a corpus file, or folder of them, all cases in every form, and nothing else; `expect` may be left out");
  add_option(command, "--scene", workload.scene, "FILE",
             "Of a mesh file what a camera sees that walks through it, and nothing else");
  add_option(command, "--size", workload.size, "N",
             "Of all targets, in px [32, of some draw calls 256]")
      ->check(CLI::Range(1, 16384));
  add_option(
      command, "--lattice", options.lattice, "N",
      fmt::format("Draw calls with coordinates that are small numbers [{}]", workload.lattice));
  add_option(command, "--random", options.random, "N",
             fmt::format("Draw calls with any numbers, and as many in a hunt for worse [{}]",
                         workload.random));
  command.add_flag("!--without-catalogue", workload.catalogue, "Leave the hard cases out");
  command.add_flag("!--without-scenes", workload.scenes, "Leave the scenes out");
  command.add_option("--seed", workload.seed, "Seed of what is drawn by chance [1]");
}

}  // namespace

void add_audit_command(CLI::App& app, Action& action) {
  const auto [command, options] = add_command(
      app, action, run_audit, "audit", "Where does a graphics driver violate its specification?",
      R"(Draws hard cases, small numbers, chance and scenes through the driver, in a process of its own, and
judges each pixel by exact arithmetic. A violation breaks a sentence of the API's specification,
beyond all that it leaves open; everything else is legal, and its error is told in ulp. Violations of
one kind in one quantity and in the same circumstances are one finding, shrunk to a small draw call.
Examples:
  clipscope audit --driver llvmpipe --out audit_llvmpipe
  clipscope audit --driver softpipe --cases mine.cases --json
  clipscope audit --driver llvmpipe --scene bunny.obj
  clipscope audit --icd /usr/share/vulkan/icd.d/lvp_icd.x86_64.json --junit audit.xml
  clipscope audit --driver own/near_unclipped     a driver with a fault that is known
  clipscope diff audit_llvmpipe audit_softpipe    two drivers, or two versions, compared
Exit code 0: no violation; 1: violations; 5: the driver is not there; 6: nothing was judged.)");
  add_driver_options(command, options);
  add_workload_options(command, options);
  command.add_flag("!--no-shrink", options.limits.shrinks,
                   "Leave the findings' worst draw calls as they are; else each is made small");
  add_option(
      command, "--out", options.out, "FOLDER",
      "Store tables there and, of each finding, picture, reproductions and a case to replay");
  add_option(command, "--corpus-out", options.corpus_out, "FILE",
             "Add the smallest draw calls to this file of hard cases");
  add_option(command, "--junit", options.junit, "FILE",
             "Also write the findings as test cases, in JUnit's XML, for CI systems");
  command.add_flag("--json", options.json, "Print JSON");
}

}  // namespace clipscope::experiments::commands
