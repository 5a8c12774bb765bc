// Tests behaviours of pens and their devices that Linux's own tablet tests require.

#include "drivers/pens/pen_state.h"

#include <cmath>
#include <gtest/gtest.h>
#include <string>

namespace tractus::drivers {
namespace {

using namespace std::chrono_literals;

// A scale of 100 counts per millimetre on 200 x 100 mm, with pressure up to 2047.
PenScale const kScale {
    .y_maximum = 10'000,
    .mm_per_count = { 0.01, 0.01 },
    .has_pressure = true,
    .pressure_maximum = 2047,
    .has_tilt = true,
};

// Pen states with the same meaning as in Linux's tests.
PenFields const kOut { .pressure = 0, .tilt_deg = Vec2::Zero(), .in_range = false, .tip = false };
PenFields const kHover { .x = 5000, .y = 2500, .pressure = 0, .in_range = true, .tip = false };
PenFields const kContact { .x = 5000, .y = 2500, .pressure = 900, .in_range = true, .tip = true };
PenFields const kEraseIntent {
    .x = 5000, .y = 2500, .pressure = 0, .in_range = true, .tip = false, .invert = true
};
PenFields const kErasing {
    .x = 5000, .y = 2500, .pressure = 900, .in_range = true, .tip = false, .eraser_touch = true
};

PenFields with_buttons(PenFields fields, std::uint32_t buttons)
{
    fields.buttons = buttons;
    return fields;
}

PenFields at_place(PenFields fields, std::int32_t x, std::int32_t y)
{
    fields.x = x;
    fields.y = y;
    return fields;
}

// A pen whose reports arrive every 5 ms. push() returns a letter for the result of each report: '-'
// no sample, 'o' out, 'h' hover, 'C' contact, 'i' erase intent, 'E' erasing. The test fails if two
// tools are in range without the first having left.
class Pen {
public:
    explicit Pen(PenHabits const& habits = {})
        : state_(habits)
    {
    }

    char push(PenFields const& fields, Duration pause = 5ms)
    {
        time_ += pause;
        return take(state_.push(time_, fields, kScale));
    }

    char leave() { return take(state_.leave(time_)); }

    std::string push(std::initializer_list<PenFields> const& reports)
    {
        std::string letters;
        for (auto const& fields : reports)
            letters += push(fields);
        return letters;
    }

    PenSample const& last() const { return last_; }
    PenState& state() { return state_; }
    Timestamp time() const { return time_; }

private:
    char take(std::optional<PenSample> const& sample)
    {
        if (!sample)
            return '-';
        EXPECT_TRUE(sample->in_range || (!sample->touching && sample->buttons == 0));
        EXPECT_FALSE(last_.in_range && sample->in_range && sample->eraser != last_.eraser)
            << "two tools at once";
        last_ = *sample;
        if (!sample->in_range)
            return 'o';
        if (sample->eraser)
            return sample->touching ? 'E' : 'i';
        return sample->touching ? 'C' : 'h';
    }

    PenState state_;
    Timestamp time_ {};
    PenSample last_;
};

TEST(PenState, FollowsAPenThatComesTouchesAndGoes)
{
    Pen pen;
    EXPECT_EQ(pen.push({ kOut, kHover, kContact, kHover, kOut }), "-hCho");
}

TEST(PenState, MovesWithTheReportThatChangesTheState)
{
    Pen pen;
    std::int32_t x = 1000;
    for (auto const& fields : { kHover, kContact, kHover }) {
        pen.push(at_place(fields, x += 500, 3000));
        EXPECT_EQ(pen.last().raw_x, x);
        EXPECT_NEAR(pen.last().position_mm.x(), x / 100.0, 1e-9);
        EXPECT_NEAR(pen.last().position_mm.y(), 70, 1e-9);
    }
}

TEST(PenState, TakesEveryLegalWayIntoRange)
{
    for (auto const& [first, letter] :
         { std::pair(kHover, 'h'), std::pair(kContact, 'C'), std::pair(kEraseIntent, 'i'),
           std::pair(kErasing, 'E'), std::pair(with_buttons(kHover, 1), 'h'),
           std::pair(with_buttons(kContact, 2), 'C') }) {
        Pen pen;
        EXPECT_EQ(pen.push(kOut), '-');
        EXPECT_EQ(pen.push(first), letter);
    }
}

TEST(PenState, TipImpliesInRange)
{
    // The pen of a touch screen, which clears its in-range bit after its first touch.
    auto touching = kContact;
    touching.in_range = false;
    Pen pen;
    EXPECT_EQ(pen.push({ kContact, touching, touching, kHover, kOut }), "CCCho");
}

TEST(PenState, ContactThenOutEndsTheStroke)
{
    Pen pen;
    EXPECT_EQ(pen.push({ kContact, kContact, kOut, kOut, kContact }), "CCo-C");
}

TEST(PenState, EraserContactIsEraserOrInvertAndTip)
{
    auto inverted = kEraseIntent;
    inverted.tip = true;
    Pen pen;
    EXPECT_EQ(pen.push({ kEraseIntent, kErasing, kEraseIntent, inverted, kEraseIntent, kOut }),
              "iEiEio");
}

TEST(PenState, OneToolAtATime)
{
    Pen pen;
    EXPECT_EQ(pen.push({ kHover, kEraseIntent, kEraseIntent, kHover, kHover }), "hoioh");
}

TEST(PenState, SurvivesAWobbleBetweenTipAndEraser)
{
    Pen pen;
    EXPECT_EQ(pen.push({ kContact, kErasing, kContact, kErasing, kErasing, kErasing, kOut }),
              "CoCoEEo");
    EXPECT_EQ(pen.push({ kHover, kErasing, kErasing, kContact, kContact, kOut }), "hoEoCo");
}

TEST(PenState, ReportsEachBarrelButtonWhileItHoversAndTouches)
{
    for (auto const& base : { kHover, kContact })
        for (std::uint32_t const button : { 1u, 2u, 4u }) {
            Pen pen;
            pen.push(base);
            auto const before = pen.last();
            pen.push(with_buttons(base, button));
            EXPECT_EQ(pen.last().buttons, button);
            EXPECT_EQ(pen.last().position_mm, before.position_mm);
            EXPECT_EQ(pen.last().pressure, before.pressure);
            pen.push(base);
            EXPECT_EQ(pen.last().buttons, 0u);
        }
}

TEST(PenState, ReleasesTipAndButtonInEitherOrder)
{
    Pen tip_first;
    EXPECT_EQ(tip_first.push({ with_buttons(kContact, 1), with_buttons(kHover, 1) }), "Ch");
    EXPECT_EQ(tip_first.last().buttons, 1u);
    tip_first.push(kHover);
    EXPECT_EQ(tip_first.last().buttons, 0u);

    Pen button_first;
    EXPECT_EQ(button_first.push({ with_buttons(kContact, 1), kContact, kHover }), "CCh");
    EXPECT_EQ(button_first.last().buttons, 0u);
}

TEST(PenState, LeavingReleasesTheButtons)
{
    Pen pen;
    EXPECT_EQ(pen.push({ with_buttons(kContact, 3), with_buttons(kOut, 3) }), "Co");
    EXPECT_EQ(pen.last().buttons, 0u);
}

TEST(PenState, AReportOfZerosDoesNotMoveAPenThatLeaves)
{
    auto tilted = kContact;
    tilted.tilt_deg = Vec2(30, -20);
    Pen pen;
    EXPECT_EQ(pen.push({ tilted, kOut }), "Co");
    EXPECT_EQ(pen.last().raw_x, 5000);
    EXPECT_NEAR(pen.last().position_mm.x(), 50, 1e-9);
    EXPECT_NEAR(pen.last().position_mm.y(), 75, 1e-9);
    EXPECT_NEAR(pen.last().tilt_rad.value().x(), radians(30.0), 1e-12);
    EXPECT_NEAR(pen.last().tilt_rad.value().y(), radians(20.0), 1e-12);
    EXPECT_EQ(pen.last().pressure, 0.0);
}

TEST(PenState, SaysNothingOfAPenThatIsAway)
{
    Pen pen;
    EXPECT_EQ(pen.push({ kOut, kHover, kOut, kOut, kOut, kHover }), "-ho--h");
}

TEST(PenState, WaitsForTheFirstPlace)
{
    auto without_place = kHover;
    without_place.carries_position = false;
    Pen pen;
    EXPECT_EQ(pen.push({ without_place, kHover, without_place }), "-hh");
    EXPECT_EQ(pen.last().raw_x, 5000);
}

TEST(PenState, KeepsPressureAndTiltWhereOnlyEverySecondReportHasThem)
{
    // An art pen sends its rotation instead of the pressure in every second report.
    auto pressing = kContact;
    pressing.tip = std::nullopt;
    pressing.tilt_deg = Vec2(10, 0);
    auto turning = pressing;
    turning.pressure = std::nullopt;
    turning.tilt_deg = std::nullopt;
    Pen pen;
    EXPECT_EQ(pen.push({ pressing, turning, pressing, turning }), "CCCC");
    EXPECT_EQ(pen.last().raw_pressure, 900);
    EXPECT_NEAR(pen.last().tilt_rad.value().x(), radians(10.0), 1e-12);
    pressing.pressure = 0;
    EXPECT_EQ(pen.push({ pressing, turning }), "hh");
}

TEST(PenState, TakesPressureForATouchWhereNoTipSwitchTells)
{
    auto scale = kScale;
    scale.touch_above = 10;
    auto fields = kHover;
    fields.tip = std::nullopt;
    PenState state;
    for (int const pressure : { 0, 10, 11 }) {
        fields.pressure = pressure;
        auto const sample = state.push({}, fields, scale);
        ASSERT_TRUE(sample);
        EXPECT_EQ(sample->touching, pressure > 10);
    }
}

TEST(PenState, FollowsATipSwitchWithoutPressure)
{
    auto scale = kScale;
    scale.has_pressure = false;
    PenState state;
    auto const sample = state.push({}, kContact, scale);
    ASSERT_TRUE(sample);
    EXPECT_TRUE(sample->touching);
    EXPECT_FALSE(sample->pressure);
}

TEST(PenState, LetsAnotherPenComeWhenTheFirstHasLeft)
{
    auto first = kHover;
    first.tool_serial = 0x1234;
    auto second = kHover;
    second.tool_serial = 0x5678;
    Pen pen;
    EXPECT_EQ(pen.push({ first, first, second, second }), "hhoh");
    EXPECT_EQ(pen.last().tool_serial, 0x5678u);
}

TEST(PenState, DoesNotCutAStrokeForASerialNumber)
{
    auto first = kContact;
    first.tool_serial = 0x1234;
    auto other = kContact;
    other.tool_serial = 0x1235; // A transmission error: nobody changes pens while drawing.
    Pen pen;
    EXPECT_EQ(pen.push({ first, other, first, kContact }), "CCCC");
}

TEST(PenState, ASilenceOf100MsEndsHoveringForFormatsThatNeverReportIt)
{
    auto hovering = kHover;
    hovering.in_range = std::nullopt;
    Pen pen;
    EXPECT_FALSE(pen.state().silence_limit());
    EXPECT_EQ(pen.push(hovering), 'h');
    EXPECT_EQ(pen.state().silence_limit(), 100ms);
    EXPECT_EQ(pen.leave(), 'o');
    EXPECT_FALSE(pen.state().silence_limit());
    EXPECT_EQ(pen.leave(), '-');
    EXPECT_EQ(pen.push(hovering), 'h');
}

// Pushes equal reports, as a streaming tablet sends them while the pen rests.
std::string rest(Pen& pen, PenFields const& fields, int reports = 4)
{
    std::string letters;
    for (int i = 0; i < reports; ++i)
        letters += pen.push(fields);
    return letters;
}

TEST(PenState, ContactRestsInSilenceOnATabletThatReportsChangesOnly)
{
    Pen pen({ .reports_leaving = false });
    for (int i = 0; i < 200; ++i) // No report occurs more than twice in a row.
        EXPECT_EQ(pen.push(at_place(kContact, 5000 + i / 2, 2500)), 'C');
    EXPECT_FALSE(pen.state().silence_limit());
    EXPECT_EQ(pen.push(at_place(kContact, 5101, 2500), std::chrono::minutes(1)), 'C');
}

TEST(PenState, SilenceEndsContactOnATabletThatStreams)
{
    Pen pen({ .reports_leaving = false });
    EXPECT_EQ(pen.push(kContact), 'C');
    EXPECT_EQ(rest(pen, kContact), "CCCC");
    EXPECT_EQ(pen.state().silence_limit(), 100ms) << "16 intervals of 5 ms are less";
    EXPECT_EQ(pen.leave(), 'o');
    EXPECT_EQ(pen.push(at_place(kContact, 9000, 2500), 500ms), 'C');
    EXPECT_EQ(pen.state().silence_limit(), 100ms);
}

TEST(PenState, SilenceIsMeasuredInTheTabletsOwnIntervals)
{
    Pen pen({ .reports_leaving = false });
    for (int i = 0; i < 20; ++i)
        EXPECT_EQ(pen.push(kContact, 15ms), 'C');
    EXPECT_EQ(pen.state().silence_limit(), 16 * 15ms);
}

TEST(PenState, AStreamingTabletThatCanSayLeavingIsWaitedForLonger)
{
    Pen pen;
    rest(pen, kHover);
    EXPECT_FALSE(pen.state().silence_limit()) << "hovering";
    EXPECT_EQ(pen.push(kContact), 'C');
    EXPECT_EQ(pen.state().silence_limit(), 1s);
}

TEST(PenState, ATouchThatGoesOnWhereItFellSilentHadOnlyRested)
{
    Pen pen({ .reports_leaving = false });
    rest(pen, kContact);
    ASSERT_TRUE(pen.state().silence_limit());
    EXPECT_EQ(pen.leave(), 'o');
    EXPECT_EQ(pen.push(at_place(kContact, 5050, 2500), 500ms), 'C');
    EXPECT_FALSE(pen.state().silence_limit()) << "it does not stream after all";
    rest(pen, kContact, 20);
    EXPECT_FALSE(pen.state().silence_limit()) << "whatever it sends";
}

TEST(PenState, AHoverAfterSilenceProvesNoRest)
{
    Pen pen({ .reports_leaving = false });
    rest(pen, kContact);
    EXPECT_EQ(pen.leave(), 'o');
    EXPECT_EQ(pen.push({ kHover, kContact }), "hC");
    EXPECT_TRUE(pen.state().silence_limit());
}

TEST(PenState, ATouchFarFromWhereItFellSilentIsAnother)
{
    auto const far = at_place(kContact, 5600, 2500); // This place is 6 mm away.
    Pen pen({ .reports_leaving = false });
    EXPECT_EQ(pen.push(kContact), 'C');
    EXPECT_EQ(pen.push(far, 101ms), 'o');
    EXPECT_EQ(pen.push(far), 'C');

    Pen fast({ .reports_leaving = false });
    EXPECT_EQ(fast.push(kContact), 'C');
    EXPECT_EQ(fast.push(far, 5ms), 'C') << "there was no silence";

    Pen telling; // The tablet of this pen reports leaving.
    EXPECT_EQ(telling.push(kContact), 'C');
    EXPECT_EQ(telling.push(far, 101ms), 'C');
}

TEST(PenState, NoSilenceEndsThePresenceOfAPenThatReportsIt)
{
    Pen pen;
    EXPECT_EQ(pen.push({ kHover, kContact }), "hC");
    EXPECT_FALSE(pen.state().silence_limit());
}

// Habits of XP-Pen's Artist 24. The second button is the eraser's bit. Pressing it while the pen
// touches sends a false leave, and then hovering.
PenHabits const kArtist24 { .second_button_is_eraser = true, .false_leave = 20ms };

TEST(PenState, HoldsAFalseLeaveWhileTouching)
{
    auto hover_pressed = kHover;
    hover_pressed.eraser_touch = true;
    auto contact_pressed = kContact;
    contact_pressed.eraser_touch = true;
    Pen pen(kArtist24);
    EXPECT_EQ(pen.push({ kContact, kOut, hover_pressed, contact_pressed }), "C--C");
    EXPECT_EQ(pen.last().buttons, 2u);
    EXPECT_EQ(pen.push({ kOut, kHover, kContact }), "--C");
    EXPECT_EQ(pen.last().buttons, 0u);
}

TEST(PenState, HoldsAFalseLeaveWhileHovering)
{
    auto pressed = kHover;
    pressed.eraser_touch = true;
    Pen pen(kArtist24);
    EXPECT_EQ(pen.push({ kHover, kOut, pressed, kOut, kHover }), "h-h-h");
}

TEST(PenState, BelievesALeaveThatLasts)
{
    Pen pen(kArtist24);
    EXPECT_EQ(pen.push({ kContact, kOut }), "C-");
    EXPECT_EQ(pen.state().silence_limit(), 25ms); // The last sample came 5 ms before.
    auto const left = pen.time();
    EXPECT_EQ(pen.push(kOut, 21ms), 'o');
    EXPECT_EQ(pen.last().time, left);
    EXPECT_EQ(pen.push(kHover), 'h');
}

TEST(PenState, ReadsTheEraserAsTheSecondButtonOnlyWhereItIsOne)
{
    Pen pen({ .second_button_is_eraser = true });
    auto pressed = kContact;
    pressed.eraser_touch = true;
    EXPECT_EQ(pen.push({ kContact, pressed }), "CC");
    EXPECT_EQ(pen.last().buttons, 2u);
    // With its eraser end down, this pen sends invert while it hovers, and invert and tip while it
    // touches.
    auto inverted = kEraseIntent;
    inverted.tip = true;
    EXPECT_EQ(pen.push({ kOut, kEraseIntent, inverted }), "oiE");
}

TEST(PenState, ReadsInvertAsTheThirdButtonUnlessThePenComesWithIt)
{
    auto pressed = kHover;
    pressed.invert = true;
    Pen pen({ .third_button_is_invert = true });
    EXPECT_EQ(pen.push({ kHover, pressed, kHover }), "hhh");
    pen.push(pressed);
    EXPECT_EQ(pen.last().buttons, 4u);
    EXPECT_EQ(pen.push({ kOut, kEraseIntent, kErasing, kEraseIntent, kOut }), "oiEio");
}

TEST(PenState, PutsATiltedPensTipBackUnderItsCoil)
{
    auto tilted = kContact;
    tilted.tilt_deg = Vec2(30, 0);
    Pen pen({ .coil_height_mm = 1.4 });
    pen.push(tilted);
    EXPECT_NEAR(pen.last().position_mm.x(), 50 - 1.4 * 0.5, 1e-9);
    EXPECT_NEAR(pen.last().position_mm.y(), 75, 1e-9);
    EXPECT_EQ(pen.last().raw_x, 5000);
}

TEST(PenState, BoundsThePressure)
{
    auto pressing = kContact;
    pressing.pressure = 65'535;
    Pen pen;
    pen.push(pressing);
    EXPECT_EQ(pen.last().pressure, 1.0);
}

} // namespace
} // namespace tractus::drivers
