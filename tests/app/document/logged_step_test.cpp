#include "app/document/logged_step.h"

#include "tests/app/session/random_edits.h"
#include "tests/app/session/same_edit.h"
#include "tests/engine/scene/edits.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace tractus::document {
namespace {

std::string refusal(std::string_view name, std::string_view arguments)
{
    auto const step = parse_step(name, arguments, scene::core_edit_kinds());
    return step && !*step ? step->error().message : "";
}

RC_GTEST_PROP(LoggedStep, EditsComeBackBitForBit, ())
{
    StepOutcome done { .status = "" };
    for (int i = *rc::gen::inRange(0, 3); i > 0; --i)
        done.edits.push_back(session::random_edit());
    auto const words = words_for(done, 17);
    RC_ASSERT(words.arguments.find('\n') == std::string::npos);
    auto const step = parse_step(words.name, words.arguments, scene::core_edit_kinds());
    RC_ASSERT(step.has_value());
    RC_ASSERT(step->has_value());
    RC_ASSERT((*step)->what == LoggedStep::What::Edits);
    RC_ASSERT((*step)->strokes_before == 17u);
    RC_ASSERT((*step)->edits.size() == done.edits.size());
    for (std::size_t i = 0; i < done.edits.size(); ++i)
        RC_ASSERT(session::same((*step)->edits[i], done.edits[i]));
}

TEST(LoggedStep, IsReadableByEye)
{
    auto const grown = words_for(
        { .status = "", .edits = { scene::SmoothStroke { scene::numbered({ 4 }), 0.5 } } }, 3);
    EXPECT_EQ(grown.name, "step");
    EXPECT_EQ(grown.arguments,
              R"(3 [{"kind":"smooth_stroke","fields":{"associations":[4],"kept_hand":0.5},)"
              R"("numbers":""}])");
    auto const undone = words_for({ .status = "", .what = LoggedStep::What::Undo }, 12);
    EXPECT_EQ(undone.name, "undo");
    EXPECT_EQ(undone.arguments, "12");
    EXPECT_EQ(words_for({ .status = "", .what = LoggedStep::What::Redo }, 0).name, "redo");
    EXPECT_EQ(words_for({ .status = "", .what = LoggedStep::What::BeginAgain }, 0).name,
              "begin_again");
}

TEST(LoggedStep, OtherWordsAreNoStep)
{
    EXPECT_FALSE(parse_step("draw", "both", scene::core_edit_kinds()));
    EXPECT_FALSE(parse_step("", "", scene::core_edit_kinds()));
}

TEST(LoggedStep, RefusesWhatIsNone)
{
    EXPECT_EQ(refusal("undo", "soon"),
              "\"undo soon\" is not a step: a number of strokes is expected");
    EXPECT_NE(refusal("undo", ""), "");
    EXPECT_NE(refusal("undo", "3 4"), "");
    for (char const* const arguments :
         { "", "3", "3 x", "3 {}", "3 [1]", R"(3 [{"kind":"select"}])",
           R"(3 [{"kind":"select","fields":{},"numbers":"0"}])",
           R"(3 [{"kind":"select","fields":{},"numbers":"0g"}])",
           R"(3 [{"kind":7,"fields":{},"numbers":""}])" })
        EXPECT_NE(refusal("step", arguments), "") << arguments;
}

TEST(LoggedStep, KeepsAnEditThatIsUnknown)
{
    auto const step
        = parse_step("step", R"(0 [{"kind":"graft","fields":{"on":3},"numbers":"00ff"}])",
                     scene::core_edit_kinds())
              .value();
    ASSERT_TRUE(step);
    ASSERT_EQ(step->edits.size(), 1u);
    auto const* const unknown = step->edits[0].get<scene::UnknownEdit>();
    ASSERT_TRUE(unknown);
    EXPECT_EQ(unknown->word, "graft");
    EXPECT_EQ(unknown->fields, R"({"on":3})");
    EXPECT_EQ(unknown->numbers, std::string("\0\xff", 2));
}

} // namespace
} // namespace tractus::document
