#include "app/session/session_repair.h"
#include "tests/app/session/small_session.h"

#include <utility>

namespace tractus::session {
namespace {

// Returns the record of an edit of an unknown kind, as from another version of the program with
// more methods.
EditRecord graft()
{
    return { "graft", R"({"on":[3,0.5],"height":1e999})", std::string("\0\x01\xff", 3) };
}

EditRecord select_with_more()
{
    return { "select", R"({"paths":[[0]],"by":"lasso"})", "" };
}

class UnknownEditsTest : public SessionFolder {
protected:
    // Creates a session of three steps. Steps 1 and 3 have only known edits. Step 2 has a known
    // edit and an unknown edit of each kind.
    void SetUp() override
    {
        SessionFolder::SetUp();
        {
            auto session = create().value();
            ASSERT_TRUE(session.append(drawing_step(1)));
        }
        auto const known = record_of(scene::SetGrowth { .parameters = {}, .seed = 77 });
        write_step_of({ graft(), known, select_with_more() });
        auto session = open().value();
        ASSERT_TRUE(session.append(drawing_step(3)));
    }

    void write_step_of(std::vector<EditRecord> const& records) const
    {
        auto const database = Database::open(path(), Database::Access::Write).value();
        std::vector<EditRow> rows;
        for (auto const& record : records) {
            auto& row = rows.emplace_back();
            row.step = 2;
            row.record = record;
            row.place.number = 4 + std::ssize(rows);
            row.place.checksum = checksum_of(row);
        }
        ASSERT_TRUE(write_step(database, rows));
    }

    // Expects the unknown edits 5 and 7 in a file to be unchanged, byte by byte.
    void expect_kept(std::string const& name) const
    {
        auto const database = Database::open(path(name), Database::Access::Read).value();
        for (auto const& [number, record] :
             { std::pair(5, graft()), std::pair(7, select_with_more()) }) {
            auto row = database.prepare("SELECT kind, fields, numbers FROM edits WHERE number = ?")
                           .value();
            row.bind(0, number);
            ASSERT_TRUE(row.step().value()) << number;
            EXPECT_EQ(row.bytes(0), record.kind);
            EXPECT_EQ(row.bytes(1), record.fields);
            EXPECT_EQ(row.bytes(2), record.numbers);
        }
    }
};

TEST_F(UnknownEditsTest, StayAsTheyAreAndNothingOfTheirStepIsDone)
{
    {
        auto session = open().value();
        EXPECT_EQ(session.step(), 3u);
        EXPECT_EQ(session.scene().associations.size(), 2u);
        EXPECT_EQ(session.scene().growth.seed, 1u);
        ASSERT_TRUE(session.append(drawing_step(4)));
        EXPECT_EQ(session.scene().associations.size(), 3u);
    }
    expect_kept("a.tractus");
}

TEST_F(UnknownEditsTest, AreNamed)
{
    auto const session = open().value();
    EXPECT_EQ(session.unknown().count, 2u);
    EXPECT_EQ(session.unknown().sentence(),
              "2 of its edits are unknown to this tractus and stay without effect (the first is "
              "edit 5: its kind \"graft\" is unknown to this tractus: a newer one has written it)");
    EXPECT_EQ(UnknownEdits {}.sentence(), "");
    auto const contents = read_session(path(), scene::core_edit_kinds()).value();
    EXPECT_EQ(contents.edits[4].edit.describe(),
              "does what this tractus does not know (\"graft\"): its kind \"graft\" is unknown to "
              "this tractus: a newer one has written it");
}

// Unknown edits must be counted, too. Later strokes then have the same ids as in programs that know
// all edits.
TEST_F(UnknownEditsTest, AreCountedForTheIdsOfLaterStrokes)
{
    auto const session = open().value();
    EXPECT_EQ(session.scene().associations[0].id, scene::item_id(4, 0));
    EXPECT_EQ(session.scene().associations[1].id, scene::item_id(9, 0)) << "of edit 9 in the file";
    auto const contents = read_session(path(), scene::core_edit_kinds()).value();
    EXPECT_EQ(contents.edits[8].edit.get<scene::Associate>()->id, scene::item_id(9, 0));
}

TEST_F(UnknownEditsTest, UndoAndRedoGoOnAroundThem)
{
    auto session = open().value();
    auto const all = session.scene();
    for (std::size_t const strokes : { 1u, 1u, 0u }) {
        ASSERT_TRUE(session.undo());
        EXPECT_EQ(session.scene().associations.size(), strokes);
    }
    EXPECT_FALSE(session.can_undo());
    for (int i = 0; i < 3; ++i)
        ASSERT_TRUE(session.redo());
    EXPECT_TRUE(same_scene(session.scene(), all));
    expect_kept("a.tractus");
}

TEST_F(UnknownEditsTest, AreRepairedWithTheOthers)
{
    auto const salvaged = salvage_session(path(), scene::core_edit_kinds()).value();
    EXPECT_TRUE(salvaged.missing.empty());
    ASSERT_TRUE(write_repaired(salvaged, {}, path("b.tractus")));
    expect_kept("b.tractus");
    EXPECT_TRUE(same_scene(open("b.tractus")->scene(), open()->scene()));
}

TEST_F(UnknownEditsTest, OfTheBeginningLeaveItsPlant)
{
    auto const database = Database::open(path(), Database::Access::Write).value();
    ASSERT_TRUE(database.execute("UPDATE edits SET kind = 'climate' WHERE number = 2"));
    EditRow row;
    row.record = record_of(beginning()[1]);
    row.record.kind = "climate";
    ASSERT_TRUE(database.execute("UPDATE edits SET checksum = " + std::to_string(checksum_of(row))
                                 + " WHERE number = 2"));
    auto session = open().value();
    EXPECT_EQ(session.unknown().count, 3u);
    EXPECT_EQ(session.scene().associations.size(), 2u);
    // Beginning again includes those edits of the first step that are known.
    auto const again = session.beginning().value();
    EXPECT_EQ(again.size(), 1u);
    ASSERT_TRUE(session.append(again));
    EXPECT_TRUE(session.scene().associations.empty());
}

} // namespace
} // namespace tractus::session
