#include "engine/methods/sketch_lsystem/model_rule.h"

#include "engine/base/fnv.h"
#include "engine/lsystem/derivation/derive.h"
#include "engine/lsystem/language/print.h"
#include "engine/methods/sketch_lsystem/change_edits.h"
#include "engine/methods/sketch_lsystem/grow_edit.h"
#include "engine/methods/sketch_lsystem/stroke_resampler.h"
#include "engine/scene/scene.h"
#include "tests/engine/methods/sketch_lsystem/strokes.h"
#include "tests/file_bytes.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <gtest/gtest.h>
#include <iterator>
#include <rapidcheck.h>
#include <string>
#include <vector>

namespace tractus::sketch {
namespace {

// Returns a model that comes with the program. Its leaves are replaced by plain blades.
ModelRule model_named(std::string const& name)
{
    auto const path = std::string(TRACTUS_OUR_MODELS "/") + name;
    ModelRule model;
    model.source = { name + ".l", file_bytes(path + ".l"), name + ".v", file_bytes(path + ".v") };
    auto& view = model.source.view_text;
    if (auto const at = view.find("\nleaf:"); at != std::string::npos)
        view.erase(at, view.find('\n', at + 1) - at);
    return model;
}

GrowAlongStroke grown(ModelRule const& model, std::vector<Vec3> const& places_mm)
{
    GrowAlongStroke edit { .model = model };
    for (auto const& place_mm : places_mm)
        edit.stroke.tips.push_back({ .position_mm = place_mm, .touching = true });
    return edit;
}

std::vector<Vec3> axis_mm(Plant const& plant)
{
    auto const nodes = plant.positions(plant.axes.front());
    return { nodes.begin(), nodes.end() };
}

std::vector<Vec3> random_walk()
{
    auto const share = [] { return *rc::gen::inRange(-1000, 1001) / 1000.0; };
    std::vector<Vec3> places_mm { { 100 * share(), 100 * share(), 100 * share() } };
    Vec3 way(0, 0, 1);
    int const steps = *rc::gen::inRange(8, 30);
    for (int i = 0; i < steps; ++i) {
        way = (way + 0.7 * Vec3(share(), share(), share())).normalized();
        places_mm.push_back(places_mm.back() + 12 * way);
    }
    return places_mm;
}

class OurModel : public testing::TestWithParam<char const*> {
protected:
    ModelRule const model_ = model_named(GetParam());
};

TEST_P(OurModel, KeepsTheContract)
{
    EXPECT_EQ(missing_for_stroke(model_, {}), std::vector<std::string> {});
}

// For any stroke, the nodes of the axis must be on the stroke, to within 1e-4 of a segment's
// length.
TEST_P(OurModel, HasItsAxisWhereAnyStrokeWas)
{
    EXPECT_TRUE(rc::check([&] {
        auto edit = grown(model_, random_walk());
        edit.scale = *rc::gen::element(0.1, 0.06, 0.2);
        auto const nodes_mm = drawn_nodes_mm(edit);
        RC_PRE(nodes_mm.has_value() && nodes_mm->size() < 60);
        auto const built = build_sketch(edit, {});
        RC_ASSERT(built.has_value());
        auto const axis = axis_mm(built->plant);
        RC_ASSERT(axis.size() >= nodes_mm->size());
        for (std::size_t i = 1; i < nodes_mm->size(); ++i) {
            double const segment_mm = ((*nodes_mm)[i] - (*nodes_mm)[i - 1]).norm();
            Vec3 const at_mm = edit.scale * axis[i] + nodes_mm->front();
            RC_ASSERT((at_mm - (*nodes_mm)[i]).norm() < 1e-4 * segment_mm);
        }
    }));
}

TEST_P(OurModel, HasOtherLateralsAndTheSameAxisForAnotherSeed)
{
    auto edit = grown(model_, bow());
    auto const one = build_sketch(edit, {}).value().plant;
    auto const count = drawn_nodes_mm(edit).value().size();
    edit.model.seed = 2;
    auto const other = build_sketch(edit, {}).value().plant;
    EXPECT_NE(one.node_position_mm, other.node_position_mm);
    auto first = axis_mm(one);
    auto second = axis_mm(other);
    first.resize(count);
    second.resize(count);
    EXPECT_EQ(first, second);
}

// The axis for the first part of a stroke must be the first part of the axis for the whole stroke,
// as far as the laws of a model allow that.
TEST_P(OurModel, HasTheAxisOfAStrokesBeginning)
{
    auto places_mm = bow();
    auto const whole = axis_along(model_, drawn_nodes_mm(grown(model_, places_mm)).value(), 0.1);
    places_mm.resize(places_mm.size() / 2);
    auto const nodes_mm = drawn_nodes_mm(grown(model_, places_mm)).value();
    auto const half = axis_along(model_, nodes_mm, 0.1);
    ASSERT_LT(half->axis.turns.size(), whole->axis.turns.size());
    for (std::size_t i = 0; i < half->axis.turns.size(); ++i)
        EXPECT_EQ(half->axis.turns[i], whole->axis.turns[i]) << i;
    auto const built = build_sketch(grown(model_, places_mm), {}).value();
    EXPECT_GE(axis_mm(built.plant).size(), nodes_mm.size());
}

TEST_P(OurModel, BearsSomethingAlongItsAxis)
{
    auto const built = build_sketch(grown(model_, bow()), {}).value();
    EXPECT_EQ(built.warnings, std::vector<std::string> {});
    EXPECT_GT(built.plant.organs.size(), 40u);
    EXPECT_GT(built.plant.segment_count(), drawn_nodes_mm(grown(model_, bow())).value().size());
}

INSTANTIATE_TEST_SUITE_P(Sketched, OurModel,
                         testing::Values("birch", "broadleaf", "conifer", "frond", "palm", "poplar",
                                         "vine"),
                         [](auto const& model) { return std::string(model.param); });

struct Before {
    char const* model;
    std::uint64_t seed;
    std::uint64_t string;
};

// Hashes (FNV-1a) of the strings of the models, computed before models could be grown along a
// stroke.
TEST(OurModels, GiveTheSameStringsWithoutAStroke)
{
    constexpr std::array kBefore {
        Before { "birch", 1, 0x56e8549c18d1782d },
        Before { "birch", 2, 0x485bb87b09d1524f },
        Before { "broadleaf", 1, 0x25d4867ab8ff5876 },
        Before { "broadleaf", 2, 0x8bd0d13103a8af59 },
        Before { "conifer", 1, 0x185fa6f4951344c5 },
        Before { "conifer", 2, 0x9013331e9600bd20 },
        Before { "palm", 1, 0x3559a90d1c525997 },
        Before { "palm", 2, 0xad249c1a2f4cdebb },
        Before { "poplar", 1, 0xdb3ee9438854e3ee },
        Before { "poplar", 2, 0x9d5b91680dbaf87a },
        Before { "vine", 1, 0xfb2a0aa3bd15d3b7 },
        Before { "vine", 2, 0xcf2b7745fda8736e },
    };
    for (auto const& [name, seed, string] : kBefore) {
        auto const model = lsystem::compile_model(model_named(name).source).value();
        auto const derived = lsystem::derive(model, { .seed = seed }).value();
        EXPECT_EQ(fnv1a_64(lsystem::to_string(model, derived)), string)
            << name << ", seed " << seed;
    }
}

TEST(ModelRule, ChangesOnlyTheContractInTheText)
{
    auto const model = model_named("birch");
    auto const along = model_of(grown(model, straight_stroke(20))).value();
    EXPECT_NE(along.text.find("#define SEGMENTS   2     /* of a trunk"), std::string::npos);
    EXPECT_NE(along.text.find("define: { array length[SEGMENTS] = {9, 8.9}; array plane[SEGMENTS] "
                              "= {0, 0}; array bend[SEGMENTS] = {0, 0}; }\n"),
              std::string::npos);
    EXPECT_EQ(along.view_text, model.source.view_text);
}

// Beyond the lengths given in the text, each length is the previous one times the ratio of the last
// two given lengths.
TEST(ModelRule, GoesOnByTheLastRatio)
{
    AxisContract contract { .lengths = { 10, 5, 4 } };
    auto const lengths = lengths_on_desk(contract, 0.2);
    ASSERT_GE(lengths.first_mm.size(), 5u);
    EXPECT_DOUBLE_EQ(lengths.first_mm[0], 20);
    EXPECT_DOUBLE_EQ(lengths.first_mm[2], 8);
    EXPECT_DOUBLE_EQ(lengths.first_mm[4], 5.12);
    EXPECT_GE(lengths.first_mm.back(), 0.4) << "none is shorter than a fiftieth of the first";
    EXPECT_EQ(lengths.most, static_cast<int>(lengths.first_mm.size()));
    EXPECT_EQ(lengths_on_desk({ .lengths = { 3 } }, 0.1).most, kMaxModelSegments);
}

TEST(ModelRule, IsVariedByItsChanceAlone)
{
    auto const source = source_of(grown(model_named("vine"), bow()));
    ASSERT_TRUE(source.can_vary());
    auto const one = source.varied({ .seed = 5, .plant = 1 });
    EXPECT_EQ(one, source.varied({ .seed = 5, .plant = 1 }));
    EXPECT_NE(one, source.varied({ .seed = 5, .plant = 2 }));
    EXPECT_EQ(source, source.varied({ .seed = 5, .plant = 1, .spread = 0 }));
    auto const text = [](scene::PlantSource const& of) { return of.model().value()->source.text; };
    EXPECT_EQ(text(one), text(source));
}

TEST(ModelRule, TakesTheRulesPlaceAndGivesItBack)
{
    auto const rule_plant = scene::apply_edit(scene::Scene {}, grown({}, bow())).value();
    auto const id = rule_plant.drawn->id;
    auto const changed
        = scene::apply_edit(rule_plant, ChangeSketch { .plant = id, .model = model_named("vine") })
              .value();
    EXPECT_GT(changed.base->organs.size(), 0u);
    EXPECT_EQ(newest_grown(*changed.drawn)->sketch->model, model_named("vine"));
    auto const back = scene::apply_edit(changed, ChangeSketch { .plant = id }).value();
    EXPECT_EQ(back.base->node_position_mm, rule_plant.base->node_position_mm);
    auto const shorter
        = scene::apply_edit(changed, ShortenSketch { .plant = id, .tips = 60 }).value();
    EXPECT_LT(shorter.base->segment_count(), changed.base->segment_count());
}

TEST(ModelRule, RefusesInASentence)
{
    auto const message = [](GrowAlongStroke const& edit) {
        auto const scene = scene::apply_edit(scene::Scene {}, edit);
        return scene ? std::string() : scene.error().message;
    };
    EXPECT_EQ(message(grown(model_named("vine"), straight_stroke(2))),
              "the stroke never gets 3.6 mm away from where it begins, so the model's axis has no "
              "segment: draw a longer one, or give the plants a smaller scale");
    EXPECT_EQ(message(grown(model_named("shrub"), bow())).find("shrub.l: it has no line #define"),
              0u);
    auto many = grown(model_named("birch"), bow());
    many.rule.most_internodes = 100;
    EXPECT_NE(message(many).find("birch.l: along this stroke it has"), std::string::npos);
}

} // namespace
} // namespace tractus::sketch
