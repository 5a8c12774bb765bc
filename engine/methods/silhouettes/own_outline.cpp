#include "engine/methods/silhouettes/own_outline.h"

#include "engine/methods/silhouettes/coverage_grid.h"
#include "engine/methods/silhouettes/loops.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace tractus::silhouette {

namespace {

constexpr double kMaxOfCrown = 0.5;
constexpr double kMaxOfTrunk = 0.5;
constexpr double kMinOfBranch = 1.0 / 3;
constexpr double kMinShared = 0.2;
// Maximum number of points of a stroke when searching for crossings.
constexpr std::size_t kMaxToCross = 512;

// The outline of the area that a stroke encloses.
std::vector<Vec2> enclosed(std::span<Vec2 const> stroke)
{
    std::vector<Vec2> closed(stroke.begin(), stroke.end());
    if (closed.size() < 3)
        return {};
    if (closed.size() > kMaxToCross)
        closed = resampled_outline(closed, kMaxToCross);
    return largest_loop(closed).outline;
}

double share_inside(std::vector<Vec2> const& loop, BranchingSystem const& system)
{
    auto const& run = system.inside;
    std::size_t count = 0;
    for (auto i = run.first; i <= run.last; ++i)
        count += is_inside(loop, system.trunk[i]);
    return static_cast<double>(count) / static_cast<double>(run.last - run.first + 1);
}

// The drawn outline of a branch's crown, prepared by clean_drawing(); empty if it cannot be the
// branch's outline.
std::vector<Vec2> crown_in(std::vector<Vec2> const& drawn, Branch const& branch)
{
    constexpr std::size_t kPoints = 96;
    OutlineOptions const options { .min_area_mm2 = 0 };
    Drawing const drawing { { drawn }, branch.line(17) };
    auto const clean = clean_drawing(drawing, options);
    if (!clean || !inside_run(clean->outline, clean->trunk))
        return {};
    return resampled_outline(clean->to_sheet.points(clean->outline), kPoints);
}

// Gives a copy the new crown of the branch that it copies. The copy's crown does not exceed its
// previous size and stays inside the system's outline.
void follow_model(BranchingSystem const& system, Branch& copy, double area_before)
{
    // Maximum distance by which the copy's crown may leave the outline, as a share of the outline's
    // diagonal.
    constexpr double kMaxOver = 0.01;
    // Minimum scale of the copy, as a share of the largest scale that does not enlarge it.
    constexpr double kSmallest = 0.3;
    auto const& model = system.branches[*copy.model];
    double const limit = kMaxOver * box_of(system.outline).diagonal();
    double const area = std::max(std::fabs(signed_area(model.crown)), 1e-300);
    double const largest = std::min(1.0, std::sqrt(area_before / area));
    auto const as_large = [&](double size) {
        auto way = copy.from_model;
        way.turn *= size;
        return way;
    };
    double low = kSmallest * largest;
    double high = largest;
    for (int i = 0; i < 12; ++i) {
        double const size = i == 0 ? high : (low + high) / 2;
        auto const crown = as_large(size).points(model.crown);
        (excursion(system.outline, crown) <= limit ? low : high) = size;
    }
    copy.from_model = as_large(low);
    copy.crown = copy.from_model.points(model.crown);
    copy.leaf = model.leaf ? std::optional(moved(*model.leaf, copy.from_model)) : std::nullopt;
    copy.path.curve = copy.from_model.cubic(model.path.curve);
    copy.path.length = length_of(copy.path.curve.points(17));
}

} // namespace

std::optional<OutlinedBranch> outlined_in(BranchingSystem const& system,
                                          std::span<Vec2 const> stroke)
{
    auto const loop = enclosed(stroke);
    if (loop.size() < 3 || std::fabs(signed_area(loop)) > kMaxOfCrown * signed_area(system.outline)
        || share_inside(loop, system) > kMaxOfTrunk)
        return std::nullopt;
    auto both = system.outline;
    both.insert(both.end(), loop.begin(), loop.end());
    CoverageGrid grid(both);
    auto const own = grid.cells_of(loop);
    grid.cover(own);
    std::optional<OutlinedBranch> best;
    double most = kMinShared;
    for (std::size_t i = 0; i < system.branches.size(); ++i) {
        auto const& branch = system.branches[i];
        if (!is_inside(loop, branch.path.curve.end))
            continue;
        auto const crown = grid.cells_of(branch.crown);
        auto const shared = static_cast<double>(grid.count_covered(crown));
        auto const all = static_cast<double>(crown.count + own.count) - shared;
        if (shared < kMinOfBranch * static_cast<double>(crown.count) || shared < most * all)
            continue;
        most = shared / all;
        best = { i, most };
    }
    return best;
}

std::optional<std::size_t> branch_in(BranchingSystem const& system, std::span<Vec2 const> stroke)
{
    auto const found = outlined_in(system, stroke);
    return found ? std::optional(found->branch) : std::nullopt;
}

void take_own_outlines(BranchingSystem& system, std::span<OwnOutline const> outlines)
{
    // Indices of the changed branches, with the previous areas of their crowns.
    std::vector<std::pair<std::size_t, double>> taken;
    for (auto const& own : outlines) {
        auto const i = number_of(system, own.branch);
        if (!i || system.branches[*i].is_outlined())
            continue;
        auto& branch = system.branches[*i];
        auto crown = crown_in(own.outline, branch);
        if (crown.empty())
            continue;
        taken.emplace_back(*i, std::fabs(signed_area(branch.crown)));
        branch.crown = std::move(crown);
        branch.own_outline = own.outline;
        branch.style_to = own.style_to;
        branch.model.reset();
        branch.from_model = {};
        if (own.is_leaf)
            branch.leaf = leaf_along(branch.crown, branch.line(17));
    }
    for (auto const& [i, area_before] : taken)
        for (auto& copy : system.branches)
            if (copy.model == i)
                follow_model(system, copy, area_before);
    if (!taken.empty())
        system.coverage_after = coverage_of(system);
}

// Searches among the trunk's branches as inferred, then among those with drawn outlines applied; a
// branch can be in different places before and after that.
static Result<std::optional<std::pair<std::string, double>>>
outlined_on_trunk(Drawing const& drawing, std::span<Vec2 const> stroke,
                  SkeletonOptions const& options)
{
    auto inferred = drawing;
    inferred.own_outlines.clear();
    for (auto const* const lines : { &std::as_const(inferred), &drawing }) {
        auto const system = TRY(infer_on_trunk(*lines, options));
        if (auto const found = outlined_in(system, stroke))
            return std::pair(name_of(system.branches[found->branch]), found->shared);
        if (drawing.own_outlines.empty())
            break;
    }
    return std::nullopt;
}

Result<std::optional<std::string>> branch_outlined_by(Drawing const& drawing,
                                                      std::span<Vec2 const> stroke,
                                                      SkeletonOptions const& options, Search search)
{
    auto best = TRY(outlined_on_trunk(drawing, stroke, options));
    if (search == Search::AnyLevel && drawing.is_refined()) {
        auto const skeleton = TRY(infer_skeleton(drawing, options));
        for (auto const s : skeleton.drawn_systems()) {
            auto const found = outlined_in(skeleton.systems[s], stroke);
            if (found && (!best || found->shared > best->second))
                best = { skeleton.path_of({ s, found->branch }), found->shared };
        }
    }
    return best ? std::optional(best->first) : std::nullopt;
}

Result<void> add_own_outline(Drawing& drawing, std::vector<Vec2> stroke,
                             SkeletonOptions const& options, StyleScope style_to, Search search,
                             bool is_leaf)
{
    auto const branch = TRY(branch_outlined_by(drawing, stroke, options, search));
    if (!branch)
        return fail(Fault::User,
                    "the outline lies around none of the tree's branches: draw it around one, "
                    "smaller than the crown");
    OutlineOptions const any_size { .min_area_mm2 = 0 };
    TRY(clean_drawing({ { stroke }, {} }, any_size));
    std::erase_if(drawing.own_outlines, [&](OwnOutline const& own) {
        is_leaf = is_leaf || (own.branch == *branch && own.is_leaf);
        return own.branch == *branch;
    });
    drawing.own_outlines.push_back({ *branch, std::move(stroke), style_to, is_leaf });
    return {};
}

} // namespace tractus::silhouette
