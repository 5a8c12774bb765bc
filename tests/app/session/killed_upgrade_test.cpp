#include "app/document/model_cost.h"
#include "app/methods/all_methods.h"
#include "app/session/session.h"
#include "app/session/session_schema.h"
#include "tests/app/session/killed_child.h"
#include "tests/file_bytes.h"

#include <filesystem>
#include <fmt/core.h>
#include <fstream>
#include <gtest/gtest.h>
#include <random>
#include <string>
#include <vector>

namespace tractus::session {
namespace {

namespace fs = std::filesystem;

// Fixture for killing the program while it brings a session of an older format up to date. The
// parameter is the format.
class KilledUpgrade : public testing::TestWithParam<int> {
protected:
    void SetUp() override
    {
        fs::remove_all(folder_);
        fs::create_directories(folder_);
        begin_anew();
        before_ = records(path());
        ASSERT_FALSE(before_.empty());
    }

    void TearDown() override { fs::remove_all(folder_); }

    fs::path path() const { return folder_ / "a.tractus"; }
    fs::path backup() const { return folder_ / "a.tractus.bak"; }

    // Leaves nothing in the folder but the session as the older program wrote it.
    void begin_anew() const
    {
        for (auto const& entry : fs::directory_iterator(folder_))
            fs::remove(entry.path());
        std::ofstream(path(), std::ios::binary)
            << file_bytes(fs::path(TRACTUS_FIXTURES) / fmt::format("format{}.tractus", GetParam()));
    }

    // Returns the session's edits, one text each, or an empty list if it cannot be read.
    static std::vector<std::string> records(fs::path const& path)
    {
        auto const contents = read_session(path, methods::all_methods().edits);
        EXPECT_TRUE(contents) << contents.error().message;
        std::vector<std::string> texts;
        for (auto const& edit : contents ? contents->edits : std::vector<SessionEdit> {}) {
            auto const record = record_of(edit.edit);
            texts.push_back(
                fmt::format("{} {} {} {}", edit.step, record.kind, record.fields, record.numbers));
        }
        if (contents)
            texts.push_back(fmt::format("step {}", contents->step));
        return texts;
    }

    static std::int64_t format_of(fs::path const& path)
    {
        return open_session(path, Database::Access::Read)
            .value()
            .whole("PRAGMA user_version")
            .value();
    }

    // Opens the session to go on with it, which brings it up to date. Reports whether it did.
    void open(Say const& say) const
    {
        auto const session
            = Session::open(path(), session_by_the_clock(methods::all_methods().edits, [] {
                                return document::load_options();
                            }));
        say(session.has_value());
    }

    // Returns how long bringing it up to date takes, without what opening does besides.
    std::chrono::microseconds upgrade_time() const
    {
        using std::chrono::duration_cast, std::chrono::microseconds;
        auto const upgrade = [&](Say const& say) {
            auto const begin = std::chrono::steady_clock::now();
            auto const database = open_session(path(), Database::Access::Write).value();
            bool const is_done = database.execute("BEGIN IMMEDIATE") && migrate(database, path())
                && database.execute("COMMIT");
            auto const time = std::chrono::steady_clock::now() - begin;
            say(is_done ? static_cast<int>(duration_cast<microseconds>(time).count()) : -1);
        };
        auto const took = last_said(upgrade, kForever);
        EXPECT_GT(took, 0);
        return microseconds(took);
    }

    // The older session, or the new one with the older one beside it; both have all edits.
    void expect_one_of_both() const
    {
        auto const format = format_of(path());
        EXPECT_TRUE(format == GetParam() || format == kSessionFormat) << format;
        EXPECT_EQ(records(path()), before_);
        if (format == kSessionFormat)
            EXPECT_TRUE(fs::exists(backup()));
        expect_backup_as_it_was();
    }

    void expect_backup_as_it_was() const
    {
        if (!fs::exists(backup()))
            return;
        EXPECT_EQ(format_of(backup()), GetParam());
        EXPECT_EQ(records(backup()), before_);
    }

    void expect_opens_as_if_nothing_had_happened() const
    {
        EXPECT_EQ(last_said([&](Say const& say) { open(say); }, kForever), 1);
        EXPECT_EQ(format_of(path()), kSessionFormat);
        EXPECT_EQ(records(path()), before_);
        EXPECT_TRUE(fs::exists(backup()));
        expect_backup_as_it_was();
        auto const files = fs::directory_iterator(folder_);
        EXPECT_EQ(std::distance(begin(files), end(files)), 2) << "temporary files are left";
    }

private:
    fs::path folder_ = fs::temp_directory_path() / fmt::format("tractus_upgrade_{}", ::getpid());
    std::vector<std::string> before_; // The edits as the older program wrote them.
};

TEST_P(KilledUpgrade, LeavesTheOlderSessionOrTheNewOne)
{
    auto const took = upgrade_time();
    std::mt19937_64 random(static_cast<std::uint64_t>(GetParam()));
    int upgraded = 0;
    constexpr int kKills = 50;
    for (int i = 0; i < kKills; ++i) {
        begin_anew();
        // The machine may be slower than it was when the time was taken.
        auto const life = random() % static_cast<std::uint64_t>(2 * took.count());
        last_said([&](Say const& say) { open(say); }, std::chrono::microseconds(life));
        SCOPED_TRACE(fmt::format("format {}, killed after {} us", GetParam(), life));
        upgraded += format_of(path()) == kSessionFormat;
        expect_one_of_both();
        expect_opens_as_if_nothing_had_happened();
        if (HasFailure())
            break;
    }
    RecordProperty("upgraded_when_killed", upgraded);
}

INSTANTIATE_TEST_SUITE_P(OfFormats, KilledUpgrade, testing::Range(1, 5));

} // namespace
} // namespace tractus::session
