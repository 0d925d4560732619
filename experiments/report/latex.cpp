// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/report/latex.hpp"

#include <fmt/format.h>

#include <cmath>

#include "experiments/report/table.hpp"

namespace clipscope::experiments {

std::string latex_escape(const std::string& text) {
  std::string escaped;
  for (const char c : text) {
    switch (c) {
      case '&':
      case '%':
      case '$':
      case '#':
      case '_':
      case '{':
      case '}': escaped += fmt::format("\\{}", c); break;
      case '\\': escaped += "\\textbackslash{}"; break;
      case '~': escaped += "\\textasciitilde{}"; break;
      case '^': escaped += "\\textasciicircum{}"; break;
      case '<': escaped += "\\textless{}"; break;
      case '>': escaped += "\\textgreater{}"; break;
      default: escaped += c;
    }
  }
  return escaped;
}

std::string latex_number(double value) {
  std::string text = format_number(value);
  const std::size_t e = text.find('e');
  if (!std::isfinite(value) || e == std::string::npos) {
    return text.starts_with('-') ? fmt::format("${}$", text) : text;
  }
  return fmt::format("${}\\cdot10^{{{}}}$", text.substr(0, e), std::stoi(text.substr(e + 1)));
}

}  // namespace clipscope::experiments
