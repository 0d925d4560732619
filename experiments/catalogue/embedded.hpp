// SPDX-License-Identifier: GPL-3.0-or-later
//
// The files of tests/corpus as they were at build time; embed.cmake writes the definition.
#pragma once

#include <span>
#include <string_view>

namespace clipscope::experiments {

struct EmbeddedFile {
  std::string_view name;  // "tests/corpus/w_sign.cases"
  std::string_view text;
};

std::span<const EmbeddedFile> embedded_case_files();

}  // namespace clipscope::experiments
