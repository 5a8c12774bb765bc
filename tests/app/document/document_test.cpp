#include "app/document/document.h"

#include "app/tools/draw_in_order_tool.h"
#include "app/tools/draw_tool.h"
#include "tests/app/full_disk.h"
#include "tests/app/session/small_session.h"

#include <rapidcheck/gtest.h>

namespace tractus::document {
namespace {

constexpr auto kOnItsThread = Document::Working::OnItsThread;
constexpr auto kAtOnce = Document::Working::AtOnce;

// Returns a stroke for the selected trunk, with an end that depends on `number`.
tools::ToolStroke stroke_number(int number)
{
    return { stroke_through({ { 0, 0, 0 }, { 10.0 * number, 5, 100 } }),
             tools::DrawInOrderTool {} };
}

StepRequest seeded(std::uint64_t seed)
{
    auto const change = [=](scene::Scene const& scene) -> Result<StepRequest::Change> {
        auto growth = scene.growth;
        // Each step changes the seed, so that the final seed shows the order of the steps.
        growth.seed = 10 * growth.seed + seed;
        return StepRequest::Change { { growth }, "seeded" };
    };
    return { change, StepRequest::Of::Growth };
}

class DocumentTest : public session::SessionFolder {
protected:
    Document new_document() const { return { create().value(), kOnItsThread }; }

    static std::vector<std::string> said_by(Document& document)
    {
        std::vector<std::string> said;
        while (auto const done = document.take_done())
            said.push_back(done->status ? *done->status : done->status.error().message);
        return said;
    }
};

TEST_F(DocumentTest, DrawsShowsAndKeepsInOrder)
{
    auto document = new_document();
    for (int i = 1; i <= 5; ++i)
        document.draw(stroke_number(i));
    document.settle();
    EXPECT_TRUE(document.is_settled());
    EXPECT_TRUE(document.waiting().empty());
    auto const drawn = document.take_finished_strokes();
    ASSERT_EQ(drawn.size(), 5u);
    for (int i = 1; i <= 5; ++i)
        EXPECT_EQ(drawn[static_cast<std::size_t>(i - 1)].stroke.tips.back().position_mm.x(),
                  10 * i);
    auto const snapshot = document.newest();
    EXPECT_EQ(snapshot->unkept, 0u);
    EXPECT_EQ(snapshot->scene.associations.size(), 5u);
    EXPECT_TRUE(session::same_scene(snapshot->scene, document.session().scene()));
    EXPECT_EQ(session::read_session(path(), scene::core_edit_kinds()).value().last_step(), 5u);
}

// Each stroke shapes the next branch. Two strokes in quick succession must not be given the same
// branch.
TEST_F(DocumentTest, GivesAStrokeItsMeaningAfterAllEarlierOnes)
{
    auto document = new_document();
    for (int i = 1; i <= 3; ++i)
        document.draw(stroke_number(i));
    document.settle();
    auto const& associations = document.newest()->scene.associations;
    EXPECT_NE(associations[0].what.path, associations[1].what.path);
    EXPECT_NE(associations[1].what.path, associations[2].what.path);
}

TEST_F(DocumentTest, EveryStrokeIsSeenUntilItIsInTheScene)
{
    auto document = new_document();
    constexpr std::size_t kStrokes = 40;
    for (int i = 1; i <= static_cast<int>(kStrokes); ++i) {
        document.draw(stroke_number(i));
        auto const waiting = document.waiting().size();
        EXPECT_GE(waiting + document.newest()->scene.associations.size(),
                  static_cast<std::size_t>(i));
    }
    document.settle();
    EXPECT_EQ(document.newest()->scene.associations.size(), kStrokes);
}

TEST_F(DocumentTest, SnapshotsStayAsTheyAre)
{
    auto document = new_document();
    auto const before = document.newest();
    document.draw(stroke_number(1));
    document.settle();
    auto const drawn = document.newest();
    document.make(seeded(2));
    document.settle();
    auto const grown = document.newest();
    EXPECT_TRUE(before->scene.associations.empty());
    EXPECT_EQ(drawn->scene.growth.seed, 1u);
    EXPECT_GT(drawn->drawn_revision, before->drawn_revision);
    EXPECT_EQ(grown->drawn_revision, drawn->drawn_revision) << "only its growth is another";
    EXPECT_GT(grown->revision, drawn->revision);
}

TEST_F(DocumentTest, DoesWhatIsWantedInItsOrder)
{
    auto document = new_document();
    document.draw(stroke_number(1));
    document.make(seeded(2));
    document.make(seeded(3));
    document.undo();
    document.make(seeded(4));
    document.redo(); // There is nothing to redo, so this call has no effect.
    document.settle();
    EXPECT_EQ(document.newest()->scene.growth.seed, 124u);
    EXPECT_EQ(document.newest()->scene.associations.size(), 1u);
    EXPECT_EQ(document.session().step(), 3u);
    EXPECT_EQ(said_by(document),
              (std::vector<std::string> {
                  "seeded", "seeded", "Undone", "seeded",
                  "there is nothing to redo: the last step was made, not undone" }));
}

TEST_F(DocumentTest, ARefusedStrokeChangesNothingAndSaysWhy)
{
    auto document = new_document();
    document.draw({ stroke_number(1).stroke, tools::DrawTool {} });
    document.settle();
    auto const drawn = document.take_finished_strokes();
    ASSERT_EQ(drawn.size(), 1u);
    EXPECT_NE(drawn[0].refusal.find("nothing is selected"), std::string::npos);
    EXPECT_TRUE(drawn[0].edits.empty());
    EXPECT_EQ(document.newest()->revision, 0u);
    EXPECT_TRUE(document.waiting().empty());
    EXPECT_EQ(session::read_session(path(), scene::core_edit_kinds()).value().last_step(), 0u);
}

TEST_F(DocumentTest, BeginsAgainAsAStepLikeAnother)
{
    auto document = new_document();
    document.draw(stroke_number(1));
    document.begin_again("as it began");
    document.settle();
    EXPECT_TRUE(document.newest()->scene.associations.empty());
    document.undo();
    document.settle();
    EXPECT_EQ(document.newest()->scene.associations.size(), 1u);
}

TEST_F(DocumentTest, DrawsOnWhileTheDiskIsFullAndKeepsAllAfterwards)
{
    auto document = new_document();
    document.draw(stroke_number(1));
    document.settle();
    {
        FullDisk const disk(1);
        document.draw(stroke_number(2));
        document.settle();
        EXPECT_EQ(document.newest()->unkept, 1u);
        EXPECT_NE(document.newest()->not_kept, "");
        document.draw(stroke_number(3));
        document.make(seeded(2));
        document.undo();
        document.try_again();
        document.settle();
        EXPECT_EQ(document.newest()->unkept, 3u);
        EXPECT_EQ(document.newest()->scene.associations.size(), 3u) << "what is drawn is seen";
        auto const said = said_by(document);
        ASSERT_EQ(said.size(), 2u);
        EXPECT_NE(said[1].find("what was drawn must be kept first"), std::string::npos);
    }
    auto const seen = document.newest();
    document.pass_time(
        timestamp_ns(1000'000'000)); // After a failure, saving is tried again one second later.
    document.pass_time(timestamp_ns(1900'000'000));
    document.settle();
    EXPECT_EQ(document.newest()->unkept, 3u);
    document.pass_time(timestamp_ns(2000'000'000));
    document.settle();
    EXPECT_EQ(document.newest()->unkept, 0u);
    EXPECT_EQ(document.newest()->not_kept, "");
    EXPECT_EQ(document.newest()->revision, seen->revision) << "it is the same scene";
    EXPECT_TRUE(session::same_scene(document.newest()->scene, seen->scene));
    EXPECT_EQ(session::read_session(path(), scene::core_edit_kinds()).value().last_step(), 4u);
}

TEST_F(DocumentTest, ClosingDoesAllThatHasCome)
{
    {
        auto document = new_document();
        for (int i = 1; i <= 30; ++i)
            document.draw(stroke_number(i));
    }
    EXPECT_EQ(session::read_session(path(), scene::core_edit_kinds()).value().last_step(), 30u);
}

TEST_F(DocumentTest, WithoutAFileStepsCanBeTakenBack)
{
    Document document(small_scene(), kOnItsThread);
    for (int i = 1; i <= 5; ++i)
        document.draw(stroke_number(i));
    document.make(seeded(2));
    document.undo();
    document.undo();
    document.settle();
    EXPECT_EQ(document.newest()->scene.growth.seed, 1u);
    EXPECT_EQ(document.newest()->scene.associations.size(), 4u);
    EXPECT_EQ(document.newest()->unkept, 0u);
    document.redo();
    document.redo();
    document.settle();
    EXPECT_EQ(document.newest()->scene.growth.seed, 12u);
    EXPECT_EQ(document.newest()->scene.associations.size(), 5u);
    EXPECT_EQ(
        said_by(document),
        (std::vector<std::string> { "seeded", "Undone", "Undone", "Done again", "Done again" }));
    document.begin_again("again", Document::Growth::AsItIs);
    document.settle();
    EXPECT_TRUE(document.newest()->scene.associations.empty());
    EXPECT_EQ(document.newest()->scene.growth.seed, 12u);
    document.begin_again("again");
    document.settle();
    EXPECT_EQ(document.newest()->scene.growth.seed, small_scene().growth.seed);
    document.undo();
    document.undo();
    document.settle();
    EXPECT_EQ(document.newest()->scene.associations.size(), 5u) << "a step like another";
}

// Random operations must give the same document and file whether the document uses a thread or not.
RC_GTEST_FIXTURE_PROP(DocumentTest, WithAThreadIsTheSameAsWithout, ())
{
    std::filesystem::remove(path("a.tractus"));
    std::filesystem::remove(path("b.tractus"));
    Document one(create("a.tractus").value(), kOnItsThread);
    Document other(create("b.tractus").value(), kAtOnce);
    auto const actions = *rc::gen::container<std::vector<int>>(rc::gen::inRange(0, 8));
    for (int number = 0; auto const action : actions) {
        for (auto* const document : { &one, &other }) {
            if (action == 0)
                document->undo();
            else if (action == 1)
                document->redo();
            else if (action == 2)
                document->make(seeded(static_cast<std::uint64_t>(number)));
            else if (action == 3)
                document->begin_again("");
            else
                document->draw(stroke_number(number));
        }
        ++number;
    }
    one.settle();
    RC_ASSERT(session::same_scene(one.newest()->scene, other.newest()->scene));
    RC_ASSERT(one.newest()->revision == other.newest()->revision);
    RC_ASSERT(said_by(one) == said_by(other));
    auto const a = session::read_session(path("a.tractus"), scene::core_edit_kinds()).value();
    auto const b = session::read_session(path("b.tractus"), scene::core_edit_kinds()).value();
    RC_ASSERT(a.step == b.step);
    RC_ASSERT(a.edits.size() == b.edits.size());
    for (std::size_t i = 0; i < a.edits.size(); ++i)
        RC_ASSERT(session::same(a.edits[i].edit, b.edits[i].edit));
}

} // namespace
} // namespace tractus::document
