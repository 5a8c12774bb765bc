#include "engine/mesh/closed_shell.h"

#include "engine/base/parallel.h"
#include "engine/mesh/cube_table.h"
#include "engine/mesh/distance_field.h"

#include <algorithm>
#include <bitset>
#include <cmath>
#include <fmt/format.h>
#include <span>
#include <utility>

namespace tractus::mesh {

namespace {

constexpr double kCellShare = 0.4; // Width of a cell, as a share of the least thickness.

// The grid is stored in blocks of cells, where there are surfaces. A block has the points of its
// cells, and those on its far faces, which belong to its neighbours, too.
constexpr int kCells = 8;
constexpr int kPoints = kCells + 1;
constexpr std::size_t kPointsOfBlock = std::size_t { kPoints } * kPoints * kPoints;

// Limits on the number of blocks, about 20 million triangles, and of tests of shapes with blocks.
constexpr std::size_t kMostBlocks = 100'000;
constexpr double kMostTests = 3e7;

constexpr std::size_t kShapesAtOnce = 256;
constexpr std::size_t kBlocksAtOnce = 4;

// A vertex keeps this distance from the ends of its edge, as a share of the cell, so that no two
// vertices coincide.
constexpr float kClear = 0.01f;

using Cell = std::array<int, 3>;

std::size_t point_number(int x, int y, int z)
{
    return static_cast<std::size_t>((z * kPoints + y) * kPoints + x);
}

// A shape that is near a block.
struct NearShape {
    Cell block;
    std::uint32_t shape;
};

// The surface in one block. Its vertices are those on edges that begin at the points of its cells.
struct BlockSurface {
    Cell block {};
    std::bitset<kPointsOfBlock> inside;
    std::vector<std::uint16_t> edges; // 3 * the number of the edge's first point + its axis.
    std::vector<Vec3f> positions_mm;  // One per edge.
    std::vector<MaterialId> materials;
    std::uint32_t first_vertex = 0;
};

class ShellGrid {
public:
    ShellGrid(DistanceField const& field, double thickness_mm)
        : field_(field)
        , thickness_mm_(thickness_mm)
        , cell_mm_(kCellShare * thickness_mm)
    {
        Eigen::AlignedBox3f box;
        for (std::size_t i = 0; i < field.size(); ++i)
            box.extend(field.box_mm(i));
        if (!box.isEmpty())
            origin_mm_ = box.min().cast<double>() - Vec3::Constant(2 * cell_mm_);
    }

    Result<ClosedMesh> surface()
    {
        if (!find_blocks())
            return too_large();
        parallel_for(blocks_.size(), kBlocksAtOnce, [&](std::size_t begin, std::size_t end) {
            Field field;
            for (auto i = begin; i != end; ++i)
                find_vertices(i, field);
        });
        near_ = {};
        return joined();
    }

private:
    // Distances and materials at the points of a block.
    struct Field {
        std::array<float, kPointsOfBlock> distance_mm;
        std::array<MaterialId, kPointsOfBlock> material;
    };

    Vec3f point_mm(Cell const& block, int x, int y, int z) const
    {
        Vec3 const number(block[0] * kCells + x, block[1] * kCells + y, block[2] * kCells + z);
        return (origin_mm_ + cell_mm_ * number).cast<float>();
    }

    // Distance from a shape within which it determines where the surface is: edges are one cell
    // long.
    float margin_mm() const { return static_cast<float>(1.01 * cell_mm_); }

    // The blocks that a box and its margin touch: the first and the last along each axis.
    std::pair<Cell, Cell> blocks_at(Eigen::AlignedBox3f const& box) const
    {
        Cell first {};
        Cell last {};
        for (int axis = 0; axis < 3; ++axis) {
            auto const k = static_cast<std::size_t>(axis);
            double const side = kCells * cell_mm_;
            double const margin = double { margin_mm() };
            first[k] = static_cast<int>(
                std::floor((double { box.min()[axis] } - margin - origin_mm_[axis]) / side));
            last[k] = static_cast<int>(
                std::floor((double { box.max()[axis] } + margin - origin_mm_[axis]) / side));
        }
        return { first, last };
    }

    // Returns an error that names a thickness for which the grid is small enough.
    tl::unexpected<Error> too_large() const
    {
        constexpr double kStep = 1.2;
        double enough = kStep * thickness_mm_;
        while (!ShellGrid(field_, enough).find_blocks())
            enough *= kStep;
        enough *= kStep; // With thicker parts there are more blocks than were found.
        double const digit = std::pow(10, std::floor(std::log10(enough)) - 1);
        return fail(Fault::User,
                    fmt::format("the plant is too large for one closed shell with details of {:g} "
                                "mm: give a least thickness of {:g} mm or more, or leave the "
                                "leaves out",
                                thickness_mm_, std::ceil(enough / digit) * digit));
    }

    // Estimate of how many blocks add_blocks() tests.
    double count_tests() const
    {
        double tests = 0;
        for (std::size_t i = 0; i < field_.size(); ++i) {
            Vec3 const sides = field_.box_mm(i).sizes().cast<double>() / (kCells * cell_mm_);
            tests += (sides.array() + 1).prod();
        }
        return tests;
    }

    // Appends the blocks near a shape.
    void add_blocks(std::size_t shape, std::vector<NearShape>& found) const
    {
        auto const [first, last] = blocks_at(field_.box_mm(shape));
        auto const reach
            = static_cast<float>(0.5 * std::sqrt(3.0) * kCells * cell_mm_) + margin_mm();
        Cell block {};
        for (block[2] = first[2]; block[2] <= last[2]; ++block[2])
            for (block[1] = first[1]; block[1] <= last[1]; ++block[1])
                for (block[0] = first[0]; block[0] <= last[0]; ++block[0]) {
                    Vec3f const center = point_mm(block, kCells / 2, kCells / 2, kCells / 2);
                    if (field_.is_slow(shape) || field_.distance_mm(shape, center) <= reach)
                        found.push_back({ block, static_cast<std::uint32_t>(shape) });
                }
    }

    // Finds the blocks near shapes. Returns false if they are too many.
    bool find_blocks()
    {
        if (count_tests() > kMostTests)
            return false;
        std::vector<std::vector<NearShape>> found(field_.size() / kShapesAtOnce + 1);
        parallel_for(found.size(), 1, [&](std::size_t begin, std::size_t end) {
            for (auto i = begin; i != end; ++i)
                for (auto shape = i * kShapesAtOnce;
                     shape < std::min((i + 1) * kShapesAtOnce, field_.size()); ++shape)
                    add_blocks(shape, found[i]);
        });
        for (auto& some : found) {
            near_.insert(near_.end(), some.begin(), some.end());
            some = {};
        }
        std::sort(near_.begin(), near_.end(), [](NearShape const& a, NearShape const& b) {
            return a.block != b.block ? a.block < b.block : a.shape < b.shape;
        });
        for (std::size_t i = 0; i < near_.size(); ++i)
            if (i == 0 || near_[i].block != near_[i - 1].block)
                first_near_.push_back(i);
        if (first_near_.size() > kMostBlocks)
            return false;
        blocks_.resize(first_near_.size());
        first_near_.push_back(near_.size());
        return true;
    }

    // Computes the least distance at each point of a block.
    void measure(std::span<NearShape const> shapes, Field& field) const
    {
        field.distance_mm.fill(2 * margin_mm());
        for (auto const& [block, shape] : shapes) {
            auto box = field_.box_mm(shape);
            box.extend(Vec3f(box.min() - Vec3f::Constant(margin_mm())));
            box.extend(Vec3f(box.max() + Vec3f::Constant(margin_mm())));
            auto const material = field_.material(shape);
            for (int z = 0; z < kPoints; ++z)
                for (int y = 0; y < kPoints; ++y)
                    for (int x = 0; x < kPoints; ++x) {
                        Vec3f const at = point_mm(block, x, y, z);
                        if (!box.contains(at))
                            continue;
                        auto const number = point_number(x, y, z);
                        float const distance = field_.distance_mm(shape, at);
                        if (distance < field.distance_mm[number]) {
                            field.distance_mm[number] = distance;
                            field.material[number] = material;
                        }
                    }
        }
    }

    void find_vertices(std::size_t number, Field& field)
    {
        auto const shapes = std::span(near_).subspan(first_near_[number],
                                                     first_near_[number + 1] - first_near_[number]);
        auto& surface = blocks_[number];
        surface.block = shapes[0].block;
        measure(shapes, field);
        for (std::size_t i = 0; i < kPointsOfBlock; ++i)
            surface.inside[i] = field.distance_mm[i] < 0;
        if (surface.inside.none() || surface.inside.all())
            return;
        for (int z = 0; z < kCells; ++z)
            for (int y = 0; y < kCells; ++y)
                for (int x = 0; x < kCells; ++x)
                    add_vertices({ x, y, z }, field, surface);
    }

    // Adds the vertices on the three edges that begin at a point.
    void add_vertices(Cell const& at, Field const& field, BlockSurface& surface) const
    {
        auto const from = point_number(at[0], at[1], at[2]);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            auto end = at;
            ++end[axis];
            auto const to = point_number(end[0], end[1], end[2]);
            if (surface.inside[from] == surface.inside[to])
                continue;
            float const first = field.distance_mm[from];
            float const second = field.distance_mm[to];
            float const share = std::clamp(first / (first - second), kClear, 1 - kClear);
            Vec3f position = point_mm(surface.block, at[0], at[1], at[2]);
            position[static_cast<int>(axis)] += share * static_cast<float>(cell_mm_);
            surface.edges.push_back(static_cast<std::uint16_t>(3 * from + axis));
            surface.positions_mm.push_back(position);
            surface.materials.push_back(field.material[surface.inside[from] ? from : to]);
        }
    }

    // Returns the vertex on an edge of a cell. The edge may begin in a neighbouring block.
    std::uint32_t vertex_at(Cell block, Cell point, int axis) const
    {
        for (std::size_t k = 0; k < 3; ++k)
            if (point[k] == kCells) {
                point[k] = 0;
                ++block[k];
            }
        auto const surface = std::lower_bound(
            blocks_.begin(), blocks_.end(), block,
            [](BlockSurface const& one, Cell const& other) { return one.block < other; });
        auto const edge = static_cast<std::uint16_t>(3 * point_number(point[0], point[1], point[2])
                                                     + static_cast<std::size_t>(axis));
        auto const place = std::lower_bound(surface->edges.begin(), surface->edges.end(), edge);
        return surface->first_vertex + static_cast<std::uint32_t>(place - surface->edges.begin());
    }

    void add_triangles(BlockSurface const& surface, Cell const& cell,
                       std::vector<ClosedMesh::Triangle>& triangles) const
    {
        unsigned inside = 0;
        for (int i = 0; i < 8; ++i)
            if (surface.inside[point_number(cell[0] + (i & 1), cell[1] + (i >> 1 & 1),
                                            cell[2] + (i >> 2 & 1))])
                inside |= 1u << i;
        auto const& table = CubeTable::get();
        for (auto const& edges : table.triangles(static_cast<std::uint8_t>(inside))) {
            ClosedMesh::Triangle triangle {};
            for (std::size_t k = 0; k < 3; ++k) {
                auto const& [axis, corner] = table.edge(edges[k]);
                Cell const point { cell[0] + (corner & 1), cell[1] + (corner >> 1 & 1),
                                   cell[2] + (corner >> 2 & 1) };
                triangle[k] = vertex_at(surface.block, point, axis);
            }
            triangles.push_back(triangle);
        }
    }

    ClosedMesh joined()
    {
        ClosedMesh mesh;
        for (auto& surface : blocks_) {
            surface.first_vertex = static_cast<std::uint32_t>(mesh.positions_mm.size());
            mesh.positions_mm.insert(mesh.positions_mm.end(), surface.positions_mm.begin(),
                                     surface.positions_mm.end());
            mesh.materials.insert(mesh.materials.end(), surface.materials.begin(),
                                  surface.materials.end());
            surface.positions_mm = {};
            surface.materials = {};
        }
        std::vector<std::vector<ClosedMesh::Triangle>> triangles(blocks_.size());
        parallel_for(blocks_.size(), kBlocksAtOnce, [&](std::size_t begin, std::size_t end) {
            for (auto i = begin; i != end; ++i)
                if (auto const& surface = blocks_[i]; surface.inside.any())
                    for (int z = 0; z < kCells; ++z)
                        for (int y = 0; y < kCells; ++y)
                            for (int x = 0; x < kCells; ++x)
                                add_triangles(surface, { x, y, z }, triangles[i]);
        });
        for (auto& some : triangles) {
            mesh.triangles.insert(mesh.triangles.end(), some.begin(), some.end());
            some = {};
        }
        return mesh;
    }

    DistanceField const& field_;
    double thickness_mm_;
    double cell_mm_;
    Vec3 origin_mm_ = Vec3::Zero();
    std::vector<NearShape> near_;         // Sorted by block.
    std::vector<std::size_t> first_near_; // Of each block in near_, and the end.
    std::vector<BlockSurface> blocks_;    // Sorted by block.
};

} // namespace

Result<ClosedMesh> closed_shell(SolidParts const& parts)
{
    DistanceField const field(parts);
    auto mesh = TRY(ShellGrid(field, parts.least_thickness_mm).surface());
    fill_hollows(mesh);
    separate_vertices(mesh);
    return mesh;
}

} // namespace tractus::mesh
