#include "app/files/resources.h"
#include "app/io/model_file.h"
#include "app/methods/all_leaves.h"
#include "app/session/session_repair.h"
#include "tests/app/methods/pairs/document_of_all_methods.h"
#include "tests/app/methods/pairs/plant_of_each_method.h"
#include "tests/app/session/small_session.h"

#include <fmt/core.h>
#include <random>

namespace tractus::methods {
namespace {

// Fixture with a session file, whose last step is undone. It tests whether the plants survive
// damage to the file. The parameter is the method with which the plants are made, as an index in
// kMethods, or kGrownLeaves for a model with grown leaves, which make a file of several megabytes.
class DamagedPlant : public session::SessionFolder,
                     public testing::WithParamInterface<std::size_t> {
public:
    static constexpr std::size_t kGrownLeaves = kMethods.size();

protected:
    void SetUp() override
    {
        session::SessionFolder::SetUp();
        if (GetParam() == kGrownLeaves)
            make_grown_leaves();
        else
            make_plants(kMethods[GetParam()]);
        whole_ = read_bytes();
        contents_ = session::read_session(path(), all_methods().edits).value();
    }

    void make_grown_leaves()
    {
        auto session = begin(io::load_model_edit(files::find_model("birch").value()).value());
        auto const leaves
            = foliage_edits(session.scene(), session.scene().state.active, parse_foliage("oak"));
        ASSERT_TRUE(leaves) << leaves.error().message;
        add(session, drawing(0));
        add(session, *leaves);
        for (int i = 1; i < 12; ++i)
            add(session, drawing(i));
        ASSERT_TRUE(session.undo());
    }

    // Makes several plants with a method, and changes each. Each edit is a step.
    void make_plants(MethodOfPair const& method)
    {
        constexpr int kPlants = 5;
        auto session = begin(small_model());
        for (int i = 0; i < kPlants; ++i) {
            Steps steps(session.scene());
            method.make(steps, 40.0 * i);
            steps.add(method.change(steps.active()));
            for (auto const& edit : steps.edits())
                add(session, { edit });
        }
        ASSERT_TRUE(session.undo());
    }

    session::Session begin(scene::Edit const& model)
    {
        std::vector<scene::Edit> const edits { model, scene::SetGrowth {} };
        auto session = session::Session::create(path(), { .plant = "plant", .program = "1.2.3" },
                                                edits, options_for_all_methods());
        EXPECT_TRUE(session) << session.error().message;
        return *std::move(session);
    }

    static std::vector<scene::Edit> drawing(int number)
    {
        std::vector<Vec3> way;
        for (int i = 0; i < 12; ++i)
            way.emplace_back(3.0 * number, 2.0 * i, 20.0 * i);
        return { scene::Select { { { 0, 1, 2 } } }, scene::Associate { stroke_through(way) } };
    }

    // Adds a step to the session, and records the file's length after it.
    void add(session::Session& session, std::vector<scene::Edit> const& edits)
    {
        ASSERT_TRUE(session.append(edits));
        ASSERT_TRUE(session::Database::open(path(), session::Database::Access::Write)
                        .value()
                        .execute("PRAGMA wal_checkpoint(PASSIVE)"));
        lengths_.push_back(std::filesystem::file_size(path()));
    }

    std::optional<session::SessionContents> salvaged(std::string const& bytes) const
    {
        write_bytes("damaged.tractus", bytes);
        auto const session = session::salvage_session(path("damaged.tractus"), all_methods().edits);
        return session ? std::optional(session::contents_of(*session)) : std::nullopt;
    }

    // True if the first `count` edits read from a file are equal to those written.
    bool has_first(session::SessionContents const& contents, std::size_t count) const
    {
        if (contents.edits.size() < count)
            return false;
        for (std::size_t i = 0; i < count; ++i) {
            auto const one = session::record_of(contents.edits[i].edit);
            auto const other = session::record_of(contents_.edits[i].edit);
            if (one.kind != other.kind || one.fields != other.fields || one.numbers != other.numbers
                || contents.edits[i].step != contents_.edits[i].step)
                return false;
        }
        return true;
    }

    std::size_t count_edits_to(std::size_t step) const
    {
        return static_cast<std::size_t>(
            std::count_if(contents_.edits.begin(), contents_.edits.end(),
                          [&](session::SessionEdit const& edit) { return edit.step <= step; }));
    }

    bool gives_the_same_plant(std::string const& bytes) const
    {
        auto const contents = salvaged(bytes);
        return contents && contents->step == contents_.step
            && has_first(*contents, count_edits_to(contents_.step));
    }

    // Returns the share of random damages after which the file still gives the same plant. Each
    // damage overwrites `damage_bytes` bytes, or changes a single bit if that is 0.
    double share_that_comes_back(std::size_t damage_bytes, std::uint32_t seed) const
    {
        // Each trial with grown leaves reads a file of several megabytes.
        int const damages = GetParam() == kGrownLeaves ? 40 : 120;
        std::mt19937 random(seed);
        int same = 0;
        for (int i = 0; i < damages; ++i) {
            auto bytes = whole_;
            auto const place = random() % bytes.size();
            if (damage_bytes == 0)
                bytes[place] ^= static_cast<char>(1U << random() % 8);
            for (auto j = place; j < std::min(place + damage_bytes, bytes.size()); ++j)
                bytes[j] = static_cast<char>(random());
            same += gives_the_same_plant(bytes);
        }
        fmt::print("damages of {} bytes: {} of {} give the same plant\n", damage_bytes, same,
                   damages);
        return double(same) / damages;
    }

    std::string whole_;
    session::SessionContents contents_;
    std::vector<std::uintmax_t> lengths_; // Length of the file after each step, in bytes.
};

TEST_P(DamagedPlant, ComesBackFromAWholeFile)
{
    EXPECT_TRUE(gives_the_same_plant(whole_));
    EXPECT_EQ(contents_.step + 1, contents_.last_step());
}

TEST_P(DamagedPlant, ComesBackAfterOneBit)
{
    EXPECT_GE(share_that_comes_back(0, 1), 0.95);
}

TEST_P(DamagedPlant, ComesBackAfterSixtyFourBytes)
{
    EXPECT_GE(share_that_comes_back(64, 2), 0.9);
}

TEST_P(DamagedPlant, ComesBackAfterFourKibibytes)
{
    EXPECT_GE(share_that_comes_back(4096, 3), 0.8);
}

// If the file is cut off, all steps must survive that were complete when the file had the remaining
// length.
TEST_P(DamagedPlant, ComesBackAsFarAsTheFileIsNotCutOff)
{
    std::mt19937 random(4);
    int const cuts = GetParam() == kGrownLeaves ? 12 : 120;
    for (int i = 0; i < cuts; ++i) {
        auto const cut = lengths_.front() + random() % (whole_.size() - lengths_.front() + 1);
        std::size_t step = 0;
        while (step < lengths_.size() && lengths_[step] <= cut)
            ++step;
        auto const contents = salvaged(whole_.substr(0, cut));
        ASSERT_TRUE(contents) << "cut at " << cut;
        EXPECT_TRUE(has_first(*contents, count_edits_to(step)))
            << "cut at " << cut << " of " << whole_.size() << ", where there were " << step
            << " steps";
    }
}

INSTANTIATE_TEST_SUITE_P(OfMethods, DamagedPlant,
                         testing::Range(std::size_t { 0 }, DamagedPlant::kGrownLeaves + 1));

} // namespace
} // namespace tractus::methods
