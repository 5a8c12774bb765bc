#include "app/session/session_repair.h"

#include "tests/app/session/small_session.h"

#include <algorithm>
#include <map>
#include <random>
#include <set>

namespace tractus::session {
namespace {

constexpr std::size_t kPageBytes = 4096;

// Fixture with a session in a single file, without a journal, whose table has interior pages. The
// positions of the edits in the file are found by searching for the bytes of their data.
class SessionRepair : public SessionFolder {
protected:
    void SetUp() override
    {
        SessionFolder::SetUp();
        {
            auto session = create().value();
            for (int i = 0; i < 120; ++i)
                ASSERT_TRUE(session.append(long_step(i)));
        }
        {
            auto const database = Database::open(path(), Database::Access::Write).value();
            ASSERT_TRUE(database.execute("PRAGMA wal_checkpoint(TRUNCATE)"));
            ASSERT_TRUE(database.execute("PRAGMA journal_mode = DELETE"));
            // Removes old copies of rows, so that each edit has a single position in the file.
            ASSERT_TRUE(database.execute("VACUUM"));
        }
        whole_ = read_bytes();
        edits_ = read_session(path(), scene::core_edit_kinds()).value().edits;
        ASSERT_EQ(edits_.size(), 242u);
    }

    // Returns a step with a stroke that is long enough to need several pages of the file.
    static std::vector<scene::Edit> long_step(int number)
    {
        std::vector<TipSample> tips;
        for (int i = 0; i < 60 + number % 50 * 5; ++i)
            tips.push_back({ .time = timestamp_ns(1'000'000'000LL * number + 5'000'000LL * i),
                             .position_mm = { 0.1 * i, 0.37 * number, 1.0 * i },
                             .pressure = 0.5,
                             .touching = true });
        return { scene::Select { { { 0, 1, 2 } } }, scene::Associate { { tips } } };
    }

    // Returns the number of edits that are read back from damaged bytes. Each must be equal to the
    // edit written under the same number.
    std::size_t count_back(std::string const& bytes)
    {
        write_bytes("damaged.tractus", bytes);
        auto const salvaged = salvage_session(path("damaged.tractus"), scene::core_edit_kinds());
        if (!salvaged)
            return 0;
        std::size_t count = 0;
        std::int64_t last = 0;
        for (auto const& row : salvaged->rows) {
            EXPECT_GT(row.place.number, last);
            last = row.place.number;
            auto const edit = edit_of(row.record, scene::core_edit_kinds());
            bool const is_known = edit && last <= std::ssize(edits_)
                && same(*edit, edits_[static_cast<std::size_t>(last) - 1].edit);
            EXPECT_TRUE(is_known) << "edit " << last << " was never made so";
            count += is_known;
        }
        return count;
    }

    // Returns the number of edits that have data in a range of damaged bytes. Only these edits may
    // be lost.
    std::size_t edits_lost_at(std::size_t begin, std::size_t size) const
    {
        std::set<std::int64_t> lost;
        for (auto const& [at, number] : bytes_of_edits())
            if (at.first < begin + size && begin < at.second)
                lost.insert(number);
        return lost.size();
    }

    // Returns the positions of pieces of each edit's numbers in the file, with the number of the
    // edit. The pieces are searched for only once.
    std::multimap<std::pair<std::size_t, std::size_t>, std::int64_t> const& bytes_of_edits() const
    {
        if (!places_.empty())
            return places_;
        constexpr std::size_t kPiece = 41; // Size of a tip, in bytes; its time makes it unique.
        for (auto const& edit : edits_) {
            auto const record = record_of(edit.edit);
            auto const& bytes = record.numbers;
            // Further pieces of the edit are near the last one, unless they are on another page.
            auto last = std::string::npos;
            for (std::size_t at = 0; at + kPiece <= bytes.size(); at += kPiece) {
                auto const piece = std::string_view(bytes).substr(at, kPiece);
                auto const from = last == std::string::npos ? 0 : last;
                auto const length = last == std::string::npos ? whole_.size() : 4 * kPageBytes;
                auto const found = std::string_view(whole_).substr(from, length).find(piece);
                if (found == std::string_view::npos)
                    continue;
                last = from + found;
                places_.emplace(std::pair(last, last + kPiece), edit.place.number);
            }
        }
        return places_;
    }

    // Returns a random position in the file. If `in_structure` is true, it is in the header, the
    // schema or an interior page.
    std::size_t random_place(std::mt19937& random, bool in_structure) const
    {
        if (!in_structure)
            return random() % whole_.size();
        std::vector<std::size_t> pages { 0 };
        for (std::size_t page = 1; page < whole_.size() / kPageBytes; ++page)
            if (whole_[page * kPageBytes] == 0x05 || whole_[page * kPageBytes] == 0x02)
                pages.push_back(page);
        EXPECT_GT(pages.size(), 1u) << "the table has interior pages";
        return pages[random() % pages.size()] * kPageBytes + random() % kPageBytes;
    }

    // Damages the file repeatedly. Of the edits outside the damage, at least half must be restored
    // each time, and at least 95 % on average.
    void expect_repaired(std::size_t damage_bytes, std::uint32_t seed)
    {
        std::mt19937 random(seed);
        double sum = 0;
        constexpr int kDamages = 200;
        for (int i = 0; i < kDamages; ++i) {
            auto bytes = whole_;
            auto const place = random_place(random, i % 2 == 0);
            if (damage_bytes == 0)
                bytes[place] ^= static_cast<char>(1U << random() % 8);
            for (std::size_t j = place; j < std::min(place + damage_bytes, bytes.size()); ++j)
                bytes[j] = static_cast<char>(random());
            auto const intact
                = edits_.size() - edits_lost_at(place, std::max<std::size_t>(damage_bytes, 1));
            double const share
                = static_cast<double>(count_back(bytes)) / static_cast<double>(intact);
            EXPECT_GE(share, 0.5) << "damage " << i << " of seed " << seed << " at " << place;
            sum += std::min(share, 1.0);
        }
        EXPECT_GE(sum / kDamages, 0.95);
        RecordProperty("mean_share_per_million", static_cast<int>(1e6 * sum / kDamages));
    }

    std::string whole_;
    std::vector<SessionEdit> edits_;
    mutable std::multimap<std::pair<std::size_t, std::size_t>, std::int64_t> places_;
};

TEST_F(SessionRepair, FindsEveryEditOfAWholeFile)
{
    EXPECT_EQ(count_back(whole_), edits_.size());
}

TEST_F(SessionRepair, BringsBackWhatOneBitDidNotTouch)
{
    expect_repaired(0, 1);
}

TEST_F(SessionRepair, BringsBackWhatSixtyFourBytesDidNotTouch)
{
    expect_repaired(64, 2);
}

TEST_F(SessionRepair, BringsBackAllBeforeATornTail)
{
    for (std::size_t pages = 3; pages < whole_.size() / kPageBytes; pages += 7) {
        auto const cut = pages * kPageBytes - 100;
        auto const back = count_back(whole_.substr(0, cut));
        // For each edit's number: the position of its last byte in the file.
        std::map<std::int64_t, std::size_t> ends;
        for (auto const& [at, number] : bytes_of_edits())
            ends[number] = std::max(ends[number], at.second);
        auto const before = static_cast<std::size_t>(std::count_if(
            ends.begin(), ends.end(), [&](auto const& end) { return end.second + 64 < cut; }));
        EXPECT_GE(back, before) << "cut at " << cut;
    }
}

TEST_F(SessionRepair, WritesASessionThatOpensAsFarAsItGoes)
{
    auto bytes = whole_;
    bytes.replace(0, 200, 200, 'x'); // Destroys the file's header and schema.
    write_bytes("damaged.tractus", bytes);
    EXPECT_FALSE(read_session(path("damaged.tractus"), scene::core_edit_kinds()));
    auto const salvaged
        = salvage_session(path("damaged.tractus"), scene::core_edit_kinds()).value();
    EXPECT_TRUE(salvaged.missing.empty());
    ASSERT_TRUE(write_repaired(salvaged, {}, path("new.tractus")));
    EXPECT_FALSE(write_repaired(salvaged, {}, path("new.tractus"))) << "never written over";
    auto const session = open("new.tractus");
    ASSERT_TRUE(session) << session.error().message;
    EXPECT_EQ(session->last_step(), 120u);
    EXPECT_EQ(session->scene().associations.size(), 120u);
    EXPECT_EQ(read_bytes("damaged.tractus"), bytes);
}

TEST_F(SessionRepair, LeavesOutWhatWasUndoneAndReplaced)
{
    std::vector<SessionEdit> after;
    {
        auto options = options_for_tests();
        auto session = Session::open(path(), options).value();
        for (int i = 0; i < 20; ++i)
            ASSERT_TRUE(session.undo());
        ASSERT_TRUE(session.append(drawing_step(7)));
    }
    after = read_session(path(), scene::core_edit_kinds()).value().edits;
    auto const salvaged = salvage_session(path(), scene::core_edit_kinds()).value();
    ASSERT_EQ(salvaged.rows.size(), after.size());
    EXPECT_EQ(salvaged.step, 101u);
    for (std::size_t i = 0; i < after.size(); ++i)
        EXPECT_TRUE(
            same(edit_of(salvaged.rows[i].record, scene::core_edit_kinds()).value(), after[i].edit))
            << i;
}

TEST_F(SessionRepair, NamesWhatIsLostAndGoesOnWithoutIt)
{
    auto salvaged = salvage_session(path(), scene::core_edit_kinds()).value();
    salvaged.rows.erase(salvaged.rows.begin() + 10); // Simulates damage to one edit.
    ASSERT_TRUE(write_repaired(salvaged, {}, path("new.tractus")));
    auto const session = open("new.tractus");
    ASSERT_TRUE(session) << session.error().message;
    EXPECT_EQ(session->last_step(), 120u);
}

// If an edit before stroke 20 is lost, a later deletion of stroke 20 must still delete the same
// stroke, even in an older session whose strokes have no ids.
TEST_F(SessionRepair, WhatIsLeftKeepsItsName)
{
    scene::Anchored<variation::Association> erased;
    {
        auto session = open().value();
        erased = session.scene().associations[20];
        ASSERT_TRUE(session.append(
            std::vector<scene::Edit> { scene::DeleteStroke { { .ids = { erased.id } } } }));
    }
    auto salvaged = salvage_session(path(), scene::core_edit_kinds()).value();
    for (auto& row : salvaged.rows)
        if (auto const edit = edit_of(row.record, scene::core_edit_kinds()).value();
            auto const* const drawn = edit.get<scene::Associate>()) {
            auto without_id = *drawn;
            without_id.id = 0;
            row.record = record_of(without_id);
        }
    salvaged.rows.erase(salvaged.rows.begin() + 10, salvaged.rows.begin() + 12);
    ASSERT_TRUE(write_repaired(salvaged, {}, path("new.tractus")));
    auto const session = open("new.tractus").value();
    EXPECT_EQ(session.scene().associations.size(), 118u);
    for (auto const& [id, association, at] : session.scene().associations)
        EXPECT_NE(association.stroke.tips.front().time, erased.what.stroke.tips.front().time);
}

TEST_F(SessionRepair, TakesAnotherPlantInThePlaceOfALostOne)
{
    auto salvaged = salvage_session(path(), scene::core_edit_kinds()).value();
    salvaged.rows.erase(salvaged.rows.begin()); // Removes the edit that adds the plant.
    ASSERT_TRUE(write_repaired(salvaged, { small_model() }, path("new.tractus")));
    auto const session = open("new.tractus");
    ASSERT_TRUE(session) << session.error().message;
    EXPECT_EQ(session->scene().associations.size(), 120u);

    ASSERT_TRUE(write_repaired(salvaged, {}, path("bare.tractus")));
    auto const bare = open("bare.tractus");
    ASSERT_TRUE(bare) << bare.error().message;
    EXPECT_EQ(bare->scene().associations.size(), 0u);
    EXPECT_EQ(read_session(path("bare.tractus"), scene::core_edit_kinds()).value().edits.size(),
              241u)
        << "nothing is thrown away";
}

TEST_F(SessionRepair, AStrokeThatCannotBeReadIsReadAgain)
{
    SharedVector<TipSample> tips;
    {
        auto const session = open().value();
        tips = session.scene().associations[0].what.stroke.tips.parked();
    }
    std::filesystem::rename(path(), path("away.tractus"));
    auto const failed = tips.in_memory();
    ASSERT_FALSE(failed);
    EXPECT_NE(failed.error().message.find(path().string()), std::string::npos)
        << failed.error().message;
    EXPECT_NE(failed.error().message.find("edit 4"), std::string::npos) << failed.error().message;
    std::filesystem::rename(path("away.tractus"), path());
    EXPECT_EQ(tips.in_memory().value().size(), 60u);
}

TEST_F(SessionRepair, WhatIsNoSession)
{
    write_bytes("text.tractus", std::string(5000, 'x'));
    auto const salvaged = salvage_session(path("text.tractus"), scene::core_edit_kinds());
    ASSERT_FALSE(salvaged);
    EXPECT_NE(salvaged.error().message.find("no edit of a session can be found in it"),
              std::string::npos);
    EXPECT_FALSE(salvage_session(path("missing.tractus"), scene::core_edit_kinds()));
}

} // namespace
} // namespace tractus::session
