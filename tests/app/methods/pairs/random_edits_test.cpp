#include "app/document/document.h"
#include "app/methods/all_methods.h"
#include "app/session/begin_empty.h"
#include "tests/app/methods/pairs/document_of_all_methods.h"
#include "tests/app/methods/pairs/random_hand.h"
#include "tests/app/methods/pictures/small_picture.h"
#include "tests/app/session/small_session.h"

#include <algorithm>
#include <fmt/core.h>

namespace tractus::methods {
namespace {

using RandomEdits = session::SessionFolder;

// Draws random strokes until the session has `steps` steps. In between, some steps are undone and
// redone.
void draw_at_random(document::Document& document, RandomHand& hand, std::size_t steps)
{
    while (document.session().step() < steps) {
        if (hand.happens(0.1))
            document.undo();
        else if (hand.happens(0.05))
            document.redo();
        else if (hand.happens(0.05))
            document.make(
                { [&](scene::Scene const& scene) -> Result<document::StepRequest::Change> {
                    if (!scene.state.picture)
                        return document::StepRequest::Change {
                            { scene::LayPicture { "small.png", pictures::small_png() } }, ""
                        };
                    return document::StepRequest::Change { { hand.growth(scene.growth) }, "" };
                } });
        else
            document.draw(hand.stroke(document.newest()->scene));
        for (auto const& drawn : document.take_finished_strokes())
            if (drawn.refusal.empty())
                hand.has_done(drawn.tool);
    }
}

// Undoes all steps, which must lead to the empty sheet. Then redoes them, which must lead to the
// same exported file. Returns that file.
std::string exported_again(document::Document& document, std::size_t steps)
{
    auto const file = exported(document.newest()->scene);
    for (std::size_t i = 0; i < steps; ++i)
        document.undo();
    EXPECT_EQ(document.session().step(), 0u);
    EXPECT_TRUE(document.newest()->scene.plants.empty());
    for (std::size_t i = 0; i < steps; ++i)
        document.redo();
    EXPECT_EQ(document.session().step(), steps);
    EXPECT_TRUE(exported(document.newest()->scene) == file);
    return file;
}

TEST_F(RandomEdits, OfAllMethodsAreUndoneAndDoneAgain)
{
    constexpr std::size_t kSteps = 1240; // Twenty steps for each tool.
    // Maximum number of tools that may be refused every time, as random strokes seldom suit them.
    constexpr std::ptrdiff_t kMaxRefused = 2;
    document::Document document(scene::Scene {}, document::Document::Working::AtOnce);
    RandomHand hand(2);
    draw_at_random(document, hand, kSteps);
    std::string never;
    for (auto const* const kind : all_methods().tools)
        if (hand.times_done(*kind) == 0)
            never += fmt::format(" {}", kind->word);
    EXPECT_LE(std::count(never.begin(), never.end(), ' '), kMaxRefused)
        << "always refused:" << never;
    exported_again(document, kSteps);
}

TEST_F(RandomEdits, OfAllMethodsAreInTheSessionsFile)
{
    constexpr std::size_t kSteps = 150; // Few steps, because each one waits for the disk.
    std::string file;
    {
        document::Document document(
            session::Session::create(path(), { .plant = "empty", .program = "1" },
                                     std::vector<scene::Edit> { session::BeginEmpty {} },
                                     options_for_all_methods())
                .value(),
            document::Document::Working::AtOnce);
        RandomHand hand(5);
        draw_at_random(document, hand, kSteps);
        file = exported_again(document, kSteps);
    }
    auto const opened = session::Session::open(path(), options_for_all_methods());
    ASSERT_TRUE(opened) << opened.error().message;
    EXPECT_TRUE(exported(opened->scene()) == file);
}

} // namespace
} // namespace tractus::methods
