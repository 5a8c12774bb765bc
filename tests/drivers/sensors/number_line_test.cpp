#include "drivers/sensors/number_line.h"

#include "tests/drivers/heights.h"

#include <gtest/gtest.h>
#include <random>
#include <string>

namespace tractus::drivers {
namespace {

Result<std::vector<HeightSample>> heights_of(std::string const& text,
                                             NumberFormat const& format = {})
{
    auto decoder = make_number_decoder(format);
    return decode_heights(*decoder, timestamp_ns(5), std::as_bytes(std::span(text)));
}

TEST(NumberLine, ReadsWhatBoardsPrint)
{
    for (std::string const text : { "512", " 512 ", "512\r", "+512", "512.2", "height: 512",
                                    "height:512", "d1=512", "raw = 512 counts", "5.12e2" }) {
        auto const samples = heights_of(text);
        ASSERT_TRUE(samples) << samples.error().message;
        ASSERT_EQ(samples->size(), 1u);
        EXPECT_EQ(samples->front().counts, 512) << text;
        EXPECT_EQ(samples->front().full_scale, 4095);
        EXPECT_EQ(samples->front().time, timestamp_ns(5));
    }
}

TEST(NumberLine, RefusesWhatIsNoHeight)
{
    for (std::string const text :
         { "", " ", "hello", "ets Jun  8 2016 00:22:57", "rst:0x1 (POWERON_RESET)", "512,513",
           "512 513", "51 2", "0x200", "nan", "inf", "height:", ":512", "12:34:56", "1e999",
           "\xff\xfe\x80" }) {
        auto const samples = heights_of(text);
        ASSERT_FALSE(samples) << text;
        EXPECT_EQ(samples.error().fault, Fault::Device);
    }
    EXPECT_NE(heights_of("a\x1b[2Jb").error().message.find("\\x1b"), std::string::npos);
}

TEST(NumberLine, KeepsAsManyDecimalsAsTheGreatestNumberHas)
{
    auto const format = parse_greatest_number("max=500.00").value().value();
    EXPECT_EQ(format.full_scale, 50'000);
    EXPECT_EQ(heights_of("23.75 mm", format)->front().counts, 2375);
    EXPECT_EQ(heights_of("23.756", format)->front().counts, 2376);
    EXPECT_EQ(parse_greatest_number("max=1023").value()->full_scale, 1023);
    EXPECT_EQ(parse_greatest_number("9600").value(), std::nullopt);
    for (auto const* const word : { "max=", "max=0", "max=-5", "max=x", "max=1023x", "max=1e3",
                                    "max=0.0000001", "max=3000000000", "max=.", "max=1.2.3" })
        EXPECT_FALSE(parse_greatest_number(word)) << word;
}

TEST(NumberLine, SaysWhereTheGreatestNumberIsTold)
{
    auto const samples = heights_of("20000");
    ASSERT_FALSE(samples);
    EXPECT_NE(samples.error().message.find("@max=65535"), std::string::npos)
        << samples.error().message;
    EXPECT_EQ(heights_of("4095")->front().counts, 4095);
    EXPECT_EQ(heights_of("-3")->front().counts, 0) << "a converter's offset";
    EXPECT_FALSE(heights_of("-300"));
}

TEST(NumberLine, NeverLeavesItsRange)
{
    std::mt19937 random(3);
    std::string const letters = "0123456789.-+e:= abmx\t\r";
    for (int i = 0; i < 20'000; ++i) {
        std::string text;
        for (auto left = random() % 12; left > 0; --left)
            text += letters[random() % letters.size()];
        if (auto const samples = heights_of(text)) {
            ASSERT_EQ(samples->size(), 1u);
            EXPECT_GE(samples->front().counts, 0) << text;
            EXPECT_LE(samples->front().counts, 4095) << text;
        }
    }
}

} // namespace
} // namespace tractus::drivers
