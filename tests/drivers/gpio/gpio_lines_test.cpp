#include "drivers/gpio/gpio_lines.h"

#include "drivers/gpio/gpio_errors.h"

#include <cerrno>
#include <gtest/gtest.h>

namespace tractus::drivers {
namespace {

TEST(GpioLines, SaysThatThereIsNoSuchChip)
{
    auto const lines = open_gpio_lines("no such chip", std::vector<GpioLine>(1));
    ASSERT_FALSE(lines);
    EXPECT_EQ(lines.error().fault, Fault::User);
    EXPECT_EQ(lines.error().message,
              "there is no GPIO chip named or labelled no such chip: \"gpiodetect\" lists those "
              "that there are");
}

TEST(GpioLines, KnowsItsLibrarysVersion)
{
    EXPECT_TRUE(gpio_library_version().starts_with("1.6")
                || gpio_library_version().starts_with("2."))
        << gpio_library_version();
}

TEST(GpioLines, ExplainsWhatKeepsLinesFromBeingTaken)
{
    GpioLine const lines[] { { .offset = 11 }, { .offset = 10 } };
    EXPECT_EQ(
        cannot_take_gpio_lines("gpiochip0", lines, EBUSY).value().message,
        "cannot take the lines 11,10 of the GPIO chip gpiochip0: one of them is in use; "
        "\"gpioinfo\" says by whom (SPI switched on for the same pins, or the station running "
        "twice?)");
    EXPECT_EQ(cannot_take_gpio_lines("gpiochip0", lines, EINVAL).value().message,
              "cannot take the lines 11,10 of the GPIO chip gpiochip0: the chip does not have them "
              "all, or one is named twice");
    EXPECT_EQ(
        cannot_open_gpio_chip("gpiochip0", EACCES).value().message,
        "cannot open the GPIO chip gpiochip0: permission denied (be in the group gpio, or see "
        "what drivers/70-tractus.rules says of GPIO)");
    EXPECT_EQ(lost_gpio_lines("gpiochip0", ENODEV).value().fault, Fault::Device);
}

} // namespace
} // namespace tractus::drivers
