// SPDX-License-Identifier: GPL-3.0-or-later
//
// The folder of a finding: what people need who want to see it, believe it or mend it.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "experiments/audit/audit.hpp"
#include "experiments/audit/driver_source.hpp"

namespace clipscope::experiments {

// In the folder of a finding.
inline constexpr const char* kCasesFile = "draw.cases";
inline constexpr const char* kPictureFile = "picture.png";  // of a finding that left pixels

// The command that audits the driver with the cases of a file.
std::string replay_command(const DriverSource& source, const DrawExample& example,
                           const std::filesystem::path& cases);

// Writes into folder/STEM, see file_stem: README.md, picture.png, draw.cases and the reproductions.
// Returns folder/STEM. Errors: OutputError; those of the pool.
std::filesystem::path write_finding(const std::filesystem::path& folder, const DriverSource& source,
                                    DriverPool& drivers, const Audit& audit,
                                    const DriverFinding& finding);

}  // namespace clipscope::experiments
