#include "tests/app/controllers/live_window_devices.h"
#include "tests/app/stream/local_reader.h"

#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

namespace tractus::controllers {
namespace {

class LiveWindowSocket : public stream::SocketPlace {
protected:
    LiveWindow window() const
    {
        auto options = live_options();
        options.socket = path_;
        return LiveWindow::create(drawing_devices(false), std::move(options)).value();
    }
};

std::vector<nlohmann::json> lines_of(std::string const& text)
{
    std::vector<nlohmann::json> lines;
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);)
        lines.push_back(nlohmann::json::parse(line));
    return lines;
}

// A program that reads from the socket must receive everything that the document receives.
TEST_F(LiveWindowSocket, TellsWhatIsDrawn)
{
    auto drawing = window();
    stream::LocalReader const reader(path_);
    advance_to_end(drawing);
    ASSERT_TRUE(drawing.close());
    EXPECT_EQ(drawing.document().stroke_count(), 1u);
    auto const lines = lines_of(reader.read_now());
    ASSERT_GE(lines.size(), 3u);
    EXPECT_EQ(lines.front()["type"], "stream");
    EXPECT_EQ(lines.back()["type"], "end");
    auto const count = [&](std::string const& type) {
        return std::count_if(lines.begin(), lines.end(),
                             [&](auto const& line) { return line["type"] == type; });
    };
    EXPECT_EQ(count("tip"), 21) << "one for each report";
    EXPECT_EQ(count("stroke"), 1);
}

// Repeated requests to close must not send data again that was sent before.
TEST_F(LiveWindowSocket, TellsItOnceHoweverOftenItIsAskedToClose)
{
    auto drawing = window();
    stream::LocalReader const reader(path_);
    while (drawing.station().counts().strokes == 0) {
        EXPECT_TRUE(drawing.may_close());
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    advance_to_end(drawing);
    ASSERT_TRUE(drawing.close());
    std::size_t strokes = 0;
    std::set<std::string> times;
    for (auto const& line : lines_of(reader.read_now())) {
        strokes += line["type"] == "stroke";
        if (line["type"] == "tip") {
            EXPECT_TRUE(times.insert(line["time_s"].dump()).second);
        }
    }
    EXPECT_EQ(times.size(), 21u);
    EXPECT_GE(strokes, 1u);
}

TEST_F(LiveWindowSocket, IsRefusedWhereAnotherProgramListens)
{
    auto const first = window();
    auto options = live_options();
    options.socket = path_;
    auto const second = LiveWindow::create(drawing_devices(false), std::move(options));
    ASSERT_FALSE(second);
    EXPECT_NE(second.error().message.find(path_.string()), std::string::npos)
        << second.error().message;
}

} // namespace
} // namespace tractus::controllers
