// SPDX-License-Identifier: GPL-3.0-or-later
//
// VertexRows: what is left of primitives as CSV on standard output, a row per vertex.
#pragma once

#include <fmt/format.h>

#include <cstdio>
#include <iterator>
#include <string>
#include <string_view>

#include "experiments/contestants/scalars.hpp"
#include "experiments/errors.hpp"
#include "experiments/hex_float.hpp"
#include "spaces/vertex.hpp"

namespace clipscope::experiments {

// The shortest decimal that reads back as the same number, or the number as a hex float; double-double
// to 32 digits in decimal, else to the nearest double; exact numbers to the nearest double.
template <class T>
std::string format_scalar(const T& x, bool hex) {
  if constexpr (std::same_as<T, dd_real>) {
    if (!hex) return x.to_string(32);
  }
  if (hex) return hex_float(nearest_double(x));
  if constexpr (ScalarTraits<T>::precision == 24)
    return fmt::format("{}", static_cast<float>(nearest_double(x)));
  return fmt::format("{}", nearest_double(x));
}

class VertexRows {
 public:
  // columns: those that number the primitive, such as "triangle" or "polygon,part". The first `dropped`
  // attributes of a vertex are not written, the `written` ones after them are.
  VertexRows(std::string_view columns, int dropped, int written, bool hex)
      : dropped_(dropped), hex_(hex), text_(fmt::format("{},vertex,x,y,z,inv_w", columns)) {
    for (int k = 0; k < written; ++k) text_ += fmt::format(",a{}", k);
    text_ += '\n';
  }

  // One row for each vertex. number: the values of the columns.
  template <class Vertices>
  void add(std::string_view number, const Vertices& vertices) {
    int n = 0;
    for (const auto& v : vertices) {
      fmt::format_to(std::back_inserter(text_), "{},{}", number, n++);
      for (int i = 0; i < 4; ++i) add_value(v.position[i]);
      for (int k = dropped_; k < v.attributes.size(); ++k) add_value(v.attributes[k]);
      text_ += '\n';
    }
    if (text_.size() > (1u << 20)) flush();
  }

  // To be called at the end. Errors: OutputError.
  void flush() {
    if (std::fwrite(text_.data(), 1, text_.size(), stdout) != text_.size() ||
        std::fflush(stdout) != 0) {
      throw OutputError("standard output: can't be written");
    }
    text_.clear();
  }

 private:
  template <class T>
  void add_value(const T& x) {
    text_ += ',';
    text_ += format_scalar(x, hex_);
  }

  int dropped_;
  bool hex_;
  std::string text_;
};

}  // namespace clipscope::experiments
