// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/report/plot.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <sstream>
#include <string_view>

#include "experiments/machine/errors.hpp"
#include "experiments/machine/files.hpp"
#include "experiments/machine/temporary_folder.hpp"
#include "experiments/report/plot_layout.hpp"
#include "experiments/report/report.hpp"
#include "experiments/table/utf8.hpp"

namespace clipscope::experiments {
namespace {

struct Ended {
  int error = 0;   // an errno: it could not be started
  int status = 0;  // as wait gives it
};

// Runs gnuplot in the folder on script.gp there; what it says goes to the file "said".
Ended run_gnuplot(const std::filesystem::path& folder) {
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addchdir_np(&actions, folder.c_str());
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "said", O_WRONLY | O_CREAT, 0600);
  posix_spawn_file_actions_adddup2(&actions, STDOUT_FILENO, STDERR_FILENO);
  std::string program = "gnuplot", no_start_up_file = "-d", script = "script.gp";
  char* const arguments[] = {program.data(), no_start_up_file.data(), script.data(), nullptr};
  pid_t child = 0;
  Ended ended;
  ended.error = posix_spawnp(&child, "gnuplot", &actions, nullptr, arguments, environ);
  posix_spawn_file_actions_destroy(&actions);
  while (ended.error == 0 && waitpid(child, &ended.status, 0) < 0) {
    if (errno != EINTR) ended.error = errno;
  }
  return ended;
}

// The line of gnuplot's message that says what is wrong: after the line that it echoes and the
// caret.
std::string complaint(const std::string& said) {
  std::string last;
  std::istringstream lines(said);
  for (std::string line; std::getline(lines, line);) {
    if (line.find_first_not_of(" ^\t") != std::string::npos) last = line;
  }
  return last.empty() ? "it said nothing" : last;
}

void replace_all(std::string& text, std::string_view from, const std::string& to) {
  for (std::size_t at = text.find(from); at != std::string::npos;
       at = text.find(from, at + to.size())) {
    text.replace(at, from.size(), to);
  }
}

// Several plots may stand in one page, so that ids must differ; a title and a description for those
// who can't see it.
std::string finished_svg(std::string svg, const Plot& plot) {
  std::string id;
  for (const char c : plot.name) id += std::isalnum(static_cast<unsigned char>(c)) != 0 ? c : '_';
  for (const std::string before : {"id='", "id=\"", "href='#", "href=\"#", "url(#"}) {
    for (const std::string name : {"gp", "gnuplot_", "textbox", "greybox"}) {
      replace_all(svg, before + name, before + id + "_" + name);
    }
  }
  // gnuplot takes the weight for a part of the family's name.
  replace_all(svg, "font-family=\"sans-serif:Bold\"",
              "font-family=\"sans-serif\" font-weight=\"bold\"");
  const std::size_t begin = svg.find("<title>"), end = svg.find("</desc>");
  if (begin != std::string::npos && end != std::string::npos && begin < end) {
    svg.replace(begin, end - begin,
                fmt::format("<title>{}</title>\n<desc>{}", xml_escaped(plot.title),
                            xml_escaped(plot.caption)));
  }
  return svg;
}

// The date of making is all that differs between two runs; a fixed one of the same length.
std::string dateless_pdf(std::string pdf) {
  static constexpr std::string_view kKey = "/CreationDate (D:";
  const std::size_t at = pdf.find(kKey);
  if (at == std::string::npos) return pdf;
  for (std::size_t i = at + kKey.size(), digits = 0; i < pdf.size() && digits < 14; ++i, ++digits) {
    pdf[i] = "20000101000000"[digits];
  }
  return pdf;
}

}  // namespace

void write_plot(const Plot& plot, const std::filesystem::path& directory) {
  const TemporaryFolder folder;
  write_file(folder.path() / "script.gp", plot_script(plot));
  const auto [error, status] = run_gnuplot(folder.path());
  // Some C libraries say by exit code 127 that the program can't be started.
  if (error == ENOENT || (error == 0 && WIFEXITED(status) && WEXITSTATUS(status) == 127)) {
    throw OutputError(fmt::format(
        "plot {}: gnuplot can't be found; install it (on Debian: apt-get install gnuplot-nox)",
        plot.name));
  }
  if (error != 0) {
    throw OutputError(
        fmt::format("plot {}: gnuplot can't be started: {}", plot.name, std::strerror(error)));
  }
  const auto drawn = [&](const char* file) { return read_if_there(folder.path() / file); };
  const std::string svg = drawn("plot.svg"), pdf = drawn("plot.pdf"), png = drawn("plot.png");
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0 || svg.empty() || pdf.empty() || png.empty()) {
    throw OutputError(
        fmt::format("plot {}: gnuplot failed: {}", plot.name, complaint(drawn("said"))));
  }
  write_file(directory / (plot.name + ".svg"), finished_svg(svg, plot));
  write_file(directory / (plot.name + ".pdf"), dateless_pdf(pdf));
  write_file(directory / (plot.name + ".png"), png);
}

}  // namespace clipscope::experiments
