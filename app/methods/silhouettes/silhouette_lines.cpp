#include "app/methods/silhouettes/silhouette_lines.h"

#include "app/methods/silhouettes/outline_meaning.h"
#include "engine/methods/silhouettes/bump_leaf.h"
#include "engine/methods/silhouettes/bump_touch.h"
#include "engine/methods/silhouettes/chosen_style.h"
#include "engine/methods/silhouettes/drawn_surface.h"
#include "engine/methods/silhouettes/kept_names.h"
#include "engine/methods/silhouettes/own_branch.h"
#include "engine/methods/silhouettes/own_outline.h"
#include "engine/methods/silhouettes/trunk_reach.h"
#include "engine/scene/anchored.h"
#include "engine/scene/scene.h"

#include <algorithm>
#include <cstddef>
#include <fmt/format.h>
#include <utility>

namespace tractus::silhouette {

namespace {

// Length in millimetres by which the trunk is continued into the crown, if it was drawn to just
// below the crown; otherwise 0.
double trunk_reach(SilhouetteFile const& file)
{
    auto const& drawing = file.drawing;
    if (drawing.trunk.empty() || drawing.outline.empty())
        return 0;
    return extension_into_crown(drawing.trunk, drawing.outline).value_or(0);
}

// Which touches to apply. Crown: those outside all parts, before parts are drawn. Parts: those
// inside parts, after the parts have been drawn.
enum class TouchesOn { Crown, Parts };

std::vector<BumpTouch> touches_of(SilhouetteFile const& file, TouchesOn which)
{
    auto touches = file.touches;
    std::erase_if(touches, [&](BumpTouch const& touch) {
        bool const is_in_part
            = std::any_of(file.parts.begin(), file.parts.end(), [&](auto const& part) {
                  return is_closed_stroke(part) && is_inside(part, touch.place);
              });
        return is_in_part != (which == TouchesOn::Parts);
    });
    return touches;
}

tl::unexpected<Error> about_line(char const* what, std::size_t number, Error const& error)
{
    return fail(error.fault, fmt::format("{} {}: {}", what, number + 1, error.message));
}

// Copies the style of a branch to the other branches that the line `line` of the file crosses.
Result<void> carry_style(SilhouetteFile& file, std::vector<Vec2> const& line,
                         SkeletonOptions const& options)
{
    auto const skeleton = TRY(infer_skeleton(file.drawing, options));
    auto const carried = TRY(copied_by(skeleton, line));
    return choose_styles(file.drawing.styles, carried, skeleton);
}

// Splits and joins bumps. Existing branches keep their names. New branches get the names that they
// would have if they were drawn by a pen after `edits` edits.
Result<void> touch_bumps(SilhouetteFile& file, TouchesOn which, SkeletonOptions& options,
                         std::size_t edits)
{
    for (auto const& touch : touches_of(file, which)) {
        auto const before = file.drawing;
        if (auto const added = add_touch(file.drawing, touch, options); !added)
            return fail(added.error().fault,
                        fmt::format("{} at [{:g}, {:g}]: {}",
                                    touch.kind == BumpTouch::Kind::Split ? "split" : "join",
                                    touch.place.x(), touch.place.y(), added.error().message));
        auto const fresh = fmt::format("{}.", scene::name_of(scene::item_id(++edits, 0)));
        auto renamed
            = TRY(kept_names(DrawingToInfer { before, options }, file.drawing, options, fresh));
        options.names = std::move(renamed.names);
    }
    return {};
}

// The outline of a leaf: the line itself or, if the line is a single point, the outline of the bump
// on which the point is.
Result<std::vector<Vec2>> leaf_outline(std::vector<Vec2> const& leaf, Drawing const& drawing,
                                       SkeletonOptions const& options)
{
    if (leaf.size() > 1)
        return leaf;
    auto const skeleton = TRY(infer_skeleton(drawing, options));
    auto bump = leaf_on_bump(skeleton, leaf.front(), Search::AnyLevel);
    if (!bump)
        return fail(Fault::User,
                    fmt::format("[{:g}, {:g}] is on no bump that a branch ends in: give a point in "
                                "one, near its edge, or the leaf's outline",
                                leaf.front().x(), leaf.front().y()));
    bump->outline.push_back(bump->outline.front());
    return std::move(bump->outline);
}

Result<void> add_parts(SilhouetteFile& file, SkeletonOptions const& options, StyleScope style_to)
{
    constexpr auto kSearch = Search::AnyLevel;
    for (std::size_t i = 0; i < file.parts.size(); ++i) {
        auto const& part = file.parts[i];
        auto const added = is_closed_stroke(part)
            ? add_own_outline(file.drawing, part, options, style_to, kSearch)
            : add_own_branch(file.drawing, part, style_to, options, kSearch);
        if (!added)
            return about_line("part", i, added.error());
    }
    for (std::size_t i = 0; i < file.leaves.size(); ++i) {
        auto outline = leaf_outline(file.leaves[i], file.drawing, options);
        if (!outline)
            return about_line("leaf", i, outline.error());
        auto const added
            = add_own_outline(file.drawing, *std::move(outline), options, style_to, kSearch, true);
        if (!added)
            return about_line("leaf", i, added.error());
    }
    return {};
}

Stroke stroke_in_space(CrownLine const& points)
{
    constexpr std::int64_t kStep_ns = 5'000'000;
    Stroke stroke;
    std::int64_t time_ns = 0;
    for (auto const& point : points)
        stroke.tips.push_back({ .time = timestamp_ns(time_ns += kStep_ns),
                                .position_mm = point,
                                .pressure = 0.5,
                                .touching = true });
    return stroke;
}

Stroke stroke_along(std::vector<Vec2> const& points)
{
    CrownLine line;
    for (auto const& point : points)
        line.emplace_back(point.x(), point.y(), 0);
    return stroke_in_space(line);
}

// Makes the edits that draw the lines of a file. The ids of the edits are those that they would
// have in a session.
class Drawer {
public:
    explicit Drawer(DrawTree first)
        : edit_(std::move(first))
    {
    }

    void draw(DrawTree::Part part, std::vector<Vec2> const& points)
    {
        draw(part, stroke_along(points));
    }

    void draw(DrawTree::Part part, Stroke stroke)
    {
        edit_.part = part;
        edit_.stroke = std::move(stroke);
        edit_.id = scene::item_id(edits_.size() + 1, 0);
        edits_.push_back(edit_);
        edit_.plant = scene::item_id(1, 0);
    }

    Result<void> draw_parts(SilhouetteFile const& file, StyleScope style_to)
    {
        edit_.style_to = style_to;
        for (auto const& part : file.parts)
            draw(is_closed_stroke(part) ? DrawTree::Part::OwnOutline : DrawTree::Part::OwnBranch,
                 part);
        edit_.is_leaf = true;
        for (auto const& leaf : file.leaves) {
            edit_.of_bump = leaf.size() == 1;
            draw(DrawTree::Part::OwnOutline, edit_.of_bump ? TRY(outline_of_bump(leaf)) : leaf);
        }
        edit_.of_bump = false;
        edit_.is_leaf = false;
        edit_.style_to = StyleScope::None;
        return {};
    }

    void touch(std::vector<BumpTouch> const& touches)
    {
        for (auto const& one : touches)
            draw(one.kind == BumpTouch::Kind::Split ? DrawTree::Part::Split : DrawTree::Part::Join,
                 { one.place });
    }

    DrawTree& edit() { return edit_; } // The next edit, without its line.
    std::vector<scene::Edit>& edits() { return edits_; }

private:
    // The outline of the bump at a leaf's point, in the tree that the edits so far draw.
    Result<std::vector<Vec2>> outline_of_bump(std::vector<Vec2> const& leaf) const
    {
        auto const scene = TRY(scene::apply_edits({}, edits_));
        auto const* const tree = TRY(active_tree(scene));
        return leaf_outline(leaf, TRY(drawing_of(*tree)), options_of(*tree));
    }

    DrawTree edit_;
    std::vector<scene::Edit> edits_;
};

} // namespace

Result<Skeleton> infer_lines(SilhouetteFile& file, SkeletonOptions options, StyleScope style_to)
{
    auto edits = file.drawing.outline.size() + !file.drawing.trunk.empty() + file.crown_lines.size()
        + file.drawing.branches.size();
    double const reach = trunk_reach(file);
    if (reach > 0)
        go_on(file.drawing.trunk, reach);
    TRY(add_surface(file.drawing, file.crown_lines, {}));
    TRY(touch_bumps(file, TouchesOn::Crown, options, edits));
    edits += touches_of(file, TouchesOn::Crown).size();
    TRY(add_parts(file, options, style_to));
    edits += file.parts.size() + file.leaves.size();
    TRY(touch_bumps(file, TouchesOn::Parts, options, edits));
    for (std::size_t i = 0; i < file.styles.size(); ++i)
        if (auto const carried = carry_style(file, file.styles[i], options); !carried)
            return about_line("style", i, carried.error());
    auto skeleton = TRY(infer_skeleton(file.drawing, options));
    if (reach > 0)
        skeleton.systems[0].notes.push_back(
            "the trunk ends just below the crown: it goes on into that");
    return skeleton;
}

Result<std::vector<scene::Edit>> edits_of_lines(SilhouetteFile const& file, DrawTree const& first,
                                                StyleScope style_to)
{
    auto const& drawing = file.drawing;
    bool const has_outline = !drawing.outline.empty();
    if (drawing.outline.size() > 1 || (!has_outline && file.crown_lines.empty()))
        return fail(Fault::User,
                    fmt::format("the outline has {} strokes: draw it in one for a session",
                                drawing.outline.size()));
    Drawer drawer(first);
    if (!drawing.trunk.empty())
        drawer.draw(DrawTree::Part::Trunk, drawing.trunk);
    drawer.edit().is_leaf = drawing.is_leaf;
    drawer.edit().trunk_goes_on_mm = trunk_reach(file);
    if (has_outline)
        drawer.draw(DrawTree::Part::Outline, drawing.outline[0]);
    drawer.edit().trunk_goes_on_mm = 0;
    drawer.edit().is_leaf = false;
    for (auto const& line : file.crown_lines)
        drawer.draw(DrawTree::Part::Surface, stroke_in_space(line));
    for (auto const& branch : drawing.branches)
        drawer.draw(DrawTree::Part::Branch, branch);
    drawer.edit().search = Search::AnyLevel;
    drawer.touch(touches_of(file, TouchesOn::Crown));
    TRY(drawer.draw_parts(file, style_to));
    drawer.touch(touches_of(file, TouchesOn::Parts));
    for (auto const& line : file.styles) {
        auto const scene = TRY(scene::apply_edits({}, drawer.edits()));
        drawer.edits().push_back(TRY(copied_styles(stroke_along(line), scene)));
    }
    return std::move(drawer.edits());
}

} // namespace tractus::silhouette
