// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/experiments/reproductions/amber_grammar.hpp"

#include <algorithm>
#include <cctype>
#include <map>
#include <optional>
#include <set>
#include <sstream>
#include <stdexcept>

namespace clipscope::experiments {
namespace {

using Words = std::vector<std::string>;

Words words_of(const std::string& line) {
  Words words;
  std::istringstream stream(line.substr(0, line.find('#')));
  for (std::string word; stream >> word;) words.push_back(word);
  return words;
}

bool is_integer(const std::string& word) {
  return !word.empty() &&
         std::ranges::all_of(word, [](unsigned char c) { return std::isdigit(c); });
}

// The tokenizer takes a number without a point for an integer, and "1e20" for the integer 1.
bool is_decimal(const std::string& word) {
  std::size_t end = 0;
  try {
    std::stod(word, &end);
  } catch (const std::exception&) {
    return false;
  }
  const bool begins_so = std::isdigit(static_cast<unsigned char>(word[0])) || word[0] == '-';
  return begins_so && end == word.size() && word.find('.') != std::string::npos;
}

class Reader {
 public:
  explicit Reader(const std::string& text) : lines_(text) {}

  AmberScript read() {
    try {
      if (next_line() != "#!amber") fail("the first line is #!amber");
      while (const auto words = next_words()) command(*words);
    } catch (const std::runtime_error& error) {
      script_.error = error.what();
    }
    return script_;
  }

 private:
  [[noreturn]] void fail(const std::string& what) const {
    throw std::runtime_error("line " + std::to_string(number_) + ": " + what);
  }
  void require(bool holds, const std::string& what) const {
    if (!holds) fail(what);
  }

  std::string next_line() {
    std::string line;
    has_line_ = static_cast<bool>(std::getline(lines_, line));
    ++number_;
    return line;
  }

  // Those of the next line that has some.
  std::optional<Words> next_words() {
    while (true) {
      const std::string line = next_line();
      if (!has_line_) return std::nullopt;
      Words words = words_of(line);
      if (!words.empty()) return words;
    }
  }

  Words words_before_end() {
    std::optional<Words> words = next_words();
    require(words.has_value(), "END is missing");
    return *words;
  }

  void command(const Words& w) {
    if (w[0] == "DEVICE_FEATURE") return feature(w);
    if (w[0] == "SHADER") return shader(w);
    if (w[0] == "BUFFER") return buffer(w);
    if (w[0] == "PIPELINE") return pipeline(w);
    if (w[0] == "RUN") return run(w);
    if (w[0] == "EXPECT") return expect(w);
    require(w.size() > 1 && pipelines_.contains(w[1]), "no pipeline " + w.back());
    if (w[0] == "CLEAR_COLOR") return colour(w, 2);
    if (w[0] == "CLEAR_DEPTH") return require(w.size() == 3 && is_decimal(w[2]), "a depth");
    require(w[0] == "CLEAR" && w.size() == 2, "unknown command " + w[0]);
  }

  void feature(const Words& w) const {
    static const std::set<std::string> kKnown = {"depthClamp", "shaderClipDistance",
                                                 "geometryShader", "largePoints",
                                                 "fragmentStoresAndAtomics"};
    require(w.size() == 2 && kKnown.contains(w[1]), "unknown feature");
  }

  void shader(const Words& w) {
    require(w.size() == 4 && (w[1] == "vertex" || w[1] == "fragment") && w[3] == "GLSL",
            "SHADER {type} {name} GLSL");
    std::string source;
    for (std::string line = next_line(); line != "END"; line = next_line()) {
      require(has_line_, "END is missing");
      source += line + "\n";
    }
    require(source.starts_with("#version 450\n"), "a version");
    require(shaders_.emplace(w[2], w[1]).second, "two shaders " + w[2]);
    script_.shaders.push_back({w[1], source});
  }

  void buffer(const Words& w) {
    require(w.size() >= 4, "BUFFER {name} ...");
    require(buffers_.emplace(w[1], w[2] + " " + w[3]).second, "two buffers " + w[1]);
    if (w[2] == "FORMAT") {
      static const std::set<std::string> kFormats = {"R8G8B8A8_UNORM", "D32_SFLOAT"};
      return require(w.size() == 4 && kFormats.contains(w[3]), "unknown format");
    }
    require(w.size() == 5 && w[2] == "DATA_TYPE" && w[4] == "DATA", "DATA_TYPE {type} DATA");
    const bool is_vector = w[3] == "vec4<float>";
    require(is_vector || w[3] == "uint32", "unknown type");
    std::size_t count = 0;
    for (Words values = words_before_end(); values != Words{"END"}; values = words_before_end()) {
      for (const std::string& value : values) {
        require(is_vector ? is_decimal(value) : is_integer(value), "no number: " + value);
        ++count;
      }
    }
    require(count > 0 && count % (is_vector ? 4 : 1) == 0, "components are missing");
    counts_[w[1]] = count / (is_vector ? 4 : 1);
  }

  void pipeline(const Words& w) {
    require(w.size() == 3 && w[1] == "graphics", "PIPELINE graphics {name}");
    std::map<std::string, std::string>& has = pipelines_[w[2]];
    require(has.empty(), "two pipelines " + w[2]);
    for (Words line = words_before_end(); line != Words{"END"}; line = words_before_end()) {
      in_pipeline(line, has);
    }
    require(has.contains("vertex") && has.contains("fragment"), "a shader is missing");
    require(has.contains("colour") && has.contains("0"), "a colour or vertices are missing");
  }

  void in_pipeline(const Words& w, std::map<std::string, std::string>& has) {
    if (w[0] == "ATTACH") {
      require(w.size() == 2 && shaders_.contains(w[1]), "no shader " + w.back());
      require(has.emplace(shaders_[w[1]], w[1]).second, "two shaders of a stage");
    } else if (w[0] == "FRAMEBUFFER_SIZE") {
      require(w.size() == 3 && is_integer(w[1]) && is_integer(w[2]), "a size");
    } else if (w[0] == "VIEWPORT") {
      require(w.size() == 6 && w[3] == "SIZE" && is_decimal(w[1]) && is_decimal(w[2]) &&
                  is_decimal(w[4]) && is_decimal(w[5]),
              "VIEWPORT {x} {y} SIZE {width} {height}");
    } else if (w[0] == "BIND") {
      bind(w, has);
    } else if (w[0] == "VERTEX_DATA") {
      require(w.size() == 4 && counts_.contains(w[1]) && w[2] == "LOCATION" && is_integer(w[3]),
              "VERTEX_DATA {buffer} LOCATION {number}");
      has[w[3]] = w[1];
    } else if (w[0] == "INDEX_DATA") {
      require(w.size() == 2 && buffers_[w[1]] == "DATA_TYPE uint32", "INDEX_DATA {buffer}");
      has["indices"] = w[1];
    } else {
      require(w.size() == 1, "unknown in a pipeline: " + w[0]);
      block(w[0]);
    }
  }

  void bind(const Words& w, std::map<std::string, std::string>& has) {
    require(w.size() >= 5 && w[1] == "BUFFER" && w[3] == "AS", "BIND BUFFER {name} AS ...");
    if (w[4] == "storage") {
      return require(w.size() == 9 && buffers_[w[2]] == "DATA_TYPE uint32" &&
                         w[5] == "DESCRIPTOR_SET" && w[6] == "0" && w[7] == "BINDING" &&
                         w[8] == "0",
                     "BIND BUFFER {name} AS storage DESCRIPTOR_SET 0 BINDING 0");
    }
    const bool is_colour = w[4] == "color" && w.size() == 7 && w[5] == "LOCATION" && w[6] == "0";
    const bool is_depth = w[4] == "depth_stencil" && w.size() == 5;
    require(is_colour ? buffers_[w[2]] == "FORMAT R8G8B8A8_UNORM"
                      : is_depth && buffers_[w[2]] == "FORMAT D32_SFLOAT",
            "no such image " + w[2]);
    has[is_colour ? "colour" : "depth"] = w[2];
  }

  void block(const std::string& name) {
    using Values = std::set<std::string>;
    const Values on_off = {"on", "off"};
    const std::map<std::string, std::map<std::string, Values>> blocks = {
        {"DEPTH",
         {{"TEST", on_off},
          {"WRITE", on_off},
          {"CLAMP", on_off},
          {"COMPARE_OP", {"less", "greater", "always"}}}}};
    require(blocks.contains(name), "unknown in a pipeline: " + name);
    const std::map<std::string, Values>& options = blocks.at(name);
    for (Words w = words_before_end(); w != Words{"END"}; w = words_before_end()) {
      require(w.size() == 2 && options.contains(w[0]) && options.at(w[0]).contains(w[1]),
              "unknown in " + name + ": " + w[0]);
    }
  }

  void run(const Words& w) {
    static const std::set<std::string> kTopologies = {
        "POINT_LIST", "LINE_LIST", "LINE_STRIP", "TRIANGLE_LIST", "TRIANGLE_STRIP", "TRIANGLE_FAN"};
    require(w.size() >= 9 && pipelines_.contains(w[1]), "RUN {pipeline} ...");
    const bool is_indexed = w[5] == "INDEXED";
    Words rest(w.begin() + (is_indexed ? 6 : 5), w.end());
    require(w[2] == "DRAW_ARRAY" && w[3] == "AS" && kTopologies.contains(w[4]),
            "DRAW_ARRAY AS {topology}");
    require(rest.size() == 4 && rest[0] == "START_IDX" && rest[1] == "0" && rest[2] == "COUNT" &&
                is_integer(rest[3]),
            "START_IDX 0 COUNT {count}");
    std::map<std::string, std::string>& has = pipelines_[w[1]];
    require(is_indexed == has.contains("indices"), "indices");
    require(std::stoul(rest[3]) == counts_[has[is_indexed ? "indices" : "0"]], "another count");
    ++script_.runs;
  }

  void colour(const Words& w, std::size_t first) const {
    require(w.size() == first + 4, "four components");
    for (std::size_t i = first; i < w.size(); ++i) {
      require(is_integer(w[i]) && std::stoi(w[i]) <= 255, "no component of a colour: " + w[i]);
    }
  }

  void expect(const Words& w) {
    require(w.size() > 2 && w[2] == "IDX", "EXPECT {buffer} IDX ...");
    if (buffers_[w[1]] == "DATA_TYPE uint32") {
      static const std::set<std::string> kComparators = {"EQ", "GE", "LE"};
      require(w.size() == 6 && w[3] == "0" && kComparators.contains(w[4]) && is_integer(w[5]),
              "EXPECT {buffer} IDX 0 {comparator} {value}");
    } else {
      require(w.size() == 13 && buffers_[w[1]] == "FORMAT R8G8B8A8_UNORM" && is_integer(w[3]) &&
                  is_integer(w[4]) && w[5] == "SIZE" && w[6] == "1" && w[7] == "1" &&
                  w[8] == "EQ_RGBA",
              "EXPECT {buffer} IDX {x} {y} SIZE 1 1 EQ_RGBA ...");
      colour(w, 9);
    }
    ++script_.expectations;
  }

  std::istringstream lines_;
  bool has_line_ = true;
  int number_ = 0;
  AmberScript script_;
  std::map<std::string, std::string> shaders_, buffers_;  // stages, and what they are of
  std::map<std::string, std::size_t> counts_;             // elements of a buffer with data
  std::map<std::string, std::map<std::string, std::string>> pipelines_;
};

}  // namespace

AmberScript read_amber(const std::string& text) { return Reader(text).read(); }

}  // namespace clipscope::experiments
