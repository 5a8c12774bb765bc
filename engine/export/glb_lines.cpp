#include "engine/export/glb_lines.h"

#include "engine/export/glb_accessor.h"
#include "engine/export/gltf_frame.h"
#include "engine/export/gltf_scene.h"

#include <fmt/core.h>

namespace tractus::exports {

namespace {

// Maximum number of lines in a file, counting those of all instances.
constexpr std::size_t kMaxLines = std::size_t { 1 } << 24;

// Returns the vertices of a primitive in the order in which lines connect them, in glTF's frame.
Result<std::vector<Vec3>> vertices_in_order(tinygltf::Model const& model,
                                            tinygltf::Primitive const& primitive)
{
    auto const positions = TRY(read_accessor<3>(model, accessor_of(primitive, "POSITION")));
    std::vector<Vec3> result;
    auto const add = [&](std::size_t i) {
        result.push_back(Eigen::Map<Vec3f const>(positions[i].data()).cast<double>());
    };
    if (primitive.indices < 0) {
        for (std::size_t i = 0; i < positions.size(); ++i)
            add(i);
    } else {
        for (auto const index : TRY(read_indices(model, primitive.indices, positions.size())))
            add(index);
    }
    return result;
}

// Appends the lines of a primitive, transformed by `place` and converted to our frame.
void add_lines(std::vector<Vec3> const& vertices, int mode, Affine const& place,
               std::vector<SkeletonPiece>& lines)
{
    auto const add = [&](std::size_t from, std::size_t to) {
        lines.push_back(
            { from_gltf(Vec3(place * vertices[from])), from_gltf(Vec3(place * vertices[to])) });
    };
    std::size_t const step = mode == TINYGLTF_MODE_LINE ? 2 : 1;
    for (std::size_t i = 0; i + 1 < vertices.size(); i += step)
        add(i, i + 1);
    if (mode == TINYGLTF_MODE_LINE_LOOP && vertices.size() > 2)
        add(vertices.size() - 1, 0);
}

} // namespace

Result<std::vector<SkeletonPiece>> read_glb_lines(std::string const& name, std::string_view bytes)
{
    auto const model = TRY(parse_glb(bytes));
    auto const places = TRY(find_places(model));
    std::vector<SkeletonPiece> lines;
    for (std::size_t i = 0; i < places.size(); ++i)
        for (auto const& primitive : model.meshes[i].primitives) {
            if (primitive.mode < TINYGLTF_MODE_LINE || primitive.mode > TINYGLTF_MODE_LINE_STRIP)
                continue;
            auto const vertices = TRY(vertices_in_order(model, primitive));
            if (vertices.size() * places[i].size() > kMaxLines - lines.size())
                return fail_reading(fmt::format("it expands to more than {} lines", kMaxLines));
            for (auto const& place : places[i])
                add_lines(vertices, primitive.mode, place, lines);
        }
    if (lines.empty())
        return fail(Fault::User,
                    fmt::format("{}: there are no lines; export the skeleton's edges as lines, not "
                                "as triangles",
                                name));
    return lines;
}

} // namespace tractus::exports
