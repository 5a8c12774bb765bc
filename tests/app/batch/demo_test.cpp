#include "app/files/resources.h"
#include "app/io/model_file.h"
#include "app/methods/all_methods.h"
#include "app/play/simulated_recording.h"
#include "engine/base/file.h"
#include "engine/plant/join_axes.h"
#include "tests/app/our_plant.h"
#include "tests/app/replayed.h"

#include <fmt/core.h>
#include <gtest/gtest.h>
#include <sstream>

namespace tractus::batch {
namespace {

// Fixture for the demos, one for each plant: a script of the hand's gestures, and the recording
// made from the script.
class Demo : public ::testing::TestWithParam<char const*> {
protected:
    scene::Scene scene() const { return our_plant(GetParam()); }
    std::filesystem::path file(char const* kind) const
    {
        return files::find_resource(fmt::format("demo/{}.{}", GetParam(), kind)).value();
    }
    sim::GestureScript script() const
    {
        auto const path = file("hand.toml");
        return sim::parse_gesture_script(read_file(path).value(), path.string()).value();
    }
};

TEST_P(Demo, IsRecordedFromItsScriptByteForByte)
{
    std::ostringstream out;
    auto const written
        = play::write_simulated_recording(out, script(), scene(), methods::all_methods().tools);
    ASSERT_TRUE(written) << written.error().message;
    // EXPECT_TRUE, because a failing EXPECT_EQ would print some half a megabyte.
    EXPECT_TRUE(out.str() == read_file(file("tractus-log")).value())
        << "record it again: tractus record --simulate app/demo/" << GetParam() << ".hand.toml";
}

TEST_P(Demo, SelectsTheBranchesThatItsScriptTraces)
{
    auto const log = drivers::read_log(file("tractus-log")).value();
    auto const [counts, scene, strokes] = replayed(log, {}, this->scene());
    auto const order = axes_in_drawing_order(*scene.base);
    std::size_t association = 0;
    AxisId traced = 0;
    for (auto const& gesture : script().gestures) {
        if (auto const* trace = std::get_if<sim::AxisTrace>(&gesture.path))
            traced = order[trace->rank];
        if (gesture.tool != "draw")
            continue;
        ASSERT_LT(association, scene.associations.size());
        auto const& path = scene.associations[association++].what.path;
        EXPECT_EQ(axis_of(*scene.base, path.front()), traced);
        EXPECT_EQ(axis_of(*scene.base, path.back()), traced);
        // The stroke follows the whole axis; it may miss one segment at either end.
        EXPECT_GE(path.size() + 2, scene.base->axes[traced].segment_count);
    }
    EXPECT_EQ(association, scene.associations.size());
    EXPECT_EQ(scene.indicators.size(), 1u);
    for (auto const& drawn : strokes)
        EXPECT_EQ(drawn.refusal, "");
}

INSTANTIATE_TEST_SUITE_P(All, Demo, ::testing::Values("broadleaf", "conifer", "daisy", "shrub"),
                         [](auto const& test) { return std::string(test.param); });

} // namespace
} // namespace tractus::batch
