// SPDX-License-Identifier: GPL-3.0-or-later
//
// Mesh files: one is refused with a sentence, or it is sound.
#include "experiments/scenes/gltf_camera.hpp"
#include "experiments/scenes/mesh_file.hpp"
#include "tests/experiments/scenes/sound_mesh.hpp"
#include "tests/fuzz/harness.hpp"

namespace clipscope::fuzz {
namespace {

using experiments::Mesh;

void read_mesh(Mesh (*read)(const std::string&, std::string_view), const std::string& name,
               Bytes bytes) {
  read_or_refuse([&] {
    const Mesh mesh = read(name, text_of(bytes));
    require(experiments::is_sound(mesh), "{} was read, but its mesh is not sound", name);
  });
}

}  // namespace

void obj(Bytes bytes) { read_mesh(experiments::read_obj, "a.obj", bytes); }
void ply(Bytes bytes) { read_mesh(experiments::read_ply, "a.ply", bytes); }
void stl(Bytes bytes) { read_mesh(experiments::read_stl, "a.stl", bytes); }

void gltf(Bytes bytes) {
  const std::string name = "no such folder/a.gltf";  // so that it has no files beside it
  read_mesh(experiments::read_gltf_mesh, name, bytes);
  read_or_refuse([&] { experiments::read_gltf_cameras(name, text_of(bytes)); });
}

}  // namespace clipscope::fuzz
