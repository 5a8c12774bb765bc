#include "app/session/session.h"

#include "tests/app/session/small_session.h"
#include "tests/engine/scene/edits.h"

#include <cstdlib>

namespace tractus::session {
namespace {

using SessionTest = SessionFolder;

TEST_F(SessionTest, HoldsWhatWasAppended)
{
    auto session = create().value();
    for (int i = 0; i < 3; ++i)
        ASSERT_TRUE(session.append(drawing_step(i)));
    auto const scene = session.scene();
    EXPECT_EQ(scene.associations.size(), 3u);
    // A session can be read while it is open for writing.
    auto const contents = read_session(path(), scene::core_edit_kinds()).value();
    EXPECT_EQ(contents.edits.size(), 8u);
    EXPECT_EQ(contents.step, 3u);
    EXPECT_EQ(contents.origin.plant, "small.l");
    EXPECT_EQ(contents.origin.program, "1.2.3");
}

TEST_F(SessionTest, OpensAsItWasClosed)
{
    scene::Scene scene;
    {
        auto session = create().value();
        for (int i = 0; i < 4; ++i)
            ASSERT_TRUE(session.append(drawing_step(i)));
        ASSERT_TRUE(session.undo());
        scene = session.scene();
    }
    EXPECT_EQ(file_count(), 1u); // No other file is left beside the session.
    auto session = open().value();
    EXPECT_TRUE(same_scene(session.scene(), scene));
    ASSERT_TRUE(session.redo());
    EXPECT_EQ(session.scene().associations.size(), 4u);
}

TEST_F(SessionTest, SaysOnceThatAnEarlierLanguagesPlantsAreDerivedAnew)
{
    ASSERT_TRUE(create());
    EXPECT_FALSE(open().value().is_derived_anew());
    EXPECT_EQ(read_session(path(), scene::core_edit_kinds()).value().origin.language,
              lsystem::kLanguageVersion);
    ASSERT_TRUE(Database::open(path(), Database::Access::Write)
                    .value()
                    .execute("DELETE FROM meta WHERE key = 'language'"));
    EXPECT_EQ(read_session(path(), scene::core_edit_kinds()).value().origin.language, 1);
    EXPECT_TRUE(open().value().is_derived_anew());
    EXPECT_FALSE(open().value().is_derived_anew()) << "it is what it is now";
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
    EXPECT_NEAR(session.scene().associations[1].what.stroke.tips.back().position_mm.x(), 70.7,
                1e-9);
    EXPECT_EQ(read_session(path(), scene::core_edit_kinds()).value().edits.size(), 6u);
}

TEST_F(SessionTest, AStepThatIsRefusedChangesNothing)
{
    auto session = create().value();
    ASSERT_TRUE(session.append(drawing_step(1)));
    EXPECT_FALSE(session.append(
        std::vector<scene::Edit> { scene::Select {}, scene::DeleteIndicator { .number = 9 } }));
    EXPECT_EQ(session.scene().selection.size(), 1u);
    EXPECT_EQ(read_session(path(), scene::core_edit_kinds()).value().edits.size(), 4u);
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
    // Copying the open session's file and journal gives the state that a killed process leaves
    // behind.
    auto session = create().value();
    ASSERT_TRUE(session.append(drawing_step(1)));
    std::filesystem::copy_file(path(), path("b.tractus"));
    std::filesystem::copy_file(path().string() + "-wal", path("b.tractus").string() + "-wal");
    EXPECT_EQ(read_session(path("b.tractus"), scene::core_edit_kinds()).value().edits.size(), 4u);
    EXPECT_EQ(open("b.tractus").value().scene().associations.size(), 1u);
}

TEST_F(SessionTest, OfAnOlderFormatIsBroughtUpToDateAndKeptAsItWas)
{
    struct Older {
        int format;
        char const* statements; // SQL statements that convert a session to the old format.
        std::int64_t made;      // Expected time of the edits; the first format did not contain it.
    };
    for (auto const& [older, statements, made] :
         { Older { 1, kToFormat1, 0 }, Older { 2, kToFormat2, 1'800'000'000 } }) {
        auto const name = "format" + std::to_string(older);
        auto const count_before = file_count();
        {
            auto session = create(name).value();
            for (int i = 0; i < 3; ++i)
                ASSERT_TRUE(session.append(drawing_step(i)));
        }
        ASSERT_TRUE(
            Database::open(path(name), Database::Access::Write).value().execute(statements));
        EXPECT_EQ(read_session(path(name), scene::core_edit_kinds()).value().edits.size(),
                  8u); // Reading must not need to change the file.
        EXPECT_EQ(file_count(), count_before + 1);
        {
            auto session = open(name).value();
            EXPECT_EQ(session.scene().associations.size(), 3u);
            EXPECT_EQ(read_session(path(name), scene::core_edit_kinds())
                          .value()
                          .edits.back()
                          .made.time_since_epoch()
                          .count(),
                      made);
            ASSERT_TRUE(session.append(std::vector<scene::Edit> {
                scene::EraseTips { scene::numbered({ 2 }), { { 0, 3 } } } }));
        }
        EXPECT_EQ(file_count(), count_before + 2);
        auto const format = [&](std::string const& file) {
            return Database::open(path(file), Database::Access::Read)
                .value()
                .whole("PRAGMA user_version")
                .value();
        };
        EXPECT_EQ(format(name), kSessionFormat);
        EXPECT_EQ(format(name + ".bak"), older);
        EXPECT_EQ(read_session(path(name), scene::core_edit_kinds()).value().edits.size(), 9u);
        EXPECT_EQ(read_session(path(name + ".bak"), scene::core_edit_kinds()).value().edits.size(),
                  8u);
    }
}

// Older programs wrote the folders of the author's files. These must be removed.
TEST_F(SessionTest, OfAnOlderFormatLosesTheFoldersOfItsModel)
{
    {
        auto const session = create().value();
    }
    {
        auto const database = Database::open(path(), Database::Access::Write).value();
        auto record = record_of(beginning()[0]);
        record.fields.replace(record.fields.find("small.l"), 7, "/home/anna/models/small.l");
        EditRow row { .place = {}, .step = 0, .record = record };
        auto update = database.prepare("UPDATE edits SET fields = ?, checksum = ? WHERE number = 1")
                          .value();
        ASSERT_TRUE(update.bind_text(0, record.fields).bind(1, checksum_of(row)).run());
        ASSERT_TRUE(database.execute(kToFormat2));
    }
    ASSERT_NE(read_bytes().find("/home/anna"), std::string::npos);
    EXPECT_EQ(read_session(path(), scene::core_edit_kinds())
                  .value()
                  .edits[0]
                  .edit.get<scene::LoadModel>()
                  ->source.name,
              "/home/anna/models/small.l");
    {
        auto const session = open().value();
        EXPECT_EQ(session.scene().model_name, "small.l");
    }
    EXPECT_EQ(read_bytes().find("/home/anna"), std::string::npos);
    EXPECT_NE(read_bytes("a.tractus.bak").find("/home/anna"), std::string::npos);
}

TEST_F(SessionTest, KeepsAStrokeThatIsErasedInPart)
{
    auto const tips = [](Session const& session) {
        return session.scene().associations[0].what.stroke.tips.size();
    };
    std::vector<scene::Edit> const middle { scene::EraseTips { scene::numbered({ 0 }),
                                                               { { 3, 5 } } } };
    std::vector<scene::Edit> const end { scene::EraseTips { scene::numbered({ 0 }),
                                                            { { 6, 7 } } } };
    {
        auto session = create().value();
        ASSERT_TRUE(session.append(drawing_step(1)));
        ASSERT_EQ(tips(session), 11u);
        ASSERT_TRUE(session.append(middle));
        ASSERT_TRUE(session.append(end));
        EXPECT_FALSE(session.append(end)) << "it has no such tips any more";
        ASSERT_TRUE(session.undo());
    }
    auto session = open().value();
    EXPECT_EQ(tips(session), 8u);
    ASSERT_TRUE(session.redo());
    EXPECT_EQ(tips(session), 6u);
    auto edits = beginning();
    for (auto const& step : { drawing_step(1), middle, end })
        edits.insert(edits.end(), step.begin(), step.end());
    EXPECT_TRUE(same_scene(session.scene(), scene::fold(edits).value()));
    for (int i = 0; i < 2; ++i)
        ASSERT_TRUE(session.undo());
    EXPECT_EQ(tips(session), 11u);
}

TEST_F(SessionTest, CannotBeBegunWhereNothingCanBeWritten)
{
    ASSERT_TRUE(create("a.tractus"));
    auto const session = create("a.tractus/b.tractus");
    ASSERT_FALSE(session);
    EXPECT_NE(session.error().message.find("is no folder"), std::string::npos)
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
        EXPECT_EQ(read_session(path(name), scene::core_edit_kinds()).value().step, 1u);
        EXPECT_TRUE(open(name)) << name;
    }
    EXPECT_EQ(file_count(), 4u);
}

} // namespace
} // namespace tractus::session
