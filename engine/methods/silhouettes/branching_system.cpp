#include "engine/methods/silhouettes/branching_system.h"

#include "engine/methods/silhouettes/bump_touch.h"
#include "engine/methods/silhouettes/spaced_ends.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace tractus::silhouette {

namespace {

// Maximum distance of the foot bump's end from the trunk, as a share of the bump's radius, in
// crowns with a given number of branches. Where two large lobes meet under the crown, the trunk
// enters through the corner of one lobe and passes near its end, although that lobe is not the
// foot.
constexpr double kCloseFoot = 0.6;

// The apex bump's end, if it is within 60 degrees of the trunk's final direction.
std::optional<Vec2> apex_ahead(BranchingSystem const& system)
{
    if (system.inside.last + 1 != system.trunk.size())
        return std::nullopt;
    auto const& trunk = system.trunk;
    Vec2 const ahead = direction_of(trunk.back() - trunk[trunk.size() - 1 - trunk.size() / 8]);
    for (auto const& bump : system.bumps)
        if (bump.role == Role::Apex
            && (bump.end - trunk.back()).dot(ahead) > 0.5 * (bump.end - trunk.back()).norm())
            return bump.end;
    return std::nullopt;
}

// Outline of the area covered by the trunk's own end: the apex bump or, if the outline is divided
// among `branches` branches, the part of the bump that the trunk keeps.
std::vector<Vec2> apex_crown(BranchingSystem const& system, std::size_t branches)
{
    std::vector<Vec2> crown;
    for (auto const& bump : system.bumps) {
        if (bump.role != Role::Apex || !(bump.strength > 0))
            continue;
        auto const n = static_cast<std::uint32_t>(system.outline.size());
        auto const arc = branches > 0 ? kept_by_trunk(system.outline, bump, branches) : bump.arc;
        for (auto i = arc.first;; i = (i + 1) % n) {
            crown.push_back(system.outline[i]);
            if (i == arc.last)
                break;
        }
    }
    return crown;
}

Branch branch_to(BranchingSystem const& system, Bump const& bump, BranchCurve path)
{
    Branch branch;
    branch.path = std::move(path);
    auto const& curve = branch.path.curve;
    branch.crown = crown_of(system.outline, bump, curve);
    branch.cone_deg = cone_angle_deg(bump.radius, (curve.end - curve.base).norm());
    return branch;
}

// The lateral bump in which a drawn branch ends, among the bumps that have no branch so far; no
// value if the branch ends in none of them.
std::optional<std::size_t> bump_at(std::span<Bump const> bumps, Vec2 const& end,
                                   std::span<std::optional<Branch> const> taken)
{
    // Tolerance as a share of the outline's diagonal, which is 1 in this frame.
    constexpr double kNear = 0.08;
    std::optional<std::size_t> nearest;
    for (std::size_t i = 0; i < bumps.size(); ++i) {
        double const far = (bumps[i].end - end).norm();
        if (bumps[i].role == Role::Lateral && !taken[i] && far <= std::max(kNear, bumps[i].radius)
            && (!nearest || far < (bumps[*nearest].end - end).norm()))
            nearest = i;
    }
    return nearest;
}

double angle_at_base_deg(BranchingSystem const& system, BranchCurve const& path, double over)
{
    auto const& trunk = system.trunk;
    auto const next = std::min(path.trunk_sample + 1, trunk.size() - 1);
    Vec2 const along = trunk[next] - trunk[next - 1];
    Vec2 const out = over > 0 ? chord_to_share(path.curve, over) : path.curve.base_tangent;
    return degrees(std::fabs(std::atan2(cross(along, out), along.dot(out))));
}

// Drawn branches: in `of_bump` by the index of the bump in which they end, in `elsewhere` if they
// end in no bump.
struct DrawnBranches {
    std::vector<std::optional<Branch>> of_bump;
    std::vector<Branch> elsewhere {};
};

// Makes the drawn branches from their strokes. Their branching angles become samples of `angles`,
// from which the other branches get theirs.
DrawnBranches take_drawn_branches(BranchingSystem const& system, Run const& bases,
                                  std::vector<std::vector<Vec2>> const& strokes,
                                  BranchingAngles& angles)
{
    DrawnBranches drawn { .of_bump = std::vector<std::optional<Branch>>(system.bumps.size()) };
    for (std::size_t number = 0; number < strokes.size(); ++number) {
        auto path = drawn_branch(
            { .trunk = system.trunk, .bases = bases, .outline = system.outline, .angles = angles },
            strokes[number]);
        angles.learn({ path.t, angle_at_base_deg(system, path, angles.over()) });
        auto const bump = bump_at(system.bumps, path.curve.end, drawn.of_bump);
        Branch branch;
        if (bump) {
            branch = branch_to(system, system.bumps[*bump], std::move(path));
        } else {
            branch.path = std::move(path);
            branch.crown = lens_crown(branch.path.curve);
        }
        branch.origin = Branch::Origin::Drawn;
        branch.number = number;
        if (bump)
            drawn.of_bump[*bump] = std::move(branch);
        else
            drawn.elsewhere.push_back(std::move(branch));
    }
    return drawn;
}

// Range of trunk samples, inside the outline, where inferred branches may start: at least two if
// possible.
Run bases_of(BranchingSystem const& system, double unbranched)
{
    auto bases = system.inside;
    auto const first = static_cast<std::size_t>(
        std::ceil(unbranched * static_cast<double>(system.trunk.size() - 1)));
    if (bases.first < bases.last)
        bases.first = std::clamp(first, bases.first, bases.last - 1);
    return bases;
}

void infer_branches(BranchingSystem& system, Run const& bases, DrawnBranches drawn,
                    BranchingAngles const& angles)
{
    BranchSearch const search {
        .trunk = system.trunk, .bases = bases, .outline = system.outline, .angles = angles
    };
    for (std::size_t i = 0; i < system.bumps.size(); ++i) {
        auto const& bump = system.bumps[i];
        if (bump.role != Role::Lateral)
            continue;
        if (drawn.of_bump[i]) {
            system.branches.push_back(*std::move(drawn.of_bump[i]));
            continue;
        }
        auto path = infer_branch(search, { .end = bump.end, .tangent = bump.tangent });
        system.branches.push_back(branch_to(system, bump, std::move(path)));
        system.branches.back().number = i;
    }
    for (auto& branch : drawn.elsewhere)
        system.branches.push_back(std::move(branch));
}

// Adds branches to the parts of the outline without bumps, until the system has `branches`
// branches.
void add_spaced(BranchingSystem& system, Run const& bases, BranchingAngles const& angles,
                std::size_t branches)
{
    BranchSearch const search {
        .trunk = system.trunk, .bases = bases, .outline = system.outline, .angles = angles
    };
    std::vector<Vec2> drawn_ends;
    for (auto const& branch : system.branches)
        if (branch.origin == Branch::Origin::Drawn)
            drawn_ends.push_back(branch.path.curve.end);
    for (auto& spaced : spaced_branches({ .outline = system.outline,
                                          .bumps = system.bumps,
                                          .search = search,
                                          .drawn_ends = drawn_ends,
                                          .has = system.branches.size(),
                                          .branches = branches })) {
        auto branch = branch_to(system, spaced.part, std::move(spaced.path));
        branch.origin = Branch::Origin::Spaced;
        branch.number = spaced.number;
        system.branches.push_back(std::move(branch));
    }
}

// The options for filling a crown that should have `branches` branches; 0: `options` as they are.
FillOptions filling(FillOptions options, std::size_t branches)
{
    constexpr double kMinGap = 0.006;
    // Minimum length of a branch; shorter ones are hidden by the trunk.
    constexpr double kMinLength = 0.02;
    if (branches > 0) {
        options.most_branches = branches;
        options.enough = 1;
        options.min_gap = kMinGap;
        options.min_length = kMinLength;
    }
    return options;
}

void add_branches(BranchingSystem& system, Run const& bases, std::optional<Vec2> const& goes_on,
                  BranchingAngles const& angles, FillOptions const& options, std::size_t branches)
{
    auto const apex = apex_crown(system, branches);
    auto filled = fill_crown({ .outline = system.outline,
                               .trunk = system.trunk,
                               .run = bases,
                               .goes_on = goes_on,
                               .angles = angles,
                               .branches = system.branches,
                               .apex = apex },
                             filling(options, branches));
    system.coverage_before = filled.coverage_before;
    system.coverage_after = filled.coverage_after;
    double farthest = 0;
    for (auto& branch : filled.added) {
        double const far = (branch.path.curve.base - system.trunk.back()).norm();
        if (branch.is_beyond && far > farthest) {
            farthest = far;
            system.trunk_goes_on_to = branch.path.curve.base;
        }
        system.branches.push_back(std::move(branch));
    }
}

// Adds the apex branch: straight from the trunk's end into the apex bump, to halfway between the
// bump's end and its tip.
void add_apex(BranchingSystem& system, std::size_t branches)
{
    auto crown = apex_crown(system, branches);
    if (crown.size() < 3 || !system.trunk_goes_on_to)
        return;
    for (std::size_t i = 0; i < system.bumps.size(); ++i) {
        if (system.bumps[i].role != Role::Apex)
            continue;
        Vec2 const base = system.trunk.back();
        Vec2 const end = 0.5 * (system.bumps[i].end + system.bumps[i].tip);
        Branch branch { .origin = Branch::Origin::Apex, .number = i, .crown = std::move(crown) };
        branch.path = { .curve = { base, end, end - base, end - base },
                        .trunk_sample = system.trunk.size() - 1,
                        .t = 1,
                        .length = (end - base).norm(),
                        .side = Side::Right };
        system.branches.push_back(std::move(branch));
        return;
    }
}

void move_to_sheet(Branch& branch, Similarity const& way)
{
    branch.crown = way.points(branch.crown);
    branch.path.curve = way.cubic(branch.path.curve);
    branch.path.length *= way.turn.norm();
    branch.path.outside *= way.turn.norm();
    // Transforms the similarity from the model to the copy, too: it is conjugated by the rotation
    // and scale of `way`. For a mirrored copy the rotation of `way` enters with the opposite sign.
    auto& copy = branch.from_model;
    copy.from = way.point(copy.from);
    copy.to = way.point(copy.to);
    if (copy.mirrors) {
        Vec2 const unit = way.turn / way.turn.norm();
        Vec2 const twice(unit.x() * unit.x() - unit.y() * unit.y(), 2 * unit.x() * unit.y());
        copy.turn = Vec2(twice.x() * copy.turn.x() - twice.y() * copy.turn.y(),
                         twice.x() * copy.turn.y() + twice.y() * copy.turn.x());
    }
}

void move_to_sheet(BranchingSystem& system, Similarity const& way)
{
    double const unit = way.turn.norm();
    system.outline = way.points(system.outline);
    system.trunk = way.points(system.trunk);
    if (system.trunk_goes_on_to)
        system.trunk_goes_on_to = way.point(*system.trunk_goes_on_to);
    for (auto& bump : system.bumps) {
        bump.end = way.point(bump.end);
        bump.tangent = way.vector(bump.tangent) / unit;
        bump.tip = way.point(bump.tip);
        bump.radius *= unit;
    }
    for (auto& branch : system.branches)
        move_to_sheet(branch, way);
}

} // namespace

double coverage_of(BranchingSystem const& system)
{
    CoverageGrid grid(system.outline);
    for (auto const& branch : system.branches)
        grid.cover(grid.cells_of(branch.crown));
    return grid.coverage();
}

std::vector<Vec2> BranchingSystem::whole_trunk() const
{
    auto whole = trunk;
    if (!trunk_goes_on_to || has_apex_branch())
        return whole;
    double const step = length_of(trunk) / static_cast<double>(trunk.size() - 1);
    Vec2 const way = *trunk_goes_on_to - trunk.back();
    auto const more = std::max<long>(1, std::lround(way.norm() / step));
    for (long i = 1; i <= more; ++i)
        whole.emplace_back(trunk.back() + way * static_cast<double>(i) / static_cast<double>(more));
    return whole;
}

Result<BranchingSystem> infer_system(Drawing const& drawing, InferenceOptions const& options)
{
    auto clean = TRY(clean_drawing(drawing, options.outline));
    BranchingSystem system;
    ChordalAxis const axis(std::move(clean.outline));
    system.outline = axis.outline();
    system.trunk = std::move(clean.trunk);
    system.notes = std::move(clean.notes);
    system.triangles = axis.counts();
    auto const run = inside_run(system.outline, system.trunk);
    if (!run)
        return fail(Fault::User,
                    "the trunk is wholly outside of the outline: draw it into the crown");
    system.inside = *run;
    system.bumps = find_bumps(axis, options.bumps);
    system.touches_taken = take_touches(system.bumps, system.outline, clean.touches);
    auto const goes_on = set_roles(system.bumps, system.outline, system.trunk, *run,
                                   options.branches > 0 ? kCloseFoot : 1);
    system.trunk_goes_on_to = apex_ahead(system);
    auto angles = options.angles;
    auto const bases = bases_of(system, options.unbranched);
    bool const anywhere = options.drawn_bases == InferenceOptions::DrawnBases::Anywhere;
    auto const drawn_bases = anywhere ? Run { 0, system.trunk.size() - 1 } : system.inside;
    auto drawn = take_drawn_branches(system, drawn_bases, clean.branches, angles);
    infer_branches(system, bases, std::move(drawn), angles);
    if (options.branches > 0)
        add_spaced(system, bases, angles, options.branches);
    add_branches(system, bases, goes_on, angles, options.fill, options.branches);
    add_apex(system, options.branches);
    move_to_sheet(system, clean.to_sheet);
    return system;
}

} // namespace tractus::silhouette
