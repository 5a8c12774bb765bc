#include "app/session/session_history.h"

#include "tests/app/session/small_session.h"
#include "tests/engine/scene/edits.h"

#include <rapidcheck/gtest.h>

namespace tractus::session {
namespace {

// Steps of a session, kept in memory and numbered as in a session file.
class Steps {
public:
    explicit Steps(std::vector<std::vector<scene::Edit>> steps)
        : steps_(std::move(steps))
    {
    }

    // Removes the steps from number `step` on, and adds a new one.
    void push(std::size_t step, std::vector<scene::Edit> edits)
    {
        steps_.resize(step);
        steps_.push_back(std::move(edits));
    }

    ReadStep read() const
    {
        return [this](std::size_t wanted) -> Result<std::vector<SessionEdit>> {
            std::int64_t number = 0;
            for (std::size_t step = 0; step < wanted; ++step)
                number += std::ssize(steps_[step]);
            std::vector<SessionEdit> edits;
            for (auto const& edit : steps_.at(wanted))
                edits.push_back({ wanted, edit, {}, { .number = ++number } });
            return edits;
        };
    }

    Result<SessionHistory> history() const
    {
        auto const last = steps_.size() - 1;
        scene::SceneBuilder builder;
        return SessionHistory::create({ last, last }, read(), builder);
    }

private:
    std::vector<std::vector<scene::Edit>> steps_;
};

// A history together with the builder that builds its scene.
class Built {
public:
    explicit Built(SessionHistory history)
        : history_(std::move(history))
    {
    }

    SessionHistory& history() { return history_; }
    scene::Scene scene() { return builder_.build(history_.state()).value(); }

    void push(std::vector<scene::Edit> const& edits)
    {
        history_.push(history_.after(edits, builder_).value());
    }

    void go_to(std::size_t step, Steps const& steps)
    {
        history_.go_to(step, history_.at(step, steps.read(), builder_).value());
    }

private:
    SessionHistory history_;
    scene::SceneBuilder builder_;
};

// Returns a step that erases tips of a random stroke. If there is no stroke, or this one has too
// few tips, the step draws a stroke.
std::vector<scene::Edit> erasing_step(scene::Scene const& scene)
{
    if (scene.associations.empty())
        return drawing_step(1);
    auto const number = *rc::gen::inRange<std::size_t>(0, scene.associations.size());
    auto const count = scene.associations[number].what.stroke.tips.size();
    if (count < 3)
        return drawing_step(2);
    auto const erased = *rc::gen::inRange<std::size_t>(1, count - 1);
    auto const first = *rc::gen::inRange<std::size_t>(0, count - erased + 1);
    return { scene::EraseTips { scene::numbered({ number }), { { first, first + erased - 1 } } } };
}

// Returns a random step that a scene with the small model accepts.
std::vector<scene::Edit> random_step(scene::Scene const& scene)
{
    switch (*rc::gen::inRange(0, 8)) {
    case 0:
        return { scene::Select { { { *rc::gen::inRange<SegmentId>(0, 12) } } } };
    case 1:
        return { scene::Indicate { { .end_mm = { *rc::gen::arbitrary<double>(), 0, 30 } } } };
    case 2:
        return { scene::SetGrowth { {}, *rc::gen::arbitrary<std::uint64_t>() } };
    case 3: {
        auto again = small_model();
        again.drawn = *rc::gen::arbitrary<bool>() ? scene::Drawn::Keep : scene::Drawn::Forget;
        return { again };
    }
    case 4:
    case 5:
        return erasing_step(scene);
    default:
        return drawing_step(*rc::gen::inRange(-9, 9));
    }
}

// A simple model of a history: all steps, and the number of steps in effect.
struct ModelOfHistory {
    std::vector<std::vector<scene::Edit>> steps;
    std::size_t count = 0;

    scene::Scene scene() const
    {
        auto edits = beginning();
        for (std::size_t i = 0; i < count; ++i)
            edits.insert(edits.end(), steps[i].begin(), steps[i].end());
        return scene::fold(edits).value();
    }
};

// Applies a random operation to both the history and its model.
void do_anything(Built& built, Steps& steps, ModelOfHistory& model)
{
    switch (*rc::gen::weightedElement<int>({ { 5, 0 }, { 4, 1 }, { 2, 2 } })) {
    case 0: {
        auto const edits = random_step(built.scene());
        built.push(edits);
        steps.push(built.history().step(), edits);
        model.steps.resize(model.count++);
        model.steps.push_back(edits);
        break;
    }
    case 1:
        model.count -= model.count > 0;
        built.go_to(model.count, steps);
        break;
    default:
        model.count += model.count < model.steps.size();
        built.go_to(model.count, steps);
    }
}

RC_GTEST_PROP(SessionHistory, IsTheFoldOfTheStepsThatCount, ())
{
    Steps steps({ beginning() });
    Built built(steps.history().value());
    ModelOfHistory model;
    for (int i = *rc::gen::inRange(0, 40); i > 0; --i) {
        do_anything(built, steps, model);
        RC_ASSERT(built.history().step() == model.count);
        RC_ASSERT(built.history().last_step() == model.steps.size());
        RC_ASSERT(same_scene(built.scene(), model.scene()));
    }
}

TEST(SessionHistory, FindsEveryStepOfALongSession)
{
    constexpr int kSteps = 400; // More steps than the history keeps in memory.
    Steps steps({ beginning() });
    Built built(steps.history().value());
    for (int i = 0; i < kSteps; ++i) {
        std::vector<scene::Edit> const edits { scene::SetGrowth { {},
                                                                  static_cast<std::uint64_t>(i) } };
        built.push(edits);
        steps.push(built.history().step(), edits);
    }
    for (std::size_t step : { 399u, 398u, 100u, 17u, 1u, 0u, 250u, 400u }) {
        built.go_to(step, steps);
        EXPECT_EQ(built.scene().growth.seed, step == 0 ? 1 : step - 1);
    }
}

TEST(SessionHistory, SaysWhichPlantCannotBeLoaded)
{
    auto const history = Steps({ { scene::SetGrowth {},
                                   scene::LoadModel { { "bad.l", "Lsystem: 1\nAxiom: (" } } } })
                             .history();
    ASSERT_TRUE(history) << "no plant is needed to know what was drawn";
    scene::SceneBuilder builder;
    auto const scene = build_scene(builder, history->state());
    ASSERT_FALSE(scene);
    EXPECT_EQ(scene.error().message.find("edit 2: bad.l:2:"), 0u) << scene.error().message;
}

// If the file is damaged, something that an edit needs may be missing. The step with this edit is
// then left out.
TEST(SessionHistory, GoesOnWithoutAStepThatCannotBeMade)
{
    scene::SetGrowth const seven { {}, 7 };
    scene::SetGrowth const eight { {}, 8 };
    auto const history
        = Steps({ { small_model() }, { seven }, { eight, scene::DeleteIndicator { .number = 3 } } })
              .history();
    ASSERT_TRUE(history) << history.error().message;
    EXPECT_EQ(scene::active_plant(history->state())->growth.seed, 7u)
        << "all of a step, or nothing";
    EXPECT_EQ(history->last_step(), 2u);
}

} // namespace
} // namespace tractus::session
