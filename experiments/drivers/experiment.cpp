// SPDX-License-Identifier: GPL-3.0-or-later
//
// Drivers: those that are installed x the catalogue, lattices, chance and scenes x every quantity.
#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "experiments/audit/draw_text.hpp"
#include "experiments/audit/driver_source.hpp"
#include "experiments/audit/finding_folder.hpp"
#include "experiments/drivers/rows.hpp"
#include "experiments/machine/files.hpp"
#include "experiments/machine/machine.hpp"
#include "experiments/report/experiment.hpp"
#include "experiments/workloads/workload.hpp"

namespace clipscope::experiments::drivers {
namespace {

// Draw calls of each driver, and what shrinking one finding may take: some drivers need 40 ms for a
// draw call. `clipscope audit` draws them all.
constexpr std::size_t kQuickCalls = 120, kCalls = 500;
constexpr double kSecondsToShrink = 3;

struct Tables {
  TableOf<DriverRow> drivers;
  TableOf<DriverClassRow> classes;
  TableOf<DriverQuantityRow> quantities;
  TableOf<DriverFindingRow> findings;
};

std::vector<DrawCall> draw_calls(const Selection& selection, const DriverInfo& info) {
  std::vector<DrawCall> calls;
  WorkloadOptions options{.seed = selection.seed};
  if (selection.quick) {
    options.lattice = options.random = kQuickCalls / 2;
    options.scenes = false;
  }
  for_each_draw_call(options, info, [&](const DrawCall& call) { calls.push_back(call); });
  return evenly_spaced(calls, selection.quick ? kQuickCalls : kCalls);
}

// Where the pictures of a finding are, in the experiment's folder.
std::filesystem::path folder_of(const std::string& driver) {
  return std::filesystem::path("findings") / driver;
}

bool shows_findings(const Selection& selection) { return selection.pictures || !selection.quick; }

// As findings/DRIVER/STEM/picture.png.
void draw_findings(const ExperimentContext& context, const DriverSource& source,
                   DriverPool& drivers, const Audit& audit, PieceRecord& record) {
  const std::filesystem::path folder = folder_of(source.name);
  for (const DriverFinding& finding : audit.findings) {
    const std::filesystem::path path =
        write_finding(context.out() / folder, source, drivers, audit, finding);
    if (!std::filesystem::exists(path / kPictureFile)) continue;
    const auto file = folder / path.filename() / kPictureFile;
    record.pictures.push_back(
        {file.string(), fmt::format("{}: {}", source.name, finding_text(finding.key))});
  }
}

AuditLimits limits_of(const Selection& selection) {
  return {.shrinks = !selection.quick, .seconds_each = kSecondsToShrink, .seed = selection.seed};
}

void audit_one(const ExperimentContext& context, const DriverSource& source, Tables& tables,
               PieceRecord& record) {
  const Selection& selection = context.selection();
  DriverPool drivers(source.make);
  const Audit audit = audit_driver(source.name, drivers, draw_calls(selection, drivers.info()),
                                   limits_of(selection));
  tables.drivers.add(driver_row(audit));
  for (const DriverClassRow& row : class_rows(audit)) tables.classes.add(row);
  for (const QuantityRow& row : quantity_rows(audit)) tables.quantities.add({audit.driver, row});
  for (const FindingRow& row : finding_rows(audit)) tables.findings.add({audit.driver, row});
  if (shows_findings(selection)) draw_findings(context, source, drivers, audit, record);
}

// The picture that a paper shows.
void show_gravest(const ExperimentContext& context, const std::vector<DriverFindingRow>& findings) {
  const DriverFindingRow* const row = gravest(findings);
  if (row == nullptr || !shows_findings(context.selection())) return;
  const auto picture = folder_of(row->driver) / file_stem(row->row.what()) / kPictureFile;
  if (!std::filesystem::exists(context.out() / picture)) return;  // it left no pixels
  write_file(context.out() / "drivers_gravest.png", read_bytes(context.out() / picture));
  context.emit_file(context.out() / "drivers_gravest.png");
}

void run(const ExperimentContext& context) {
  Tables tables;
  std::set<std::string> renderers;  // asked already: default may be another name of one
  for (const DriverHere& here : drivers_here()) {
    const std::string& name = here.driver.name;
    if (!here.info) {
      tables.drivers.add_note(fmt::format("{} is not here: {}", name, here.reason));
    } else if (!renderers.insert(driver_text(*here.info)).second) {
      tables.drivers.add_note(
          fmt::format("{} is one of those named: {}", name, here.info->renderer));
    } else {
      context.piece(name, {&tables.drivers, &tables.classes, &tables.quantities, &tables.findings},
                    [&](PieceRecord& record) {
                      audit_one(context, driver_source(here.driver), tables, record);
                    });
    }
  }
  tables.drivers.add_note(machine_description());
  context.emit(tables.drivers, tables.classes, tables.quantities, tables.findings);
  show_gravest(context, tables.findings.rows());
  context.finding(finding(tables.drivers.rows(), tables.findings.rows()));
}

}  // namespace

extern constinit const Experiment kExperiment{"drivers",
                                              "How right are the clippers that people use?", run};

}  // namespace clipscope::experiments::drivers
