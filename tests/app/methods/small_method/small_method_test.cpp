#include "app/document/logged_step.h"
#include "app/methods/all_methods.h"
#include "app/session/session.h"
#include "app/session/session_file.h"
#include "app/tools/tool_choices.h"
#include "app/tools/tool_table.h"
#include "app/view/station_view.h"
#include "tests/app/methods/small_method/gust.h"
#include "tests/app/simple_rig.h"

#include <filesystem>
#include <gtest/gtest.h>
#include <string>
#include <unistd.h>

namespace tractus::methods {
namespace {

namespace fs = std::filesystem;

tools::Tool strong_gust()
{
    return GustTool { GustTool::Towards::Start, 2.5 };
}

TEST(SmallMethod, HasALineInLogs)
{
    auto const words = tools::words_for(strong_gust());
    EXPECT_EQ(words.name + " " + words.arguments, "gust towards_start strength=2.5");
    auto const tools = methods_with_gust().tools;
    EXPECT_EQ(tools::parse_tool(tools, words.name, words.arguments).value(), strong_gust());
    EXPECT_EQ(tools::parse_tool(tools, "gust", "").value(), tools::Tool(GustTool {}));
    EXPECT_NE(tools::parse_tool(tools, "gust", "strength=9").error().message.find("from 0.1 to 5"),
              std::string::npos);
    EXPECT_FALSE(tools::parse_tool(all_methods().tools, "gust", ""));
}

TEST(SmallMethod, HasButtonsAKeyAndALineInTheManual)
{
    auto const tools = methods_with_gust().tools;
    auto const choices = tools::tool_choices(tools, {});
    ASSERT_EQ(choices.size(), tools::tool_choices(all_methods().tools, {}).size() + 1);
    EXPECT_EQ(std::string(choices.back().text), "Gust");
    auto const meanings = tools::meanings_of(tools, strong_gust());
    ASSERT_EQ(meanings.size(), 3u);
    EXPECT_TRUE(meanings[1].is_on);
    EXPECT_EQ(meanings[0].tool, tools::Tool(GustTool { GustTool::Towards::End, 2.5 }));
    EXPECT_EQ(meanings[2].text, "strength 2.5##strength");
    EXPECT_EQ(meanings[2].number, 0u);
    EXPECT_NE(
        tools::manual_table(tools).find("| `gust` | `towards_start`; `strength=0.1..5` | **G** | "),
        std::string::npos);
}

class SmallMethodSession : public testing::Test {
protected:
    SmallMethodSession() { fs::create_directories(folder_); }
    ~SmallMethodSession() override { fs::remove_all(folder_); }
    SmallMethodSession(SmallMethodSession const&) = delete;
    SmallMethodSession& operator=(SmallMethodSession const&) = delete;

    session::SessionOptions options() const
    {
        return session::session_by_the_clock(methods_with_gust().edits,
                                             [] { return scene::LoadOptions {}; });
    }
    fs::path path() const { return folder_ / "gust.tractus"; }
    session::Session session() const
    {
        std::vector<scene::Edit> const beginning { small_model() };
        return session::Session::create(path(), { .plant = "small.l", .program = "1" }, beginning,
                                        options())
            .value();
    }
    static station::StationOptions rig()
    {
        station::StationOptions rig;
        rig.scripted_height = calib::ScriptedHeight {
            .scenario = { .kind = calib::HeightScenario::Kind::Constant, .constant_mm = 100 },
            .first_pen = {},
            .last_pen = {},
        };
        rig.tools = methods_with_gust().tools;
        rig.layers = methods_with_gust().layers;
        rig.tool = strong_gust();
        return rig;
    }
    // Draws strokes into a document with the simple pen and the gust tool.
    void draw(document::Document& document) const
    {
        auto station
            = station::Station::create(std::vector { drivers::simple_pen() }, rig()).value();
        draw_across(station, 10);
        station.finish();
        for (auto& stroke : station.take_strokes())
            document.draw(std::move(stroke));
    }

    fs::path const folder_
        = fs::temp_directory_path() / ("tractus_small_method_" + std::to_string(::getpid()));
};

TEST_F(SmallMethodSession, KeepsWhatIsDrawnAndUndone)
{
    variation::MotionIndicator drawn;
    {
        document::Document document(session(), document::Document::Working::AtOnce);
        draw(document);
        auto const done = document.take_finished_strokes();
        ASSERT_EQ(done.size(), 1u);
        EXPECT_EQ(done[0].refusal, "");
        EXPECT_EQ(done[0].edits[0].describe(), "blows a gust of 2.5");
        ASSERT_EQ(document.newest()->scene.indicators.size(), 1u);
        drawn = document.newest()->scene.indicators[0].what;
        EXPECT_LT(drawn.end_mm.x(), drawn.start_mm.x()) << "against the stroke";
        document.undo();
        EXPECT_TRUE(document.newest()->scene.indicators.empty());
        document.redo();
    }
    auto const again = session::Session::open(path(), options()).value();
    EXPECT_EQ(again.unknown().count, 0u);
    ASSERT_EQ(again.scene().indicators.size(), 1u);
    EXPECT_EQ(again.scene().indicators[0].what.end_mm, drawn.end_mm);
}

TEST_F(SmallMethodSession, HasALayerInTheViews)
{
    auto station = station::Station::create(std::vector { drivers::simple_pen() }, rig()).value();
    document::Document document(session(), document::Document::Working::AtOnce);
    view::StationView view(station, document);
    EXPECT_TRUE(view.state().layers.empty()) << "no layer has lines";
    draw(document);
    view.show(station, document);
    auto const& layers = view.state().layers;
    ASSERT_EQ(layers.size(), 2u) << "the indicators' and the gusts'";
    EXPECT_EQ(layers[1].layer, &kGustLayer);
    ASSERT_EQ(layers[1].lines_mm.size(), 1u);
    EXPECT_EQ(layers[1].lines_mm[0].back().z(), 0);
}

// A program that lacks the method must still be able to open the session.
TEST_F(SmallMethodSession, StaysInASessionThatDoesNotKnowIt)
{
    {
        document::Document document(session(), document::Document::Working::AtOnce);
        draw(document);
    }
    auto const contents = session::read_session(path(), all_methods().edits).value();
    ASSERT_EQ(contents.edits.size(), 2u);
    auto const* const unknown = contents.edits[1].edit.get<scene::UnknownEdit>();
    ASSERT_TRUE(unknown);
    EXPECT_EQ(unknown->word, "blow_gust");
    EXPECT_TRUE(session::read_session(path(), methods_with_gust().edits)
                    .value()
                    .edits[1]
                    .edit.get<BlowGust>());
}

TEST_F(SmallMethodSession, HasItsEditsInLogs)
{
    document::StepOutcome const step { .status = std::string(),
                                       .edits
                                       = { BlowGust { Stroke { std::vector<TipSample>(2) }, 3 } } };
    auto const words = document::words_for(step, 4);
    auto const known = document::parse_step(words.name, words.arguments, methods_with_gust().edits);
    ASSERT_TRUE(known && *known);
    ASSERT_TRUE((*known)->edits[0].get<BlowGust>());
    EXPECT_EQ((*known)->edits[0].get<BlowGust>()->strength, 3);
    auto const unknown = document::parse_step(words.name, words.arguments, all_methods().edits);
    ASSERT_TRUE(unknown && *unknown);
    EXPECT_TRUE((*unknown)->edits[0].get<scene::UnknownEdit>());
}

} // namespace
} // namespace tractus::methods
