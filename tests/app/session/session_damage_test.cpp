#include "app/session/session_copy.h"
#include "tests/app/session/small_session.h"
#include "tests/corpus.h"

#include <cstdlib>
#include <random>

namespace tractus::session {
namespace {

// Remedy that an error message offers for a damaged session. The file's name is left out.
std::string const kRemedy = "\"tractus session repair  -o NEW.tractus\" brings back what is whole";

// Fixture for tests of damaged session files. Each file must either be refused with a message or be
// valid.
class SessionDamage : public SessionFolder {
protected:
    void SetUp() override
    {
        SessionFolder::SetUp();
        auto session = create().value();
        for (int i = 0; i < 3; ++i)
            ASSERT_TRUE(session.append(drawing_step(i)));
    }

    // Makes a copy of the session with the given name, and changes it by an SQL statement.
    void change(std::string const& name, std::string const& sql) const
    {
        std::filesystem::copy_file(path(), path(name));
        auto const database = Database::open(path(name), Database::Access::Write).value();
        ASSERT_TRUE(database.execute(sql)) << sql;
    }

    // Returns the error message for a copy of the session that was changed by `sql`. The name of
    // the file is removed from the message.
    std::string refusal_after(std::string const& sql) const
    {
        change("changed", sql);
        auto sentence = refusal("changed");
        std::filesystem::remove(path("changed"));
        auto const name = path("changed").string();
        EXPECT_EQ(sentence.find(name), 0u) << sentence;
        for (auto at = sentence.find(name); at != std::string::npos; at = sentence.find(name))
            sentence.erase(at, name.size());
        return sentence;
    }
};

TEST_F(SessionDamage, WhatIsNoSession)
{
    write_bytes("empty", "");
    write_bytes("text", std::string(5000, 'x'));
    change("other", "PRAGMA application_id = 7");
    for (std::string const name : { "empty", "text", "other" })
        EXPECT_EQ(refusal(name).find(path(name).string() + " is not a session of tractus"), 0u);
    EXPECT_NE(refusal("text").find("tractus session repair"), std::string::npos)
        << "the header may be all that is damaged";
    EXPECT_EQ(refusal("missing"),
              "cannot open " + path("missing").string() + ": there is no such file");
    EXPECT_NE(refusal("."), "");
}

TEST_F(SessionDamage, ASessionOfANewerProgram)
{
    EXPECT_EQ(refusal_after("PRAGMA user_version = 1000"),
              " was written by a newer tractus (format 1000, and this one knows up to "
                  + std::to_string(kSessionFormat) + "): open it with that one");
}

TEST_F(SessionDamage, WhatDoesNotFitTogether)
{
    EXPECT_EQ(refusal_after("DELETE FROM edits WHERE number = 3"),
              " is damaged (edit 3 is missing): " + kRemedy);
    EXPECT_EQ(refusal_after("DELETE FROM edits"), " is damaged (edit 1 is missing): " + kRemedy);
    EXPECT_NE(refusal_after("UPDATE edits SET step = step + 1").find("edit 1 is missing"),
              std::string::npos);
    EXPECT_NE(refusal_after("UPDATE meta SET value = 9 WHERE key = 'step'").find("is damaged"),
              std::string::npos);
    EXPECT_NE(refusal_after("DELETE FROM meta").find("is damaged"), std::string::npos);
    EXPECT_NE(refusal_after("DROP TABLE edits").find("is damaged"), std::string::npos);
    EXPECT_NE(refusal_after("PRAGMA user_version = 0").find("is damaged"), std::string::npos);
}

// A malicious file may have more in its schema than a session. This must be neither executed nor
// read.
TEST_F(SessionDamage, WhatHasMoreInItsSchemaThanASession)
{
    std::string const endless
        = "WITH RECURSIVE n(i) AS (SELECT 1 UNION ALL SELECT i + 1 FROM n) SELECT ";
    for (std::string const& sql : {
             "DROP TABLE edits; CREATE VIEW edits AS " + endless
                 + "i AS number, 0 AS step, '' AS kind, '' AS fields, x'' AS numbers, 0 AS made, "
                   "0 AS checksum FROM n",
             "DROP TABLE meta; CREATE VIEW meta AS " + endless + "'step' AS key, i AS value FROM n",
             std::string("CREATE VIEW other AS SELECT * FROM edits"),
             std::string("CREATE TRIGGER t BEFORE INSERT ON edits BEGIN SELECT RAISE(IGNORE); END"),
             std::string("CREATE TRIGGER t AFTER INSERT ON edits BEGIN DELETE FROM edits WHERE "
                         "number < new.number; END"),
             std::string("CREATE TRIGGER t AFTER UPDATE ON meta BEGIN DELETE FROM edits; END"),
             std::string("CREATE INDEX i ON edits (kind)"),
             std::string("CREATE INDEX i ON edits (number) WHERE abs(step) < 3"),
             std::string("CREATE TABLE edits2 (number)"),
             std::string("ALTER TABLE edits ADD COLUMN more INTEGER"),
             std::string("ALTER TABLE edits ADD COLUMN more AS (length(fields))"),
             std::string("DROP TABLE meta_copies; CREATE TABLE meta_copies (key TEXT PRIMARY KEY, "
                         "value, checksum INTEGER NOT NULL CHECK (checksum < 0))"),
             std::string("ALTER TABLE copies RENAME TO old; CREATE TABLE copies AS SELECT * FROM "
                         "old; DROP TABLE old"),
         })
        EXPECT_EQ(refusal_after(sql).find(" is not as tractus writes sessions: it has a "), 0u)
            << sql;
}

TEST_F(SessionDamage, WhatHasValuesOfOtherTypes)
{
    for (char const* const sql :
         { "UPDATE edits SET numbers = CAST(numbers AS TEXT) WHERE number = 4",
           "UPDATE edits SET fields = CAST(fields AS BLOB) WHERE number = 4",
           "UPDATE edits SET step = '1x' WHERE number = 4",
           "UPDATE edits SET made = 1.5 WHERE number = 4" })
        EXPECT_NE(refusal_after(sql).find("is damaged"), std::string::npos) << sql;
}

// Reading the name of a session must end, even if the table with the name is an endless view.
TEST_F(SessionDamage, AnEndlessNameIsNone)
{
    change("endless",
           "DROP TABLE meta; CREATE VIEW meta AS WITH RECURSIVE n(i) AS (SELECT 1 UNION "
           "ALL SELECT i + 1 FROM n) SELECT 'key' AS key, i AS value FROM n");
    EXPECT_EQ(session_name(path("endless")), "");
}

TEST_F(SessionDamage, AStatementWithoutEndIsGivenUp)
{
    auto const database = Database::open(path(), Database::Access::Read).value();
    auto const counted = database.whole("WITH RECURSIVE n(i) AS (SELECT 1 UNION ALL SELECT i + 1 "
                                        "FROM n) SELECT count(*) FROM n");
    ASSERT_FALSE(counted);
    EXPECT_EQ(counted.error().message,
              path().string() + " cannot be read: it makes SQLite work without end");
    EXPECT_EQ(database.whole("SELECT count(*) FROM edits").value(), 8) << "others go on";
}

TEST_F(SessionDamage, ThatIsCutOff)
{
    auto const whole = read_bytes();
    for (std::size_t part = 1; part < 8; ++part) {
        write_bytes("cut", whole.substr(0, whole.size() * part / 8));
        EXPECT_NE(refusal("cut"), "") << part;
    }
}

TEST_F(SessionDamage, AnEditThatIsNotAsItWasWritten)
{
    for (char const* const sql :
         { "UPDATE edits SET numbers = zeroblob(length(numbers)) WHERE number = 4",
           "UPDATE edits SET fields = replace(fields, '1.0', '0.5') WHERE number = 4",
           "UPDATE edits SET checksum = checksum + 1 WHERE number = 4" })
        EXPECT_EQ(refusal_after(sql), " is damaged (edit 4 is not as it was written): " + kRemedy);
}

// If a damaged file is accepted, it must have all of its edits, unchanged.
TEST_F(SessionDamage, RandomBytesNeverHarm)
{
    auto const whole = read_bytes();
    auto const edits = read_session(path(), scene::core_edit_kinds()).value().edits;
    std::mt19937 random(1);
    int refused = 0;
    // About half of the flipped bits are in redundant copies, which are not read.
    for (int i = 0; i < 800; ++i) {
        auto bytes = whole;
        for (int flips = 1 + i % 3; flips > 0; --flips)
            bytes[random() % bytes.size()] ^= static_cast<char>(1u << (random() % 8));
        write_bytes("flipped", bytes);
        auto const read = read_session(path("flipped"), scene::core_edit_kinds());
        refused += !read;
        EXPECT_EQ(open("flipped").has_value(), read.has_value());
        if (!read)
            continue;
        ASSERT_EQ(read->edits.size(), edits.size());
        for (std::size_t edit = 0; edit < edits.size(); ++edit)
            EXPECT_TRUE(same(read->edits[edit].edit, edits[edit].edit));
    }
    EXPECT_GT(refused, 100);
}

TEST_F(SessionDamage, AFileThatMayNotBeWrittenCanBeRead)
{
    if (::geteuid() == 0)
        GTEST_SKIP() << "root may write everywhere";
    std::filesystem::permissions(path(), std::filesystem::perms::owner_read);
    EXPECT_TRUE(read_session(path(), scene::core_edit_kinds()));
    EXPECT_NE(open().error().message.find("may not be written"), std::string::npos)
        << open().error().message;
}

TEST(SessionCorpus, ASessionThatIsAnEndlessViewIsRefusedAtOnce)
{
    REQUIRE_CORPUS();
    auto const path = corpus() / "faults" / "hang_view.tractus";
    auto const read = read_session(path, scene::core_edit_kinds());
    ASSERT_FALSE(read);
    EXPECT_NE(read.error().message.find("is not as tractus writes sessions"), std::string::npos)
        << read.error().message;
    EXPECT_EQ(session_name(path), "");
}

} // namespace
} // namespace tractus::session
