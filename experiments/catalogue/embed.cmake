# Writes OUTPUT, the text files of the list FILES as initializers of pairs: their names from ROOT, their texts.
# cmake -D OUTPUT=... -D ROOT=... -D FILES=... -P embed.cmake
set(source "// Written by embed.cmake.\n")
foreach(file IN LISTS FILES)
  file(READ "${file}" text)
  file(RELATIVE_PATH name "${ROOT}" "${file}")
  string(APPEND source "{\"${name}\", R\"corpus(${text})corpus\"},\n")
endforeach()
file(WRITE "${OUTPUT}" "${source}")
