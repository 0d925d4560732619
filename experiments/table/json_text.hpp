// SPDX-License-Identifier: GPL-3.0-or-later
//
// JSON as text, whatever its strings hold. Names of files, cases and plug-ins are bytes that
// anybody may have chosen; the library's own `dump` throws at the first that is no UTF-8.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace clipscope::experiments {

// Each byte that belongs to no well-formed UTF-8 sequence becomes U+FFFD. indent: blanks for each
// level; -1: all on one line.
template <class Json>
std::string json_text(const Json& json, int indent = -1) {
  return json.dump(indent, ' ', false, Json::error_handler_t::replace);
}

}  // namespace clipscope::experiments
