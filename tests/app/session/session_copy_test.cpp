#include "app/session/session_copy.h"
#include "tests/app/session/small_session.h"

namespace tractus::session {
namespace {

using SessionCopy = SessionFolder;

TEST_F(SessionCopy, HasANameUntilItGetsAnother)
{
    {
        auto session = create().value();
        EXPECT_EQ(session.name(), "");
        EXPECT_EQ(session_name(path()), "");
        ASSERT_TRUE(session.append(drawing_step(1)));
        ASSERT_TRUE(session.set_name("Ash by the gate"));
        EXPECT_EQ(session_name(path()), "Ash by the gate") << "while it is being drawn in";
        EXPECT_EQ(session.step(), 1u) << "a name is no step";
    }
    auto session = open().value();
    EXPECT_EQ(session.name(), "Ash by the gate");
    ASSERT_TRUE(session.undo());
    ASSERT_TRUE(session.set_name(""));
    EXPECT_EQ(session_name(path()), "");
    EXPECT_EQ(session_name(path("missing.tractus")), "");
}

TEST_F(SessionCopy, ASessionInMemoryHasNoPlaceForAName)
{
    auto session = Session::in_memory(create().value().scene(), options_for_tests());
    EXPECT_NE(session.set_name("Ash").error().message.find("memory alone"), std::string::npos);
}

// Returns the result of SQLite's PRAGMA integrity_check on a session file.
std::string integrity(std::filesystem::path const& path)
{
    auto const database = Database::open(path, Database::Access::Read).value();
    auto check = database.prepare("PRAGMA integrity_check").value();
    EXPECT_TRUE(check.step().value());
    return check.bytes(0);
}

TEST_F(SessionCopy, CopiesWhatIsDrawnSoFar)
{
    auto session = create().value();
    for (int i = 0; i < 3; ++i)
        ASSERT_TRUE(session.append(drawing_step(i)));
    ASSERT_TRUE(session.undo());
    ASSERT_TRUE(copy_session(path(), path("copy.tractus"), "A copy"));
    EXPECT_EQ(integrity(path("copy.tractus")), "ok");
    ASSERT_TRUE(session.append(drawing_step(7)));
    auto copy = open("copy.tractus").value();
    EXPECT_EQ(copy.name(), "A copy");
    EXPECT_EQ(copy.step(), 2u);
    EXPECT_EQ(copy.last_step(), 3u) << "what was undone can be done again";
    ASSERT_TRUE(copy.redo());
    EXPECT_EQ(copy.scene().associations.size(), 3u);
    EXPECT_EQ(session_name(path()), "") << "the original keeps its own";
    EXPECT_EQ(session.scene().associations.size(), 3u) << "and goes on by itself";
}

TEST_F(SessionCopy, NeverWritesOverAFile)
{
    ASSERT_TRUE(create());
    ASSERT_TRUE(create("other.tractus"));
    auto const before = file_bytes(path("other.tractus"));
    auto const copied = copy_session(path(), path("other.tractus"), "A copy");
    ASSERT_FALSE(copied);
    EXPECT_NE(copied.error().message.find("already there"), std::string::npos);
    EXPECT_EQ(file_bytes(path("other.tractus")), before);
    auto const missing = copy_session(path("missing.tractus"), path("new.tractus"), "A copy");
    ASSERT_FALSE(missing);
    EXPECT_FALSE(std::filesystem::exists(path("new.tractus")));
    EXPECT_EQ(file_count(), 2u) << "nothing is left of it";
}

} // namespace
} // namespace tractus::session
