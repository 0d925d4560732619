// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/proofs/gappa.hpp"

#include <fmt/format.h>
#include <sys/wait.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>

namespace clipscope::proofs {

namespace {

// A double times 2^scale as an integer times a power of two, as Gappa reads it.
std::string dyadic(double value, int scale = 0) {
  int exponent;
  auto digits = static_cast<std::int64_t>(std::ldexp(std::frexp(value, &exponent), 53));
  if (digits == 0) return "0";
  for (exponent -= 53; digits % 2 == 0; digits /= 2) ++exponent;
  exponent += scale;
  const bool is_integer = 0 <= exponent && exponent < 10;
  return is_integer ? fmt::format("{}", digits << exponent)
                    : fmt::format("{}b{}", digits, exponent);
}

// n / d, rounded up to a double unless it is exact; 1 / d may be beyond the largest one.
std::string quotient_above(double n, double d) {
  int exponent;
  const double divisor = std::frexp(d, &exponent), q = n / divisor;
  return dyadic(std::fma(q, divisor, -n) == 0 ? q : std::nextafter(q, HUGE_VAL), -exponent);
}

std::string read(const std::filesystem::path& file) {
  std::ifstream in(file);
  if (!in) throw std::runtime_error(fmt::format("{}: can't be read", file.string()));
  return {std::istreambuf_iterator<char>(in), {}};
}

// What replaces one @token@.
class Replacement {
 public:
  Replacement(const Proof& proof, const Values& values, Script& script)
      : proof_(proof), values_(values), script_(script) {}

  std::string operator()(std::string_view token) const {
    for (const Parameter& p : proof_.parameters) {
      if (p.name != token) continue;
      return p.text.front() == '@' ? (*this)(inner(p.text)) : std::string(p.text);
    }
    const std::size_t slash = token.find('/');
    if (slash == token.npos) return dyadic(value(token));
    const std::string_view first = token.substr(0, slash), second = token.substr(slash + 1);
    if (second == "2") return dyadic(value(first) / 2);
    return quotient_above(std::stod(std::string(first)), value(second));
  }

 private:
  static std::string_view inner(std::string_view text) { return text.substr(1, text.size() - 2); }

  double value(std::string_view name) const {
    script_.constants.insert(constant(name).name);
    return values_(name);
  }

  const Proof& proof_;
  const Values& values_;
  Script& script_;
};

struct Answer {
  int status;
  std::string words;
};

Answer run(const std::string& command) {
  FILE* const pipe = popen((command + " 2>&1").c_str(), "r");
  if (pipe == nullptr) throw std::runtime_error("no process can be started");
  Answer r{0, {}};
  std::array<char, 4096> part;
  while (const std::size_t n = std::fread(part.data(), 1, part.size(), pipe)) {
    r.words.append(part.data(), n);
  }
  const int status = pclose(pipe);
  r.status = WIFEXITED(status) ? WEXITSTATUS(status) : 128;
  return r;
}

// A folder of its own that is removed in the end.
class Folder {
 public:
  Folder() {
    std::string name = (std::filesystem::temp_directory_path() / "proofXXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) throw std::runtime_error(name + ": can't be made");
    path_ = name;
  }
  ~Folder() { std::filesystem::remove_all(path_); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  std::filesystem::path write(std::string_view name, const std::string& text) const {
    std::ofstream(path_ / name) << text;
    return path_ / name;
  }
  std::string quoted(std::string_view name) const {
    return fmt::format("'{}'", (path_ / name).string());
  }

 private:
  std::filesystem::path path_;
};

// Constants like 1 + u need more than the 60 bits that are Gappa's default; splitting intervals
// helps with none of these proofs, and takes long where one fails.
constexpr std::string_view kGappa = "gappa -Eprecision=256 -Eno-auto-dichotomy";

}  // namespace

double value_in_code(std::string_view name) { return constant(name).value; }

std::set<std::string> templates() {
  constexpr std::string_view kEnding = ".g.in";
  std::set<std::string> r;
  for (const auto& entry : std::filesystem::directory_iterator(CLIPSCOPE_PROOFS)) {
    const std::string name = entry.path().filename().string();
    if (name.ends_with(kEnding)) r.insert(name.substr(0, name.size() - kEnding.size()));
  }
  return r;
}

Script script_of(const Proof& proof, const Values& values) {
  const std::filesystem::path file =
      std::filesystem::path(CLIPSCOPE_PROOFS) / fmt::format("{}.g.in", proof.script);
  const std::string text = read(file);
  Script r;
  const Replacement replacement(proof, values, r);
  std::size_t at = 0;
  while (true) {
    // Gappa's own words that begin with @ have no second one: @FIX(, @FLT(, @rnd.
    const std::size_t open = text.find('@', at);
    r.text += text.substr(at, open - at);
    if (open == text.npos) return r;
    const std::size_t close = text.find_first_not_of(
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789_/", open + 1);
    if (close != text.npos && text[close] == '@') {
      r.text += replacement(std::string_view(text).substr(open + 1, close - open - 1));
      at = close + 1;
    } else {
      r.text += '@';
      at = open + 1;
    }
  }
}

bool is_gappa_installed() { return run("command -v gappa").status == 0; }

bool is_proved(const Script& script) {
  const Folder folder;
  folder.write("script.g", script.text);
  const Answer answer = run(fmt::format("{} {}", kGappa, folder.quoted("script.g")));
  if (answer.status == 0 && answer.words.empty()) return true;
  const bool is_no = answer.words.starts_with("Error: some properties were not satisfied:") &&
                     answer.words.find("Warning") == std::string::npos;
  if (answer.status == 1 && is_no) return false;
  throw std::runtime_error(
      fmt::format("Gappa (exit code {}) says of the script:\n{}", answer.status, answer.words));
}

void certify(const Script& script) {
  const Folder folder;
  folder.write("script.g", script.text);
  const std::string from = folder.quoted("script.g"), to = folder.quoted("certificate.v");
  for (const std::string& command :
       {fmt::format("{} -Bcoq {} >{}", kGappa, from, to), fmt::format("coqc -q {}", to)}) {
    const Answer answer = run(command);
    if (answer.status != 0) {
      throw std::runtime_error(
          fmt::format("{} (exit code {}) says:\n{}", command, answer.status, answer.words));
    }
  }
}

bool is_proved_with(const Proof& proof, const Constant& weakened, int steps) {
  return is_proved(script_of(proof, [&](std::string_view name) {
    return name == weakened.name ? weakened.weakened(steps) : constant(name).value;
  }));
}

int steps_to_spare(const Proof& proof, const Constant& c) {
  const auto passes = [&](int steps) { return is_proved_with(proof, c, steps); };
  // What is weaker is not proved either: doubled steps, then halved intervals.
  int good = 0, bad = 1;
  while (passes(bad)) {
    if (bad == c.most_steps()) {
      throw std::runtime_error(
          fmt::format("{} proves the same whatever {} is", proof.name, c.name));
    }
    good = bad;
    bad = std::min(2 * bad, c.most_steps());
  }
  while (bad - good > 1) {
    const int middle = good + (bad - good) / 2;
    (passes(middle) ? good : bad) = middle;
  }
  return good;
}

}  // namespace clipscope::proofs
