#include "engine/mesh/tube_shape.h"

#include <algorithm>
#include <cmath>

namespace tractus::mesh {

namespace {

class SaddleShaper {
public:
    SaddleShaper(Spine const& spine, std::span<Section const> sections, TubePart const& part,
                 Vec3f* positions, Vec3f* normals)
        : spine_(spine)
        , sections_(sections)
        , part_(part)
        , positions_(positions)
        , normals_(normals)
        , corners_(static_cast<std::size_t>(spine.sides) + 1)
    {
    }

    void run() const
    {
        auto const contains = [&](std::uint32_t station) {
            return spine_.saddle.contains(spine_.stations[station].arc_mm);
        };
        auto first = part_.first;
        while (first < part_.last && !contains(first))
            ++first;
        auto end = first;
        while (end <= part_.last && contains(end))
            lean(end++);
        for (auto station = first; station < end; ++station)
            set_normals(station);
    }

private:
    Vec3f& position(std::uint32_t station, std::size_t corner) const
    {
        return positions_[(station - part_.first) * corners_ + corner];
    }

    double share(std::uint32_t station) const
    {
        return spine_.saddle.share(spine_.stations[station].arc_mm);
    }

    // Component of a vector across the parent.
    Vec3 across_parent(Vec3 const& v) const
    {
        auto const& along = spine_.saddle.parent_direction;
        return v - along * along.dot(v);
    }

    // Moves the corners of a ring along the tube.
    void lean(std::uint32_t station) const
    {
        auto const& saddle = spine_.saddle;
        auto const& section = sections_[station];
        // With larger steps, rings could pass each other.
        double const most_mm = 0.45 * (saddle.end_mm - saddle.level_mm);
        double const left = share(station) * share(station);
        Vec3 const along = section.tangent.cast<double>();
        for (std::size_t j = 0; j < corners_; ++j) {
            auto& corner = position(station, j);
            Vec3 const out = (corner - section.center_mm).cast<double>();
            double const step_mm
                = std::clamp(exit_mm(out, along) - saddle.level_mm, -most_mm, most_mm);
            corner += (left * step_mm * along).cast<float>();
        }
    }

    // Distance from the base at which a line along the tube leaves the parent. `out`: vector from
    // the tube's centre line to that line.
    double exit_mm(Vec3 const& out, Vec3 const& along) const
    {
        double const radius_mm = spine_.saddle.parent_radius_mm;
        Vec3 const way = across_parent(along);
        Vec3 const from = across_parent(out);
        double const square = std::max(way.squaredNorm(), 1e-6);
        double const middle = from.dot(way);
        double const room = std::max(0.0, radius_mm * radius_mm - from.squaredNorm());
        return (std::sqrt(middle * middle + square * room) - middle) / square;
    }

    // Sets the normals of a ring: those of the leaning tube, blended with those of the parent's
    // surface.
    void set_normals(std::uint32_t station) const
    {
        auto const below = std::max(station, part_.first + 1) - 1;
        auto const above = std::min(station + 1, part_.last);
        auto const sides = corners_ - 1;
        auto const parents = static_cast<float>(std::pow(share(station), 3));
        for (std::size_t j = 0; j < corners_; ++j) {
            auto& normal = normals_[(station - part_.first) * corners_ + j];
            Vec3f const around
                = position(station, (j + 1) % sides) - position(station, (j + sides - 1) % sides);
            Vec3f tube = around.cross(position(above, j) - position(below, j));
            tube = tube.norm() > 0 ? Vec3f(tube.normalized()) : normal;
            Vec3 const out
                = across_parent(position(station, j).cast<double>() - spine_.saddle.base_mm);
            Vec3f const blend = (1 - parents) * tube + parents * out.normalized().cast<float>();
            normal = blend.norm() > 1e-3f ? Vec3f(blend.normalized()) : tube;
            turn_outwards(normal, position(station, j) - sections_[station].center_mm,
                          sections_[station].tangent);
        }
    }

    // Limits how far a normal leans into the tube, in the sharp corner between a steep branch and
    // its parent.
    static void turn_outwards(Vec3f& normal, Vec3f const& from_center, Vec3f const& along)
    {
        constexpr float kMost = 0.2f;
        Vec3f const across = from_center - along * along.dot(from_center);
        Vec3f const out = across.normalized();
        float const outwards = out.dot(normal);
        if (!(outwards < -kMost))
            return;
        Vec3f const beside = normal - outwards * out;
        normal = (std::sqrt(1 - kMost * kMost) * beside.normalized() - kMost * out).normalized();
    }

    Spine const& spine_;
    std::span<Section const> sections_;
    TubePart part_;
    Vec3f* positions_;
    Vec3f* normals_;
    std::size_t corners_;
};

} // namespace

double ridge_height(Ridges const& ridges, double arc_mm)
{
    constexpr double kLeast = 0.004;
    double const height = ridges.count > 0 ? ridges.depth_at(arc_mm) : 0;
    return height < kLeast ? 0 : height;
}

void add_ridges(Ridges const& ridges, Section const& section, std::size_t count, Vec3f* positions,
                Vec3f* normals)
{
    for (std::size_t j = 0; j < count; ++j) {
        Vec3f const out = (positions[j] - section.center_mm) / section.radius_mm;
        double const angle = std::atan2(out.y(), out.x());
        float const height = 1 + section.ridge * static_cast<float>(ridges.outline(angle));
        float const slope = section.ridge * static_cast<float>(ridges.outline_slope(angle));
        positions[j] = section.center_mm + height * section.radius_mm * out;
        if (normals)
            normals[j] = (normals[j] - slope / height * section.tangent.cross(out)).normalized();
    }
}

void shape_saddle(Spine const& spine, std::span<Section const> sections, TubePart const& part,
                  Vec3f* positions, Vec3f* normals)
{
    if (spine.saddle.parent_radius_mm > 0)
        SaddleShaper(spine, sections, part, positions, normals).run();
}

} // namespace tractus::mesh
