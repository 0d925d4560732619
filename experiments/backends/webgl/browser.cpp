// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/backends/webgl/browser.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <sstream>
#include <utility>

#include "experiments/table/json_text.hpp"

namespace clipscope::experiments {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

// Where Chromium expects its pipes.
constexpr int kCommands = 3, kReplies = 4;
constexpr const char* kEnded = "the browser has ended";
constexpr std::size_t kPiece = std::size_t{1} << 20;  // bytes that are read at once

std::string environment_value(const char* name) {
  const char* value = std::getenv(name);
  return value == nullptr ? "" : value;
}

// The first of the names that the search path has a program of; empty if there is none.
std::string program_of(const std::vector<std::string>& names) {
  for (const std::string& name : names) {
    std::istringstream folders(environment_value("PATH"));
    for (std::string folder; std::getline(folders, folder, ':');) {
      const std::string file = folder + "/" + name;
      if (access(file.c_str(), X_OK) == 0) return file;
    }
  }
  return {};
}

std::string find_chromium() {
  const std::string chosen = environment_value("CLIPSCOPE_CHROMIUM");
  if (!chosen.empty()) {
    if (access(chosen.c_str(), X_OK) == 0) return chosen;
    throw NoBrowser(fmt::format("$CLIPSCOPE_CHROMIUM is {}, which is no program", chosen));
  }
  const std::string found = program_of({"chromium", "chromium-browser", "google-chrome"});
  if (found.empty()) {
    throw NoBrowser("there is no chromium, chromium-browser or google-chrome (Debian: chromium)");
  }
  return found;
}

// A pipe that holds much, so that pixels come in few pieces.
Pipe open_big_pipe() {
  Pipe pipe = open_pipe();
  fcntl(pipe.read_end.number(), F_SETPIPE_SZ, static_cast<int>(kPiece));
  return pipe;
}

fs::path make_profile_folder() {
  std::string name = (fs::temp_directory_path() / "clipscope-chromium-XXXXXX").string();
  if (mkdtemp(name.data()) == nullptr) {
    throw NoBrowser(fmt::format("{} can't be made: {}", name, std::strerror(errno)));
  }
  return name;
}

// A shell that outlives us removes the folder when the browser has ended, which it does when its
// pipe is closed.
std::vector<std::string> command_of(const std::string& chromium, const fs::path& folder,
                                    const std::vector<std::string>& options) {
  std::vector<std::string> words = {"sh", "-c", "\"$@\"; rm -rf \"$0\"", folder.string(), chromium};
  for (const char* option :
       {"--headless=new", "--remote-debugging-pipe", "--no-first-run", "--disable-dev-shm-usage",
        "--disable-extensions", "--disable-background-networking", "--log-level=3"}) {
    words.emplace_back(option);
  }
  words.push_back("--user-data-dir=" + folder.string());
  if (geteuid() == 0) words.emplace_back("--no-sandbox");  // which root can't have
  words.insert(words.end(), options.begin(), options.end());
  words.emplace_back("about:blank");
  return words;
}

}  // namespace

Browser::Browser(const std::vector<std::string>& options) {
  const std::string chromium = find_chromium();
  std::signal(SIGPIPE, SIG_IGN);  // a browser that is gone is an error of writing
  folder_ = make_profile_folder();
  Pipe commands = open_big_pipe(), replies = open_big_pipe();
  const std::array<GivenFile, 3> files = {{{STDERR_FILENO, STDOUT_FILENO},
                                           {commands.read_end.number(), kCommands},
                                           {replies.write_end.number(), kReplies}}};
  // What else it leaves behind goes with its folder.
  const std::vector<std::string> environment = {"TMPDIR=" + folder_.string()};
  process_ = start_process("/bin/sh", command_of(chromium, folder_, options),
                           environment_with(environment), files);
  commands_ = std::move(commands.write_end);
  replies_ = std::move(replies.read_end);
  // The browser's own ends are closed here, so that its end is seen.
  commands.read_end = Descriptor();
  replies.write_end = Descriptor();
  try {
    product_ = call("Browser.getVersion", json::object()).value("product", "");
    open_page();
  } catch (const std::exception& error) {
    end();
    throw NoBrowser(fmt::format("{} does not start: {}", chromium, error.what()));
  }
}

Browser::~Browser() { end(); }

void Browser::end() {
  commands_ = Descriptor();
  replies_ = Descriptor();
  ends_before(process_, std::chrono::steady_clock::now() + std::chrono::seconds(3));
  end_group(process_);
  std::error_code ignored;
  fs::remove_all(folder_, ignored);
}

void Browser::open_page() {
  std::string page;
  for (const json& target : call("Target.getTargets", json::object()).at("targetInfos")) {
    if (target.at("type") == "page") page = target.at("targetId");
  }
  if (page.empty()) page = call("Target.createTarget", {{"url", "about:blank"}}).at("targetId");
  session_ = call("Target.attachToTarget", {{"targetId", page}, {"flatten", true}}).at("sessionId");
}

json Browser::receive() {
  std::size_t end = received_.find('\0');
  while (end == std::string::npos) {
    const std::size_t size = received_.size();
    received_.resize(size + kPiece);
    const ssize_t read_bytes =
        read(replies_.number(), received_.data() + size, received_.size() - size);
    received_.resize(size + static_cast<std::size_t>(std::max(read_bytes, ssize_t{0})));
    if (read_bytes == 0 || (read_bytes < 0 && errno != EINTR)) throw NoBrowser(kEnded);
    end = received_.find('\0', size);
  }
  json message = json::parse(std::string_view(received_).substr(0, end), nullptr, false);
  received_.erase(0, end + 1);
  return message;
}

// Events come between an order and its answer; of those only the end of the page matters.
json Browser::call(std::string_view method, json parameters) {
  json order = {{"id", ++last_id_}, {"method", method}, {"params", std::move(parameters)}};
  if (!session_.empty()) order["sessionId"] = session_;
  const std::string text = json_text(order) + '\0';
  for (std::size_t done = 0; done < text.size();) {
    const ssize_t written = write(commands_.number(), text.data() + done, text.size() - done);
    if (written < 0 && errno != EINTR) throw NoBrowser(kEnded);
    if (written > 0) done += static_cast<std::size_t>(written);
  }
  while (true) {
    json message = receive();
    if (message.value("method", "") == "Target.detachedFromTarget") {
      throw NoBrowser("the page has ended");
    }
    if (message.value("id", 0) != last_id_) continue;
    if (message.contains("error")) {
      throw NoBrowser(fmt::format("{}: {}", method, message["error"].value("message", "")));
    }
    return message.at("result");
  }
}

json Browser::evaluate(std::string_view expression) {
  const json result =
      call("Runtime.evaluate", {{"expression", expression}, {"returnByValue", true}});
  if (!result.contains("exceptionDetails")) return result.at("result").value("value", json());
  const json& thrown = result["exceptionDetails"];
  return {{"error", thrown.value("exception", json::object())
                        .value("description", thrown.value("text", "an exception"))}};
}

}  // namespace clipscope::experiments
