#include "app/station/session_keeper.h"

#include "tests/app/full_disk.h"
#include "tests/app/session/small_session.h"
#include "tests/app/simple_rig.h"

namespace tractus {
namespace {

// A station, and what keeps its strokes in a session.
class Keeping : public SessionFolder {
protected:
    static WantedStep seed(std::uint64_t seed)
    {
        auto const change = [=](Scene const& scene) -> Result<WantedStep::Change> {
            auto growth = scene.growth;
            growth.seed = 10 * growth.seed + seed; // Shows in which order they were made.
            return WantedStep::Change { { growth }, "seeded" };
        };
        return { change, WantedStep::Of::Growth };
    }

    void settle(SessionKeeper& keeper, Station& station) { keeper.settle(station, at_ms(now_ms_)); }

    std::int64_t now_ms_ = 1000;
};

TEST_F(Keeping, KeepsStrokesInTheBackgroundWhileOthersWait)
{
    SessionKeeper keeper(create().value());
    auto station = station_on(keeper.session().scene());
    draw_across(station, 1000);
    keeper.advance(station, at_ms(2000));
    EXPECT_FALSE(keeper.is_settled());
    draw_across(station, 2000);
    EXPECT_EQ(station.waiting_strokes().size(), 1u);
    EXPECT_EQ(station.counts().strokes, 1u);
    settle(keeper, station);
    EXPECT_TRUE(keeper.is_settled());
    EXPECT_TRUE(station.waiting_strokes().empty());
    EXPECT_EQ(station.counts().strokes, 2u);
    EXPECT_EQ(read_session(path()).value().last_step(), 2u);
    EXPECT_TRUE(same_scene(station.scene(), keeper.session().scene()));
}

TEST_F(Keeping, DoesWhatIsWantedInItsOrder)
{
    SessionKeeper keeper(create().value());
    auto station = station_on(keeper.session().scene());
    draw_across(station, 1000);
    keeper.make(seed(2));
    keeper.make(seed(3));
    keeper.undo();
    keeper.make(seed(4));
    keeper.redo(); // There is nothing any more.
    settle(keeper, station);
    EXPECT_EQ(station.scene().growth.seed, 124u);
    EXPECT_EQ(station.scene().associations.size(), 1u);
    EXPECT_EQ(keeper.session().step(), 3u);
    std::vector<std::string> said;
    while (auto const done = keeper.take_done())
        said.push_back(done->status ? *done->status : done->status.error().message);
    EXPECT_EQ(said,
              (std::vector<std::string> {
                  "seeded", "seeded", "Undone", "seeded",
                  "there is nothing to redo: the last step was made, not undone" }));
}

TEST_F(Keeping, BeginsAgainAsAStepLikeAnother)
{
    SessionKeeper keeper(create().value());
    auto station = station_on(keeper.session().scene());
    draw_across(station, 1000);
    keeper.begin_again("as it began");
    settle(keeper, station);
    EXPECT_TRUE(station.scene().associations.empty());
    keeper.undo();
    settle(keeper, station);
    EXPECT_EQ(station.scene().associations.size(), 1u);
}

TEST_F(Keeping, LosesNothingWhenTheStationChangesWhileTheDiskIsFull)
{
    SessionKeeper keeper(create().value());
    auto station = station_on(keeper.session().scene());
    draw_across(station, 1000);
    settle(keeper, station);
    draw_across(station, 2000);
    {
        FullDisk const disk(1);
        settle(keeper, station);
    }
    ASSERT_FALSE(keeper.not_kept().empty());
    ASSERT_EQ(keeper.unkept_strokes(), 1u);
    auto next = station_on(small_scene());
    next.take_drawing_from(station);
    keeper.try_again();
    settle(keeper, next);
    EXPECT_EQ(keeper.not_kept(), "");
    EXPECT_EQ(read_session(path()).value().last_step(), 2u);
    EXPECT_TRUE(same_scene(next.scene(), keeper.session().scene()));
}

TEST_F(Keeping, TellsWhatCannotBeKeptAndTriesAgain)
{
    SessionKeeper keeper(create().value());
    // The session knows of no branch that is selected.
    auto scene = apply_edit(keeper.session().scene(), Select { { { 0, 1, 2 } } }).value();
    auto station = station_on(std::move(scene), { Tool::Kind::Draw });
    draw_across(station, 1000);
    settle(keeper, station);
    EXPECT_FALSE(keeper.is_settled());
    EXPECT_NE(keeper.not_kept().find("nothing is selected"), std::string::npos);
    EXPECT_EQ(station.strokes().size(), 1u);
    keeper.undo();
    auto const undone = keeper.take_done();
    ASSERT_TRUE(undone);
    EXPECT_NE(undone->status.error().message.find("must be kept first"), std::string::npos);
    now_ms_ += 2000;
    settle(keeper, station);
    EXPECT_FALSE(keeper.not_kept().empty());
    EXPECT_EQ(read_session(path()).value().last_step(), 0u);
}

TEST_F(Keeping, ChangesTheSceneWithoutASession)
{
    SessionKeeper keeper(std::nullopt);
    auto station = station_on(small_scene());
    draw_across(station, 1000);
    keeper.make(seed(2));
    keeper.undo();
    keeper.advance(station, at_ms(2000));
    EXPECT_TRUE(keeper.is_settled());
    EXPECT_EQ(station.scene().growth.seed, 12u);
    EXPECT_EQ(*keeper.take_done()->status, "seeded");
    EXPECT_NE(keeper.take_done()->status.error().message.find("no session"), std::string::npos);
    keeper.forget_kept(station);
    EXPECT_TRUE(station.strokes().empty());
}

} // namespace
} // namespace tractus
