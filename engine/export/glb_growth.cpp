#include "engine/export/glb_growth.h"

#include "engine/base/check.h"
#include "engine/base/parallel.h"
#include "engine/export/glb_column.h"
#include "engine/export/gltf_frame.h"
#include "engine/export/gltf_materials.h"
#include "engine/export/tangents.h"
#include "engine/export/texture.h"

#include <algorithm>
#include <fmt/format.h>
#include <optional>
#include <utility>

namespace tractus::exports {

namespace {

constexpr NumberFormat kVectors {};
constexpr NumberFormat kNumbers { ComponentType::Float, 1, false, 4 };
constexpr std::size_t kVerticesAtOnce = 16 << 10;

// Displacements of a surface's positions or normals from the whole plant to one age, in glTF's
// frame, and the limits of the displacements.
struct Steps {
    BulkVector<Vec3f> steps;
    Vec3f low = Vec3f::Zero();
    Vec3f high = Vec3f::Zero();

    bool is_nothing() const { return low.isZero(0) && high.isZero(0); }
    bool is_finite() const { return low.allFinite() && high.allFinite(); }
};

template<typename ToGltf>
void find_steps(std::span<Vec3f const> from, std::span<Vec3f const> to, ToGltf const& to_gltf,
                Steps& steps)
{
    steps.steps.resize(from.size());
    parallel_for(from.size(), kVerticesAtOnce, [&](std::size_t begin, std::size_t end) {
        for (auto i = begin; i != end; ++i)
            steps.steps[i] = to_gltf(Vec3f(to[i] - from[i]));
    });
    steps.low = steps.high = from.empty() ? Vec3f(Vec3f::Zero()) : steps.steps[0];
    // Sum of x - x over all displacements x: 0 if all are finite, otherwise NaN.
    Vec3f nothing = Vec3f::Zero();
    for (auto const& step : steps.steps) {
        steps.low = steps.low.cwiseMin(step);
        steps.high = steps.high.cwiseMax(step);
        nothing += step - step;
    }
    steps.low += nothing;
}

// One attempt to write a film's file with a given space for its JSON.
class FilmWriter {
public:
    FilmWriter(std::ostream& out, GrowthFilm const& film, std::uint64_t json_room)
        : film_(film)
        , json_room_(json_room)
        , stream_(out, json_room)
        , materials_(json_, stream_, film.textures == GlbOptions::Textures::Embedded,
                     kBarkPicture_px)
    {
    }

    Result<void> write();

    // Fills in the headers and the JSON. If the JSON exceeds its space, returns no value;
    // json_bytes() then returns the size of the JSON.
    Result<std::optional<GlbSummary>> finish();
    std::uint64_t json_bytes() const { return json_bytes_; }

private:
    std::vector<mesh::TriangleMesh> const& surfaces() const { return film_.mesh->whole().surfaces; }
    Result<void> add_surface(mesh::TriangleMesh const& surface);
    Result<std::size_t> add_steps(Steps const& steps, Json const& more);
    Result<void> add_age(double age);
    GlbColumn add_numbers(std::span<float const> values);
    void add_animation();

    GrowthFilm const& film_;
    std::uint64_t json_room_;
    GltfJson json_;
    GlbStream stream_;
    GltfMaterials materials_;
    Json primitives_ = Json::array(); // One glTF primitive for each surface.
    Json names_ = Json::array();      // Names of the morph targets.
    GlbSummary summary_;
    std::uint64_t json_bytes_ = 0;

    // Buffers for the age that is being written, reused for all ages.
    std::vector<mesh::AgedMesh::Vertices> vertices_;
    Steps positions_;
    Steps normals_;
};

auto fail_not_finite()
{
    return fail(Fault::Station, "cannot write the glTF file: a coordinate is not a finite number");
}

Result<void> FilmWriter::write()
{
    for (auto const& surface : surfaces())
        TRY(add_surface(surface));
    for (std::size_t i = 0; i + 1 < film_.ages.size(); ++i)
        TRY(add_age(film_.ages[i]));
    Json node;
    node["name"] = film_.name;
    bool const has_mesh = !primitives_.empty();
    bool const moves = has_mesh && !names_.empty();
    if (has_mesh) {
        Json mesh { { "name", film_.name }, { "primitives", std::move(primitives_) } };
        if (moves) {
            mesh["weights"] = Json(names_.size(), 0);
            mesh["extras"]["targetNames"] = names_;
        }
        node["mesh"] = json_.meshes.add(mesh);
    }
    json_.scene.push_back(json_.nodes.add(node));
    if (moves)
        add_animation();
    return stream_.check();
}

Result<void> FilmWriter::add_surface(mesh::TriangleMesh const& surface)
{
    auto const& material = film_.mesh->whole().materials[surface.material];
    SurfaceFormat const format {
        .tangents = film_.textures == GlbOptions::Textures::Embedded && has_relief(material),
    };
    auto triangles = view_of(surface);
    BulkVector<Eigen::Vector4f> tangents;
    if (format.tangents) {
        find_tangents(triangles, tangents);
        triangles.tangents = tangents;
    }
    EncodedPiece piece;
    encode_triangles(triangles, format, piece);
    if (!piece.is_finite)
        return fail_not_finite();
    auto const vertices = surface.positions_mm.size();
    std::array<GlbColumn, kTriangleColumns> columns {
        open_column(stream_, kVectors, vertices),
        open_column(stream_, kVectors, vertices),
        open_column(stream_, format.texture_coordinates(), vertices),
        open_column(stream_, format.indices(), surface.indices.size()),
    };
    if (format.tangents)
        columns[4] = open_column(stream_, format.tangent_vectors(), vertices);
    for (std::size_t i = 0; i < columns.size(); ++i)
        if (columns[i].count > 0)
            stream_.write(columns[i].block, piece.streams[i]);
    auto primitive = add_triangles(json_, columns, piece);
    primitive["material"] = materials_.index_of(material);
    primitives_.push_back(std::move(primitive));
    summary_.triangles += surface.triangle_count();
    return stream_.check();
}

Result<std::size_t> FilmWriter::add_steps(Steps const& steps, Json const& more)
{
    if (!steps.is_finite())
        return fail_not_finite();
    if (steps.is_nothing())
        return add_zeros(json_, kVectors, steps.steps.size(), more);
    auto column = open_column(stream_, kVectors, steps.steps.size());
    stream_.write(column.block, std::as_bytes(std::span(steps.steps)));
    return add_accessor(json_, column, kArrayBuffer, more);
}

Result<void> FilmWriter::add_age(double age)
{
    film_.mesh->at(film_.plant_at(age), vertices_);
    for (std::size_t i = 0; i < surfaces().size(); ++i) {
        find_steps(
            surfaces()[i].positions_mm, vertices_[i].positions_mm,
            [](Vec3f const& step) { return to_gltf(step); }, positions_);
        find_steps(
            surfaces()[i].normals, vertices_[i].normals,
            [](Vec3f const& step) { return turn_to_gltf(step); }, normals_);
        Json target;
        target["POSITION"]
            = TRY(add_steps(positions_, limits_json(positions_.low, positions_.high)));
        target["NORMAL"] = TRY(add_steps(normals_, Json::object()));
        primitives_[i]["targets"].push_back(std::move(target));
    }
    names_.push_back(fmt::format("age {:.4g}", age));
    return stream_.check();
}

GlbColumn FilmWriter::add_numbers(std::span<float const> values)
{
    auto column = open_column(stream_, kNumbers, values.size());
    stream_.write(column.block, std::as_bytes(values));
    return column;
}

// Animates the weights of the morph targets. At the time of each age only the target of that age
// has a weight, 1. At the last age, that of the whole plant, all weights are 0.
void FilmWriter::add_animation()
{
    auto const count = film_.ages.size();
    double const first = film_.ages.front();
    double const span = film_.ages.back() - first;
    std::vector<float> times;
    std::vector<float> weights(count * (count - 1), 0);
    for (std::size_t i = 0; i < count; ++i) {
        times.push_back(static_cast<float>(film_.seconds * (film_.ages[i] - first) / span));
        if (i + 1 < count)
            weights[i * (count - 1) + i] = 1;
    }
    auto const input
        = add_accessor(json_, add_numbers(times), kNoTarget,
                       { { "min", Json::array({ json_number(double { times[0] }) }) },
                         { "max", Json::array({ json_number(double { times.back() }) }) } });
    auto const output = add_accessor(json_, add_numbers(weights), kNoTarget);
    Json const sampler { { "input", input }, { "output", output }, { "interpolation", "LINEAR" } };
    Json const channel { { "sampler", 0 }, { "target", { { "node", 0 }, { "path", "weights" } } } };
    json_.animations.add({ { "name", "growth" },
                           { "samplers", Json::array({ sampler }) },
                           { "channels", Json::array({ channel }) } });
}

Result<std::optional<GlbSummary>> FilmWriter::finish()
{
    auto const text = json_.text(stream_.binary_bytes());
    json_bytes_ = text.size();
    if (text.size() > json_room_)
        return std::optional<GlbSummary>();
    TRY(stream_.finish(text));
    summary_.bytes = stream_.file_bytes();
    return std::optional(summary_);
}

// Fails if the file would be too large. Its size is that of the displacements of all vertices at
// all ages, plus an allowance for JSON and pictures.
Result<void> check_size(GrowthFilm const& film)
{
    constexpr double kRoom = 16 << 20; // Bytes for JSON and pictures.
    constexpr std::size_t kVector = sizeof(Vec3f);
    double bytes = kRoom;
    for (auto const& surface : film.mesh->whole().surfaces)
        bytes += static_cast<double>(surface.positions_mm.size()
                                         * (2 * kVector * film.ages.size() + sizeof(Vec2f))
                                     + surface.indices.size() * sizeof(std::uint32_t));
    if (bytes <= static_cast<double>(kMaxGlbBytes))
        return {};
    return fail(Fault::User,
                fmt::format("{} ages of this plant take up to {:.1f} GiB and a glTF file holds at "
                            "most 4: write fewer ages, or a file for each",
                            film.ages.size(), bytes / 0x1p30));
}

} // namespace

Result<GlbSummary> write_glb(std::ostream& out, GrowthFilm const& film)
{
    CHECK(film.mesh && !film.ages.empty() && film.seconds > 0);
    CHECK(std::is_sorted(film.ages.begin(), film.ages.end(), std::less_equal<>()));
    auto const start = out.tellp();
    if (start < 0)
        return fail(Fault::User,
                    "cannot write the glTF file: its stream cannot seek, so write to a file");
    TRY(check_size(film));
    auto const surfaces = film.mesh->whole().surfaces.size();
    std::uint64_t room = 4000 + (600 + surfaces * 1000) * (film.ages.size() + 2);
    while (true) {
        out.seekp(start);
        FilmWriter writer(out, film, (room + 3) / 4 * 4);
        TRY(writer.write());
        if (auto const summary = TRY(writer.finish()))
            return *summary;
        room = writer.json_bytes();
    }
}

} // namespace tractus::exports
