#include "engine/methods/construction_lines/own_rules.h"

#include "engine/methods/construction_lines/line_edits.h"
#include "engine/methods/construction_lines/organ_edits.h"
#include "engine/scene/write_rules.h"
#include "tests/engine/methods/construction_lines/drawn_sketch.h"

// Tests of rules that the user writes to replace those of a pattern.

namespace tractus::lines {
namespace {

std::string replaced(std::string text, std::string const& part, std::string const& with)
{
    auto const at = text.find(part);
    EXPECT_NE(at, std::string::npos) << part << " in " << text;
    return at == std::string::npos ? text : text.replace(at, part.size(), with);
}

std::string text_of(Drawing const& drawing)
{
    auto const model = model_of(drawing.sketch());
    EXPECT_TRUE(model) << model.error().message;
    return model ? model->source.text : "";
}

// Adds a second organ to each node in the text of a spiral model.
std::string twice(std::string const& text)
{
    return replaced(text, "    --> [/(t)", "    /* Twice. */ --> [~l(9)][/(t)");
}

scene::WriteRules rules(Drawing const& drawing, std::string const& text)
{
    return { .plant = drawing.scene().state.active, .rules = { .text = text } };
}

TEST(OwnRules, AreTheModelsThatTheyWereWrittenFrom)
{
    auto drawing = whole_sketch();
    auto const own = text_of(drawing);
    drawing.apply(rules(drawing, own));
    EXPECT_EQ(text_of(drawing), own);
}

// If a line is redrawn, only functions and numbers of the model may change, not the user's rules.
TEST(OwnRules, StayWhereTheSketchIsDrawnAgain)
{
    auto drawing = whole_sketch();
    auto const organs = drawing.organs();
    drawing.apply(rules(drawing, twice(text_of(drawing))));
    auto const more = drawing.organs();
    EXPECT_EQ(more, 2 * organs);
    auto const before = model_of(drawing.sketch()).value();
    auto const layer = layers_of(drawing.sketch()).value().front();
    drawing.apply(SetLayerNodes { drawing.scene().state.active, layer.line, layer.nodes + 4 });
    EXPECT_EQ(drawing.organs(), more + 2 * 4) << "two for each node now";
    // A new boundary on the left.
    drawing.draw(pen_stroke({ { -80, -70, 0 }, { -70, 0, 0 }, { -30, 70, 0 } }));
    auto const after = model_of(drawing.sketch()).value();
    EXPECT_NE(after.functions, before.functions);
    EXPECT_NE(after.source.text.find("/* Twice. */"), std::string::npos);
    drawing.apply(rules(drawing, ""));
    EXPECT_EQ(after.source.text, twice(text_of(drawing))) << "all else is the pattern's";
}

TEST(OwnRules, TheNextPatternComesWithItsOwn)
{
    auto drawing = whole_sketch();
    drawing.apply(rules(drawing, twice(text_of(drawing))));
    drawing.apply(
        SetLinePattern { drawing.scene().state.active, { .kind = Pattern::Kind::Decussate } });
    EXPECT_EQ(text_of(drawing).find("Twice"), std::string::npos);
    EXPECT_FALSE(drawing.sketch().rules);
}

TEST(OwnRules, ThatDoNotCompileChangeNothing)
{
    auto drawing = whole_sketch();
    auto const organs = drawing.organs();
    auto const refusal = drawing.refusal(
        rules(drawing, replaced(text_of(drawing), "homomorphism\n", "homomorphism\nS(x --> *\n")));
    EXPECT_EQ(refusal.find("lines.l:"), 0U) << refusal;
    EXPECT_EQ(drawing.organs(), organs);
    EXPECT_FALSE(drawing.sketch().rules);
}

// If a change needs a table that the user's rules do not read, the change must be refused until the
// rules are rewritten.
TEST(OwnRules, RefuseWhatTheyDoNotRead)
{
    auto drawing = whole_sketch();
    drawing.apply(rules(drawing, twice(text_of(drawing))));
    auto const layer = layers_of(drawing.sketch()).value().front();
    EXPECT_NE(drawing
                  .refusal(SetLinePattern { drawing.scene().state.active,
                                            { .kind = Pattern::Kind::Decussate },
                                            layer.line })
                  .find("the rules that were written have no \"array organ\""),
              std::string::npos);
    EXPECT_NE(text_of(drawing).find("Twice"), std::string::npos);
}

TEST(OwnRules, HaveAViewOfTheirOwn)
{
    auto drawing = whole_sketch();
    auto const model = model_of(drawing.sketch()).value();
    drawing.apply(scene::WriteRules {
        .plant = drawing.scene().state.active,
        .rules = { model.source.text,
                   replaced(model.source.view_text, "kind=blade", "kind=blade curl=30") } });
    EXPECT_NE(model_of(drawing.sketch())->source.view_text, model.source.view_text);
}

// Arrays with equal names in several L-systems must stay separate. The user's own arrays must stay
// as they are.
TEST(OwnRules, KeepEachLSystemsNumbers)
{
    LineModel model;
    model.source.text = "#define LEN 7 /* of it */\nderivation length: 3\n"
                        "define: { array at[1] = {1}; }\nderivation length: 4\n"
                        "define: { array at[2] = {2, 3}; }\n";
    auto const written
        = with_own_rules(model,
                         { "/* mine */ #define MINE 9\n#define LEN 1 /* mine, too */\n"
                           "derivation length: 1\narray at[1] = {9};\narray mine[1] = {5};\n"
                           "derivation length: 1\narray at[1] = {9};\n" });
    ASSERT_TRUE(written) << written.error().message;
    EXPECT_EQ(written->source.text,
              "/* mine */ #define MINE 9\n#define LEN 7 /* mine, too */\n"
              "derivation length: 3\narray at[1] = {1};\narray mine[1] = {5};\n"
              "derivation length: 4\narray at[2] = {2, 3};\n");
    for (std::string const broken : { "", "array", "array at", "array at[1] = {", "#define",
                                      "#define ", "#define LEN", "derivation length:" })
        EXPECT_FALSE(with_own_rules(model, { broken }));
}

TEST(OwnRules, AreOnlyForDrawnPlants)
{
    auto const scene = scene::apply_edit(
        {},
        scene::LoadModel { .source = { .name = "a.l",
                                       .text = "Lsystem: 1\nderivation length: 1\nAxiom: F(3)\n"
                                               "F(x) --> F(x)\nendlsystem\n" } });
    ASSERT_TRUE(scene);
    auto const refused = scene::apply_edit(
        *scene, scene::WriteRules { .plant = scene->state.active, .rules = { "x", "" } });
    ASSERT_FALSE(refused);
    EXPECT_NE(refused.error().message.find("has no rules that one could write"), std::string::npos);
}

} // namespace
} // namespace tractus::lines
