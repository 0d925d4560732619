// SPDX-License-Identifier: GPL-3.0-or-later
//
// Options that take a fixed count of numbers separated by commas, such as --eye 0,1,2.
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace clipscope::experiments {

// Adds the option; `set` is called with exactly `count` numbers. Anything else is a usage error that names
// the option, what was given and what it takes (`type`, such as "X,Y,Z").
CLI::Option* add_number_list(CLI::App& command, const std::string& name, std::size_t count,
                             const std::string& type,
                             std::function<void(const std::vector<double>&)> set,
                             const std::string& help);

}  // namespace clipscope::experiments
