#include "app/session/session.h"

#include "tests/app/session/small_session.h"

#include <cstdlib>

namespace tractus {
namespace {

using SessionTest = SessionFolder;

TEST_F(SessionTest, HoldsWhatWasAppended)
{
    auto session = create().value();
    for (int i = 0; i < 3; ++i)
        ASSERT_TRUE(session.append(drawing_step(i)));
    auto const scene = session.scene();
    EXPECT_EQ(scene.associations.size(), 3u);
    auto const contents = read_session(path()).value(); // While it is being written.
    EXPECT_EQ(contents.edits.size(), 8u);
    EXPECT_EQ(contents.step, 3u);
    EXPECT_EQ(contents.origin.plant, "small.l");
    EXPECT_EQ(contents.origin.program, "1.2.3");
}

TEST_F(SessionTest, OpensAsItWasClosed)
{
    Scene scene;
    {
        auto session = create().value();
        for (int i = 0; i < 4; ++i)
            ASSERT_TRUE(session.append(drawing_step(i)));
        ASSERT_TRUE(session.undo());
        scene = session.scene();
    }
    EXPECT_EQ(file_count(), 1u); // Nothing is left beside it.
    auto session = open().value();
    EXPECT_TRUE(same_scene(session.scene(), scene));
    ASSERT_TRUE(session.redo());
    EXPECT_EQ(session.scene().associations.size(), 4u);
}

TEST_F(SessionTest, UndoEndsAtTheBeginningAndRedoAtTheEnd)
{
    auto session = create().value();
    ASSERT_TRUE(session.append(drawing_step(1)));
    EXPECT_FALSE(session.can_redo());
    EXPECT_EQ(session.redo().error().message,
              "there is nothing to redo: the last step was made, not undone");
    ASSERT_TRUE(session.undo());
    EXPECT_TRUE(session.scene().associations.empty());
    EXPECT_EQ(session.scene().base->segment_count(), 12u);
    EXPECT_FALSE(session.can_undo());
    EXPECT_EQ(session.undo().error().message,
              "there is nothing to undo: this is how the session began");
}

TEST_F(SessionTest, AStrokeAfterUndoReplacesWhatWasUndone)
{
    {
        auto session = create().value();
        for (int i = 0; i < 3; ++i)
            ASSERT_TRUE(session.append(drawing_step(i)));
        ASSERT_TRUE(session.undo());
        ASSERT_TRUE(session.undo());
        ASSERT_TRUE(session.append(drawing_step(7)));
        EXPECT_FALSE(session.can_redo());
    }
    auto const session = open().value();
    ASSERT_EQ(session.scene().associations.size(), 2u);
    EXPECT_NEAR(session.scene().associations[1].stroke.tips.back().position_mm.x(), 70.7, 1e-9);
    EXPECT_EQ(read_session(path()).value().edits.size(), 6u);
}

TEST_F(SessionTest, AStepThatIsRefusedChangesNothing)
{
    auto session = create().value();
    ASSERT_TRUE(session.append(drawing_step(1)));
    EXPECT_FALSE(session.append(std::vector<Edit> { Select {}, DeleteIndicator { 9 } }));
    EXPECT_EQ(session.scene().selection.size(), 1u);
    EXPECT_EQ(read_session(path()).value().edits.size(), 4u);
    ASSERT_TRUE(session.append({}));
    EXPECT_EQ(session.step(), 1u);
}

TEST_F(SessionTest, IsNeverWrittenOver)
{
    write_bytes("a.tractus", "a letter");
    EXPECT_EQ(create().error().message,
              path().string()
                  + " is already there: choose another name, a session is never written over");
    EXPECT_EQ(read_bytes(), "a letter");
    EXPECT_EQ(file_count(), 1u);
}

TEST_F(SessionTest, OnlyOneProgramDrawsInIt)
{
    auto session = create().value();
    auto const second = open();
    ASSERT_FALSE(second);
    EXPECT_EQ(second.error().message,
              path().string() + " is in use by another program: close it there first");
    EXPECT_TRUE(session.append(drawing_step(1)));
    EXPECT_TRUE(session.undo());
}

TEST_F(SessionTest, ThatTheProgramLeftOpenIsReadAsItWas)
{
    // What kill -9 leaves behind: the file and its journal.
    auto session = create().value();
    ASSERT_TRUE(session.append(drawing_step(1)));
    std::filesystem::copy_file(path(), path("b.tractus"));
    std::filesystem::copy_file(path().string() + "-wal", path("b.tractus").string() + "-wal");
    EXPECT_EQ(read_session(path("b.tractus")).value().edits.size(), 4u);
    EXPECT_EQ(open("b.tractus").value().scene().associations.size(), 1u);
}

TEST_F(SessionTest, OfAnOlderFormatIsBroughtUpToDateAndKeptAsItWas)
{
    {
        auto session = create().value();
        for (int i = 0; i < 3; ++i)
            ASSERT_TRUE(session.append(drawing_step(i)));
    }
    ASSERT_TRUE(Database::open(path(), Database::Access::Write).value().execute(kToFormat1));
    EXPECT_EQ(read_session(path()).value().edits.size(), 8u); // Reading needs no change.
    EXPECT_EQ(file_count(), 1u);
    {
        auto session = open().value();
        EXPECT_EQ(session.scene().associations.size(), 3u);
        EXPECT_EQ(read_session(path()).value().edits.back().made.time_since_epoch().count(), 0);
        ASSERT_TRUE(session.append(drawing_step(3)));
    }
    EXPECT_EQ(file_count(), 2u);
    auto const format = [&](char const* name) {
        return Database::open(path(name), Database::Access::Read)
            .value()
            .whole("PRAGMA user_version")
            .value();
    };
    EXPECT_EQ(format("a.tractus"), kSessionFormat);
    EXPECT_EQ(format("a.tractus.bak"), 1);
    EXPECT_EQ(read_session(path("a.tractus")).value().edits.size(), 10u);
    EXPECT_EQ(read_session(path("a.tractus.bak")).value().edits.size(), 8u);
}

TEST_F(SessionTest, CannotBeBegunWhereNothingCanBeWritten)
{
    auto const session = create("nowhere/a.tractus");
    ASSERT_FALSE(session);
    EXPECT_NE(session.error().message.find("No such file or directory"), std::string::npos)
        << session.error().message;
}

TEST_F(SessionTest, MayHaveAnyName)
{
    for (char const* const name :
         { "my plant?.tractus", "Pfl\xc3\xa4nzchen", "\xff\xfe", "a%20#b" }) {
        {
            auto session = create(name).value();
            ASSERT_TRUE(session.append(drawing_step(1)));
        }
        EXPECT_EQ(read_session(path(name)).value().step, 1u);
        EXPECT_TRUE(open(name)) << name;
    }
    EXPECT_EQ(file_count(), 4u);
}

} // namespace
} // namespace tractus
