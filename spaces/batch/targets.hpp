// SPDX-License-Identifier: MIT
//
// The instruction sets that the SIMD code is compiled for. To be read before
// <hwy/foreach_target.h>.
#pragma once

// SSE4, AVX2, AVX-512 and NEON remain: these gain nothing over them, or have vectors of no fixed
// size.
#define HWY_DISABLED_TARGETS \
  (HWY_SSSE3 | HWY_AVX3_DL | HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128 | HWY_RVV)

// Whether HWY_TARGET has vectors, of doubles too. Without them the plain version is the best there
// is.
#define CLIPSCOPE_BATCH_HAS_SIMD \
  (HWY_TARGET != HWY_SCALAR && HWY_TARGET != HWY_EMU128 && HWY_HAVE_FLOAT64)
