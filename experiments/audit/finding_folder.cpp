// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/audit/finding_folder.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <variant>

#include "experiments/audit/draw_cases.hpp"
#include "experiments/audit/draw_text.hpp"
#include "experiments/audit/finding_picture.hpp"
#include "experiments/catalogue/catalogue.hpp"
#include "experiments/machine/files.hpp"
#include "experiments/machine/shell_word.hpp"
#include "experiments/reproductions/reproduction.hpp"
#include "experiments/table/hex_float.hpp"
#include "experiments/table/row.hpp"

namespace clipscope::experiments {
namespace {

namespace fs = std::filesystem;

// How to run a reproduction, by its extension.
std::string runner_of(const std::string& file) {
  const std::string extension = extension_of(file);
  if (extension == ".shader_test") {
    return fmt::format("`shader_runner {} -auto -fbo` (piglit)", file);
  }
  if (extension == ".amber") return fmt::format("`amber {}` (Amber, Vulkan)", file);
  return fmt::format("open [{}]({}) in a browser (WebGL 2)", file, file);
}

// As Markdown: each vertex with its varying, in decimal and, to the bit, hexadecimal.
std::string vertex_table(const DrawCall& call) {
  std::string text =
      "| vertex | x | y | z | w | varying | hexadecimal |\n|---|---|---|---|---|---|---|\n";
  for (std::size_t i = 0; i < call.vertices.size(); ++i) {
    const auto& [x, y, z, w] = call.vertices[i].position;
    text += fmt::format("| {} | {} | {} | {} | {} | {} | `{:a} {:a} {:a} {:a}` |\n", i, x, y, z, w,
                        fmt::join(call.vertices[i].varying, " "), x, y, z, w);
  }
  return text;
}

std::string came_out_text(const Audit& audit, const DriverFinding& finding) {
  const DrawExample& example = finding.example();
  const Violation& v = example.violation;
  if (v.pixels == 0) return fmt::format("{}: {}", name_of(v.kind), example.reason);
  return fmt::format(
      "{} in {} pixels of primitive {}; {}. {} of {} draw calls of the audit show the like, in {} pixels.",
      name_of(v.kind), v.pixels, v.primitive, pixel_text(v), finding.cases, audit.cases,
      finding.pixels);
}

std::string readme_text(const DriverSource& source, const Audit& audit,
                        const DriverFinding& finding, bool has_picture,
                        const std::vector<Reproduction>& reproductions) {
  const DrawExample& example = finding.example();
  std::string text = fmt::format("# {}: {}\n\n", audit.driver, finding_text(finding.key));
  text +=
      fmt::format("**Drawn.** {}.\n\n{}\n", draw_text(example.call), vertex_table(example.call));
  text +=
      fmt::format("**Demanded.** {}: {}\n\n", section_text(finding.clause), finding.clause.meaning);
  text += fmt::format("**Came out.** {}\n\n", came_out_text(audit, finding));
  text += fmt::format("**By.** {}.\n\n", driver_text(audit.info));
  if (has_picture) {
    text += fmt::format(
        "![What came, what is right, the difference, and the primitive in clip space]({})\n\n",
        kPictureFile);
  }
  text += fmt::format("**Again.** `{}`", replay_command(source, example, kCasesFile));
  for (const Reproduction& r : reproductions) text += fmt::format("; {}", runner_of(r.file_name));
  return text + ".\n";
}

}  // namespace

std::string replay_command(const DriverSource& source, const DrawExample& example,
                           const fs::path& cases) {
  return fmt::format("clipscope audit {} --cases {} --size {}", source.options,
                     shell_word(cases.string()), example.call.width);
}

fs::path write_finding(const fs::path& folder, const DriverSource& source, DriverPool& drivers,
                       const Audit& audit, const DriverFinding& finding) {
  const fs::path path = folder / file_stem(finding_text(finding.key));
  make_folder(path);
  fs::remove(path / kCasesFile);
  for (const HardCase& c : cases_of(audit, finding)) append_case(path / kCasesFile, c);
  const DrawExample& example = finding.example();
  const std::vector<Reproduction> all = reproductions(example.call, example.violation, audit.info);
  for (const Reproduction& r : all) write_file(path / r.file_name, r.text);
  const Drawn drawn = drivers.draw(example.call);
  const auto* const pixels = std::get_if<Pixels>(&drawn);
  if (pixels != nullptr) write_finding_picture(path / kPictureFile, audit, finding, *pixels);
  write_file(path / "README.md", readme_text(source, audit, finding, pixels != nullptr, all));
  return path;
}

}  // namespace clipscope::experiments
