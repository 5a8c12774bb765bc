#include "engine/methods/leaves/flat_mesh.h"

#include "engine/methods/leaves/flat_geometry.h"
#include "engine/methods/leaves/leaf_contour.h"
#include "engine/methods/leaves/leaf_triangles.h"

#include <algorithm>
#include <map>

namespace tractus::leaf {

namespace {

bool do_meet(Vec2 const& a, Vec2 const& b, Vec2 const& c, Vec2 const& d)
{
    return turn(a, b, c) * turn(a, b, d) < 0 && turn(c, d, a) * turn(c, d, b) < 0;
}

// True if the point is inside the contour: a ray to the right meets it an odd number of times.
bool is_within(Vec2 const& point, std::vector<Vec2> const& contour)
{
    bool is_inside = false;
    for (std::size_t i = 0; i < contour.size(); ++i) {
        Vec2 const& a = contour[i];
        Vec2 const& b = contour[(i + 1) % contour.size()];
        if ((a.y() > point.y()) == (b.y() > point.y()))
            continue;
        double const x = a.x() + (point.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x());
        is_inside ^= x > point.x();
    }
    return is_inside;
}

// Positive if d is inside the circle through a, b and c, which are counter-clockwise.
double in_circle(Vec2 const& a, Vec2 const& b, Vec2 const& c, Vec2 const& d)
{
    Vec2 const p = a - d;
    Vec2 const q = b - d;
    Vec2 const r = c - d;
    return p.squaredNorm() * cross(q, r) - q.squaredNorm() * cross(p, r)
        + r.squaredNorm() * cross(p, q);
}

} // namespace

FlatMesh::FlatMesh(std::span<std::vector<Vec2> const> contours)
{
    add_contours(contours);
    link_faces();
    improve_all();
}

std::vector<FlatMesh::Triangle> FlatMesh::triangles() const
{
    std::vector<Triangle> made;
    for (auto const& face : faces_)
        made.push_back(face.corners);
    return made;
}

// Joins each hole to its outer contour by an edge that is walked in both directions, so that the
// area between them has a single border (Eberly, "Triangulation by ear clipping", 2002).
void FlatMesh::add_contours(std::span<std::vector<Vec2> const> contours)
{
    std::vector<std::vector<Corner>> rings;
    for (auto const& contour : contours) {
        rings.emplace_back();
        for (auto const& point : contour) {
            rings.back().push_back(static_cast<Corner>(points_.size()));
            points_.push_back(point);
        }
    }
    auto const is_bridge_free = [&](Vec2 const& a, Vec2 const& b) {
        for (auto const& ring : rings)
            for (std::size_t i = 0; i < ring.size(); ++i)
                if (do_meet(a, b, points_[ring[i]], points_[ring[(i + 1) % ring.size()]]))
                    return false;
        return true;
    };
    for (std::size_t outer = 0; outer < rings.size(); ++outer) {
        if (contour_area(contours[outer]) <= 0)
            continue;
        auto ring = rings[outer];
        for (std::size_t hole = 0; hole < rings.size(); ++hole) {
            if (contour_area(contours[hole]) > 0 || !is_within(contours[hole][0], contours[outer]))
                continue;
            struct Bridge {
                std::size_t from = 0;
                std::size_t to = 0;
                double length2 = 0;
            };
            std::vector<Bridge> bridges;
            for (std::size_t i = 0; i < ring.size(); ++i)
                for (std::size_t j = 0; j < rings[hole].size(); ++j)
                    bridges.push_back(
                        { i, j, (points_[ring[i]] - points_[rings[hole][j]]).squaredNorm() });
            std::ranges::stable_sort(bridges, {}, &Bridge::length2);
            auto const best = std::ranges::find_if(bridges, [&](Bridge const& bridge) {
                return is_bridge_free(points_[ring[bridge.from]], points_[rings[hole][bridge.to]]);
            });
            if (best == bridges.end())
                continue;
            std::vector<Corner> way;
            for (std::size_t j = 0; j <= rings[hole].size(); ++j)
                way.push_back(rings[hole][(best->to + j) % rings[hole].size()]);
            way.push_back(ring[best->from]);
            ring.insert(ring.begin() + static_cast<std::ptrdiff_t>(best->from) + 1, way.begin(),
                        way.end());
        }
        add_area(ring);
    }
}

void FlatMesh::add_area(std::vector<Corner> const& ring)
{
    std::vector<Vec2> places;
    for (auto const corner : ring)
        places.push_back(points_[corner]);
    for (auto const& [a, b, c] : cut_polygon(places))
        faces_.push_back({ .corners = { ring[a], ring[b], ring[c] } });
}

void FlatMesh::link_faces()
{
    std::map<std::pair<Corner, Corner>, Edge> edges;
    for (std::size_t i = 0; i < faces_.size(); ++i)
        for (unsigned k = 0; k < 3; ++k)
            edges[{ faces_[i].corners[k], faces_[i].corners[(k + 1) % 3] }]
                = { static_cast<std::int32_t>(i), k };
    for (auto const& [ends, edge] : edges)
        if (auto const other = edges.find({ ends.second, ends.first }); other != edges.end())
            face(edge.face).across[edge.k] = other->second.face;
}

FlatMesh::Edge FlatMesh::other_side(Edge const& edge) const
{
    auto const& here = face(edge.face);
    auto const there = here.across[edge.k];
    auto const& corners = face(there).corners;
    auto const from = here.corners[(edge.k + 1) % 3];
    return { there, static_cast<unsigned>(std::ranges::find(corners, from) - corners.begin()) };
}

// Lets a neighbour's edge that begins at `from` lead to the face `now`.
void FlatMesh::relink(std::int32_t neighbour, Corner from, std::int32_t now)
{
    if (neighbour == kNone)
        return;
    auto& other = face(neighbour);
    auto const k = std::ranges::find(other.corners, from) - other.corners.begin();
    other.across[static_cast<std::size_t>(k)] = now;
}

bool FlatMesh::is_line(Corner a, Corner b) const
{
    return lines_.contains(std::minmax(a, b));
}

// True if the two triangles of an edge form a convex quadrilateral, whose other diagonal can
// replace the edge.
bool FlatMesh::can_flip(Edge const& edge) const
{
    auto const& here = face(edge.face);
    if (here.across[edge.k] == kNone
        || is_line(here.corners[edge.k], here.corners[(edge.k + 1) % 3]))
        return false;
    auto const other = other_side(edge);
    Vec2 const& a = points_[here.corners[edge.k]];
    Vec2 const& b = points_[here.corners[(edge.k + 1) % 3]];
    Vec2 const& c = points_[here.corners[(edge.k + 2) % 3]];
    Vec2 const& d = points_[face(other.face).corners[(other.k + 2) % 3]];
    double const least = 1e-9 * (c - d).squaredNorm();
    return turn(a, d, c) > least && turn(d, b, c) > least;
}

void FlatMesh::flip(Edge const& edge)
{
    auto const other = other_side(edge);
    auto const t = face(edge.face);
    auto const u = face(other.face);
    auto const a = t.corners[edge.k];
    auto const b = t.corners[(edge.k + 1) % 3];
    auto const c = t.corners[(edge.k + 2) % 3];
    auto const d = u.corners[(other.k + 2) % 3];
    auto const ad = u.across[(other.k + 1) % 3];
    auto const db = u.across[(other.k + 2) % 3];
    auto const bc = t.across[(edge.k + 1) % 3];
    auto const ca = t.across[(edge.k + 2) % 3];
    face(edge.face) = { { a, d, c }, { ad, other.face, ca } };
    face(other.face) = { { d, b, c }, { db, bc, edge.face } };
    relink(ad, d, edge.face);
    relink(bc, c, other.face);
}

// Flips edges until those that are given, and those around flipped ones, are Delaunay.
void FlatMesh::improve(std::vector<Edge> pending)
{
    std::size_t most = 100 * (faces_.size() + pending.size()); // Rounding could make it cycle.
    while (!pending.empty() && most-- > 0) {
        auto const edge = pending.back();
        pending.pop_back();
        if (!can_flip(edge))
            continue;
        auto const other = other_side(edge);
        auto const& here = face(edge.face).corners;
        auto const& far = points_[face(other.face).corners[(other.k + 2) % 3]];
        Vec2 const& a = points_[here[0]];
        Vec2 const& b = points_[here[1]];
        Vec2 const& c = points_[here[2]];
        double const scale = std::max({ (a - far).squaredNorm(), (b - far).squaredNorm(), 1e-12 });
        if (in_circle(a, b, c, far) <= 1e-9 * scale * scale)
            continue;
        flip(edge);
        for (auto const number : { edge.face, other.face })
            for (unsigned k = 0; k < 3; ++k)
                pending.push_back({ number, k });
    }
}

void FlatMesh::improve_all()
{
    std::vector<Edge> all;
    for (std::size_t i = 0; i < faces_.size(); ++i)
        for (unsigned k = 0; k < 3; ++k)
            all.push_back({ static_cast<std::int32_t>(i), k });
    improve(std::move(all));
}

std::optional<FlatMesh::Corner> FlatMesh::add_point(Vec2 const& at)
{
    auto const holds = [&](Face const& face) {
        auto const& [a, b, c] = face.corners;
        return turn(points_[a], points_[b], at) >= 0 && turn(points_[b], points_[c], at) >= 0
            && turn(points_[c], points_[a], at) >= 0;
    };
    auto const found = std::ranges::find_if(faces_, holds);
    bool const is_there
        = std::ranges::any_of(points_, [&](Vec2 const& point) { return point == at; });
    if (found == faces_.end() || is_there)
        return std::nullopt;
    auto const number = static_cast<Corner>(points_.size());
    points_.push_back(at);
    auto const first = static_cast<std::int32_t>(found - faces_.begin());
    auto const second = static_cast<std::int32_t>(faces_.size());
    auto const old = *found;
    auto const& [a, b, c] = old.corners;
    face(first) = { { a, b, number }, { old.across[0], second, second + 1 } };
    faces_.push_back({ { b, c, number }, { old.across[1], second + 1, first } });
    faces_.push_back({ { c, a, number }, { old.across[2], first, second } });
    relink(old.across[1], c, second);
    relink(old.across[2], a, second + 1);
    improve({ { first, 0 }, { second, 0 }, { second + 1, 0 } });
    return number;
}

bool FlatMesh::has_edge(Corner from, Corner to) const
{
    for (auto const& face : faces_)
        for (unsigned k = 0; k < 3; ++k)
            if ((face.corners[k] == from && face.corners[(k + 1) % 3] == to)
                || (face.corners[k] == to && face.corners[(k + 1) % 3] == from))
                return true;
    return false;
}

// Finds an edge that crosses the line between two points and can be flipped; one whose place is
// taken by an edge that does not cross the line, if there is any.
std::optional<FlatMesh::Edge> FlatMesh::crossing(Corner from, Corner to) const
{
    std::optional<Edge> found;
    for (std::size_t i = 0; i < faces_.size(); ++i)
        for (unsigned k = 0; k < 3; ++k) {
            auto const& corners = faces_[i].corners;
            auto const a = corners[k];
            auto const b = corners[(k + 1) % 3];
            Edge const edge { static_cast<std::int32_t>(i), k };
            if (a > b || !do_meet(points_[a], points_[b], points_[from], points_[to])
                || !can_flip(edge))
                continue;
            auto const other = other_side(edge);
            auto const c = corners[(k + 2) % 3];
            auto const d = face(other.face).corners[(other.k + 2) % 3];
            if (!do_meet(points_[c], points_[d], points_[from], points_[to]))
                return edge;
            found = edge;
        }
    return found;
}

bool FlatMesh::add_line(Corner from, Corner to)
{
    constexpr int kMost = 200; // More flips than a line of a leaf ever needs.
    for (int i = 0; i < kMost && !has_edge(from, to); ++i) {
        auto const edge = crossing(from, to);
        if (!edge)
            return false;
        flip(*edge);
    }
    if (!has_edge(from, to))
        return false;
    lines_.insert(std::minmax(from, to));
    improve_all();
    return true;
}

} // namespace tractus::leaf
