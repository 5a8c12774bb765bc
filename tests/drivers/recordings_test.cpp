// Decodes every recording of a real pen with the decoder of its device. The result must agree with
// what the tablet's maker publishes, and with what a hand can do.

#include "calib/fuser.h"
#include "drivers/logs/log.h"
#include "drivers/tablets/pen_decoders.h"
#include "tests/corpus.h"
#include "tests/drivers/decode_one.h"

#include <algorithm>
#include <filesystem>
#include <gtest/gtest.h>
#include <string>
#include <string_view>
#include <vector>

namespace tractus::drivers {
namespace {

// Known facts about the recordings whose file names begin with `file`.
struct Published {
    std::string_view file;
    Vec2 size_mm = Vec2::Zero();
    // Greatest counts in the recording, if somebody drew around the edges; otherwise 0.
    std::int32_t reached_x = 0;
    std::int32_t reached_y = 0;
    std::int32_t reached_pressure = 0;
};

Published const kPublished[] = {
    { .file = "Huion_H610__", .size_mm = { 254, 158.75 } },
    { .file = "Huion_HS610__dumps__enabled__pen_coords",
      .size_mm = { 254, 158.75 },
      .reached_x = 50'800,
      .reached_y = 31'750 },
    { .file = "Huion_HS610__dumps__enabled__pen_pressure",
      .size_mm = { 254, 158.75 },
      .reached_pressure = 8191 },
    { .file = "Huion_HS610__dumps__default__pen_coords",
      .size_mm = { 254, 158.75 },
      .reached_x = 32'767,
      .reached_y = 32'767,
      .reached_pressure = 8191 },
    { .file = "Huion_HS610__", .size_mm = { 254, 158.75 } },
    { .file = "Huion_New_1060_Plus__dumps__pen_coords",
      .size_mm = { 254, 158.75 },
      .reached_x = 50'800,
      .reached_y = 31'750,
      .reached_pressure = 8191 },
    { .file = "Huion_New_1060_Plus__", .size_mm = { 254, 158.75 } },
    { .file = "Ugee_M708_v2__dumps__pen_pressure",
      .size_mm = { 254, 152.4 },
      .reached_pressure = 8191 },
    { .file = "Ugee_M708_v2__", .size_mm = { 254, 152.4 } },
    { .file = "VEIKK_A30__", .size_mm = { 254, 152.4 } },
    { .file = "XP-Pen_Artist_16_Pro__dumps__pen_pressure",
      .size_mm = { 344.16, 193.59 },
      .reached_pressure = 8191 },
    { .file = "XP-Pen_Artist_16_Pro__", .size_mm = { 344.16, 193.59 } },
    { .file = "XP-Pen_Deco_01__dumps__pen_coords",
      .size_mm = { 254, 158.75 },
      .reached_x = 25'400,
      .reached_y = 15'875 },
    { .file = "XP-Pen_Deco_01__", .size_mm = { 254, 158.75 } },
    { .file = "Wacom_BambooFun_4x5", .size_mm = { 147.6, 92.25 } },
    { .file = "Wacom_Bamboo_056a", .size_mm = { 147.6, 92.25 }, .reached_pressure = 511 },
    { .file = "Wacom_Bamboo_Pen",
      .size_mm = { 147.2, 92 },
      .reached_x = 14'720,
      .reached_y = 9200 },
    { .file = "Wacom_DTU2231", .size_mm = { 478.6, 270.1 }, .reached_pressure = 511 },
    { .file = "Wacom_Graphire3", .size_mm = { 127.6, 92.8 } },
    { .file = "Wacom_Intuos3_6x8", .size_mm = { 203.2, 152.4 } },
    { .file = "Wacom_Intuos4_4x6", .size_mm = { 157.5, 98.4 } },
    { .file = "Wacom_Intuos_Pro_S", .size_mm = { 157.5, 98.4 } },
    { .file = "Wacom_PenPartner", .size_mm = { 81.25, 58 } },
    { .file = "n-trig", .size_mm = { 256.8, 144.5 } },
};

Published published(std::string_view file)
{
    for (auto const& known : kPublished)
        if (file.starts_with(known.file))
            return known;
    ADD_FAILURE() << "nothing is known of " << file;
    return {};
}

// A pen in a recording, with the samples from decoding the whole recording, including silences.
struct DecodedPen {
    std::string file {};
    PenTraits traits {};
    std::vector<PenSample> samples {};
    std::size_t refused = 0; // Number of refused reports.
};

DecodedPen decode_pen(Log const& log, std::size_t device, PenDecoder& decoder)
{
    DecodedPen pen { .traits = decoder.traits() };
    PenSilence silence;
    auto const use = [&](std::optional<PenSample> const& sample) {
        if (sample)
            pen.samples.push_back(*sample);
    };
    for (auto const& record : log.records) {
        if (record.device != device)
            continue;
        use(silence.leave_after_silence(decoder, record.time));
        auto const sample = decode_one(decoder, record.time, log.report(record));
        pen.refused += !sample;
        if (!sample || !*sample)
            continue;
        silence.heard(**sample);
        use(*sample);
    }
    if (!log.records.empty())
        use(silence.leave_after_silence(decoder,
                                        log.records.back().time + std::chrono::seconds(1)));
    return pen;
}

// Returns the pens of all recordings in a folder. Finger touches are not pens.
std::vector<DecodedPen> decode_pens(std::filesystem::path const& folder)
{
    std::vector<DecodedPen> pens;
    for (auto const& entry : std::filesystem::recursive_directory_iterator(folder)) {
        auto const kind = entry.path().extension();
        if (!entry.is_regular_file() || kind == ".ev" || kind == ".toml" || kind == ".png")
            continue;
        auto const log = read_log(entry.path());
        EXPECT_TRUE(log) << log.error().message;
        auto decoder = make_pen_decoder(log->devices.front());
        EXPECT_TRUE(decoder) << entry.path() << ": " << decoder.error().message;
        if (!decoder)
            continue;
        pens.push_back(decode_pen(*log, 0, **decoder));
        pens.back().file = entry.path().filename().string();
    }
    return pens;
}

// Returns all pens recorded by other people.
std::vector<DecodedPen> const& recorded_pens()
{
    static auto const all = decode_pens(corpus() / "recordings");
    return all;
}

// Returns the pens of the corpus, if there is one, and those of the program's own demonstrations.
std::vector<DecodedPen> const& all_pens()
{
    static auto const all = [] {
        auto pens = decode_pens(shipped("../../app/demo"));
        EXPECT_FALSE(pens.empty());
        if (!corpus().empty())
            pens.insert(pens.end(), recorded_pens().begin(), recorded_pens().end());
        return pens;
    }();
    return all;
}

TEST(Recordings, DecodeAll)
{
    REQUIRE_CORPUS();
    EXPECT_GE(recorded_pens().size(), 41u);
    for (auto const& pen : recorded_pens()) {
        EXPECT_EQ(pen.refused, 0u) << pen.file;
        // One of the recordings is of a mouse on the tablet, and one is of the tablet's dials.
        bool const has_pen = !pen.file.starts_with("Wacom_Intuos3")
            && pen.file.find("frame_dials") == std::string::npos;
        EXPECT_EQ(pen.samples.empty(), !has_pen) << pen.file;
    }
}

TEST(Recordings, StayWithinThePublishedMaxima)
{
    for (auto const& pen : all_pens())
        for (auto const& sample : pen.samples) {
            ASSERT_TRUE(sample.raw_x >= 0 && sample.raw_x <= pen.traits.raw_x_maximum) << pen.file;
            ASSERT_TRUE(sample.raw_y >= 0 && sample.raw_y <= pen.traits.raw_y_maximum) << pen.file;
            ASSERT_TRUE(sample.raw_pressure >= 0
                        && sample.raw_pressure <= pen.traits.raw_pressure_maximum)
                << pen.file;
            ASSERT_TRUE(sample.position_mm.x() >= -0.01
                        && sample.position_mm.x() <= pen.traits.size_mm.x() + 0.01)
                << pen.file;
            ASSERT_TRUE(sample.position_mm.y() >= -0.01
                        && sample.position_mm.y() <= pen.traits.size_mm.y() + 0.01)
                << pen.file;
        }
}

TEST(Recordings, ReachThePublishedMaximaWhereSomebodyDrewRoundTheEdges)
{
    REQUIRE_CORPUS();
    for (auto const& pen : recorded_pens()) {
        auto const known = published(pen.file);
        auto const greatest = [&](std::int32_t PenSample::*member) {
            std::int32_t value = 0;
            for (auto const& sample : pen.samples)
                value = std::max(value, sample.*member);
            return value;
        };
        if (known.reached_x > 0) {
            EXPECT_EQ(greatest(&PenSample::raw_x), known.reached_x) << pen.file;
            EXPECT_EQ(greatest(&PenSample::raw_y), known.reached_y) << pen.file;
        }
        if (known.reached_pressure > 0) {
            EXPECT_EQ(greatest(&PenSample::raw_pressure), known.reached_pressure) << pen.file;
        }
    }
}

TEST(Recordings, HaveThePublishedSizes)
{
    REQUIRE_CORPUS();
    for (auto const& pen : recorded_pens()) {
        auto const known = published(pen.file);
        EXPECT_NEAR(pen.traits.size_mm.x() / known.size_mm.x(), 1, 0.02) << pen.file;
        EXPECT_NEAR(pen.traits.size_mm.y() / known.size_mm.y(), 1, 0.02) << pen.file;
    }
}

TEST(Recordings, HaveOneToolAtATime)
{
    for (auto const& pen : all_pens())
        for (std::size_t i = 1; i < pen.samples.size(); ++i) {
            auto const& before = pen.samples[i - 1];
            auto const& sample = pen.samples[i];
            ASSERT_TRUE(sample.in_range || !sample.touching) << pen.file;
            ASSERT_FALSE(before.in_range && sample.in_range && before.eraser != sample.eraser)
                << pen.file << " at " << to_seconds(sample.time) << " s";
        }
}

TEST(Recordings, HaveTimesInOrder)
{
    for (auto const& pen : all_pens())
        EXPECT_TRUE(std::is_sorted(pen.samples.begin(), pen.samples.end(),
                                   [](auto const& a, auto const& b) { return a.time < b.time; }))
            << pen.file;
}

TEST(Recordings, EndWithThePenUp)
{
    for (auto const& pen : all_pens())
        if (!pen.samples.empty()) {
            EXPECT_FALSE(pen.samples.back().touching) << pen.file;
        }
}

TEST(Recordings, HaveNoStrokeThatLeapsToTheOriginOrElsewhere)
{
    // A fast hand moves at 2 m/s, and a report may be lost.
    constexpr double kFastest_mm_per_s = 2000, kSlack_mm = 2;
    for (auto const& pen : all_pens())
        for (std::size_t i = 1; i < pen.samples.size(); ++i) {
            auto const& before = pen.samples[i - 1];
            auto const& sample = pen.samples[i];
            if (!before.touching || !sample.touching)
                continue;
            auto const leap_mm = (sample.position_mm - before.position_mm).norm();
            auto const time_s = to_seconds(sample.time - before.time);
            ASSERT_LE(leap_mm, kSlack_mm + kFastest_mm_per_s * time_s)
                << pen.file << " at " << to_seconds(sample.time) << " s";
        }
}

TEST(Recordings, HaveNoStrokeThatIsTornWhereThePenOnlyRested)
{
    constexpr double kSamePlace_mm = 1;
    for (auto const& pen : all_pens())
        for (std::size_t i = 2; i < pen.samples.size(); ++i) {
            auto const& touch = pen.samples[i - 2];
            auto const& left = pen.samples[i - 1];
            auto const& next = pen.samples[i];
            bool const is_one_touch = touch.touching && !left.in_range && next.touching;
            ASSERT_FALSE(is_one_touch
                         && (next.position_mm - touch.position_mm).norm() <= kSamePlace_mm)
                << pen.file << " at " << to_seconds(left.time) << " s";
        }
}

TEST(Recordings, EraseOnlyWhereThePenHasAnEraser)
{
    REQUIRE_CORPUS();
    std::size_t erasing = 0;
    for (auto const& pen : recorded_pens())
        for (auto const& sample : pen.samples) {
            ASSERT_TRUE(!sample.eraser || pen.traits.has_eraser) << pen.file;
            erasing += sample.eraser && sample.touching;
        }
    EXPECT_GT(erasing, 100u);
}

TEST(Recordings, HaveBothButtonsWhereSomebodyPressedThem)
{
    REQUIRE_CORPUS();
    for (auto const& pen : recorded_pens()) {
        if (pen.file.find("pen_buttons") == std::string::npos)
            continue;
        std::uint32_t pressed = 0;
        for (auto const& sample : pen.samples)
            pressed |= sample.buttons;
        // The New 1060 Plus sends only two buttons in the mode to which Linux switches it.
        EXPECT_EQ(pressed, pen.file.starts_with("Huion_New_1060_Plus") ? 2u : 3u) << pen.file;
    }
}

// Returns the settled tips of a pen that draws at height 0, split into strokes.
std::vector<std::vector<TipSample>> strokes_of(DecodedPen const& pen, calib::Rig const& rig)
{
    calib::Fuser fuser(rig, calib::ScriptedHeight {});
    for (auto const& sample : pen.samples)
        (void)fuser.push(sample);
    fuser.flush();
    std::vector<std::vector<TipSample>> strokes;
    bool was_touching = false;
    for (auto const& tip : fuser.take_settled()) {
        if (tip.touching && !was_touching)
            strokes.emplace_back();
        if (tip.touching)
            strokes.back().push_back(tip);
        was_touching = tip.touching;
    }
    return strokes;
}

TEST(Recordings, HaveNoBlobAtAStrokesStartOrEnd)
{
    // The end of a stroke is a blob if its pressure exceeds that of each of the next five tips by
    // more than a tenth of the maximum.
    constexpr double kBlob = 0.1;
    constexpr std::size_t kNext = 5;
    std::size_t count = 0;
    auto const is_blob = [](auto end) {
        auto const hardest
            = std::max_element(end + 1, end + 1 + kNext, [](auto const& a, auto const& b) {
                  return a.pressure < b.pressure;
              });
        return end->pressure > hardest->pressure + kBlob;
    };
    for (auto const& pen : all_pens()) {
        if (!pen.traits.has_pressure)
            continue;
        for (auto const& stroke : strokes_of(pen, { .pressure = { .threshold = 0.02 } })) {
            if (stroke.size() < 2 * kNext)
                continue;
            ++count;
            EXPECT_FALSE(is_blob(stroke.begin()))
                << pen.file << " at " << to_seconds(stroke.front().time) << " s";
            EXPECT_FALSE(is_blob(stroke.rbegin()))
                << pen.file << " at " << to_seconds(stroke.back().time) << " s";
        }
    }
    EXPECT_GT(count, corpus().empty() ? 10u : 100u);
}

TEST(Recordings, MakeNoMoreStrokesWithAThreshold)
{
    // With a threshold, a light hand must draw one stroke, and not fragments.
    for (auto const& pen : all_pens())
        EXPECT_LE(strokes_of(pen, { .pressure = { .threshold = 0.02 } }).size(),
                  strokes_of(pen, {}).size())
            << pen.file;
}

} // namespace
} // namespace tractus::drivers
