#include "app/session/session_history.h"

#include "tests/app/session/small_session.h"

#include <rapidcheck/gtest.h>

namespace tractus {
namespace {

SessionHistory history_of_beginning()
{
    SessionContents contents;
    for (auto const& edit : beginning())
        contents.edits.push_back({ 0, edit });
    return SessionHistory::create(std::move(contents), options_for_tests().load_options).value();
}

// A step that any scene of the small model takes.
std::vector<Edit> random_step()
{
    switch (*rc::gen::inRange(0, 6)) {
    case 0:
        return { Select { { { *rc::gen::inRange<SegmentId>(0, 12) } } } };
    case 1:
        return { Indicate { { .end_mm = { *rc::gen::arbitrary<double>(), 0, 30 } } } };
    case 2:
        return { SetGrowth { {}, *rc::gen::arbitrary<std::uint64_t>() } };
    case 3: {
        auto again = small_model();
        again.drawn = *rc::gen::arbitrary<bool>() ? Drawn::Keep : Drawn::Forget;
        return { again };
    }
    default:
        return drawing_step(*rc::gen::inRange(-9, 9));
    }
}

// All steps, and how many of them count.
struct ModelOfHistory {
    std::vector<std::vector<Edit>> steps;
    std::size_t count = 0;

    Scene scene() const
    {
        auto edits = beginning();
        for (std::size_t i = 0; i < count; ++i)
            edits.insert(edits.end(), steps[i].begin(), steps[i].end());
        return fold(edits).value();
    }
};

// Does one thing to both.
void do_anything(SessionHistory& history, ModelOfHistory& model)
{
    switch (*rc::gen::weightedElement<int>({ { 5, 0 }, { 4, 1 }, { 2, 2 } })) {
    case 0: {
        auto const edits = random_step();
        history.push({ history.step() + 1, edits }, history.after(edits).value());
        model.steps.resize(model.count++);
        model.steps.push_back(edits);
        break;
    }
    case 1:
        model.count -= model.count > 0;
        history.go_to(model.count, history.at(model.count).value());
        break;
    default:
        model.count += model.count < model.steps.size();
        history.go_to(model.count, history.at(model.count).value());
    }
}

RC_GTEST_PROP(SessionHistory, IsTheFoldOfTheStepsThatCount, ())
{
    auto history = history_of_beginning();
    ModelOfHistory model;
    for (int i = *rc::gen::inRange(0, 40); i > 0; --i) {
        do_anything(history, model);
        RC_ASSERT(history.step() == model.count);
        RC_ASSERT(history.contents().last_step() == model.steps.size());
        RC_ASSERT(same_scene(history.scene(), model.scene()));
    }
}

TEST(SessionHistory, FindsEveryStepOfALongSession)
{
    constexpr int kSteps = 400; // More than are kept.
    auto history = history_of_beginning();
    for (int i = 0; i < kSteps; ++i) {
        std::vector<Edit> const edits { SetGrowth { {}, static_cast<std::uint64_t>(i) } };
        history.push({ history.step() + 1, edits }, history.after(edits).value());
    }
    for (std::size_t step : { 399u, 398u, 100u, 17u, 1u, 0u, 250u, 400u }) {
        history.go_to(step, history.at(step).value());
        EXPECT_EQ(history.scene().growth.seed, step == 0 ? 1 : step - 1);
    }
}

TEST(SessionHistory, SaysWhichEditFails)
{
    SessionContents contents { .edits = { { 0, small_model() }, { 1, DeleteIndicator { 3 } } },
                               .step = 1 };
    auto const history
        = SessionHistory::create(std::move(contents), options_for_tests().load_options);
    ASSERT_FALSE(history);
    EXPECT_EQ(history.error().message, "edit 2: there is no motion indicator 4: the scene has 0");
}

} // namespace
} // namespace tractus
