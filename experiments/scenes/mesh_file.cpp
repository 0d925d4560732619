// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments/scenes/mesh_file.hpp"

#include "experiments/errors.hpp"

namespace clipscope::experiments {
Mesh load_mesh(const std::filesystem::path& path) {
  throw InputError(path.string() + ": mesh files are not read yet");
}
}  // namespace clipscope::experiments
