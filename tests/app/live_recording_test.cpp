#include "app/live_recording.h"

#include "tests/drivers/devices.h"

#include <gtest/gtest.h>
#include <sstream>

namespace tractus {
namespace {

// Reports come from hardware alone; what can be seen without it is how a recording begins and ends.

TEST(LiveRecording, NamesTheDeviceThatIsNotThere)
{
    std::ostringstream out;
    auto device = simple_pen();
    device.location = "/dev/hidraw_of_nobody";
    std::atomic<bool> const stop = false;
    auto const recorded = record_live(out, { device }, {}, stop);
    ASSERT_FALSE(recorded);
    EXPECT_EQ(recorded.error().fault, Fault::User);
    EXPECT_NE(recorded.error().message.find("/dev/hidraw_of_nobody"), std::string::npos);
}

TEST(LiveRecording, EndsWhenNoDeviceIsLeft)
{
    std::ostringstream out;
    std::atomic<bool> const stop = false;
    auto const recorded
        = record_live(out, {}, { .seconds = {}, .rig_text = "version = 1\n" }, stop);
    ASSERT_TRUE(recorded) << recorded.error().message;
    EXPECT_EQ(recorded->reports, 0u);
    EXPECT_NE(out.str().find("C: version = 1\n"), std::string::npos) << out.str();
}

} // namespace
} // namespace tractus
