#include "engine/methods/silhouettes/tree_edits.h"

#include "engine/methods/silhouettes/bumps.h"
#include "engine/methods/silhouettes/inferred_trees.h"
#include "engine/methods/silhouettes/tree_form_fields.h"
#include "engine/scene/edit_words.h"
#include "engine/scene/make_edit_kind.h"
#include "engine/scene/paper.h"

#include <array>
#include <fmt/format.h>
#include <memory>
#include <utility>

namespace tractus::silhouette {

namespace {

// Names indexed by the values of DrawTree::Part.
constexpr std::array kParts { "trunk",      "outline", "branch", "own_outline",
                              "own_branch", "split",   "join",   "surface" };
void list(scene::Fields& fields, DrawTree& edit)
{
    fields.word("part", edit.part, kParts);
    fields.sparse_field("is_leaf", &edit.is_leaf);
    fields.sparse_field("of_bump", &edit.of_bump);
    bool to_siblings = edit.style_to == StyleScope::Siblings;
    bool to_deeper = edit.style_to == StyleScope::Deeper;
    fields.sparse_field("style_to_siblings", &to_siblings);
    fields.sparse_field("style_to_deeper", &to_deeper);
    edit.style_to = to_deeper ? StyleScope::Deeper
        : to_siblings         ? StyleScope::Siblings
                              : StyleScope::None;
    bool at_any_level = edit.search == Search::AnyLevel;
    fields.sparse_field("at_any_level", &at_any_level);
    edit.search = at_any_level ? Search::AnyLevel : Search::OnTrunk;
    fields.sparse_field("plant", &edit.plant);
    fields.field("stands_at_mm", &edit.stands_at_mm);
    bool has_ground = edit.ground_mm.has_value();
    Vec2 ground_mm = edit.ground_mm.value_or(Vec2::Zero());
    fields.sparse_field("has_ground", &has_ground);
    fields.sparse_field("ground_x_mm", &ground_mm.x());
    fields.sparse_field("ground_y_mm", &ground_mm.y());
    edit.ground_mm = has_ground ? std::optional(ground_mm) : std::nullopt;
    list(fields, edit.form);
    fields.field("scale", &edit.scale);
    fields.sparse_field("enlarged", &edit.enlarged);
    fields.sparse_field("trunk_goes_on_mm", &edit.trunk_goes_on_mm);
    fields.sparse_field("takes_style", &edit.takes_style);
    fields.sparse_field("turned_round", &edit.is_drawn_reversed);
    fields.id(edit.id);
    fields.numbers(edit.stroke);
}

void list(scene::Fields& fields, EraseTreePart& edit)
{
    fields.field("plant", &edit.plant);
    fields.word("part", edit.part, kParts);
    fields.sparse_field("branch", &edit.branch);
}

void list(scene::Fields& fields, DeclareLeaf& edit)
{
    fields.field("plant", &edit.plant);
    fields.sparse_field("outline", &edit.outline);
    fields.field("is_leaf", &edit.is_leaf);
}

void list(scene::Fields& fields, ChooseStyles& edit)
{
    fields.field("plant", &edit.plant);
    fields.field("styles", &edit.styles);
}

void list(scene::Fields& fields, FormTree& edit)
{
    fields.field("plant", &edit.plant);
    fields.sparse_field("takes_style", &edit.takes_style);
    list(fields, edit.form);
}

Result<OutlinedTree> tree_of(scene::DocumentState const& state, scene::ItemId plant)
{
    auto const number = TRY(scene::plant_number(state, plant));
    auto const* const tree = outlined_tree(*state.plants[number]);
    if (!tree)
        return fail(Fault::User,
                    fmt::format("plant {} has no outline: choose a tree that was drawn by its "
                                "outline",
                                scene::name_of(plant)));
    return *tree;
}

// Performs the checks of building a tree without building it.
Result<void> check_tree(OutlinedTree const& tree)
{
    constexpr double kFarthest_mm = 1e5;
    TRY(check_form(tree.form));
    if (!(tree.trunk_goes_on_mm >= 0 && tree.trunk_goes_on_mm <= kFarthest_mm))
        return fail(Fault::User,
                    fmt::format("the trunk cannot go on by {:g} mm into the crown: draw it again",
                                tree.trunk_goes_on_mm));
    if (!tree.has_crown()) {
        TRY(build_tree(tree));
        return {};
    }
    auto const drawing = TRY(drawing_of(tree));
    auto const clean = TRY(clean_drawing(drawing));
    if (!inside_run(clean.outline, clean.trunk))
        return fail(Fault::User,
                    "the trunk is wholly outside of the outline: draw it into the crown");
    return {};
}

// Replaces a plant's tree. The plant moves with the trunk's foot on the paper, so that the tree
// stays where it was drawn.
Result<scene::DocumentState> with_tree(scene::DocumentState state, scene::ItemId plant,
                                       OutlinedTree tree)
{
    TRY(check_tree(tree));
    auto const foot_mm = TRY(foot_of(tree));
    scene::redraw_on_paper(state, TRY(scene::plant_number(state, plant)),
                           scene::PlantSource(OutlinedTree::kKind, std::move(tree)), foot_mm);
    return state;
}

// The document with the changed lines of a tree; new branches are named after `id`.
Result<scene::DocumentState> with_lines(scene::DocumentState state, scene::ItemId plant,
                                        OutlinedTree const& before, OutlinedTree after,
                                        scene::ItemId id)
{
    TRY(check_tree(after));
    TRY(keep_names(before, after, fmt::format("{}.", scene::name_of(id))));
    return with_tree(std::move(state), plant, std::move(after));
}

Result<scene::DocumentState> applied(scene::DocumentState state, DrawTree const& edit,
                                     scene::SceneBuilder&)
{
    if (edit.plant != 0) {
        auto const before = TRY(tree_of(state, edit.plant));
        auto const id = scene::take_id(state, edit.id);
        auto after = TRY(with_part(before, edit, id));
        return with_lines(std::move(state), edit.plant, before, std::move(after), id);
    }
    using Part = DrawTree::Part;
    if (edit.part != Part::Trunk && edit.part != Part::Outline && edit.part != Part::Surface)
        return fail(Fault::User, "there is no tree for the branch: draw a trunk or a crown first");
    auto tree = TRY(with_part({ .form = edit.form, .scale = edit.scale }, edit,
                              scene::take_id(state, edit.id)));
    tree.ground_mm = edit.ground_mm;
    tree.takes_style = edit.takes_style;
    tree.inferred = std::make_shared<InferredTrees>();
    TRY(check_tree(tree));
    if (!edit.stands_at_mm.allFinite())
        return fail(Fault::User, "the place for the tree is not a number: draw it again");
    if (edit.enlarged != 0 && !(edit.enlarged > 1e-6 && edit.enlarged < 1e6))
        return fail(Fault::User,
                    fmt::format("a tree cannot be shown {:g} times as large as it was drawn",
                                edit.enlarged));
    auto const foot_mm = TRY(foot_of(tree));
    if (!state.scale)
        state.scale = edit.scale;
    return scene::with_source(std::move(state),
                              { .name = "tree",
                                .source = scene::PlantSource(OutlinedTree::kKind, std::move(tree)),
                                .drawn = scene::Drawn::Beside,
                                .stands_at_mm = edit.stands_at_mm,
                                .paper_mm = foot_mm,
                                .paper_unit = edit.enlarged != 0 ? edit.enlarged : 1,
                                .id = edit.id });
}

// Removes the entry with this id; returns false if there is none.
template<typename Drawn> bool take_out(std::vector<Drawn>& drawn, scene::ItemId id)
{
    return std::erase_if(drawn, [&](Drawn const& one) { return one.id == id; }) > 0;
}

Result<scene::DocumentState> applied(scene::DocumentState state, EraseTreePart const& edit,
                                     scene::SceneBuilder&)
{
    auto const before = TRY(tree_of(state, edit.plant));
    auto after = before;
    bool is_there = false;
    switch (edit.part) {
    case DrawTree::Part::Trunk:
        is_there = !std::exchange(after.trunk, {}).tips.empty();
        after.trunk_goes_on_mm = 0;
        break;
    case DrawTree::Part::Outline:
        is_there = !std::exchange(after.outline, {}).tips.empty();
        after.is_leaf = false;
        break;
    case DrawTree::Part::Branch:
        is_there = take_out(after.branches, edit.branch);
        break;
    case DrawTree::Part::OwnOutline:
        is_there = take_out(after.own_outlines, edit.branch);
        break;
    case DrawTree::Part::OwnBranch:
        is_there = take_out(after.own_branches, edit.branch);
        break;
    case DrawTree::Part::Split:
    case DrawTree::Part::Join:
        is_there = take_out(after.touches, edit.branch);
        break;
    case DrawTree::Part::Surface:
        is_there = take_out(after.crown_lines, edit.branch);
        break;
    }
    if (!is_there)
        return fail(Fault::User, "the tree has no such part any more");
    if (after.trunk.tips.empty() && !after.has_crown())
        return fail(Fault::User,
                    "nothing of the tree would be left: remove the plant to take it away");
    auto const id = scene::item_id(state.last_edit, 0);
    return with_lines(std::move(state), edit.plant, before, std::move(after), id);
}

Result<scene::DocumentState> applied(scene::DocumentState state, DeclareLeaf const& edit,
                                     scene::SceneBuilder&)
{
    auto const before = TRY(tree_of(state, edit.plant));
    auto after = before;
    bool is_there = edit.outline == 0 && after.has_crown();
    if (edit.outline == 0)
        after.is_leaf = edit.is_leaf;
    for (auto& own : after.own_outlines)
        if (own.id == edit.outline) {
            own.is_leaf = edit.is_leaf;
            is_there = true;
        }
    if (!is_there)
        return fail(Fault::User, "the tree has no such outline any more");
    auto const id = scene::item_id(state.last_edit, 0);
    return with_lines(std::move(state), edit.plant, before, std::move(after), id);
}

Result<scene::DocumentState> applied(scene::DocumentState state, ChooseStyles const& edit,
                                     scene::SceneBuilder&)
{
    auto const before = TRY(tree_of(state, edit.plant));
    auto after = TRY(with_styles(before, edit.styles));
    auto const id = scene::item_id(state.last_edit, 0);
    return with_lines(std::move(state), edit.plant, before, std::move(after), id);
}

Result<scene::DocumentState> applied(scene::DocumentState state, FormTree const& edit,
                                     scene::SceneBuilder&)
{
    auto const before = TRY(tree_of(state, edit.plant));
    auto tree = before;
    tree.form = edit.form;
    tree.takes_style = edit.takes_style;
    if (!tree.is_refined() && tree.styles.empty() && tree.touches.empty())
        return with_tree(std::move(state), edit.plant, std::move(tree));
    // The new form changes the branches, so the lines drawn on them must be assigned again.
    auto const id = scene::item_id(state.last_edit, 0);
    return with_lines(std::move(state), edit.plant, before, std::move(tree), id);
}

std::string described(DrawTree const& edit)
{
    constexpr std::array kWhat { "a trunk",
                                 "the outline of a crown",
                                 "a branch",
                                 "a branch's own outline",
                                 "a branch on a branch",
                                 "a touch that splits a bump",
                                 "a touch that joins bumps",
                                 "a line in space on a crown" };
    auto const what = std::string(kWhat[static_cast<std::size_t>(edit.part)])
        + (edit.is_leaf ? ", a leaf," : "") + (edit.of_bump ? " as it was inferred," : "");
    auto const whose = edit.plant == 0 ? std::string("a new tree")
                                       : fmt::format("plant {}", scene::name_of(edit.plant));
    constexpr std::array kStyles { "", ", in whose style its siblings are",
                                   ", in whose style its siblings and those below are" };
    auto const* const style = kStyles[static_cast<std::size_t>(edit.style_to)];
    auto const* const reach = edit.trunk_goes_on_mm > 0 ? ", the trunk going on into it" : "";
    return fmt::format("draws {} for {}{}{}{}: {}", what, whose, style, reach,
                       edit.is_drawn_reversed ? ", turned round" : "",
                       scene::describe_stroke(edit.stroke));
}

std::string described(EraseTreePart const& edit)
{
    constexpr std::array kWhat { "the trunk",
                                 "the outline of the crown",
                                 "a drawn branch",
                                 "a branch's own outline",
                                 "a branch on a branch",
                                 "the split of a bump",
                                 "the join of bumps",
                                 "a line in space on the crown" };
    return fmt::format("takes {} of plant {} away", kWhat[static_cast<std::size_t>(edit.part)],
                       scene::name_of(edit.plant));
}

std::string described(DeclareLeaf const& edit)
{
    return fmt::format("declares {} of plant {} {}",
                       edit.outline == 0 ? "the outline of the crown" : "a branch's own outline",
                       scene::name_of(edit.plant), edit.is_leaf ? "a leaf" : "no leaf any more");
}

std::string described(ChooseStyles const& edit)
{
    std::string said;
    for (auto const& [target, source] : edit.styles)
        said += fmt::format("{}{}", said.empty() ? "" : ", ",
                            source.empty() ? target + " its own" : target + " that of " + source);
    return fmt::format("gives branches of plant {} styles: {}", scene::name_of(edit.plant), said);
}

std::string described(FormTree const& edit)
{
    if (edit.takes_style)
        return fmt::format("gives plant {} the style of the nearest tree",
                           scene::name_of(edit.plant));
    return fmt::format("arranges plant {}: {} around the trunk, {} around branches, {}, {:g} times "
                       "as many as usual, {} leaves on a twig",
                       scene::name_of(edit.plant), describe(edit.form.patterns[0]),
                       describe(edit.form.patterns[1]),
                       scene::counted(static_cast<std::size_t>(edit.form.levels), "level"),
                       edit.form.density, edit.form.leaves);
}

} // namespace

Result<OutlinedTree> with_part(OutlinedTree tree, DrawTree const& edit, scene::ItemId id)
{
    tree.turned_line = edit.is_drawn_reversed ? id : 0;
    switch (edit.part) {
    case DrawTree::Part::Trunk:
        tree.trunk = edit.stroke;
        tree.trunk_goes_on_mm = edit.trunk_goes_on_mm;
        break;
    case DrawTree::Part::Outline:
        tree.outline = edit.stroke;
        tree.trunk_goes_on_mm = edit.trunk_goes_on_mm;
        tree.is_leaf = tree.is_leaf || edit.is_leaf;
        break;
    case DrawTree::Part::Branch:
        tree.branches.push_back({ id, edit.stroke });
        break;
    case DrawTree::Part::OwnOutline:
        return with_own_outline(std::move(tree), edit.stroke,
                                { id, edit.style_to, edit.search, edit.is_leaf, edit.of_bump });
    case DrawTree::Part::OwnBranch:
        return with_own_branch(std::move(tree), edit.stroke, { id, edit.style_to, edit.search });
    case DrawTree::Part::Split:
        return with_touch(std::move(tree), { id, edit.stroke, BumpTouch::Kind::Split },
                          edit.search);
    case DrawTree::Part::Join:
        return with_touch(std::move(tree), { id, edit.stroke, BumpTouch::Kind::Join }, edit.search);
    case DrawTree::Part::Surface:
        return with_crown_line(std::move(tree), { id, edit.stroke });
    }
    return tree;
}

OutlinedTree const* outlined_tree(scene::PlantState const& plant)
{
    return plant.source.get<OutlinedTree>(OutlinedTree::kKind);
}

constexpr scene::EditKind DrawTree::kKind
    = scene::make_edit_kind<DrawTree, list, applied, described>("draw_tree", true);
constexpr scene::EditKind EraseTreePart::kKind
    = scene::make_edit_kind<EraseTreePart, list, applied, described>("erase_tree_part");
constexpr scene::EditKind DeclareLeaf::kKind
    = scene::make_edit_kind<DeclareLeaf, list, applied, described>("declare_leaf");
constexpr scene::EditKind ChooseStyles::kKind
    = scene::make_edit_kind<ChooseStyles, list, applied, described>("choose_branch_styles");
constexpr scene::EditKind FormTree::kKind
    = scene::make_edit_kind<FormTree, list, applied, described>("form_tree", true);

} // namespace tractus::silhouette
