#include "engine/lsystem/derivation/derive.h"
#include "engine/lsystem/language/print.h"
#include "engine/methods/sketch_lsystem/drawn_axis.h"
#include "engine/methods/sketch_lsystem/stroke_resampler.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <span>

// Tests of laws that hold for every stroke and every rule.

namespace tractus::sketch {
namespace {

double between(double least, double most)
{
    return least + (most - least) * *rc::gen::inRange(0, 10'001) / 10'000.0;
}

// Returns a random rule, with so few internodes that it can be derived a hundred times.
Rule random_rule()
{
    Rule rule;
    rule.first_length_mm = between(15, 60);
    rule.length_ratio = between(0.5, 1.2);
    rule.width_ratio = between(0.3, 1);
    rule.first_width_mm = rule.first_length_mm * between(0.02, 0.5);
    rule.laterals = *rc::gen::inRange(0, 9);
    rule.angle_deg = between(0, 150);
    rule.lateral_length = between(0.2, 1);
    rule.lateral_width = between(0.2, 1);
    rule.axis_twist_deg = between(-180, 180);
    rule.lateral_twist_deg = between(-180, 180);
    rule.shortest_mm = between(0.5, 8);
    rule.most_segments = *rc::gen::inRange(1, 20);
    rule.most_internodes = *rc::gen::inRange(20, 3'000);
    int const lateral_rules = *rc::gen::inRange(-2, 5);
    for (int i = 0; i < lateral_rules; ++i)
        rule.lateral_rules.push_back({ .length_ratio = between(0.5, 1.2),
                                       .width_ratio = between(0.3, 1),
                                       .laterals = *rc::gen::inRange(0, 5),
                                       .angle_deg = between(0, 150),
                                       .lateral_length = between(0.2, 1),
                                       .lateral_width = between(0.2, 1),
                                       .twist_deg = between(-180, 180),
                                       .shortest_mm = between(0.5, 8),
                                       .laterals_by = *rc::gen::inRange(0, 1 + lateral_rules) });
    return rounded_as_text(rule);
}

// Returns a stroke through random points in space.
std::vector<Vec3> random_stroke()
{
    std::vector<Vec3> tips { Vec3(between(-100, 100), between(-80, 80), between(0, 300)) };
    int const count = *rc::gen::inRange(2, 60);
    Vec3 way(0, 0, 5);
    for (int i = 0; i < count; ++i) {
        way += Vec3(between(-3, 3), between(-3, 3), between(-3, 3));
        tips.push_back(tips.back() + way);
    }
    return tips;
}

std::string string_after(Rule const& rule, DrawnAxis const& axis, int steps)
{
    auto const model = lsystem::compile_model(write_model(rule, axis, Leaves::Bare, "sketch"));
    RC_ASSERT(bool(model));
    auto const string = lsystem::derive(*model, { .steps = steps });
    RC_ASSERT(bool(string));
    return lsystem::to_string(*model, *string);
}

// The plant of the beginning of a stroke must be the plant that the model of the whole stroke gives
// after fewer steps.
RC_GTEST_PROP(SketchLaws, FewerStepsAreTheStrokesBeginning, ())
{
    auto const rule = random_rule();
    auto const nodes_mm = resample_stroke(rule, random_stroke());
    auto const axis = draw_axis(rule, nodes_mm);
    RC_PRE(axis.segments() > 0);
    int const steps = *rc::gen::inRange(0, axis.segments() + 1);
    auto beginning
        = draw_axis(rule, std::span(nodes_mm).first(static_cast<std::size_t>(steps) + 1));
    beginning.depth = axis.depth;
    RC_ASSERT(string_after(rule, axis, steps) == string_after(rule, beginning, steps));
}

RC_GTEST_PROP(SketchLaws, StringsHaveAsManyInternodesAsIsCounted, ())
{
    auto const rule = random_rule();
    auto const axis = draw_axis(rule, resample_stroke(rule, random_stroke()));
    auto const string = string_after(rule, axis, axis.segments());
    RC_ASSERT(std::count(string.begin(), string.end(), 'F')
              == count_internodes(rule, axis.segments(), axis.depth));
}

RC_GTEST_PROP(SketchLaws, AStrokeDrawnAgainWithMoreTipsIsTheSame, ())
{
    auto const rule = random_rule();
    auto const tips = random_stroke();
    std::vector<Vec3> dense;
    for (std::size_t i = 1; i < tips.size(); ++i)
        for (int j = 0; j < 7; ++j)
            dense.push_back(tips[i - 1] + (tips[i] - tips[i - 1]) * (j / 7.0));
    dense.push_back(tips.back());
    auto const sparse_nodes = resample_stroke(rule, tips);
    auto const dense_nodes = resample_stroke(rule, dense);
    RC_ASSERT(sparse_nodes.size() == dense_nodes.size());
    for (std::size_t i = 0; i < sparse_nodes.size(); ++i)
        RC_ASSERT((sparse_nodes[i] - dense_nodes[i]).norm() < 1e-6);
}

// Whatever the stroke is, every segment must have the length that the rule gives.
RC_GTEST_PROP(SketchLaws, SegmentsAreAsLongAsTheRuleSays, ())
{
    auto const rule = random_rule();
    auto const nodes_mm = resample_stroke(rule, random_stroke());
    double length_mm = rule.first_length_mm;
    for (std::size_t i = 1; i < nodes_mm.size(); ++i) {
        RC_ASSERT(std::abs((nodes_mm[i] - nodes_mm[i - 1]).norm() - length_mm) < 1e-6);
        length_mm *= rule.length_ratio;
    }
}

// If a stroke and a rule are scaled by two, the plant must be scaled by two.
RC_GTEST_PROP(SketchLaws, ScalingStrokeAndRuleScalesThePlant, ())
{
    auto rule = random_rule();
    auto tips = random_stroke();
    auto const axis = draw_axis(rule, resample_stroke(rule, tips));
    for (auto& tip : tips)
        tip *= 2;
    rule.first_length_mm *= 2;
    rule.first_width_mm *= 2;
    rule.shortest_mm *= 2;
    for (auto& lateral : rule.lateral_rules)
        lateral.shortest_mm *= 2;
    auto const doubled = draw_axis(rule, resample_stroke(rule, tips));
    RC_ASSERT(doubled.segments() == axis.segments());
    RC_ASSERT(doubled.depth == axis.depth);
    for (std::size_t i = 0; i < axis.turns.size(); ++i)
        RC_ASSERT(std::abs(doubled.turns[i].bend_deg - axis.turns[i].bend_deg) < 1e-3);
}

} // namespace
} // namespace tractus::sketch
