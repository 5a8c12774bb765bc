#include "app/plants/drawing.h"
#include "app/plants/session_plant.h"
#include "tests/app/simulated_drawing.h"

#include <chrono>
#include <csignal>
#include <filesystem>
#include <fmt/core.h>
#include <fstream>
#include <functional>
#include <gtest/gtest.h>
#include <random>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

namespace tractus {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

// What a child said before its end: numbers, the last of which counts.
using Say = std::function<void(int)>;

// Runs `work` in a program of its own, which is killed after so long; answers the last number that
// it has said, -1 for none. This program itself derives no plant and so has no threads, which a
// child would miss.
int last_said(std::function<void(Say const&)> const& work, std::chrono::microseconds life)
{
    int ends[2];
    if (::pipe(ends) != 0)
        return -2;
    auto const child = ::fork();
    if (child == 0) {
        ::close(ends[0]);
        work([&](int number) { (void)!::write(ends[1], &number, sizeof number); });
        ::_exit(0);
    }
    ::close(ends[1]);
    auto const end = Clock::now() + life;
    while (Clock::now() < end && ::waitpid(child, nullptr, WNOHANG) == 0)
        std::this_thread::sleep_for(
            std::min<Clock::duration>(std::chrono::microseconds(200), end - Clock::now()));
    ::kill(child, SIGKILL);
    ::waitpid(child, nullptr, 0);
    int last = -1;
    while (::read(ends[0], &last, sizeof last) == sizeof last) { }
    ::close(ends[0]);
    return last;
}

constexpr int kStrokes = 24;

// The trunk is selected; then strokes shape it, and directions lean the plant.
std::string many_strokes()
{
    std::string script = "version = 1\nseed = 3\n"
                         "[[gesture]]\ntool = \"select\"\ntrace = \"axis\"\naxis = 0\n";
    for (int i = 1; i < kStrokes; ++i)
        script += fmt::format("[[gesture]]\ntool = {}\npath = \"line\"\n"
                              "from_mm = [{}, 0, 50]\nto_mm = [40, {}, 120]\n",
                              i % 4 == 3 ? "\"indicate\"" : "\"draw\"\npropagation = \"both\"", i,
                              i + 3);
    return script;
}

// A hand draws a recording into a session and is killed, again and again.
class KilledDrawing : public testing::Test {
protected:
    static constexpr std::chrono::seconds kForever { 60 };

    void SetUp() override
    {
        fs::remove_all(folder_);
        fs::create_directories(folder_);
        auto const write_log = [&](Say const& say) {
            auto const text = recorded(many_strokes());
            std::ofstream(log(), std::ios::binary) << (text ? *text : text.error().message);
            std::ofstream(folder_ / "small.l") << small_model().source.text;
            say(text.has_value());
        };
        ASSERT_EQ(last_said(write_log, kForever), 1);
    }

    void TearDown() override { fs::remove_all(folder_); }

    // Says how many strokes are kept as soon as each is.
    void draw_into(fs::path const& path, Say const& say) const
    {
        auto const edits = growing_plant_edits(folder_ / "small.l", {}, 1).value();
        auto session = begin_session(path, edits).value();
        int kept = 0;
        say(kept);
        DrawingOptions options;
        options.log = log();
        options.on_stroke = [&](DrawnStroke const& drawn) -> Result<void> {
            TRY(session.append(drawn.edits));
            say(++kept);
            return {};
        };
        Progress progress;
        DrawingReport report;
        (void)read_drawing(options, session.scene(), progress, report);
    }

    // Opens it as somebody does who goes on drawing, and says how many strokes are there: that
    // which selects, and those that shape the trunk or lean the plant.
    static void open_and_count(fs::path const& path, Say const& say)
    {
        auto session = Session::open(path, session_by_the_clock([] { return LoadOptions {}; }));
        if (!session)
            return;
        auto const& scene = session->scene();
        auto const drawn = scene.associations.size() + scene.indicators.size();
        auto const steps = session->step();
        if (drawn + scene.selection.size() == steps
            && session->append(std::vector<Edit> { Select {} }))
            say(static_cast<int>(steps));
    }

    fs::path log() const { return folder_ / "hand.tractus-log"; }
    fs::path session() const { return folder_ / "drawn.tractus"; }

    void remove_session() const
    {
        for (auto const& entry : fs::directory_iterator(folder_))
            if (entry.path().string().find(".tractus") != std::string::npos
                && entry.path() != log())
                fs::remove(entry.path());
    }

private:
    fs::path folder_ = fs::temp_directory_path() / fmt::format("tractus_killed_{}", ::getpid());
};

TEST_F(KilledDrawing, LosesNoFinishedStrokeAndOpensAgain)
{
    auto const draw = [&](Say const& say) { draw_into(session(), say); };
    auto const begin = Clock::now();
    ASSERT_EQ(last_said(draw, kForever), kStrokes);
    auto const whole_us
        = std::chrono::duration_cast<std::chrono::microseconds>(Clock::now() - begin).count();

    std::mt19937_64 random(7);
    int in_the_middle = 0;
    for (int i = 0; i < 100; ++i) {
        remove_session();
        auto const kept = last_said(
            draw, std::chrono::microseconds(random() % static_cast<std::uint64_t>(whole_us)));
        SCOPED_TRACE(fmt::format("{} strokes were kept when it was killed", kept));
        if (kept < 0 && !fs::exists(session()))
            continue; // It had not begun, and left nothing half under that name.
        auto const contents = read_session(session());
        ASSERT_TRUE(contents) << contents.error().message;
        // One more may have come to the disk than there was time to say.
        auto const steps = static_cast<int>(contents->step);
        EXPECT_TRUE(steps == kept || steps == kept + 1) << steps;
        EXPECT_EQ(contents->last_step(), contents->step);
        auto const count = [&](Say const& say) { open_and_count(session(), say); };
        EXPECT_EQ(last_said(count, kForever), steps);
        in_the_middle += kept > 0 && kept < kStrokes;
    }
    RecordProperty("killed_while_drawing", in_the_middle);
}

} // namespace
} // namespace tractus
