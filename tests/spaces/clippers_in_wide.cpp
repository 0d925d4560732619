// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/spaces/clippers_in.hpp"

namespace clipscope::tests {

template std::span<const ClipperIn<dd_real, 3>> clippers<dd_real, 3>();
template std::span<const ClipperIn<dd_real, 2>> clippers<dd_real, 2>();
template std::span<const ClipperIn<experiments::Exact, 3>> clippers<experiments::Exact, 3>();
template std::span<const ClipperIn<experiments::Exact, 2>> clippers<experiments::Exact, 2>();

}  // namespace clipscope::tests
