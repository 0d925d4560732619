// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/render/image_library.hpp"

#include <dlfcn.h>
#include <fmt/format.h>

#include "experiments/errors.hpp"

namespace clipscope::experiments {
namespace {

namespace fs = std::filesystem;

// Beside an installed program, else where the build has put it.
fs::path module_path() {
  const fs::path program = fs::read_symlink("/proc/self/exe");
  const fs::path installed = program.parent_path() / CLIPSCOPE_INSTALLED_MODULE;
  return fs::exists(installed) ? installed : fs::path(CLIPSCOPE_BUILT_MODULE);
}

const ImageLibrary& open_module() {
  void* const module = dlopen(module_path().c_str(), RTLD_LAZY | RTLD_LOCAL);
  void* const entry = module != nullptr ? dlsym(module, "clipscope_image_library") : nullptr;
  if (entry == nullptr) {
    throw OutputError(
        fmt::format("pictures need OpenImageIO, and its module can't be opened: {}", dlerror()));
  }
  return *reinterpret_cast<decltype(&clipscope_image_library)>(entry)();
}

}  // namespace

const ImageLibrary& image_library() {
  static const ImageLibrary& library = open_module();
  return library;
}

}  // namespace clipscope::experiments
