// SPDX-License-Identifier: MIT
//
// Clips a mesh of two triangles with the installed batch clippers and checks the answer by hand.
#include <cstdint>
#include <cstdio>
#include <spaces/batch/batch.hpp>

int main() {
  using namespace clipscope;
  // x y z w and one attribute. The last vertex is to the right of the volume.
  const float vertices[] = {0, 0, 0, 1, 0, .5f, 0, 0, 1, 1, 0, .5f, 0, 1, 0, 2, .5f, 0, 1, 4};
  const std::uint32_t indices[] = {0, 1, 2, 1, 3, 2};
  batch::Output out;
  batch::clip(batch::Method::correctly_rounded, ClipVolume{},
              batch::IndexedMesh{{vertices, 4, 1}, indices}, out);
  // Both edges to that vertex meet x = w: from (0, 1/2) halfway, where the attribute is 2.
  bool has_middle = false;
  for (std::size_t i = 0; i < out.vertices().size(); i += out.stride()) {
    const float* v = &out.vertices()[i];
    has_middle = has_middle || (v[0] == 1 && v[1] == .5f && v[3] == 1 && v[4] == 2);
  }
  std::printf("inside %zu, cut %zu, on %s\n", out.inside().size(), out.polygons().size(),
              batch::target_name().c_str());
  return out.inside().size() == 1 && out.polygons().size() == 1 &&
                 out.polygon(0).size() == 4 * out.stride() && has_middle
             ? 0
             : 1;
}
