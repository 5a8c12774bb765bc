#pragma once

#include "engine/methods/construction_lines/line_edits.h"
#include "engine/methods/leaves/leaf_sketch_edits.h"
#include "engine/methods/silhouettes/tree_edits.h"
#include "engine/methods/sketch_lsystem/change_edits.h"
#include "engine/scene/scene.h"
#include "tests/app/small_model.h"

#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <vector>

namespace tractus::methods {

// Applies edits one after the other, so that later edits can refer to the results of earlier ones.
class Steps {
public:
    explicit Steps(scene::Scene scene)
        : scene_(std::move(scene))
    {
    }

    void add(scene::Edit const& edit)
    {
        auto next = scene::apply_edit(scene_, edit);
        ASSERT_TRUE(next) << next.error().message;
        scene_ = *std::move(next);
        edits_.push_back(edit);
    }

    scene::Scene const& scene() const { return scene_; }
    scene::ItemId active() const { return scene_.state.active; }
    std::vector<scene::Edit> const& edits() const { return edits_; }

private:
    scene::Scene scene_;
    std::vector<scene::Edit> edits_;
};

inline Stroke paper_stroke(std::vector<Vec2> const& corners)
{
    std::vector<Vec3> places_mm;
    for (auto const& corner : corners)
        places_mm.emplace_back(corner.x(), corner.y(), 100);
    return stroke_through(places_mm);
}

inline void load_model(Steps& steps, double x_mm)
{
    auto model = small_model();
    model.drawn = scene::Drawn::Beside;
    model.stands_at_mm = { x_mm, 0, 0 };
    steps.add(model);
}

// Returns an edit that changes the small model: its rules stay, but its internodes are longer.
inline scene::Edit change_model(scene::ItemId)
{
    auto model = small_model();
    model.source.text.replace(model.source.text.find("F(10)"), 5, "F(13)");
    model.drawn = scene::Drawn::Keep;
    return model;
}

inline void grow_along_stroke(Steps& steps, double x_mm)
{
    sketch::GrowAlongStroke edit { .rule = { .shortest_mm = 8 } };
    edit.stroke = stroke_through({ { x_mm, 0, 0 }, { x_mm + 20, 10, 70 }, { x_mm, 20, 150 } });
    steps.add(edit);
}

inline scene::Edit change_rule(scene::ItemId plant)
{
    return sketch::ChangeSketch { plant, 0, { .laterals = 3, .shortest_mm = 8 } };
}

inline void draw_tree(Steps& steps, double x_mm)
{
    using silhouette::DrawTree;
    steps.add(DrawTree { .part = DrawTree::Part::Trunk,
                         .stroke = paper_stroke({ { x_mm, -60 }, { x_mm, 5 } }),
                         .stands_at_mm = { x_mm, 0, 0 } });
    std::vector<Vec2> crown;
    for (int i = 0; i <= 24; ++i) {
        double const angle = i * kPi / 12;
        double const lobes = 40 + 4 * std::cos(5 * angle);
        crown.emplace_back(x_mm + lobes * std::sin(angle), 10 - lobes * std::cos(angle));
    }
    steps.add(DrawTree {
        .part = DrawTree::Part::Outline, .stroke = paper_stroke(crown), .plant = steps.active() });
}

inline scene::Edit change_form(scene::ItemId plant)
{
    silhouette::TreeForm form;
    form.leaves = 3;
    return silhouette::FormTree { plant, form };
}

inline void draw_lines(Steps& steps, double x_mm)
{
    std::vector<std::vector<Vec2>> const lines { { { 0, -60 }, { 0, 60 } },
                                                 { { -30, -60 }, { -20, 70 } },
                                                 { { 40, -60 }, { 40, 70 } },
                                                 { { -50, -20 }, { 0, -40 }, { 60, -10 } },
                                                 { { -50, 60 }, { 0, 30 }, { 60, 70 } } };
    for (std::size_t i = 0; i < lines.size(); ++i) {
        auto moved = lines[i];
        for (auto& corner : moved)
            corner.x() += x_mm;
        steps.add(lines::AddLine { .plant = i == 0 ? 0 : steps.active(),
                                   .stroke = paper_stroke(moved),
                                   .nodes = 5,
                                   .stands_at_mm = { x_mm, 0, 0 } });
    }
}

inline scene::Edit change_pattern(scene::ItemId plant)
{
    return lines::SetLinePattern { plant, { .kind = lines::Pattern::Kind::Decussate } };
}

inline void draw_leaf(Steps& steps, double x_mm)
{
    std::vector<Vec2> outline;
    for (int i = 0; i <= 24; ++i) {
        double const angle = i * kPi / 12;
        outline.emplace_back(x_mm + 20 * std::sin(angle), -40 * std::cos(angle));
    }
    steps.add(
        leaf::AddLeafLine { .stroke = paper_stroke(outline), .stands_at_mm = { x_mm, 0, 0 } });
    steps.add(leaf::AddLeafLine { .plant = steps.active(),
                                  .stroke = paper_stroke({ { x_mm, -60 }, { x_mm, 39 } }) });
}

inline scene::Edit change_leaf(scene::ItemId plant)
{
    return leaf::FormLeaf { plant, { .bend_deg = 40 } };
}

// A method: a function that makes a plant with it, and an edit that then changes the plant.
struct MethodOfPair {
    char const* name;
    void (*make)(Steps& steps, double x_mm);
    scene::Edit (*change)(scene::ItemId plant);
};

inline constexpr std::array<MethodOfPair, 5> kMethods { {
    { "a model", load_model, change_model },
    { "a rule along a stroke", grow_along_stroke, change_rule },
    { "an outline", draw_tree, change_form },
    { "construction lines", draw_lines, change_pattern },
    { "a leaf", draw_leaf, change_leaf },
} };

} // namespace tractus::methods
