#include "app/controllers/choice_page.h"

#include "app/controllers/picture_files.h"
#include "app/document/logged_step.h"
#include "app/methods/pictures/picture_tool.h"
#include "app/session/session.h"
#include "drivers/logs/log.h"
#include "engine/base/file.h"
#include "tests/app/controllers/live_window_devices.h"
#include "tests/app/methods/pictures/small_picture.h"

#include <filesystem>
#include <fmt/core.h>
#include <fstream>
#include <gtest/gtest.h>
#include <unistd.h>

namespace tractus::pictures {
namespace {

namespace fs = std::filesystem;

// Fixture with a temporary folder of pictures.
class Pictures : public testing::Test {
protected:
    Pictures() { fs::create_directories(folder_ / "trip"); }
    ~Pictures() override { fs::remove_all(folder_); }

    fs::path put(fs::path const& name, std::string const& bytes = small_png()) const
    {
        std::ofstream(folder_ / name, std::ios::binary) << bytes;
        return folder_ / name;
    }

    controllers::LiveWindow window(fs::path const& session = {}) const
    {
        auto options = controllers::live_options();
        options.folder = folder_;
        options.picture_folders = { folder_ };
        if (!session.empty())
            options.session = session::Session::open(
                                  session, session::session_by_the_clock(options.methods.edits, {}))
                                  .value();
        return controllers::LiveWindow::create(controllers::drawing_devices(false),
                                               std::move(options))
            .value();
    }

    fs::path const folder_
        = fs::temp_directory_path() / fmt::format("tractus_pictures_{}", ::getpid());
};

TEST_F(Pictures, AreListedTheNewestFirst)
{
    auto const old = put("old.png");
    fs::last_write_time(old, fs::file_time_type::clock::now() - std::chrono::hours(2));
    auto const newer = put("trip/new.JPG");
    fs::last_write_time(newer, fs::file_time_type::clock::now() - std::chrono::hours(1));
    put(".hidden.png");
    put("notes.txt", "no picture");
    EXPECT_EQ(controllers::pictures_in(folder_, 10), (std::vector { newer, old }));
    EXPECT_EQ(controllers::pictures_in(folder_, 1), std::vector { newer });
    EXPECT_TRUE(controllers::pictures_in(folder_ / "nowhere", 10).empty());
}

TEST_F(Pictures, LieBehindWhatIsDrawnWhenTheyAreChosen)
{
    put("oak.png", small_png(300, 100));
    auto window = this->window();
    window.perform(view::OpenPictures {});
    window.settle();
    auto* const page = window.start_page();
    ASSERT_NE(page, nullptr);
    ASSERT_EQ(page->state().groups.size(), 1u);
    ASSERT_EQ(page->state().groups[0].cards.size(), 1u);
    auto const& card = page->state().groups[0].cards[0];
    EXPECT_EQ(card.title, "oak");
    ASSERT_NE(card.picture, nullptr);
    EXPECT_EQ(card.picture->width(), 300);
    EXPECT_TRUE(page->state().is_beside_drawing);
    page->choose(0, 0);
    EXPECT_EQ(window.start_page(), nullptr);
    window.advance({});
    window.settle();
    auto const& state = window.state();
    EXPECT_EQ(state.status, "oak.png lies behind what is drawn");
    ASSERT_TRUE(state.picture);
    EXPECT_EQ(state.picture->image->width(), 300);
    EXPECT_LE(state.picture->place.width_mm, state.surface_size_mm().x());
    EXPECT_EQ(&state.hand.kind(), &PictureTool::kKind) << "the pen places it next";
}

TEST_F(Pictures, AreLeftAsTheyWereWithoutAChoice)
{
    put("oak.png");
    auto window = this->window();
    window.perform(view::OpenPictures {});
    window.start_page()->leave();
    window.advance({});
    window.settle();
    EXPECT_EQ(window.start_page(), nullptr);
    EXPECT_FALSE(window.state().picture);
}

TEST_F(Pictures, WhereThereAreNoneItIsSaidWhereToPutThem)
{
    controllers::ChoicePage page({});
    page.open(controllers::picture_choices({ folder_ }));
    EXPECT_TRUE(page.state().groups.empty());
    EXPECT_NE(page.state().note.find(folder_.string()), std::string::npos);
}

TEST_F(Pictures, ThatCannotBeReadAreRefusedByName)
{
    auto const broken = put("broken.png", small_png().substr(0, 60));
    auto window = this->window();
    window.perform(view::LayPictureFile { broken });
    window.settle();
    EXPECT_NE(window.state().status.find("broken.png"), std::string::npos);
    EXPECT_FALSE(window.state().picture);
    window.perform(view::LayPictureFile { folder_ / "nothing.png" });
    window.settle();
    EXPECT_NE(window.state().status.find("nothing.png"), std::string::npos);
}

// The session contains the picture, so its file is no longer needed.
TEST_F(Pictures, AreKeptInTheSession)
{
    auto const session = folder_ / "drawing.tractus";
    {
        auto options = controllers::live_options();
        auto const kinds = session::session_by_the_clock(options.methods.edits, {});
        session::Session::create(session, {}, std::vector<scene::Edit> { small_model() }, kinds)
            .value();
    }
    auto const oak = put("oak.png", small_png(50, 70));
    {
        auto window = this->window(session);
        window.perform(view::LayPictureFile { oak });
        ASSERT_TRUE(window.close());
    }
    fs::remove(oak);
    auto window = this->window(session);
    window.settle();
    ASSERT_TRUE(window.state().picture);
    EXPECT_EQ(window.state().picture->image->height(), 70);
    for (int i = 0; i < 3; ++i) // Each window's devices have drawn a stroke, which is undone first.
        window.perform(view::Undo {});
    window.settle();
    EXPECT_FALSE(window.state().picture);
    for (int i = 0; i < 3; ++i)
        window.perform(view::Redo {});
    window.settle();
    EXPECT_TRUE(window.state().picture);
}

// A recording must contain the picture, so that its replay shows the picture over which it was
// drawn.
TEST_F(Pictures, AreStepsOfARecording)
{
    auto const png = small_png(50, 70);
    auto const log = folder_ / "evening.tractus-log";
    {
        auto options = controllers::live_options();
        options.folder = folder_;
        options.recording = log;
        options.picture = put("oak.png", png);
        auto window = controllers::LiveWindow::create(controllers::drawing_devices(false),
                                                      std::move(options))
                          .value();
        window.settle();
        ASSERT_TRUE(window.close());
    }
    auto const recorded = drivers::read_log(log).value();
    std::size_t laid = 0;
    for (auto const& line : recorded.tools) {
        auto const step
            = document::parse_step(line.tool, line.arguments, methods::all_methods().edits);
        if (!step || !*step)
            continue;
        for (auto const& edit : (**step).edits)
            if (auto const* const picture = edit.get<scene::LayPicture>()) {
                ++laid;
                EXPECT_EQ(picture->file, png);
            }
    }
    EXPECT_EQ(laid, 1u);
}

} // namespace
} // namespace tractus::pictures
