#include "app/python/plant_class.h"

#include "app/batch/pictures.h"
#include "app/batch/plant_file.h"
#include "app/batch/plant_report.h"
#include "app/python/arrays.h"
#include "app/python/errors.h"
#include "app/python/mesh_classes.h"
#include "app/python/plant_arrays.h"
#include "engine/base/file.h"
#include "engine/mesh/make_mesh.h"
#include "engine/plant/mtg.h"

#include <array>
#include <filesystem>
#include <fmt/format.h>
#include <optional>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>
#include <sstream>
#include <string_view>
#include <utility>
#include <vector>

namespace tractus::python {

namespace {

namespace py = pybind11;
using namespace pybind11::literals;

// A shape of organs, in the words of .mtg files.
struct ShapeHandle {
    std::string name;
    std::string kind;
    std::string material;
    double length_mm = 0;
    double width_mm = 0;
    double petiole_mm = 0;
};

std::vector<ShapeHandle> organ_shapes(PlantHandle const& handle)
{
    constexpr std::array<std::string_view, 6> kKinds { "blade", "needle",  "disc",
                                                       "ball",  "surface", "leaf" };
    std::vector<ShapeHandle> shapes;
    for (auto const& shape : handle.plant->organ_shapes)
        shapes.push_back({ shape.name, std::string(kKinds.at(static_cast<std::size_t>(shape.kind))),
                           handle.plant->materials.at(shape.material).name, shape.length_mm,
                           shape.width_mm, shape.petiole_mm });
    return shapes;
}

std::vector<std::string> material_names_of(PlantHandle const& handle)
{
    std::vector<std::string> names;
    for (auto const& material : handle.plant->materials)
        names.push_back(material.name);
    return names;
}

// The corners of the plant's box, lowest first; None for an empty plant.
py::object bounds_of(PlantHandle const& handle)
{
    auto const box = bounds(*handle.plant);
    if (box.empty())
        return py::none();
    return take_array(std::vector<double> { box.min_mm.x(), box.min_mm.y(), box.min_mm.z(),
                                            box.max_mm.x(), box.max_mm.y(), box.max_mm.z() },
                      { 2, 3 });
}

py::object measures_of(PlantHandle const& handle)
{
    auto const report = without_gil([&] { return batch::print_plant_report(*handle.plant); });
    return py::module_::import("json").attr("loads")(report);
}

std::string mtg_of(PlantHandle const& handle)
{
    return without_gil([&] {
        std::ostringstream out;
        write_mtg(out, *handle.plant);
        return std::move(out).str();
    });
}

PlantHandle plant_from_mtg(std::string const& text, std::string const& name)
{
    auto plant = value_of(without_gil([&] { return parse_mtg(name, text); }));
    return { std::make_shared<Plant const>(std::move(plant)), name };
}

// How a plant is saved, as Python says it.
struct SaveOptions {
    std::optional<std::string> organs;
    std::string vertices;
    bool has_textures = true;
    batch::PlantFileOptions file {};
};

// Returns the place of a word in a list, which is that of an enumerator. Fails with a user error if
// it is none of them.
Result<std::size_t> word_number(std::string const& option, std::string const& word,
                                std::vector<std::string> const& words)
{
    for (std::size_t i = 0; i < words.size(); ++i)
        if (words[i] == word)
            return i;
    return fail(Fault::User,
                fmt::format("{} is {}: it must be {}", option, word, batch::listed(words)));
}

Result<void> check_picture_size(batch::PictureSize const& size)
{
    auto const fits = [](int side) {
        return side >= batch::PictureSize::kSmallest_px && side <= batch::PictureSize::kLargest_px;
    };
    if (fits(size.width_px) && fits(size.height_px))
        return {};
    return fail(Fault::User,
                fmt::format("a picture of {} by {} pixels cannot be made: its sides have {} to {}",
                            size.width_px, size.height_px, batch::PictureSize::kSmallest_px,
                            batch::PictureSize::kLargest_px));
}

Result<batch::WrittenFile> save(PlantHandle const& handle, std::filesystem::path const& path,
                                SaveOptions options)
{
    using Organs = exports::GlbOptions::Organs;
    auto& file = options.file;
    if (!batch::is_plant_file(path))
        return fail(Fault::User,
                    fmt::format("{}: a plant is written as {}", path.string(),
                                batch::listed(batch::plant_endings())));
    TRY(check_picture_size(file.picture));
    if (options.organs) {
        auto const number
            = TRY(word_number("organs", *options.organs, { "merged", "instanced", "nodes" }));
        file.glb.organs = static_cast<Organs>(number);
        file.usd.organs = file.glb.organs == Organs::Instanced
            ? exports::UsdOptions::Organs::Instanced
            : exports::UsdOptions::Organs::Merged;
    }
    file.glb.vertices = static_cast<exports::GlbOptions::Vertices>(
        TRY(word_number("vertices", options.vertices, { "float", "quantized", "compressed" })));
    if (!options.has_textures)
        file.glb.textures = exports::GlbOptions::Textures::None;
    TRY(check_writable(path));
    return batch::write_plant_file(*handle.plant, handle.name, path, file);
}

batch::WrittenFile save_plant(PlantHandle const& handle, std::filesystem::path const& path,
                              std::optional<std::string> organs, std::string vertices,
                              bool textures, int bark_size, int width, int height, bool watertight,
                              std::optional<double> least_thickness_mm,
                              std::optional<double> print_height_mm, bool without_leaves)
{
    if (least_thickness_mm)
        check_range("least_thickness_mm", *least_thickness_mm, 0.001, 100'000);
    if (print_height_mm)
        check_range("print_height_mm", *print_height_mm, 0.1, 1e6);
    check_range("bark_size", bark_size, 64, exports::kMaxBarkPicture_px);
    SaveOptions options { std::move(organs), std::move(vertices), textures };
    options.file.glb.bark_px = bark_size;
    options.file.picture = { width, height };
    options.file.solid = { watertight, least_thickness_mm, print_height_mm, without_leaves };
    return value_of(without_gil([&] { return save(handle, path, std::move(options)); }));
}

Result<render::Image> picture_of(PlantHandle const& handle, batch::PictureSize const& size)
{
    TRY(check_picture_size(size));
    auto pictures = TRY(batch::PictureMaker::create());
    return pictures.plant(mesh::make_mesh(*handle.plant), size);
}

py::array picture_array(PlantHandle const& handle, int width, int height)
{
    auto const picture = std::make_shared<render::Image const>(value_of(without_gil([&] {
        return picture_of(handle, { width, height });
    })));
    static_assert(sizeof(render::Color) == 4);
    return show_array(picture, &picture->pixels().data()->red, { height, width, 4 });
}

py::bytes picture_file(PlantHandle const& handle)
{
    auto const png = value_of(without_gil([&]() -> Result<std::string> {
        auto const picture = TRY(picture_of(handle, { 640, 480 }));
        std::ostringstream out;
        TRY(render::write_png(out, picture));
        return std::move(out).str();
    }));
    return py::bytes(png);
}

void add_arrays(py::class_<PlantHandle>& plant)
{
    plant
        .def_property_readonly("node_positions_mm", &node_positions,
                               "(n, 3) float64: positions of the nodes, axis after axis, from base "
                               "to tip. Not copied.")
        .def_property_readonly("node_radii_mm", &node_radii,
                               "(n,) float32: radii of the nodes. Not copied.")
        .def_property_readonly("axes", &axis_records,
                               R"((a,) records: the axes, parents before children. Not copied.

first_node, first_segment, segment_count: an axis has segment_count + 1 nodes.
parent_segment, parent_axis: where it is attached, to the segment's end; -1: on the ground.
order: 0 for a trunk, the parent's plus 1 for a lateral.)")
        .def_property_readonly("axis_orders", &axis_orders,
                               "(a,) uint32: the branching order of each axis. Not copied.")
        .def_property_readonly(
            "axis_parents", &axis_parents,
            "(a,) int32: the parent of each axis; -1: on the ground. Not copied.")
        .def_property_readonly(
            "segment_materials", &segment_materials,
            "(s,) uint16: an index into `materials` for each segment. Not copied.")
        .def_property_readonly("segment_nodes", &segment_nodes,
                               "(s, 2) uint32: base and tip node of each segment. Made anew.")
        .def_property_readonly(
            "segment_parents", &segment_parents,
            "(s,) int32: the segment below each segment; -1: on the ground. Made anew.")
        .def_property_readonly("segment_axes", &segment_axes,
                               "(s,) uint32: the axis of each segment. Made anew.")
        .def_property_readonly("organs", &organ_records,
                               R"((o,) records: leaves, flowers and fruits. Not copied.

shape: an index into `organ_shapes`. segment: where it is attached; -1: on the ground.
position_mm: (3,). orientation: (4,), a quaternion x, y, z, w, from the organ's frame to the plant's.
scale: (3,). The organ's frame: +y along the organ, +x to its right, +z out of its upper side.)");
}

void add_files(py::class_<PlantHandle>& plant)
{
    plant
        .def("save", &save_plant, "path"_a, py::kw_only(), "organs"_a = py::none(),
             "vertices"_a = "float", "textures"_a = true, "bark_size"_a = exports::kBarkPicture_px,
             "width"_a = 1280, "height"_a = 960, "watertight"_a = false,
             "least_thickness_mm"_a = py::none(), "print_height_mm"_a = py::none(),
             "without_leaves"_a = false,
             R"(Write the plant in the format that the path's ending says: see plant_endings().

organs: "merged" (a .glb's default), "instanced" (a .usda's) or "nodes", as in `tractus grow`.
vertices: "float", "quantized" or "compressed", for .glb. textures, bark_size: of a .glb, the
latter in pixels, 64 to 2048.
width, height: of a .png, in pixels. watertight, least_thickness_mm, print_height_mm,
without_leaves: how a .stl or .ply is made solid, for printing.

Raises Error if the file cannot be written or an option is out of range.)")
        .def("to_mtg", &mtg_of,
             "The plant as text of a multiscale tree graph, as in the .mtg of `tractus grow`.")
        .def_static("from_mtg", &plant_from_mtg, "text"_a, "name"_a = "plant",
                    R"(The plant of a multiscale tree graph with positions (XX, YY, ZZ).

Raises Error, with the line, if the text is none.)")
        .def("mesh", &mesh_of_plant, "sides"_a = mesh::MeshOptions().max_sides, py::kw_only(),
             "subdivision"_a = mesh::MeshOptions().subdivision,
             R"(The plant's triangles.

sides: of the thickest tubes, 3 to 64. subdivision: into how many pieces a segment is divided where
its axis bends, 0 to 16. Raises Error if one is out of range.)")
        .def("picture", &picture_array, "width"_a = 1280, "height"_a = 960,
             R"((height, width, 4) uint8: a picture of the plant, sRGB with alpha, top row first.

Raises Error if the system has no OpenGL, or a side is not 16 to 8192.)")
        .def("_repr_png_", &picture_file, "A picture for notebooks.");
}

void add_shape(py::module_& module)
{
    py::class_<ShapeHandle>(module, "OrganShape", "The shape of a kind of organ, at scale 1.")
        .def_readonly("name", &ShapeHandle::name)
        .def_readonly("kind", &ShapeHandle::kind, "blade, needle, disc, ball, surface or leaf.")
        .def_readonly("material", &ShapeHandle::material, "The name of its material.")
        .def_readonly("length_mm", &ShapeHandle::length_mm, "From attachment to tip.")
        .def_readonly("width_mm", &ShapeHandle::width_mm)
        .def_readonly("petiole_mm", &ShapeHandle::petiole_mm);
}

void add_written_file(py::module_& module)
{
    using batch::WrittenFile;
    py::class_<WrittenFile>(module, "WrittenFile", "What Plant.save() wrote.")
        .def_readonly("triangles", &WrittenFile::triangles, "0 if the format has none.")
        .def_readonly("note", &WrittenFile::note,
                      "What the program says of the file; may be empty.");
}

} // namespace

void add_plant_class(py::module_& module)
{
    add_shape(module);
    add_written_file(module);
    py::class_<PlantHandle> plant(module, "Plant",
                                  R"(A plant: its skeleton and organs. It never changes.

Frame: right-handed, +z up, origin at the plant's base, millimetres. Arrays are read-only; those
that are not made anew show the plant's own memory, without a copy, and keep it alive.)");
    plant.def_readonly("name", &PlantHandle::name)
        .def_property_readonly("organ_shapes", &organ_shapes)
        .def_property_readonly("materials", &material_names_of, "The names of the materials.")
        .def_property_readonly(
            "bounds_mm", &bounds_of,
            "(2, 3) float64: lowest and highest corner of the nodes' and organs' box; None: empty.")
        .def("measures", &measures_of,
             "What `tractus grow --report` prints: heights in metres, diameter in millimetres.")
        .def("__repr__", [](PlantHandle const& handle) {
            return fmt::format("<tractus.Plant {}: {} axes, {} segments, {} organs>", handle.name,
                               handle.plant->axes.size(), handle.plant->segment_count(),
                               handle.plant->organs.size());
        });
    add_arrays(plant);
    add_files(plant);
}

} // namespace tractus::python
