#include "engine/methods/leaves/leaf_shape.h"

#include "engine/methods/leaves/flat_geometry.h"
#include "engine/methods/leaves/flat_mesh.h"
#include "engine/methods/leaves/leaf_contour.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace tractus::leaf {

namespace {

constexpr double kHalf = 0.5; // Alpha at a leaf's edge.

// Largest distance in pixels between the edge and its polygon; small pictures get the same as large
// ones.
double finest(int side)
{
    return 0.12 * std::max(1.0, side / 512.0);
}

// Picture coordinates, y downwards.
std::vector<Vec2> downwards(std::vector<Vec2> points, int side)
{
    for (auto& point : points)
        point.y() = side - point.y();
    return points;
}

// Contours of the visible parts; crumbs and pinholes are left out.
std::vector<Contour> alpha_edges(std::span<float const> alpha, int side, double level)
{
    double const crumb = std::max(2.0, 2e-5 * side * side);
    double const hole = std::max(4.0, 2e-4 * side * side);
    auto contours = trace_contours(alpha, side, level, crumb);
    std::erase_if(contours, [&](Contour const& contour) {
        double const area = contour_area(contour);
        return area < 0 && -area < hole;
    });
    return contours;
}

double filled_area(std::span<Contour const> contours)
{
    double sum = 0;
    for (auto const& contour : contours)
        sum += contour_area(contour);
    return sum;
}

double filled_area(FlatMesh const& mesh)
{
    double sum = 0;
    for (auto const& [a, b, c] : mesh.triangles())
        sum += std::abs(turn(mesh.points()[a], mesh.points()[b], mesh.points()[c])) / 2;
    return sum;
}

} // namespace

Cutout card_around(std::span<float const> alpha, int side)
{
    Eigen::AlignedBox2d box;
    for (int y = 0; y < side; ++y) {
        auto const row = alpha.subspan(static_cast<std::size_t>(y) * static_cast<std::size_t>(side),
                                       static_cast<std::size_t>(side));
        auto const is_there = [](float value) { return value > 0; };
        auto const first = std::ranges::find_if(row, is_there);
        if (first == row.end())
            continue;
        auto const behind = std::find_if(row.rbegin(), row.rend(), is_there).base();
        box.extend(Vec2(double(first - row.begin()), y));
        box.extend(Vec2(double(behind - row.begin()), y + 1));
    }
    if (box.isEmpty())
        return {};
    return { .corners = { { box.min().x(), box.max().y() },
                          { box.max().x(), box.max().y() },
                          { box.max().x(), box.min().y() },
                          { box.min().x(), box.min().y() } },
             .triangles = { { 0, 1, 2 }, { 0, 2, 3 } } };
}

Cutout cut_along_edge(std::span<float const> alpha, int side, double empty)
{
    auto edge = alpha_edges(alpha, side, kHalf);
    double const area = filled_area(edge);
    if (edge.empty())
        return {};
    // The smooth rim of a broad leaf belongs to it; that of a thin one would be much of its shape.
    double room = empty * area;
    for (double const level : { 0.01, 0.1, 0.25 }) {
        auto wider = alpha_edges(alpha, side, level);
        double const more = filled_area(wider) - area;
        if (more > 0.6 * room)
            continue;
        edge = std::move(wider);
        room -= more;
        break;
    }
    // A coarse polygon may cross itself. Then the areas of its triangles do not add up to its own.
    for (double tolerance = finest(side);; tolerance /= 2) {
        std::vector<Contour> contours;
        for (auto const& contour : edge) {
            contours.push_back(thinned(contour, tolerance));
            double const share = std::min(1.0, std::abs(contour_area(contour)) / area);
            grow_simpler(contours.back(), room * share, 0.004 * area, side);
        }
        FlatMesh const mesh(contours);
        double const wanted = filled_area(contours);
        if (std::abs(filled_area(mesh) - wanted) < 0.003 * wanted || tolerance < 0.1 * finest(side))
            return { downwards(mesh.points(), side), mesh.triangles() };
    }
}

namespace {

// Finds the place in space, and the upper side's normal, of points of the flat leaf.
class Bearing {
public:
    explicit Bearing(LeafTriangles const& leaf)
        : leaf_(leaf)
    {
    }

    // Place of a flat point. Beyond the leaf's edge, the nearest triangle goes on without bending.
    Vec3 place(Vec2 const& flat) const
    {
        Nearest nearest;
        for (auto const* const part : { &leaf_.limb, &leaf_.veins })
            for (auto const& triangle : *part)
                look_at(flat, triangle, nearest);
        if (!nearest.triangle)
            return { flat.x(), flat.y(), 0 };
        auto const& [a, b, c] = *nearest.triangle;
        auto const& at = leaf_.positions;
        Vec3 const& w = nearest.weights;
        Vec3 const on = w[0] * at[a] + w[1] * at[b] + w[2] * at[c];
        Vec2 const off
            = flat - (w[0] * leaf_.flat[a] + w[1] * leaf_.flat[b] + w[2] * leaf_.flat[c]);
        Vec3 const normal = (at[b] - at[a]).cross(at[c] - at[a]);
        if (!(off.norm() > 0) || !(normal.norm() > 0))
            return on;
        auto const turned = Eigen::Quaterniond::FromTwoVectors(Vec3::UnitZ(), normal);
        return on + turned * Vec3(off.x(), off.y(), 0);
    }

private:
    struct Nearest {
        std::array<std::uint32_t, 3> const* triangle = nullptr;
        Vec3 weights = Vec3::Zero(); // Barycentric coordinates of the nearest point.
        double distance2 = 0;
    };

    void look_at(Vec2 const& flat, std::array<std::uint32_t, 3> const& triangle,
                 Nearest& nearest) const
    {
        Vec2 const& a = leaf_.flat[triangle[0]];
        Vec2 const& b = leaf_.flat[triangle[1]];
        Vec2 const& c = leaf_.flat[triangle[2]];
        double const area = turn(a, b, c);
        if (std::abs(area) < 1e-12)
            return;
        Vec3 weights(turn(b, c, flat) / area, turn(c, a, flat) / area, 0);
        weights[2] = 1 - weights[0] - weights[1];
        if (weights.minCoeff() < 0)
            weights = clamped(flat, { a, b, c });
        double const distance2
            = (weights[0] * a + weights[1] * b + weights[2] * c - flat).squaredNorm();
        if (!nearest.triangle || distance2 < nearest.distance2)
            nearest = { &triangle, weights, distance2 };
    }

    // Barycentric coordinates of the point on a triangle's edges that is nearest to `point`.
    static Vec3 clamped(Vec2 const& point, std::array<Vec2, 3> const& corners)
    {
        Vec3 best = Vec3::UnitX();
        double least = (corners[0] - point).squaredNorm();
        for (int k = 0; k < 3; ++k) {
            auto const& from = corners[static_cast<std::size_t>(k)];
            auto const& to = corners[static_cast<std::size_t>((k + 1) % 3)];
            double const length2 = (to - from).squaredNorm();
            double const share
                = length2 > 0 ? std::clamp((point - from).dot(to - from) / length2, 0.0, 1.0) : 0;
            double const distance2 = (from + share * (to - from) - point).squaredNorm();
            if (distance2 >= least && k > 0)
                continue;
            least = distance2;
            best = Vec3::Zero();
            best[k] = 1 - share;
            best[(k + 1) % 3] = share;
        }
        return best;
    }

    LeafTriangles const& leaf_;
};

std::vector<Vec3> smooth_normals(std::span<Vec3 const> positions,
                                 std::span<FlatMesh::Triangle const> triangles)
{
    std::vector<Vec3> normals(positions.size(), Vec3::Zero());
    for (auto const& triangle : triangles) {
        Vec3 const area = (positions[triangle[1]] - positions[triangle[0]])
                              .cross(positions[triangle[2]] - positions[triangle[0]]);
        for (auto const corner : triangle)
            normals[corner] += area;
    }
    for (auto& normal : normals)
        normal = normal.norm() > 0 ? normal.normalized().eval() : Vec3::UnitZ();
    return normals;
}

// Makes the flat mesh of a modelled leaf in the picture's coordinates, y upwards.
class Modeller {
public:
    Modeller(std::span<float const> alpha, int side, std::vector<Leaf::Midrib> midribs,
             ModelOptions const& options)
        : edge_(alpha_edges(alpha, side, kHalf))
        , side_(side)
        , midribs_(std::move(midribs))
        , options_(options)
    {
        Eigen::AlignedBox2d box;
        for (auto const& contour : edge_)
            for (auto const& point : contour)
                box.extend(point);
        extent_ = box.isEmpty() ? 0 : box.sizes().maxCoeff();
    }

    std::optional<FlatMesh> mesh() const
    {
        if (edge_.empty())
            return std::nullopt;
        double step = extent_ / 14;
        // The coarsest edge deviates by 4 % of the leaf; more than that nobody would call its edge.
        for (double tolerance = 5 * finest(side_); tolerance < 0.04 * side_;) {
            auto const contours = divided(tolerance, step);
            std::size_t corners = 0;
            for (auto const& contour : contours)
                corners += contour.size();
            if (static_cast<double>(corners) > 0.8 * options_.max_triangles) {
                tolerance *= 1.15;
                continue;
            }
            auto const made = filled(contours, step);
            auto const count = static_cast<int>(made.triangles().size());
            double const wanted = filled_area(contours);
            bool const is_whole = std::abs(filled_area(made) - wanted) < 0.003 * wanted;
            if (is_whole && count >= options_.min_triangles && count <= options_.max_triangles)
                return made;
            if (count < options_.min_triangles && step > 0.01 * extent_)
                step *= 0.8;
            else
                tolerance *= 1.15;
        }
        return std::nullopt;
    }

private:
    // The leaf's edge within a tolerance, with sides of at most `step`.
    std::vector<Contour> divided(double tolerance, double step) const
    {
        std::vector<Contour> made;
        for (auto const& contour : edge_) {
            auto const thin = thinned(contour, tolerance);
            if (thin.size() < 3 || std::abs(contour_area(thin)) < 2)
                continue;
            made.emplace_back();
            for (std::size_t i = 0; i < thin.size(); ++i) {
                Vec2 const& from = thin[i];
                Vec2 const& to = thin[(i + 1) % thin.size()];
                int const pieces
                    = std::max(1, static_cast<int>(std::ceil((to - from).norm() / step)));
                for (int k = 0; k < pieces; ++k)
                    made.back().push_back(from + (to - from) * (double(k) / pieces));
            }
        }
        return made;
    }

    // Triangles within the edge, with points along midribs and between them.
    FlatMesh filled(std::vector<Contour> const& contours, double step) const
    {
        FlatMesh mesh(contours);
        for (auto const& midrib : midribs_)
            add_fold(mesh, contours, midrib, step);
        // Each point adds two triangles.
        double const room = 0.5 * (options_.max_triangles - double(mesh.triangles().size()));
        double const grid
            = std::max(1.3 * step, std::sqrt(filled_area(contours) / std::max(1.0, 0.9 * room)));
        for (double y = grid / 2; y < side_; y += grid)
            for (double x = grid / 2; x < side_; x += grid) {
                bool const is_free = std::ranges::all_of(mesh.points(), [&](Vec2 const& other) {
                    return (other - Vec2(x, y)).norm() > 0.55 * grid;
                });
                if (is_free && distance_to_edge(contours, { x, y }) > 0.4 * grid)
                    mesh.add_point({ x, y });
            }
        return mesh;
    }

    static double distance_to_edge(std::vector<Contour> const& contours, Vec2 const& point)
    {
        double least = std::numeric_limits<double>::infinity();
        for (auto const& contour : contours)
            for (std::size_t i = 0; i < contour.size(); ++i) {
                Vec2 const& from = contour[i];
                Vec2 const along = contour[(i + 1) % contour.size()] - from;
                double const share
                    = std::clamp((point - from).dot(along) / along.squaredNorm(), 0.0, 1.0);
                least = std::min(least, (from + share * along - point).norm());
            }
        return least;
    }

    // Adds points along a midrib, and the lines between them, on which the blade folds.
    void add_fold(FlatMesh& mesh, std::vector<Contour> const& contours, Leaf::Midrib const& midrib,
                  double step) const
    {
        double const length = (midrib.to - midrib.from).norm();
        int const count = std::max(2, static_cast<int>(length / step));
        std::optional<FlatMesh::Corner> last;
        for (int i = 0; i <= count; ++i) {
            Vec2 const at = midrib.from + (midrib.to - midrib.from) * (double(i) / count);
            bool const is_inside = distance_to_edge(contours, at) > std::min(0.25 * step, 2.5);
            auto const point = is_inside ? mesh.add_point(at) : std::nullopt;
            if (point && last)
                mesh.add_line(*last, *point);
            last = point;
        }
    }

    std::vector<Contour> edge_;
    int side_;
    std::vector<Leaf::Midrib> midribs_;
    ModelOptions const& options_;
    double extent_ = 0;
};

// Distance of a point from the midrib that it belongs to: that of the nearest blade.
double distance_from_midrib(Vec2 const& flat, std::span<Leaf::Midrib const> midribs)
{
    double least = std::numeric_limits<double>::infinity();
    double distance = 0;
    for (auto const& midrib : midribs) {
        Vec2 const along = midrib.to - midrib.from;
        double const length = along.norm();
        if (!(length > 0))
            continue;
        double const share
            = std::clamp((flat - midrib.from).dot(along) / (length * length), 0.0, 1.0);
        double const near = (midrib.from + share * along - flat).norm();
        if (near < least) {
            least = near;
            distance = std::abs(cross(along / length, flat - midrib.from));
        }
    }
    return distance;
}

} // namespace

ModelledLeaf model_leaf(std::span<float const> alpha, int side, LeafTriangles const& leaf,
                        std::span<Leaf::Midrib const> midribs, PictureFrame const& frame,
                        ModelOptions const& options)
{
    // A frond of many small blades folds as a whole.
    constexpr std::size_t kMostBlades = 8;
    Eigen::AlignedBox2d box;
    for (auto const& flat : leaf.flat)
        box.extend(flat);
    std::vector<Leaf::Midrib> folds(midribs.begin(), midribs.end());
    if (folds.empty() || folds.size() > kMostBlades)
        folds = { { Vec2(0, box.min().y()), Vec2(0, box.max().y()) } };
    auto const upwards = [&](Vec2 const& flat) {
        Vec2 const pixel = frame.pixel(flat);
        return Vec2(pixel.x(), side - pixel.y());
    };
    std::vector<Leaf::Midrib> in_picture;
    for (auto const& fold : folds)
        in_picture.push_back({ upwards(fold.from), upwards(fold.to) });
    auto const mesh = Modeller(alpha, side, in_picture, options).mesh();
    if (!mesh)
        return {};
    ModelledLeaf made { .triangles = mesh->triangles() };
    made.corners = downwards(mesh->points(), side);
    Bearing const bearing(leaf);
    std::vector<Vec2> flats;
    for (auto const& corner : made.corners) {
        flats.push_back(frame.flat(corner));
        made.positions.push_back(bearing.place(flats.back()));
    }
    auto const normals = smooth_normals(made.positions, made.triangles);
    double const rise = std::tan(options.fold_deg * kPi / 180);
    for (std::size_t i = 0; i < flats.size(); ++i)
        made.positions[i] += rise * distance_from_midrib(flats[i], folds) * normals[i];
    made.normals = smooth_normals(made.positions, made.triangles);
    return made;
}

} // namespace tractus::leaf
