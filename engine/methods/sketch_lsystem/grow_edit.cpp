#include "engine/methods/sketch_lsystem/grow_edit.h"

#include "engine/base/random.h"
#include "engine/methods/sketch_lsystem/stroke_resampler.h"
#include "engine/scene/edit_words.h"
#include "engine/scene/lsystem_source.h"
#include "engine/scene/make_edit_kind.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fmt/core.h>
#include <memory>
#include <optional>
#include <utility>

namespace tractus::sketch {

namespace {

// World millimetres per plant millimetre in a model's text: 1 mm drawn is 1 cm of the plant.
constexpr double kModelScale = 0.1;

bool same(GrowAlongStroke const& one, GrowAlongStroke const& other)
{
    return one.rule == other.rule && one.stroke.tips.id() == other.stroke.tips.id()
        && one.surface == other.surface && one.leaves == other.leaves && one.scale == other.scale
        && one.model == other.model && one.is_drawn_reversed == other.is_drawn_reversed;
}

// Returns the edit with the laterals of its rule varied at random; for a model, only the seed
// changes. The drawn axis stays as it is.
GrowAlongStroke varied(GrowAlongStroke edit, scene::SourceVariation const& variation)
{
    constexpr std::uint32_t kStream = 0x736B;
    constexpr auto kAngle_deg = kRuleSpread.angle_deg;
    constexpr auto kShare = kRuleSpread.share;
    constexpr auto kTwist_deg = kRuleSpread.twist_deg;
    Random random({ variation.seed, kStream + variation.stream, variation.plant });
    if (edit.model.is_set()) {
        edit.model.seed = random.next_u64();
        return edit;
    }
    auto const spread = [&](double deviation) {
        return variation.spread * deviation
            * std::clamp(random.normal(), -kMaxDeviations, kMaxDeviations);
    };
    auto& rule = edit.rule;
    rule.angle_deg = std::clamp(rule.angle_deg + spread(kAngle_deg), 0.0, 150.0);
    rule.lateral_length = std::clamp(rule.lateral_length * (1 + spread(kShare)), 0.2, 1.0);
    rule.lateral_width = std::clamp(rule.lateral_width * (1 + spread(kShare)), 0.2, 1.0);
    rule.axis_twist_deg = std::remainder(rule.axis_twist_deg + spread(kTwist_deg), 360);
    rule.lateral_twist_deg = std::remainder(rule.lateral_twist_deg + spread(kTwist_deg), 360);
    for (auto& lateral : rule.lateral_rules) {
        lateral.angle_deg = std::clamp(lateral.angle_deg + spread(kAngle_deg), 0.0, 150.0);
        lateral.lateral_length
            = std::clamp(lateral.lateral_length * (1 + spread(kShare)), 0.2, 1.0);
        lateral.twist_deg = std::remainder(lateral.twist_deg + spread(kTwist_deg), 360);
    }
    return edit;
}

constexpr scene::SourceKind kSketch {
    .word = "sketch_lsystem",
    .build =
        [](void const* drawn, scene::LoadOptions const& options) {
            return build_sketch(*static_cast<GrowAlongStroke const*>(drawn), options);
        },
    .same =
        [](void const* one, void const* other) {
            return same(*static_cast<GrowAlongStroke const*>(one),
                        *static_cast<GrowAlongStroke const*>(other));
        },
    .model = [](void const* drawn) -> Result<scene::SourceModel> {
        auto const& edit = *static_cast<GrowAlongStroke const*>(drawn);
        return scene::SourceModel { TRY(model_of(edit)), edit.model.includes };
    },
    .vary = [](void const* drawn,
               scene::SourceVariation const& variation) -> std::shared_ptr<void const> {
        return std::make_shared<GrowAlongStroke const>(
            varied(*static_cast<GrowAlongStroke const*>(drawn), variation));
    },
};

void list(scene::Fields& fields, GrowAlongStroke& edit)
{
    list_rule(fields, edit.rule);
    fields.word("surface", edit.surface, kSurfaceWords);
    fields.word("leaves", edit.leaves, kLeavesWords);
    fields.field("scale", &edit.scale);
    fields.id(edit.id);
    list_model(fields, edit.model);
    fields.sparse_field("turned_round", &edit.is_drawn_reversed);
    fields.numbers(edit.stroke);
}

// Converts a rule's lengths on the desk from a document's `scale` to that of the model's text.
Rule at_scale(Rule rule, double scale)
{
    rule.first_length_mm *= kModelScale / scale;
    rule.first_width_mm *= kModelScale / scale;
    rule.shortest_mm *= kModelScale / scale;
    rule.occupancy_radius_mm *= kModelScale / scale;
    for (auto& lateral : rule.lateral_rules)
        lateral.shortest_mm *= kModelScale / scale;
    return rule;
}

Result<scene::DocumentState> applied(scene::DocumentState state, GrowAlongStroke const& edit,
                                     scene::SceneBuilder&)
{
    TRY(drawn_nodes_mm(edit));
    if (!state.scale)
        state.scale = edit.scale;
    return scene::with_source(std::move(state),
                              { .name = "sketch",
                                .source = source_of(edit),
                                .drawn = scene::Drawn::Beside,
                                .stands_at_mm = stands_at_mm(edit),
                                .paper_mm = paper_position_mm(edit),
                                .id = edit.id });
}

std::string described(GrowAlongStroke const& edit)
{
    if (edit.model.is_set())
        return fmt::format("grows the model {} along a stroke: {}",
                           std::filesystem::path(edit.model.source.name).filename().string(),
                           scene::describe_stroke(edit.stroke));
    return fmt::format("grows a rule of {} at {:g} degrees along a stroke: {}",
                       scene::counted(static_cast<std::size_t>(edit.rule.laterals), "lateral"),
                       edit.rule.angle_deg, scene::describe_stroke(edit.stroke));
}

} // namespace

// Names of the fields of each lateral rule in session files: the letter of its module in the
// model's text, then the name of the field in rule files. A session without lateral rules has none
// of these fields.
using LateralNames = std::array<char const*, 9>;
static constexpr std::array<LateralNames, kMaxLateralRules> kLateralNames { {
    { { "A_r", "A_q", "A_k", "A_a", "A_s", "A_v", "A_T", "A_l_min", "A_by" } },
    { { "B_r", "B_q", "B_k", "B_a", "B_s", "B_v", "B_T", "B_l_min", "B_by" } },
    { { "C_r", "C_q", "C_k", "C_a", "C_s", "C_v", "C_T", "C_l_min", "C_by" } },
    { { "D_r", "D_q", "D_k", "D_a", "D_s", "D_v", "D_T", "D_l_min", "D_by" } },
    { { "E_r", "E_q", "E_k", "E_a", "E_s", "E_v", "E_T", "E_l_min", "E_by" } },
    { { "H_r", "H_q", "H_k", "H_a", "H_s", "H_v", "H_T", "H_l_min", "H_by" } },
    { { "I_r", "I_q", "I_k", "I_a", "I_s", "I_v", "I_T", "I_l_min", "I_by" } },
    { { "J_r", "J_q", "J_k", "J_a", "J_s", "J_v", "J_T", "J_l_min", "J_by" } },
} };

// Lists the fields of all lateral rules. The function works on a copy of the rules and writes it
// back only after a change, because edits are shared between threads.
static void list_lateral_rules(scene::Fields& fields, std::vector<LateralRule>& rules)
{
    constexpr LateralRule kNone { 0, 0, 0, 0, 0, 0, 0, 0, 0 };
    auto all = rules;
    all.resize(kMaxLateralRules, kNone);
    for (std::size_t level = 0; level < all.size(); ++level) {
        auto const& names = kLateralNames[level];
        auto& rule = all[level];
        fields.sparse_field(names[0], &rule.length_ratio);
        fields.sparse_field(names[1], &rule.width_ratio);
        fields.sparse_field(names[2], &rule.laterals);
        fields.sparse_field(names[3], &rule.angle_deg);
        fields.sparse_field(names[4], &rule.lateral_length);
        fields.sparse_field(names[5], &rule.lateral_width);
        fields.sparse_field(names[6], &rule.twist_deg);
        fields.sparse_field(names[7], &rule.shortest_mm);
        fields.sparse_field(names[8], &rule.laterals_by);
    }
    std::erase(all, kNone);
    if (all != rules)
        rules = std::move(all);
}

void list_rule(scene::Fields& fields, Rule& rule)
{
    fields.field("l", &rule.first_length_mm);
    fields.field("r", &rule.length_ratio);
    fields.field("q", &rule.width_ratio);
    fields.field("w", &rule.first_width_mm);
    fields.field("k", &rule.laterals);
    fields.field("a", &rule.angle_deg);
    fields.field("s", &rule.lateral_length);
    fields.field("v", &rule.lateral_width);
    fields.field("T", &rule.axis_twist_deg);
    fields.field("t", &rule.lateral_twist_deg);
    fields.field("l_min", &rule.shortest_mm);
    fields.field("n_max", &rule.most_segments);
    fields.field("limit", &rule.most_internodes);
    fields.sparse_field("o", &rule.occupancy_radius_mm);
    list_lateral_rules(fields, rule.lateral_rules);
}

void list_model(scene::Fields& fields, ModelRule& model)
{
    fields.sparse_field("model", &model.source.text);
    if (!model.is_set())
        return;
    fields.field("model_name", &model.source.name);
    fields.field("view_name", &model.source.view_name);
    fields.field("view", &model.source.view_text);
    fields.field("includes", &model.includes);
    fields.field("seed", &model.seed);
}

Result<SegmentLengths> lengths_of(GrowAlongStroke const& edit)
{
    if (!(edit.scale > 0 && std::isfinite(edit.scale)))
        return fail(Fault::User,
                    fmt::format("a plant cannot be shown {} times as large as it is", edit.scale));
    if (edit.model.is_set())
        return lengths_on_desk(TRY(contract_of(edit.model.source.name, edit.model.source.text)),
                               edit.scale);
    TRY(check_rule(edit.rule));
    return lengths_of(edit.rule);
}

Result<std::vector<Vec3>> drawn_nodes_mm(GrowAlongStroke const& edit)
{
    auto const lengths = TRY(lengths_of(edit));
    if (edit.surface == StrokeSurface::Decided)
        return fail(Fault::User, "the stroke is neither in space nor on paper: say which");
    auto const tips = TRY(edit.stroke.tips.in_memory());
    auto nodes_mm = resample_stroke(lengths, plant_tips(tips, edit.surface));
    if (nodes_mm.size() >= 2)
        return nodes_mm;
    auto const away = fmt::format("the stroke never gets {:g} mm away from where it begins, so ",
                                  lengths.first_mm.front());
    if (edit.model.is_set())
        return fail(Fault::User,
                    away
                        + "the model's axis has no segment: draw a longer one, or give the plants "
                          "a smaller scale");
    return fail(Fault::User,
                away
                    + "the rule is not applied once: draw a longer one, or give a rule with a "
                      "shorter first internode, l");
}

scene::PlantSource source_of(GrowAlongStroke const& edit)
{
    return { kSketch, edit };
}

GrowAlongStroke const* sketch_of(scene::PlantSource const& source)
{
    return source.get<GrowAlongStroke>(kSketch);
}

Vec3 stands_at_mm(GrowAlongStroke const& edit)
{
    auto const tips = edit.stroke.tips.in_memory();
    if (!tips || tips->empty())
        return Vec3::Zero();
    Vec3 at_mm = tips->front().position_mm;
    if (edit.surface == StrokeSurface::Paper)
        at_mm = { at_mm.x(), 0, 0 };
    return at_mm;
}

std::optional<Vec2> paper_position_mm(GrowAlongStroke const& edit)
{
    auto const tips = edit.stroke.tips.in_memory();
    if (edit.surface != StrokeSurface::Paper || !tips || tips->empty())
        return std::nullopt;
    return tips->front().position_mm.head<2>();
}

Result<lsystem::ModelSource> model_of(GrowAlongStroke const& edit)
{
    auto const nodes_mm = TRY(drawn_nodes_mm(edit));
    if (edit.model.is_set())
        return model_along(edit.model, nodes_mm, edit.scale);
    return write_model(at_scale(edit.rule, edit.scale), draw_axis(edit.rule, nodes_mm), edit.leaves,
                       "sketch");
}

// Converts nodes on the desk to the plant's frame, whose origin is the start of the stroke.
static std::vector<Vec3> nodes_in_plant(std::vector<Vec3> nodes_mm, double scale)
{
    Vec3 const base_mm = nodes_mm.front();
    for (auto& node_mm : nodes_mm)
        node_mm = (node_mm - base_mm) / scale;
    return nodes_mm;
}

static Result<scene::BuiltSource> build_model(GrowAlongStroke const& edit,
                                              scene::LoadOptions const& options)
{
    auto const nodes_mm = TRY(drawn_nodes_mm(edit));
    auto source = TRY(model_of(edit));
    auto built = TRY(scene::build_lsystem(
        { .source = std::move(source), .includes = edit.model.includes, .seed = edit.model.seed },
        options));
    auto const& name = edit.model.source.name;
    if (static_cast<double>(built.plant.segment_count()) > edit.rule.most_internodes)
        return fail(Fault::User,
                    fmt::format("{}: along this stroke it has {} internodes, and {:g} are allowed: "
                                "draw a shorter stroke, or give the plants a larger scale",
                                name, built.plant.segment_count(), edit.rule.most_internodes));
    TRY(check_follows(name, built.plant, nodes_in_plant(nodes_mm, edit.scale)));
    return built;
}

Result<scene::BuiltSource> build_sketch(GrowAlongStroke const& edit,
                                        scene::LoadOptions const& options)
{
    if (edit.model.is_set())
        return build_model(edit, options);
    return scene::build_lsystem({ .source = TRY(model_of(edit)) }, options);
}

constexpr scene::EditKind GrowAlongStroke::kKind
    = scene::make_edit_kind<GrowAlongStroke, list, applied, described>("grow_along_stroke", true);

} // namespace tractus::sketch
