// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/scenes/text_file.hpp"

#include <cmath>
#include <limits>

#include "experiments/scenes/mesh_file.hpp"
#include "tests/catch.hpp"
#include "tests/experiments/scenes/mesh_bits.hpp"
#include "tests/experiments/scenes/messages.hpp"
#include "tests/experiments/scenes/sample_files.hpp"

namespace clipscope::experiments {
namespace {

const std::string kName = "a.txt";
const std::string kMark = "\xEF\xBB\xBF";

// "1:a b|2:c|": the words of each line behind its number.
std::string lines_of(const std::string& text, TextForm form = {}) {
  TextFile file(kName, text, form);
  std::string lines;
  while (file.next_words()) {
    lines += std::to_string(file.line()) + ":";
    for (const std::string_view word : file.words()) lines += std::string(word) + " ";
    lines.back() = '|';
  }
  return lines;
}

std::string with_line_ends(const std::string& text, const std::string& end) {
  std::string changed;
  for (const char c : text) changed += c == '\n' ? end : std::string(1, c);
  return changed;
}

// The text in UTF-16, each byte a unit of its own.
std::string as_utf16(const std::string& text, bool big_endian) {
  std::string wide;
  for (const char c : text) wide += big_endian ? std::string{'\0', c} : std::string{c, '\0'};
  return wide;
}

TEST_CASE("text files: lines end in LF, CRLF or CR, and are counted alike") {
  const std::string end = GENERATE("\n", "\r\n", "\r");
  CHECK(lines_of(with_line_ends("a b\n\n c\nd", end)) == "1:a b|3:c|4:d|");
}

TEST_CASE("text files: a text may mix its line ends") {
  CHECK(lines_of("a\nb\rc\r\nd") == "1:a|2:b|3:c|4:d|");
}

TEST_CASE("text files: behind CR line ends an LF belongs to what follows") {
  const std::string text = "ply\rend\r\nbytes";
  TextFile file(kName, text);
  file.next_line();
  file.next_line();
  CHECK(file.rest() == "\nbytes");
}

TEST_CASE("text files: a byte order mark is skipped, at the beginning alone") {
  CHECK(lines_of(kMark + "a b") == "1:a b|");
  CHECK(lines_of("a " + kMark + "b") == "1:a " + kMark + "b|");
}

TEST_CASE("text files: UTF-16 and UTF-32 are named, with a mark and without") {
  const auto refusal = [](const std::string& text) {
    return message_of<InputError>([&] { TextFile(kName, text); });
  };
  CHECK(contains(refusal("\xFF\xFE" + as_utf16("v 0", false)),
                 "a.txt: the text is UTF-16 (little-endian); UTF-8 or ASCII expected"));
  CHECK(contains(refusal("\xFE\xFF" + as_utf16("v 0", true)), "UTF-16 (big-endian)"));
  CHECK(contains(refusal(as_utf16("v 0", false)), "UTF-16 (little-endian)"));
  CHECK(contains(refusal(as_utf16("v 0", true)), "UTF-16 (big-endian)"));
  CHECK(contains(refusal(std::string("\xFF\xFE\0\0v\0\0\0", 8)), "UTF-32 (little-endian)"));
}

TEST_CASE("text files: a separator, comments and continued lines are read as the form says") {
  CHECK(lines_of("a,b#c\nd", {.separator = ',', .comment = '#'}) == "1:a b|2:d|");
  CHECK(lines_of("a \\\nb\\\nc\nd", {.continuation = '\\'}) == "1:a b c|4:d|");
  CHECK(lines_of("a # \\\nb", {.comment = '#', .continuation = '\\'}) == "1:a|2:b|");
}

TEST_CASE("text files: every format of text is read alike behind a mark and with any line ends") {
  const std::string end = GENERATE("\n", "\r\n", "\r");
  const std::string mark = GENERATE(std::string(), kMark);
  const FolderOfFiles folder;
  for (const SampleFile& file : sample_files()) {
    const bool is_text = file.name == "a.obj" || file.name == "text.ply" ||
                         file.name == "strips.ply" || file.name == "text.stl" ||
                         file.name == "a.gltf";
    if (!is_text) continue;
    INFO(file.name);
    const Mesh plain = load_mesh(folder.write(file.name, file.content));
    const Mesh mesh = load_mesh(folder.write(file.name, mark + with_line_ends(file.content, end)));
    CHECK(hash_of(mesh) == hash_of(plain));
    CHECK(mesh.triangles == plain.triangles);
    CHECK(contains(message_of<InputError>([&] {
                     load_mesh(folder.write(file.name, "\xFF\xFE" + as_utf16(file.content, false)));
                   }),
                   "UTF-16 (little-endian)"));
  }
}

TEST_CASE("text files: the header of a binary PLY file may have a mark and any line ends") {
  const std::string end = GENERATE("\r\n", "\r");
  const FolderOfFiles folder;
  const std::string plain = sample_ply_binary(false);
  const std::size_t body = plain.find("end_header\n") + 11;
  const std::string changed =
      kMark + with_line_ends(plain.substr(0, body), end) + plain.substr(body);
  CHECK(hash_of(load_mesh(folder.write("a.ply", changed))) ==
        hash_of(load_mesh(folder.write("b.ply", plain))));
}

TEST_CASE("text files: a number is rounded to float once, not by way of double") {
  const auto rounded = [](const char* word) { return to_float(word, *to_number(word)); };
  // Just above and just below halfway between 1 and the next float, by less than doubles tell.
  CHECK(rounded("1.000000059604644775390625000001") == std::nextafter(1.0f, 2.0f));
  CHECK(rounded("1.000000059604644775390624999999") == 1.0f);
  CHECK(rounded("1.000000059604644775390625") == 1.0f);
  CHECK(rounded("16777217.0000000000000001") == 16777218.0f);
  // The same for the smallest float.
  CHECK(rounded("7.0064923216240853546186479164495806564013097093825788587853e-46") == 0);
  CHECK(
      rounded(
          "7.00649232162408535461864791644958065640130970938257885878534141944895541342930300743319094181060791015626e-46") ==
      std::numeric_limits<float>::denorm_min());
  CHECK(std::signbit(rounded("-1e-400")));
}

TEST_CASE("text files: the largest float is one, also as nine digits have it") {
  CHECK(defect_of(*to_number("3.40282347e+38")).empty());
  CHECK(to_float("3.40282347e+38", 3.40282347e+38) == std::numeric_limits<float>::max());
  CHECK(contains(defect_of(3.4028236e38), "too large for a float"));
}

}  // namespace
}  // namespace clipscope::experiments
