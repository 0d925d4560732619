// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/spaces/clippers_in.hpp"

namespace clipscope::tests {

template std::span<const ClipperIn<float, 3>> clippers<float, 3>();
template std::span<const ClipperIn<float, 2>> clippers<float, 2>();
template std::span<const ClipperIn<double, 3>> clippers<double, 3>();
template std::span<const ClipperIn<double, 2>> clippers<double, 2>();
template std::span<const ClipperIn<experiments::Counted, 3>> clippers<experiments::Counted, 3>();
template std::span<const ClipperIn<experiments::Counted, 2>> clippers<experiments::Counted, 2>();

}  // namespace clipscope::tests
