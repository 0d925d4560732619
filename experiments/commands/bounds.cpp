// SPDX-License-Identifier: GPL-3.0-or-later
//
// clipscope bounds: bounding volumes against a view volume, or their screen rectangles, beside the
// exact answer.
#include <optional>
#include <string>
#include <vector>

#include "experiments/bounds/rectangle.hpp"
#include "experiments/bounds/solid.hpp"
#include "experiments/commands/options.hpp"

namespace clipscope::experiments::commands {
namespace {

using bounds::AnswerRow;
using bounds::RectangleRow;
using bounds::Region;
using bounds::Solid;
using bounds::SolidKind;

struct BoundsOptions {
  PrimitiveTextOptions text;
  Selection selection;
  std::optional<std::string> scene;
  bool screen = false;
  std::optional<std::array<double, 2>> viewport;
  std::optional<std::string> out;
  CLI::App* command = nullptr;
};

// Errors: UsageError if no volume is given, or one that encloses nothing.
Region region_of_options(const BoundsOptions& options) {
  const Batch batch = described_batch(options.text);
  if (!batch.matrix) return bounds::region_of(frustum_cast<float>(batch.frustum));
  const Region region = bounds::region_of(batch.volume.depth, matrix_cast<float>(*batch.matrix));
  if (region.hull.known) return region;
  usage_error("--matrix: it is singular, or can't be told from one that is; it has no view volume");
}

// Errors: InputError.
std::vector<Solid> read_solids(const std::string& file) {
  std::vector<Solid> solids;
  for (const TextLine& line : read_lines(file)) {
    std::vector<float> numbers;
    for (std::size_t i = 1; i < line.words.size(); ++i) {
      numbers.push_back(static_cast<float>(parse_number(line.words[i], true, line.place)));
    }
    solids.push_back(bounds::solid_of(line.place, line.words[0], std::move(numbers)));
  }
  if (solids.empty()) {
    throw InputError(
        fmt::format("{}: there is no solid in it; expected lines such as 'sphere 0 0 -5 1'",
                    file == "-" ? "standard input" : file));
  }
  return solids;
}

// The corners of a mesh's triangles, three each, as a view sees them; as they are without one.
std::vector<Vec3<float>> corners_of(const Scene& scene, const View& view) {
  std::vector<SceneTriangle> triangles(scene.mesh.triangles.size());
  view_triangles(scene, view, 0, triangles);
  std::vector<Vec3<float>> corners;
  for (const SceneTriangle& triangle : triangles) {
    for (const auto& vertex : triangle) corners.push_back(vertex.position);
  }
  return corners;
}

// A box or a sphere as a solid of that name.
Solid solid_of(const std::string& name, const bounds::Bound& bound) {
  Solid solid{fmt::format("{}, {}", name, bound.name), SolidKind::box, {}};
  const auto append = [&](const Vec3<float>& v) {
    solid.numbers.insert(solid.numbers.end(), {v[0], v[1], v[2]});
  };
  if (const auto* box = std::get_if<AxisBox<float>>(&bound.volume)) {
    append(box->lower);
    append(box->upper);
  } else if (const auto* sphere = std::get_if<Sphere<float>>(&bound.volume)) {
    solid.kind = SolidKind::sphere;
    append(sphere->centre);
    solid.numbers.push_back(sphere->radius);
  } else {
    const auto& oriented = std::get<OrientedBox<float>>(bound.volume);
    solid.kind = SolidKind::obb;
    append(oriented.centre);
    for (int i = 0; i < 3; ++i) {
      append(oriented.half[i] * oriented.axes[static_cast<std::size_t>(i)]);
    }
  }
  return solid;
}

// What the table is made of: rows of answers, or of rectangles.
class Tables {
 public:
  explicit Tables(const BoundsOptions& options) : options_(options) {}

  void add(const Region& region, const Solid& solid) {
    if (options_.screen) return add_rectangles(region, solid);
    const Visibility content = bounds::exact_answer(region, solid);
    for (const bounds::Bound& bound : bounds::bounds_of(solid)) {
      answers_.add(bounds::answer_row(region, solid.name, bound, content));
    }
  }

  void add(const Region& region, const std::string& name, std::span<const Vec3<float>> corners) {
    const std::vector<bounds::Bound> around = bounds::bounds_around(corners);
    const Visibility content = bounds::exact_answer(region, corners);
    for (const bounds::Bound& bound : around) {
      if (options_.screen) add_rectangles(region, solid_of(name, bound));
      if (!options_.screen) answers_.add(bounds::answer_row(region, name, bound, content));
    }
  }

  void print() const {
    const Table& table = options_.screen ? static_cast<const Table&>(rectangles_) : answers_;
    print_table(table, options_.selection.json, options_.out);
  }

 private:
  void add_rectangles(const Region& region, const Solid& solid) {
    for (const RectangleRow& row : bounds::rectangle_rows(region, solid, options_.viewport)) {
      rectangles_.add(row);
    }
  }

  const BoundsOptions& options_;
  TableOf<AnswerRow> answers_;
  TableOf<RectangleRow> rectangles_;
};

// Through the scene's own views, or as the mesh is where a projection is given.
void add_scene(const BoundsOptions& options, Tables& tables) {
  const Scene scene = load_selected_scene(options.selection, *options.scene);
  if (!options.text.projections.empty()) {
    View as_given;
    tables.add(region_of_options(options), scene.name, corners_of(scene, as_given));
    return;
  }
  for (const View& view : scene.views) {
    const Region region = view.matrix ? bounds::region_of(view.frustum.depth, *view.matrix)
                                      : bounds::region_of(view.frustum);
    tables.add(region, view.label, corners_of(scene, view));
  }
}

int show_bounds(const BoundsOptions& options) {
  Tables tables(options);
  if (options.scene) {
    if (options.command->count("file") > 0) {
      usage_error("--scene: its mesh is what is bounded; leave out the file {}", options.text.file);
    }
    add_scene(options, tables);
  } else {
    const Region region = region_of_options(options);
    for (const Solid& solid : read_solids(options.text.file)) tables.add(region, solid);
  }
  tables.print();
  return kExitOk;
}

constexpr const char* kBoundsFooter =
    R"(Input, a solid per line, in the space of the frustum or the matrix:
  box X0 Y0 Z0 X1 Y1 Z1                             axis-aligned, lower and upper corner
  sphere X Y Z R
  obb CX CY CZ  UX UY UZ  VX VY VZ  WX WY WZ        centre and three half axes
  points X Y Z ...  and  polygon X Y Z ...          what is bounded by a box, a sphere and an obb
Numbers are decimal or C99 hex floats, rounded once to float. With --scene the mesh is bounded, as
its views see it; with a projection, too, as it is.
A test says rejected, accepted or look closer; beside it is the answer of exact arithmetic, of the
bound and of its content, and which test's look closer was needless.
Examples:
  echo 'box 4 0 -5 9 1 -4' | clipscope bounds --perspective 90,1,1,10
  echo 'sphere 0 0 0 2' | clipscope bounds --frustum -1,1,-1,1,1,10 --viewport 640x480
  clipscope bounds --scene teapot --quick)";

}  // namespace

void add_bounds_command(CLI::App& app, Action& action) {
  const auto [command, options] = add_command(
      app, action, show_bounds, "bounds",
      "Bounding volumes against a view volume, and their screen rectangles", kBoundsFooter);
  options.command = &command;
  add_projection_options(command, options.text);
  add_option(command, "--scene", options.scene, "NAME|FILE",
             "Bound the mesh of this scene or file instead of solids");
  command.add_option("--seed", options.selection.seed, "Seed of the random scenes [1]");
  command.add_flag("--quick", options.selection.quick, "The smaller scene of `--quick` runs");
  command.add_flag("--screen", options.screen, "Screen rectangles instead, in NDC");
  const auto set = [&to = options](const std::array<double, 2>& viewport) {
    to.screen = true;
    to.viewport = viewport;
  };
  add_viewport_option(command, set, "Screen rectangles instead, in NDC and in pixels");
  add_json_option(command, options.selection);
  add_out_option(command, options.out);
  add_option(command, "file", options.text.file, "FILE", "Solids, one per line [standard input]");
}

}  // namespace clipscope::experiments::commands
