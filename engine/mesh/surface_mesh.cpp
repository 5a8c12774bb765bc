#include "engine/mesh/surface_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

namespace tractus::mesh {
namespace {

constexpr int kMaxStrips = 24;
// Allowed deviation of the triangles from the surface at subdivision 1, as a share of the surface's
// size.
constexpr double kFlatness = 0.064;
// Vertices closer together than this share of the surface's size coincide.
constexpr double kSameVertex = 1e-5;

Eigen::AlignedBox3d box_of(OrganShape const& shape)
{
    Eigen::AlignedBox3d box;
    for (auto const& patch : shape.patches)
        for (auto const& point : patch.control)
            box.extend(point);
    return box;
}

// Returns the number of strips into which every patch is divided. It follows from the curvature: a
// cubic deviates from n chords by at most 6 / 8 of its second differences, divided by n squared.
int strip_count(OrganShape const& shape, double size, int subdivision)
{
    double bend = 0;
    auto const see = [&](Vec3 const& a, Vec3 const& b, Vec3 const& c) {
        bend = std::max(bend, (a - 2 * b + c).norm());
    };
    for (auto const& patch : shape.patches)
        for (std::size_t i = 0; i < 4; ++i)
            for (std::size_t k = 0; k < 2; ++k) {
                auto const& p = patch.control;
                see(p[4 * i + k], p[4 * i + k + 1], p[4 * i + k + 2]);
                see(p[i + 4 * k], p[i + 4 * (k + 1)], p[i + 4 * (k + 2)]);
            }
    double const fineness = std::max(1, subdivision);
    double const allowed = size * kFlatness / (fineness * fineness);
    return std::clamp(static_cast<int>(std::ceil(std::sqrt(0.75 * bend / allowed))), 1, kMaxStrips);
}

// The vertices of all patches, each patch with its own.
struct Grid {
    int strips = 1;
    std::vector<Vec3> positions;
    std::vector<Vec3> normals;
    // For each vertex, a coinciding vertex of a neighbouring patch with a lower index, or the
    // vertex itself.
    std::vector<std::size_t> same_as;

    std::size_t at(std::size_t patch, int i, int j) const
    {
        auto const width = static_cast<std::size_t>(strips) + 1;
        return (patch * width + static_cast<std::size_t>(i)) * width + static_cast<std::size_t>(j);
    }
    // Index of the k-th vertex on one side of a patch.
    std::size_t on_side(std::size_t patch, std::size_t side, int k) const
    {
        switch (side) {
        case BezierPatch::Above:
            return at(patch, 0, k);
        case BezierPatch::Below:
            return at(patch, strips, k);
        case BezierPatch::Left:
            return at(patch, k, 0);
        default:
            return at(patch, k, strips);
        }
    }
    std::size_t root(std::size_t vertex) const
    {
        while (same_as[vertex] != vertex)
            vertex = same_as[vertex];
        return vertex;
    }
};

// Returns the unit normal of a patch at (s, t). Where control points coincide, the patch may have
// no normal; then that of a point further inside the patch is used.
Vec3 unit_normal(BezierPatch const& patch, double s, double t, double size)
{
    for (double const inward : { 0.0, 0.01, 0.1, 0.5 }) {
        Vec3 const normal = patch.normal_at(s + inward * (0.5 - s), t + inward * (0.5 - t));
        double const length = normal.norm();
        if (length > 1e-9 * size * size)
            return normal / length;
    }
    return Vec3::UnitZ();
}

Grid sample(OrganShape const& shape, int strips, double size)
{
    Grid grid;
    grid.strips = strips;
    for (auto const& patch : shape.patches)
        for (int i = 0; i <= strips; ++i)
            for (int j = 0; j <= strips; ++j) {
                double const s = static_cast<double>(i) / strips;
                double const t = static_cast<double>(j) / strips;
                grid.positions.push_back(patch.at(s, t));
                grid.normals.push_back(unit_normal(patch, s, t, size));
            }
    grid.same_as.resize(grid.positions.size());
    std::iota(grid.same_as.begin(), grid.same_as.end(), std::size_t { 0 });
    return grid;
}

// Calls use(vertex, other) for each vertex on each seam between patches. `other`: the neighbouring
// patch's vertex at the same place of the seam.
template<typename Use> void for_each_seam_vertex(OrganShape const& shape, Grid const& grid, Use use)
{
    constexpr std::array<std::size_t, 4> kOpposite { BezierPatch::Below, BezierPatch::Above,
                                                     BezierPatch::Right, BezierPatch::Left };
    for (std::size_t patch = 0; patch < shape.patches.size(); ++patch)
        for (std::size_t side = 0; side < 4; ++side) {
            auto const neighbor = shape.patches[patch].neighbors[side];
            if (neighbor == BezierPatch::kNoPatch)
                continue;
            for (int k = 0; k <= grid.strips; ++k)
                use(grid.on_side(patch, side, k), grid.on_side(neighbor, kOpposite[side], k));
        }
}

void join_seams(OrganShape const& shape, Grid& grid, double size)
{
    // Only normals from grid.normals, those of single patches, are added, so that the order of the
    // seams does not matter.
    auto normals = grid.normals;
    for_each_seam_vertex(shape, grid, [&](std::size_t vertex, std::size_t other) {
        normals[vertex] += grid.normals[other];
    });
    for_each_seam_vertex(shape, grid, [&](std::size_t vertex, std::size_t other) {
        auto const a = grid.root(vertex);
        auto const b = grid.root(other);
        if (a != b && (grid.positions[a] - grid.positions[b]).norm() < kSameVertex * size) {
            grid.same_as[std::max(a, b)] = std::min(a, b);
            normals[std::min(a, b)] += normals[std::max(a, b)];
        }
    });
    for (std::size_t i = 0; i < normals.size(); ++i)
        if (double const length = normals[i].norm(); length > 1e-6)
            grid.normals[i] = normals[i] / length;
}

// The arrangement of patches in a rectangular grid.
struct PatchRows {
    struct Place {
        int row = 0;
        int column = 0;
    };
    std::vector<Place> places; // Position of each patch in the grid.
    int rows = 0;
    int columns = 0;
};

// Arranges the patches in a grid, by their neighbours. Returns no value if rows of patches have
// different lengths or are closed rings, or if the rows do not contain all patches.
std::optional<PatchRows> rows_of(std::vector<BezierPatch> const& patches)
{
    constexpr auto kNone = BezierPatch::kNoPatch;
    auto const first = std::find_if(patches.begin(), patches.end(), [](BezierPatch const& patch) {
        return patch.neighbors[BezierPatch::Above] == kNone
            && patch.neighbors[BezierPatch::Left] == kNone;
    });
    if (first == patches.end())
        return std::nullopt;
    PatchRows result { .places = std::vector<PatchRows::Place>(patches.size()) };
    std::vector<bool> is_placed(patches.size(), false);
    std::size_t count = 0;
    for (auto begin = static_cast<std::uint16_t>(first - patches.begin()); begin != kNone;
         begin = patches[begin].neighbors[BezierPatch::Below], ++result.rows) {
        int column = 0;
        for (auto at = begin; at != kNone; at = patches[at].neighbors[BezierPatch::Right]) {
            if (is_placed[at])
                return std::nullopt;
            is_placed[at] = true;
            result.places[at] = { result.rows, column++ };
            ++count;
        }
        if (result.rows > 0 && column != result.columns)
            return std::nullopt;
        result.columns = column;
    }
    return count == patches.size() ? std::optional(std::move(result)) : std::nullopt;
}

// Computes texture coordinates (u, v) of the vertices for TextureMapping::OnPatches.
class PatchTexture {
public:
    PatchTexture(std::vector<BezierPatch> const& patches, PatchRows rows, int strips)
        : rows_(std::move(rows))
        , strips_(strips)
    {
        // Sum of the directions along s over all patches. `right`: along t.
        Vec3 down = Vec3::Zero();
        Vec3 right = Vec3::Zero();
        for (auto const& patch : patches)
            for (std::size_t k = 0; k < 4; ++k) {
                down += patch.control[12 + k] - patch.control[k];
                right += patch.control[4 * k + 3] - patch.control[4 * k];
            }
        is_turned_ = std::fabs(down.y()) < std::fabs(right.y());
        is_u_back_ = (is_turned_ ? down : right).x() < 0;
        is_v_back_ = (is_turned_ ? right : down).y() < 0;
    }

    Vec2f at(std::size_t vertex) const
    {
        auto const width = static_cast<std::size_t>(strips_) + 1;
        auto const& place = rows_.places[vertex / (width * width)];
        auto const share = [&](int patch, std::size_t strip, int count) {
            return (patch + static_cast<double>(strip) / strips_) / count;
        };
        double v = share(place.row, vertex / width % width, rows_.rows);
        double u = share(place.column, vertex % width, rows_.columns);
        if (is_turned_)
            std::swap(u, v);
        return Vec2(is_u_back_ ? 1 - u : u, is_v_back_ ? 1 - v : v).cast<float>();
    }

private:
    PatchRows rows_;
    int strips_ = 1;
    bool is_turned_ = false; // True if rows of patches run along the organ instead of across it.
    bool is_u_back_ = false;
    bool is_v_back_ = false;
};

class SurfaceWriter {
public:
    SurfaceWriter(Grid const& grid, Eigen::AlignedBox3d const& box,
                  std::optional<PatchTexture> texture, TriangleMesh& mesh)
        : grid_(grid)
        , box_(box)
        , texture_(std::move(texture))
        , mesh_(mesh)
        , index_(grid.positions.size(), kUnwritten)
    {
    }

    // Writes the triangles of the front or the back of the surface. Those of the back have the
    // opposite orientation.
    void write(std::size_t patch_count, bool is_back)
    {
        std::fill(index_.begin(), index_.end(), kUnwritten);
        for (std::size_t patch = 0; patch < patch_count; ++patch)
            for (int i = 0; i < grid_.strips; ++i)
                for (int j = 0; j < grid_.strips; ++j) {
                    auto const a = vertex(grid_.at(patch, i, j), is_back);
                    auto const b = vertex(grid_.at(patch, i + 1, j), is_back);
                    auto const c = vertex(grid_.at(patch, i + 1, j + 1), is_back);
                    auto const d = vertex(grid_.at(patch, i, j + 1), is_back);
                    triangle(a, b, c, is_back);
                    triangle(a, c, d, is_back);
                }
    }

private:
    static constexpr std::uint32_t kUnwritten = 0xffffffff;

    std::uint32_t vertex(std::size_t in_grid, bool is_back)
    {
        auto const root = grid_.root(in_grid);
        if (index_[root] == kUnwritten) {
            index_[root] = static_cast<std::uint32_t>(mesh_.positions_mm.size());
            Vec3 const& position = grid_.positions[root];
            Vec3 const share = (position - box_.min()).cwiseQuotient(box_.sizes().cwiseMax(1e-9));
            mesh_.positions_mm.push_back(position.cast<float>());
            mesh_.normals.push_back(
                (is_back ? Vec3(-grid_.normals[root]) : grid_.normals[root]).cast<float>());
            mesh_.texture_coordinates.push_back(texture_ ? texture_->at(root)
                                                         : share.head<2>().cast<float>());
        }
        return index_[root];
    }

    // Adds a triangle, unless it is degenerate because the patch narrows to a point.
    void triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c, bool is_back)
    {
        auto const& p = mesh_.positions_mm;
        if (p[a] == p[b] || p[b] == p[c] || p[c] == p[a])
            return;
        if (is_back)
            std::swap(b, c);
        mesh_.indices.insert(mesh_.indices.end(), { a, b, c });
    }

    Grid const& grid_;
    Eigen::AlignedBox3d const& box_;
    std::optional<PatchTexture> texture_;
    TriangleMesh& mesh_;
    std::vector<std::uint32_t> index_; // For each vertex of the grid, its index in the mesh.
};

} // namespace

TriangleMesh surface_mesh(OrganShape const& shape, int subdivision, TextureMapping lies)
{
    TriangleMesh mesh;
    mesh.material = shape.material;
    auto const box = box_of(shape);
    double const size = box.isEmpty() ? 0 : box.diagonal().norm();
    if (!(size > 0))
        return mesh;
    auto grid = sample(shape, strip_count(shape, size, subdivision), size);
    join_seams(shape, grid, size);
    std::optional<PatchTexture> texture;
    if (lies == TextureMapping::OnPatches)
        if (auto rows = rows_of(shape.patches))
            texture.emplace(shape.patches, *std::move(rows), grid.strips);
    SurfaceWriter writer(grid, box, std::move(texture), mesh);
    writer.write(shape.patches.size(), false);
    if (shape.has_back)
        writer.write(shape.patches.size(), true);
    return mesh;
}

} // namespace tractus::mesh
