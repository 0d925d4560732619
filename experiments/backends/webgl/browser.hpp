// SPDX-License-Identifier: GPL-3.0-or-later
//
// A headless Chromium with one empty page, driven by the Chrome DevTools Protocol over two pipes
// (--remote-debugging-pipe: JSON, each message ended by a NUL).
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <string_view>
#include <sys/types.h>
#include <vector>

#include "experiments/guests/child.hpp"

namespace clipscope::experiments {

// It does not start, or it ended.
struct NoBrowser : std::runtime_error {
  using std::runtime_error::runtime_error;
};

class Browser {
 public:
  // Starts $CLIPSCOPE_CHROMIUM, else chromium, chromium-browser or google-chrome, with those
  // options besides. Its folder is its own, and removed at its end, even where this process is
  // killed.
  // Errors: NoBrowser.
  explicit Browser(const std::vector<std::string>& options);
  ~Browser();
  Browser(const Browser&) = delete;
  Browser& operator=(const Browser&) = delete;

  const std::string& product() const { return product_; }  // "Chrome/156.0.8078.108"

  // The value of the expression in the page, or what it threw as {"error": "..."}. Errors:
  // NoBrowser if the browser or the page ended.
  nlohmann::json evaluate(std::string_view expression);

 private:
  nlohmann::json call(std::string_view method, nlohmann::json parameters);
  nlohmann::json receive();
  void open_page();
  void end();

  std::filesystem::path folder_;
  pid_t process_ = -1;
  Descriptor commands_ = Descriptor(), replies_ = Descriptor();
  int last_id_ = 0;
  std::string session_ = {}, product_ = {};
  std::string received_ = {};
};

}  // namespace clipscope::experiments
