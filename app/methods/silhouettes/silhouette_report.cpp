#include "app/methods/silhouettes/silhouette_report.h"

#include "engine/methods/silhouettes/crown_surface.h"
#include "engine/methods/silhouettes/leaf_raster.h"
#include "engine/methods/silhouettes/sibling_style.h"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>

namespace tractus::silhouette {

using Report = nlohmann::ordered_json;

static Report point_json(Vec2 const& point)
{
    return { point.x(), point.y() };
}

static char const* word_of(Role role)
{
    switch (role) {
    case Role::Foot:
        return "foot";
    case Role::Apex:
        return "apex";
    case Role::Lateral:
        break;
    }
    return "lateral";
}

static Report bump_json(Bump const& bump)
{
    Report report { { "E", point_json(bump.end) },
                    { "r", bump.radius },
                    { "tip", point_json(bump.tip) },
                    { "tangent", point_json(bump.tangent) },
                    { "role", word_of(bump.role) } };
    if (bump.touch)
        report["touched"] = true;
    return report;
}

// Report of a branch's laterals, for a branch on which the user drew or that copies the style of
// such a branch.
static Report bearing_json(Branch const& parent, BranchingSystem const& system)
{
    auto const style = parent_style(parent, system);
    Report bearing { { "children", style.children.size() } };
    if (!style.children.empty())
        bearing.update(
            { { "unbranched", style.unbranched() },
              { "last", style.last() },
              { "spacing", { { "mean", style.spacing }, { "deviation", style.deviation } } },
              { "angle_deg", style.mean_angle_deg() } });
    Report drawn = Report::array();
    for (auto const& child : style.children)
        if (child.branch.is_stroke())
            drawn.push_back({ { "name", name_of(child.branch) },
                              { "u", child.u },
                              { "base", point_json(child.branch.path.curve.base) },
                              { "end", point_json(child.branch.path.curve.end) } });
    if (!drawn.empty())
        bearing["drawn"] = std::move(drawn);
    return bearing;
}

static Report branch_json(Skeleton const& skeleton, std::size_t i)
{
    auto const& branch = skeleton.systems[0].branches[i];
    auto const& curve = branch.path.curve;
    Report report { { "name", name_of(branch) },
                    { "t", branch.path.t },
                    { "side", branch.path.side == Side::Left ? "left" : "right" },
                    { "base", point_json(curve.base) },
                    { "end", point_json(curve.end) },
                    { "curve",
                      { point_json(curve.base), point_json(curve.base + curve.base_tangent / 3),
                        point_json(curve.end - curve.end_tangent / 3), point_json(curve.end) } },
                    { "length", branch.path.length },
                    { "tangent_share", branch.path.tangent_share },
                    { "cone_deg", branch.cone_deg } };
    if (branch.is_outlined()) {
        report["outlined"] = true;
        report["bears"] = skeleton.branches_on({ 0, i });
    }
    if (branch.leaf)
        report["leaf"] = true;
    auto const below = skeleton.system_of[0][i];
    if (below == kNoSystem) {
        if (branch.leaf && !branch.style_from.empty())
            report["style_from"] = branch.style_from;
        return report;
    }
    auto const& system = skeleton.systems[below];
    if (branch.is_refined() || system.is_in_siblings_style)
        report["bearing"] = bearing_json(branch, system);
    if (!branch.style_from.empty())
        report["style_from"] = branch.style_from;
    else if (!branch.is_refined() && system.is_in_siblings_style)
        report["follows"] = true;
    return report;
}

// Report of the branches at deeper levels on which the user drew or that copy the style of such a
// branch.
static Report refined_json(Skeleton const& skeleton)
{
    Report refined = Report::array();
    for (auto const s : skeleton.drawn_systems())
        for (std::size_t b = 0; b < skeleton.systems[s].branches.size(); ++b) {
            auto const& branch = skeleton.systems[s].branches[b];
            auto const below = skeleton.system_of[s][b];
            if (s == 0 || !branch.is_refined() || (below == kNoSystem && !branch.leaf))
                continue;
            Report report { { "path", skeleton.path_of({ s, b }) },
                            { "base", point_json(branch.path.curve.base) },
                            { "end", point_json(branch.path.curve.end) } };
            if (branch.is_outlined())
                report["outlined"] = true;
            if (branch.leaf)
                report["leaf"] = true;
            else
                report["bearing"] = bearing_json(branch, skeleton.systems[below]);
            refined.push_back(std::move(report));
        }
    return refined;
}

static Report place_json(Place const& place)
{
    return { { "theta", place.theta_deg }, { "u", place.u } };
}

static Report arrangements_json(Tree const& tree)
{
    Report levels = Report::array();
    for (auto const& arrangement : tree.arrangements) {
        Report level = Report::array();
        for (auto const& branch : arrangement) {
            Report place { { "name", branch.name } };
            place.update(place_json(branch.place));
            level.push_back(std::move(place));
        }
        levels.push_back(std::move(level));
    }
    return levels;
}

static Report level_json(MeasuredLevel const& level)
{
    auto const& style = level.style;
    return { { "parents", level.parents },
             { "children",
               { { "mean", style.children }, { "deviation", style.children_deviation } } },
             { "bare", style.bare },
             { "unbranched", style.unbranched },
             { "spacing", { { "mean", style.spacing }, { "deviation", style.spacing_deviation } } },
             { "angle_deg",
               { { "mean", level.mean_angle_deg },
                 { "first", style.first_angle_deg },
                 { "last", style.last_angle_deg },
                 { "deviation", style.angle_deviation_deg } } },
             { "lengths", level.lengths },
             { "pattern", name_of(level.pattern) } };
}

static Report levels_json(MeasuredStyle const& style)
{
    Report levels = Report::array();
    for (auto const& level : style.levels)
        levels.push_back(level_json(level));
    return levels;
}

static Report surface_json(Skeleton const& skeleton, std::vector<CrownLine> const& lines)
{
    constexpr int kHeights = 10;
    constexpr int kStep_deg = 30;
    CrownSurface const surface(skeleton.surface, skeleton.systems[0].trunk);
    std::array<std::size_t, 3> counts {};
    for (auto const& line : lines)
        if (auto const kind = kind_of(line))
            ++counts[static_cast<std::size_t>(*kind)];
    Vec2 range(1e300, -1e300);
    for (int theta = 0; theta < 360; theta += kStep_deg) {
        Vec2 const own = surface.heights(theta);
        range = { std::min(range.x(), own.x()), std::max(range.y(), own.y()) };
    }
    Report rows = Report::array();
    for (int i = 0; i <= kHeights; ++i) {
        double const height = range.x() + (range.y() - range.x()) * i / kHeights;
        Report at = Report::array();
        for (int theta = 0; theta < 360; theta += kStep_deg) {
            auto const reach = surface.reach(theta, height);
            at.push_back(reach ? Report(*reach) : Report());
        }
        rows.push_back({ { "height", height }, { "at", std::move(at) } });
    }
    return { { "rings", counts[0] },
             { "climbs", counts[1] },
             { "sides", counts[2] },
             { "radius", std::move(rows) } };
}

std::string print_report(Skeleton const& skeleton, Tree const& tree,
                         std::optional<MeasuredStyle> const& style,
                         std::vector<CrownLine> const& crown_lines)
{
    auto const& system = skeleton.systems[0];
    auto const& counts = system.triangles;
    auto const leaves = leaf_coverage(tree.plant, tree.outline_mm);
    Report bumps = Report::array();
    for (auto const& bump : system.bumps)
        bumps.push_back(bump_json(bump));
    Report branches = Report::array();
    for (std::size_t i = 0; i < system.branches.size(); ++i)
        if (system.branches[i].origin != Branch::Origin::Apex || system.branches[i].is_refined())
            branches.push_back(branch_json(skeleton, i));
    Report report {
        { "samples", system.outline.size() },
        { "triangles", counts.terminal + counts.sleeve + counts.junction },
        { "terminal", counts.terminal },
        { "sleeve", counts.sleeve },
        { "junction", counts.junction },
        { "bumps", system.bumps.size() },
        { "bump", std::move(bumps) },
        { "trunk_samples_inside", Report::array({ system.inside.first, system.inside.last }) },
        { "trunk_continues_to",
          system.trunk_goes_on_to ? point_json(*system.trunk_goes_on_to) : Report() },
        { "branch", std::move(branches) },
        { "coverage",
          { { "before", system.coverage_before }, { "after", system.coverage_after } } },
        { "leaf_coverage", { { "inside", leaves.inside }, { "outside", leaves.outside } } },
        { "arrangement", arrangements_json(tree) },
        { "elements", tree.element_count() },
        { "leaves", tree.leaves },
        { "branches", tree.plant.axes.size() - 1 + tree.sprays },
        { "notes", system.notes }
    };
    if (system.leaf)
        report["leaf"] = true;
    if (auto refined = refined_json(skeleton); !refined.empty())
        report["refined"] = std::move(refined);
    if (!skeleton.surface.empty())
        report["surface"] = surface_json(skeleton, crown_lines);
    if (style) {
        auto const again = measure_style(tree.plant);
        report["style"] = { { "measured", levels_json(*style) },
                            { "tree", again ? levels_json(*again) : Report::array() } };
    }
    return report.dump() + "\n";
}

std::string print_arrangement(Arrangement const& arrangement, Pattern pattern, std::uint64_t seed)
{
    Report places = Report::array();
    for (auto const& place : arrangement.places)
        places.push_back(place_json(place));
    Report report { { "pattern", name_of(pattern) } };
    if (pattern == Pattern::Whorls)
        report["whorl"] = pattern.whorl;
    report.update({ { "count", arrangement.places.size() },
                    { "seed", seed },
                    { "cost_before", arrangement.cost_before },
                    { "cost_after", arrangement.cost_after },
                    { "places", std::move(places) } });
    return report.dump() + "\n";
}

} // namespace tractus::silhouette
