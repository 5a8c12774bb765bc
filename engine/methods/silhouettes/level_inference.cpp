#include "engine/methods/silhouettes/level_inference.h"

#include <utility>

namespace tractus::silhouette {

// Infers the children of `parent`; they include the strokes that were drawn on it, unchanged. If
// the parent's crown is too small, a lens around the parent serves as its crown.
static Result<BranchingSystem> system_with_strokes(Branch const& parent, InferenceOptions options)
{
    options.drawn_bases = InferenceOptions::DrawnBases::Anywhere;
    auto const trunk = parent.line(17);
    auto const& crown = parent.is_outlined() ? parent.own_outline : parent.crown;
    Drawing drawing { { crown }, trunk, parent.own_branches };
    drawing.touches = parent.touches;
    auto system = infer_system(drawing, options);
    if (!system)
        system = infer_system({ { lens_crown(parent.path.curve) }, trunk, parent.own_branches },
                              options);
    if (system)
        for (auto& branch : system->branches)
            if (branch.origin == Branch::Origin::Drawn) {
                branch.stroke = parent.own_branches[branch.number];
                // The stroke's exact end is restored, because it was rounded in the normalised
                // frame.
                branch.path.curve.end = branch.stroke.back();
            }
    return system;
}

static void keep_drawn(BranchingSystem& system)
{
    std::erase_if(system.branches, [](Branch const& branch) {
        return branch.origin != Branch::Origin::Drawn && branch.origin != Branch::Origin::Apex;
    });
    system.coverage_after = coverage_of(system);
}

Result<BranchingSystem> infer_crown_system(Drawing const& drawing, InferenceOptions const& options)
{
    auto system = TRY(infer_system(drawing, options));
    if (!drawing.is_leaf)
        return system;
    system.leaf = leaf_along(system.outline, system.trunk);
    system.bumps.clear();
    system.branches.clear();
    system.touches_taken = 0;
    system.trunk_goes_on_to.reset();
    system.coverage_before = system.coverage_after = 1;
    return system;
}

Result<BranchingSystem> system_below(Branch const& branch, LevelInference const& how)
{
    auto const& options = branch.is_outlined() ? how.outlined : how.usual;
    auto const& crown = branch.is_outlined() ? branch.own_outline : branch.crown;
    bool const has_strokes = !branch.own_branches.empty();
    Drawing drawing { { crown }, branch.line(17) };
    drawing.touches = branch.touches;
    auto system = has_strokes ? TRY(system_with_strokes(branch, options))
                              : TRY(infer_system(drawing, options));
    system.is_of_own_outline = branch.is_outlined();
    system.is_in_siblings_style = branch.style_to != StyleScope::None;
    if (has_strokes && !branch.is_outlined() && how.besides == LevelInference::Besides::Nothing)
        keep_drawn(system);
    return system;
}

InferenceOptions styled(InferenceOptions options, std::vector<BranchStyle> const& styles, int level)
{
    auto const i = static_cast<std::size_t>(level);
    if (i >= styles.size() || !styles[i].is_set())
        return options;
    auto const& style = styles[i];
    options.angles
        = BranchingAngles({ { style.unbranched, style.first_angle_deg },
                            { style.unbranched + style.extent(), style.last_angle_deg } },
                          kAngleOver);
    options.unbranched = style.unbranched;
    return options;
}

} // namespace tractus::silhouette
