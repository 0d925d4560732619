// SPDX-License-Identifier: GPL-3.0-or-later
//
// How often tests of random input try. Sanitizers watch what is done, not what comes out of it, and
// every try takes ten times as long with them: a quarter of the tries is enough for them.
#pragma once

namespace clipscope::tests {

#if defined(__SANITIZE_ADDRESS__)
inline constexpr bool kSanitized = true;
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
inline constexpr bool kSanitized = true;
#else
inline constexpr bool kSanitized = false;
#endif
#else
inline constexpr bool kSanitized = false;
#endif

constexpr int sampled(int tries) { return kSanitized ? tries / 4 : tries; }

}  // namespace clipscope::tests
