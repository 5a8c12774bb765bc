#include "engine/mesh/sheet_pieces.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>
#include <tuple>
#include <utility>

namespace tractus::mesh {

namespace {

using Triangle = ClosedMesh::Triangle;
constexpr std::uint32_t kNoTwin = 0xFFFFFFFF;

// The normal of a plate's vertex is no steeper to its triangles than this, so that a plate that is
// folded sharply has no spikes.
constexpr float kSteepestMitre = 0.5f;

// Merges vertices at the same position. Returns the number of the first of each.
std::vector<std::uint32_t> merged_vertices(BulkVector<Vec3f> const& positions)
{
    auto const key = [&](std::uint32_t i) {
        Vec3f const at = positions[i] + Vec3f::Zero(); // -0 is 0.
        return std::array { at.x(), at.y(), at.z() };
    };
    std::vector<std::uint32_t> order(positions.size());
    std::iota(order.begin(), order.end(), 0);
    std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
        return key(a) != key(b) ? key(a) < key(b) : a < b;
    });
    std::vector<std::uint32_t> first(positions.size());
    for (std::size_t i = 0; i < order.size(); ++i)
        first[order[i]]
            = i > 0 && key(order[i]) == key(order[i - 1]) ? first[order[i - 1]] : order[i];
    return first;
}

// Returns the triangles between merged vertices, without repeated and collapsed ones.
std::vector<Triangle> distinct_triangles(TriangleMesh const& mesh)
{
    auto const first = merged_vertices(mesh.positions_mm);
    std::vector<Triangle> triangles;
    std::set<Triangle> seen;
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
        Triangle const triangle { first[mesh.indices[i]], first[mesh.indices[i + 1]],
                                  first[mesh.indices[i + 2]] };
        auto sorted = triangle;
        std::sort(sorted.begin(), sorted.end());
        bool const has_area = sorted[0] != sorted[1] && sorted[1] != sorted[2];
        if (has_area && seen.insert(sorted).second)
            triangles.push_back(triangle);
    }
    return triangles;
}

// Sets of numbers that are united step by step. The set's least number represents it.
class Sets {
public:
    explicit Sets(std::size_t count)
        : root_(count)
    {
        std::iota(root_.begin(), root_.end(), 0);
    }

    std::uint32_t find(std::uint32_t i)
    {
        while (root_[i] != i)
            i = root_[i] = root_[root_[i]];
        return i;
    }

    void unite(std::uint32_t a, std::uint32_t b)
    {
        a = find(a);
        b = find(b);
        root_[std::max(a, b)] = std::min(a, b);
    }

private:
    std::vector<std::uint32_t> root_;
};

// Half-edge 3 t + k runs from corner k of triangle t to its next corner.
std::uint32_t next_corner(std::uint32_t edge)
{
    return edge % 3 == 2 ? edge - 2 : edge + 1;
}

// Returns the opposite half-edge of each half-edge; kNoTwin along the rim and along cuts.
std::vector<std::uint32_t> find_twins(std::vector<Triangle> const& triangles)
{
    struct Half {
        std::uint32_t low;
        std::uint32_t high;
        std::uint32_t edge;
        bool is_up; // True if it runs from the lower to the higher vertex.
    };
    std::vector<Half> halves;
    for (std::uint32_t edge = 0; edge < 3 * triangles.size(); ++edge) {
        auto const from = triangles[edge / 3][edge % 3];
        auto const to = triangles[edge / 3][next_corner(edge) % 3];
        halves.push_back({ std::min(from, to), std::max(from, to), edge, from < to });
    }
    std::sort(halves.begin(), halves.end(), [](Half const& a, Half const& b) {
        return std::tie(a.low, a.high, a.edge) < std::tie(b.low, b.high, b.edge);
    });
    std::vector<std::uint32_t> twins(halves.size(), kNoTwin);
    for (std::size_t i = 0; i < halves.size();) {
        std::size_t end = i;
        while (end < halves.size() && halves[end].low == halves[i].low
               && halves[end].high == halves[i].high)
            ++end;
        if (end - i == 2 && halves[i].is_up != halves[i + 1].is_up) {
            twins[halves[i].edge] = halves[i + 1].edge;
            twins[halves[i + 1].edge] = halves[i].edge;
        }
        i = end;
    }
    return twins;
}

Vec3f area_vector(SheetPiece const& piece, Triangle const& triangle)
{
    auto const& p = piece.positions_mm;
    Vec3f const side = p[triangle[1]] - p[triangle[0]];
    return 0.5f * side.cross(Vec3f(p[triangle[2]] - p[triangle[0]]));
}

// Returns how far the vertices of a plate move along their normals, in multiples of half its
// thickness, so that its faces move by half its thickness.
std::vector<float> mitres(SheetPiece const& piece, std::vector<Vec3f> const& normals)
{
    std::vector<float> least(normals.size(), 1);
    for (auto const& triangle : piece.triangles) {
        Vec3f const normal = area_vector(piece, triangle).normalized();
        for (auto const vertex : triangle)
            least[vertex] = std::min(least[vertex], normals[vertex].dot(normal));
    }
    for (auto& share : least)
        share = 1 / std::max(share, kSteepestMitre);
    return least;
}

ClosedMesh plate_of(SheetPiece const& piece, double thickness_mm)
{
    auto const normals = vertex_normals(piece);
    auto const reach = mitres(piece, normals);
    auto const half = static_cast<float>(thickness_mm / 2);
    auto const count = static_cast<std::uint32_t>(piece.positions_mm.size());
    ClosedMesh plate;
    plate.positions_mm.resize(2 * std::size_t { count });
    for (std::uint32_t i = 0; i < count; ++i) {
        Vec3f const up = half * reach[i] * normals[i];
        plate.positions_mm[i] = piece.positions_mm[i] + up;
        plate.positions_mm[count + i] = piece.positions_mm[i] - up;
    }
    for (auto const& [a, b, c] : piece.triangles) {
        plate.triangles.push_back({ a, b, c });
        plate.triangles.push_back({ count + a, count + c, count + b });
    }
    for (auto const& [a, b] : piece.rim) {
        plate.triangles.push_back({ b, a, count + a });
        plate.triangles.push_back({ b, count + a, count + b });
    }
    return plate;
}

double signed_volume(SheetPiece const& piece)
{
    double sum = 0;
    for (auto const& triangle : piece.triangles)
        sum += double(area_vector(piece, triangle)
                          .dot(piece.positions_mm[triangle[0]] - piece.positions_mm[0]));
    return sum / 3;
}

double area_of(SheetPiece const& piece)
{
    double area = 0;
    for (auto const& triangle : piece.triangles)
        area += double { area_vector(piece, triangle).norm() };
    return area;
}

// Turns the surface round: its inner side becomes the outer one.
void reverse(SheetPiece& piece)
{
    for (auto& triangle : piece.triangles)
        std::swap(triangle[1], triangle[2]);
    for (auto& edge : piece.rim)
        std::swap(edge[0], edge[1]);
}

ClosedMesh grown(SheetPiece const& piece, double growth_mm)
{
    ClosedMesh solid;
    solid.positions_mm = piece.positions_mm;
    solid.triangles = piece.triangles;
    auto const normals = vertex_normals(piece);
    for (std::size_t i = 0; i < normals.size(); ++i)
        solid.positions_mm[i] += static_cast<float>(growth_mm) * normals[i];
    return solid;
}

} // namespace

std::vector<SheetPiece> split_sheet(TriangleMesh const& mesh)
{
    auto const triangles = distinct_triangles(mesh);
    auto const twins = find_twins(triangles);
    Sets corners(3 * triangles.size()); // Each set is a vertex of the pieces.
    Sets parts(triangles.size());
    for (std::uint32_t edge = 0; edge < twins.size(); ++edge) {
        if (twins[edge] == kNoTwin)
            continue;
        corners.unite(edge, next_corner(twins[edge]));
        corners.unite(next_corner(edge), twins[edge]);
        parts.unite(edge / 3, twins[edge] / 3);
    }
    std::vector<SheetPiece> pieces;
    std::vector<std::uint32_t> piece_of(triangles.size());
    std::vector<std::uint32_t> vertex_of(3 * triangles.size());
    for (std::uint32_t t = 0; t < triangles.size(); ++t) {
        auto const part = parts.find(t);
        if (part == t) {
            piece_of[t] = static_cast<std::uint32_t>(pieces.size());
            pieces.emplace_back();
        }
        auto& piece = pieces[piece_of[part]];
        Triangle own {};
        for (std::uint32_t k = 0; k < 3; ++k) {
            auto const corner = 3 * t + k;
            auto const vertex = corners.find(corner);
            if (vertex == corner) {
                vertex_of[corner] = static_cast<std::uint32_t>(piece.positions_mm.size());
                piece.positions_mm.push_back(mesh.positions_mm[triangles[t][k]]);
            }
            own[k] = vertex_of[vertex];
        }
        piece.triangles.push_back(own);
        for (std::uint32_t k = 0; k < 3; ++k)
            if (twins[3 * t + k] == kNoTwin)
                piece.rim.push_back({ own[k], own[(k + 1) % 3] });
    }
    for (auto& piece : pieces)
        if (piece.is_closed() && signed_volume(piece) < 0)
            reverse(piece);
    return pieces;
}

SheetPiece placed(SheetPiece const& piece, InstanceTransform const& instance)
{
    auto result = piece;
    Eigen::Matrix3f const turn = instance.rotation.toRotationMatrix();
    for (auto& position : result.positions_mm)
        position = turn * instance.scale.cwiseProduct(position) + instance.translation_mm;
    if (instance.scale.prod() < 0)
        reverse(result);
    return result;
}

std::vector<Vec3f> vertex_normals(SheetPiece const& piece)
{
    std::vector<Vec3f> normals(piece.positions_mm.size(), Vec3f::Zero());
    for (auto const& triangle : piece.triangles) {
        Vec3f const area = area_vector(piece, triangle);
        for (auto const vertex : triangle)
            normals[vertex] += area;
    }
    for (auto& normal : normals) {
        float const length = normal.norm();
        normal = length > 0 ? Vec3f(normal / length) : Vec3f::UnitZ();
    }
    return normals;
}

double growth_of(SheetPiece const& piece, double thickness_mm)
{
    double const area = area_of(piece);
    // Exact for a plate; less than the thickness of rods and balls.
    double const thickness = area > 0 ? 2 * std::abs(signed_volume(piece)) / area : 0;
    // A corner of a rod with four sides moves further than its sides.
    constexpr double kSideOfRod = 0.71;
    return std::max(0.0, thickness_mm - thickness) / (2 * kSideOfRod);
}

ClosedMesh solid_of(SheetPiece const& piece, MaterialId material, double thickness_mm)
{
    auto solid = piece.is_closed() ? grown(piece, growth_of(piece, thickness_mm))
                                   : plate_of(piece, thickness_mm);
    solid.materials.assign(solid.positions_mm.size(), material);
    return solid;
}

} // namespace tractus::mesh
