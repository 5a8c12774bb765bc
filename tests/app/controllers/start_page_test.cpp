#include "app/batch/session_plant.h"
#include "app/controllers/live_window.h"
#include "app/controllers/recent_drawings.h"
#include "app/controllers/start_page_controller.h"
#include "app/methods/all_methods.h"
#include "app/session/begin_empty.h"
#include "drivers/logs/log_writer.h"
#include "engine/base/file.h"
#include "engine/methods/sketch_lsystem/grow_edit.h"
#include "tests/app/simple_rig.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <string>
#include <unistd.h>

namespace tractus::controllers {

namespace {

namespace fs = std::filesystem;
using std::chrono::sys_seconds;

constexpr auto kPost = "/* A bare post: nothing grows on it. */\n"
                       "Lsystem: 1\nderivation length: 1\nAxiom: F(10)F(10)\nA --> A\nendlsystem\n";

} // namespace

class StartPage : public testing::Test {
protected:
    void SetUp() override
    {
        ::setenv("XDG_DATA_HOME", folder_.c_str(), 1);
        fs::create_directories(folder_ / "models");
        ASSERT_TRUE(write_file(folder_ / "models" / "bare_post.l", std::string_view(kPost)));
    }
    void TearDown() override
    {
        ::unsetenv("XDG_DATA_HOME");
        fs::remove_all(folder_);
    }

    StartPageOptions options() const
    {
        return { .kinds = methods::all_methods().edits,
                 .tools = methods::all_methods().tools,
                 .models = { folder_ / "models", folder_ / "missing" },
                 .sessions = sessions(),
                 .pictures = folder_ / "pictures",
                 .now = [] { return sys_seconds(std::chrono::days(20'000)); } };
    }

    // Opens the window with a log as its device, the simple pen, which draws a line away from the
    // user after one second.
    LiveWindow window(bool at_page = true)
    {
        auto const file = folder_ / "pen.tractus-log";
        std::ofstream out(file);
        drivers::LogWriter log(
            out, { .devices = { drivers::simple_pen() }, .rig_text = {}, .start = {} });
        for (int i = 0; i <= 40; ++i)
            log.write_report(0, at_ms(1000 + 5 * i), pen_report(100, 90 - 2 * i, true));
        log.write_report(0, at_ms(1300), pen_report(100, 10, false));
        EXPECT_TRUE(log.flush());
        out.close();
        auto const now = std::make_shared<Timestamp>();
        LiveWindowOptions how { .methods = methods::all_methods(),
                                .height_mm = 100,
                                .scene = at_page ? scene::Scene() : small_scene(),
                                .folder = folder_,
                                .now = [now] { return *now; },
                                .counted_time = now,
                                .start_page = std::make_unique<StartPageController>(options()),
                                .unnamed = unnamed_ };
        if (at_page)
            how.start_page->open({});
        auto devices = devices::LiveDevices::play_log(file.string(), how.now).value();
        return LiveWindow::create(std::move(devices), std::move(how)).value();
    }

    static void pass(LiveWindow& window, int milliseconds)
    {
        for (int i = 0; i < milliseconds / 10; ++i)
            window.advance(std::chrono::milliseconds(10));
        window.settle();
    }

    // Presses the card with the given title.
    static void press(LiveWindow& window, std::string const& title)
    {
        auto* const page = window.start_page();
        ASSERT_NE(page, nullptr);
        auto const& groups = page->state().groups;
        for (std::size_t group = 0; group < groups.size(); ++group)
            for (std::size_t card = 0; card < groups[group].cards.size(); ++card)
                if (groups[group].cards[card].title == title) {
                    page->choose(group, card);
                    return window.settle();
                }
        ADD_FAILURE() << "no card is called " << title;
    }

    fs::path sessions() const { return folder_ / "tractus"; }
    std::vector<fs::path> session_files() const
    {
        std::vector<fs::path> files;
        std::error_code ignored;
        for (auto const& entry : fs::directory_iterator(sessions(), ignored))
            if (batch::is_session_file(entry.path()))
                files.push_back(entry.path());
        return files;
    }

    fs::path const folder_
        = fs::temp_directory_path() / ("tractus_start_page_" + std::to_string(::getpid()));
    std::shared_ptr<fs::path> unnamed_ = std::make_shared<fs::path>();
};

TEST_F(StartPage, OffersEachMethodOnAnEmptySheetAndTheModels)
{
    StartPageController page(options());
    EXPECT_FALSE(page.is_open());
    page.open("Hello.");
    ASSERT_TRUE(page.is_open());
    auto const& state = page.state();
    EXPECT_EQ(state.note, "Hello.");
    ASSERT_EQ(state.groups.size(), 2u) << "nothing was drawn yet";
    std::vector<std::string> sheets;
    for (auto const& card : state.groups[0].cards)
        sheets.push_back(card.title);
    EXPECT_EQ(sheets,
              (std::vector<std::string> { "Along a stroke", "From an outline", "Growth brush",
                                          "From lines", "A leaf" }));
    EXPECT_EQ(state.groups[0].cards[0].key, 'K');
    ASSERT_EQ(state.groups[1].cards.size(), 1u);
    EXPECT_EQ(state.groups[1].cards[0].title, "Bare post");
    EXPECT_EQ(state.groups[1].cards[0].detail, "A bare post");
}

TEST_F(StartPage, BeginsAnEmptySheetWhoseFirstStrokeIsAPlantThatIsKept)
{
    {
        auto window = this->window();
        press(window, "Along a stroke");
        EXPECT_EQ(window.start_page(), nullptr);
        EXPECT_STREQ(window.state().hand.kind().word, "sketch");
        EXPECT_TRUE(window.scene().plants.empty());
        EXPECT_TRUE(window.state().has_session);
        window.perform(view::NextVariation {});
        window.settle();
        EXPECT_NE(window.state().status.find("There is no plant yet"), std::string::npos);
        EXPECT_TRUE(window.scene().plants.empty());
        pass(window, 2000);
        ASSERT_EQ(window.scene().plants.size(), 1u) << window.state().status;
        EXPECT_GT(window.scene().base->segment_count(), 3u);
        ASSERT_TRUE(window.close());
    }
    ASSERT_EQ(session_files().size(), 1u);
    EXPECT_TRUE(session_files()[0].filename().string().starts_with("drawing-"));
    auto const kept
        = session::read_session(session_files()[0], methods::all_methods().edits).value();
    ASSERT_EQ(kept.edits.size(), 2u);
    EXPECT_TRUE(kept.edits[0].edit.get<session::BeginEmpty>());
    EXPECT_TRUE(kept.edits[1].edit.get<sketch::GrowAlongStroke>());
    // A session must start with an empty sheet even if the kind of its first edit is unknown.
    auto const others = methods::all_methods().edits;
    std::vector<scene::EditKind const*> fewer(others.begin(), others.end());
    std::erase(fewer, &session::BeginEmpty::kKind);
    EXPECT_EQ(batch::load_session_scene(session_files()[0], fewer).value().plants.size(), 1u);
}

TEST_F(StartPage, LeadsBackToTheEmptySheetByUndoAndByBeginningAgain)
{
    auto window = this->window();
    press(window, "Along a stroke");
    pass(window, 2000);
    ASSERT_EQ(window.scene().plants.size(), 1u);
    window.perform(view::Undo {});
    window.settle();
    EXPECT_TRUE(window.scene().plants.empty());
    window.perform(view::Redo {});
    window.settle();
    EXPECT_EQ(window.scene().plants.size(), 1u);
    window.perform(view::Restart {});
    window.settle();
    EXPECT_TRUE(window.scene().plants.empty());
}

TEST_F(StartPage, OpensAModelInASessionNamedAfterIt)
{
    auto window = this->window();
    press(window, "Bare post");
    EXPECT_EQ(window.start_page(), nullptr);
    EXPECT_EQ(window.scene().base->segment_count(), 2u);
    EXPECT_EQ(window.state().title, "tractus: bare_post");
    ASSERT_EQ(session_files().size(), 1u);
    EXPECT_EQ(*unnamed_, session_files()[0]);
    EXPECT_TRUE(unnamed_->filename().string().starts_with("bare_post-"));
}

TEST_F(StartPage, ClosesTheDrawingAndSaysWhereItIsKept)
{
    auto window = this->window();
    press(window, "Along a stroke");
    pass(window, 2000);
    auto const before = window.state();
    window.perform(view::OpenStartPage {});
    ASSERT_NE(window.start_page(), nullptr);
    ASSERT_EQ(session_files().size(), 1u);
    auto const file = session_files()[0];
    EXPECT_EQ(window.start_page()->state().note,
              "The drawing is kept as " + file.filename().string());
    EXPECT_TRUE(window.scene().plants.empty());
    EXPECT_TRUE(unnamed_->empty()) << "it is not taken away";
    EXPECT_GT(window.state().plant_revision, before.plant_revision) << "what was shown is gone";
    EXPECT_GT(window.state().skeleton_revision, before.skeleton_revision);
    auto const& recent = window.start_page()->state().groups[1];
    EXPECT_EQ(recent.title, "Recent drawings");
    ASSERT_EQ(recent.cards.size(), 1u);
    press(window, "Drawing");
    EXPECT_EQ(window.start_page(), nullptr);
    EXPECT_EQ(window.scene().plants.size(), 1u);
    EXPECT_EQ(session_files(), std::vector { file }) << "it goes on in the same";
}

TEST_F(StartPage, KeepsNoFileWhereNothingWasDrawn)
{
    auto window = this->window();
    press(window, "Bare post");
    ASSERT_EQ(session_files().size(), 1u);
    window.perform(view::OpenStartPage {});
    ASSERT_NE(window.start_page(), nullptr);
    EXPECT_EQ(window.start_page()->state().note, "");
    EXPECT_TRUE(session_files().empty());
}

TEST_F(StartPage, StaysAndSaysWhyWhatCannotBeOpenedCannot)
{
    ASSERT_TRUE(
        write_file(folder_ / "models" / "broken.l", std::string("Lsystem: 1\nAxiom: F(\n")));
    auto window = this->window();
    press(window, "Broken");
    ASSERT_NE(window.start_page(), nullptr);
    auto const& state = window.start_page()->state();
    EXPECT_FALSE(state.is_opening);
    EXPECT_TRUE(state.note.starts_with("It cannot be opened: ")) << state.note;
    EXPECT_NE(state.note.find("broken.l"), std::string::npos) << state.note;
    EXPECT_TRUE(session_files().empty());
    press(window, "Bare post");
    EXPECT_EQ(window.start_page(), nullptr);
}

TEST_F(StartPage, EndsARecordingWithItsDrawing)
{
    auto window = this->window(false);
    window.perform(view::SetRecording { true });
    ASSERT_TRUE(window.state().recording.is_on);
    window.perform(view::OpenStartPage {});
    EXPECT_FALSE(window.state().recording.is_on);
    EXPECT_EQ(window.start_page()->state().note, "") << "this drawing was in no file";
}

TEST_F(StartPage, ShowsPicturesAndKeepsThoseThatItHasMade)
{
    auto const shown = [&] {
        StartPageController page(options());
        page.open({});
        page.settle();
        page.advance();
        return page.state().groups[1].cards[0].picture;
    };
    auto const made = shown();
    ASSERT_NE(made, nullptr);
    EXPECT_EQ(made->width(), CardPictures::kWidth_px);
    std::vector<fs::path> kept;
    for (auto const& entry : fs::directory_iterator(folder_ / "pictures"))
        kept.push_back(entry.path());
    ASSERT_EQ(kept.size(), 1u);
    // A picture stored in the folder is shown the next time. A picture beside a model is shown from
    // the start.
    auto const write = [](fs::path const& file, render::Image const& picture) {
        ASSERT_TRUE(
            write_file(file, [&](std::ostream& out) { return render::write_png(out, picture); }));
    };
    render::Image const red(20, 10, { 255, 0, 0 });
    write(kept[0], red);
    EXPECT_EQ(*shown(), red);
    render::Image const blue(20, 10, { 0, 0, 255 });
    write(folder_ / "models" / "bare_post.png", blue);
    EXPECT_EQ(*shown(), blue);
}

TEST(RecentDrawings, AreTheNewestFirstAndNamedInWords)
{
    auto const folder
        = fs::temp_directory_path() / ("tractus_recent_" + std::to_string(::getpid()));
    fs::create_directories(folder);
    auto const put = [&](char const* name, int days) {
        std::ofstream(folder / name) << "x";
        auto const time = sys_seconds(std::chrono::days(19'000 + days) + std::chrono::hours(12));
        fs::last_write_time(folder / name, fs::file_time_type::clock::from_sys(time));
    };
    put("shrub-2026-01-09-1403.tractus", 1);
    put("lombardy_poplar-2026-01-09-1403-2.tractus", 3);
    put("mine.tractus", 2);
    put("mine.txt", 4);
    auto const now = sys_seconds(std::chrono::days(19'003) + std::chrono::hours(13));
    auto const recent = recent_drawings(folder, 2, now);
    ASSERT_EQ(recent.size(), 2u);
    EXPECT_EQ(recent[0].name, "Lombardy poplar");
    EXPECT_EQ(recent[1].name, "Mine");
    EXPECT_EQ(recent_drawings(folder, 12, now)[2].name, "Shrub");
    EXPECT_TRUE(recent_drawings(folder / "missing", 12, now).empty());
    fs::remove_all(folder);
}

// The expected times are those that "date -u -d @1774620180" and similar commands print.
TEST(RecentDrawings, SayTheirTimeInWords)
{
    ::setenv("TZ", "UTC", 1);
    ::tzset();
    auto const at = [](std::int64_t seconds) { return sys_seconds(std::chrono::seconds(seconds)); };
    auto const now = at(1774620180); // 2026-03-27 14:03:00 UTC.
    EXPECT_EQ(time_in_words(now, now), "Today, 14:03");
    EXPECT_EQ(time_in_words(at(1774569600), now), "Today, 0:00");
    EXPECT_EQ(time_in_words(at(1774569599), now), "Yesterday, 23:59");
    EXPECT_EQ(time_in_words(at(1772323199), now), "28 February, 23:59");
    EXPECT_EQ(time_in_words(at(1740960000), now), "3 March 2025");
    ::unsetenv("TZ");
    ::tzset();
}

} // namespace tractus::controllers
