#include "engine/methods/silhouettes/tree_form.h"

#include <cmath>
#include <fmt/format.h>
#include <utility>

namespace tractus::silhouette {

namespace {

tl::unexpected<Error> refuse(char const* what, double given, double least, double most)
{
    return fail(Fault::User,
                fmt::format("{} cannot be {:g}: give {:g} to {:g}", what, given, least, most));
}

Result<void> check_style(BranchStyle const& style)
{
    struct Range {
        char const* what;
        double given;
        double least;
        double most;
    };
    std::array const ranges {
        Range { "the branches of a parent", style.children, 1, kMaxChildren },
        Range { "their deviation", style.children_deviation, 0, kMaxChildren },
        Range { "the share of parents without branches", style.bare, 0, kMaxBare },
        Range { "the unbranched share of a parent", style.unbranched, 0, 1 },
        Range { "the distance of branches", style.spacing, 0, 1 },
        Range { "the unevenness of distances", style.unevenness, 0, kMaxUneven },
        Range { "the deviation of distances", style.spacing_deviation, 0, 1 },
        Range { "the angle of the first branch", style.first_angle_deg, kMinAngle_deg,
                kMaxAngle_deg },
        Range { "the angle of the last branch", style.last_angle_deg, kMinAngle_deg,
                kMaxAngle_deg },
        Range { "the deviation of angles", style.angle_deviation_deg, 0, kMaxAngle_deg },
    };
    for (auto const& range : ranges)
        if (!(range.given >= range.least && range.given <= range.most))
            return refuse(range.what, range.given, range.least, range.most);
    return {};
}

Result<void> check_styles(TreeForm const& form)
{
    for (auto const& style : form.styles)
        if (!(style == BranchStyle {}))
            TRY(check_style(style));
    double const branches = styled_branches(form);
    if (branches > kMaxStyled)
        return fail(Fault::User,
                    fmt::format("the style would give the tree {:.0f} branches: {:g} are the "
                                "most; take fewer levels",
                                branches, kMaxStyled));
    return {};
}

} // namespace

bool is_usual(TreeForm form)
{
    TreeForm usual;
    usual.seed = form.seed;
    usual.has_whole_nodes = form.has_whole_nodes;
    usual.leaves_reach_outline = form.leaves_reach_outline;
    usual.bases_by_angle = form.bases_by_angle;
    if (form.plane_branches == kUsualPlaneBranches)
        usual.plane_branches = kUsualPlaneBranches;
    return form == usual;
}

double styled_branches(TreeForm const& form)
{
    double branches = 1;
    for (int level = 0; level < form.levels; ++level) {
        auto const& style = form.styles[static_cast<std::size_t>(level)];
        if (style.is_set())
            branches *= style.children * (1 - style.bare);
    }
    return branches;
}

Result<void> check_form(TreeForm const& form)
{
    if (form.levels < 1 || form.levels > 3)
        return refuse("the levels of a tree", form.levels, 1, 3);
    if (!(form.density >= 0 && form.density <= 10))
        return refuse("the density of branches", form.density, 0, 10);
    if (form.leaves < 1 || form.leaves > 500)
        return refuse("the leaves on a twig", form.leaves, 1, 500);
    if (!(form.leaf_width >= 0.01 && form.leaf_width <= 2))
        return refuse("the width of a leaf", form.leaf_width, 0.01, 2);
    for (auto const& pattern : form.patterns)
        if (pattern.whorl < kMinWhorl || pattern.whorl > kMaxWhorl)
            return refuse("the branches of a whorl", pattern.whorl, kMinWhorl, kMaxWhorl);
    if (form.plane_branches < 0 || form.plane_branches > kMaxPlaneBranches)
        return refuse("the branches in the drawing's plane", form.plane_branches, 0,
                      kMaxPlaneBranches);
    for (double const angle_deg : { form.base_angle_deg, form.tip_angle_deg })
        if (angle_deg != 0 && !(angle_deg >= kMinAngle_deg && angle_deg <= kMaxAngle_deg))
            return refuse("the angle of a branch", angle_deg, kMinAngle_deg, kMaxAngle_deg);
    if (!(std::fabs(form.rise) <= 2))
        return refuse("the rise of branches", form.rise, -2, 2);
    return check_styles(form);
}

// The branching angles that a form gives the trunk's branches.
static BranchingAngles angles_of(TreeForm const& form)
{
    BranchingAngles const usual;
    auto samples = usual.samples();
    if (form.base_angle_deg > 0)
        samples.front().angle_deg = form.base_angle_deg;
    if (form.tip_angle_deg > 0)
        samples.back().angle_deg = form.tip_angle_deg;
    BranchingAngles angles(std::move(samples));
    if (form.bases_by_angle)
        angles.set_bases(BranchingAngles::Bases::ByAngle);
    if (form.rise != 0)
        angles.set_rise(form.rise);
    return angles;
}

SkeletonOptions skeleton_options(TreeForm const& form)
{
    SkeletonOptions options;
    options.levels = form.levels;
    options.styles.assign(form.styles.begin(), form.styles.end());
    options.seed = form.seed;
    options.tree.branches = static_cast<std::size_t>(form.plane_branches);
    if (form.plane_branches > 0)
        options.tree.bumps.ends = BumpThresholds::Ends::Even;
    options.tree.angles = angles_of(form);
    return options;
}

TreeOptions tree_options(TreeForm const& form, double height_mm)
{
    TreeOptions options;
    options.height_mm = height_mm;
    options.seed = form.seed;
    options.angles = angles_of(form);
    options.bark = form.bark;
    options.leaf.per_spray = form.leaves;
    options.leaf.width = form.leaf_width;
    options.leaves_reach_outline = form.leaves_reach_outline;
    options.levels.resize(form.patterns.size(), options.levels.back());
    for (std::size_t level = 0; level < form.patterns.size(); ++level) {
        options.levels[level].pattern = form.patterns[level];
        options.levels[level].added *= form.density;
        options.levels[level].style = form.styles[level];
        options.levels[level].nodes = form.has_whole_nodes ? ArrangementOptions::Nodes::Whole
                                                           : ArrangementOptions::Nodes::Snap;
    }
    return options;
}

} // namespace tractus::silhouette
