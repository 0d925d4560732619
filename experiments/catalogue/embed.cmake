# Writes OUTPUT, a C++ source that holds the text files of the list FILES, named from ROOT.
# cmake -D OUTPUT=... -D ROOT=... -D FILES=... -P embed.cmake
set(source [=[
// Written by embed.cmake.
#include "experiments/catalogue/embedded.hpp"

namespace clipscope::experiments {
namespace {

constexpr EmbeddedFile kFiles[] = {
]=])
foreach(file IN LISTS FILES)
  file(READ "${file}" text)
  file(RELATIVE_PATH name "${ROOT}" "${file}")
  string(APPEND source "    {\"${name}\", R\"corpus(${text})corpus\"},\n")
endforeach()
string(APPEND source [=[
};

}  // namespace

std::span<const EmbeddedFile> embedded_case_files() { return kFiles; }

}  // namespace clipscope::experiments
]=])
file(WRITE "${OUTPUT}" "${source}")
