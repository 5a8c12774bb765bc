#include "drivers/pens/known_habits.h"

namespace tractus::drivers {

namespace {

struct KnownHabits {
    std::uint16_t vendor_id = 0;
    std::uint16_t product_id = 0;
    PenHabits habits {};
};

// Habits of pens that report leaving and then hovering when their second button is pressed.
constexpr PenHabits kArtist24 {
    .second_button_is_eraser = true,
    .false_leave = std::chrono::milliseconds(20),
};

constexpr PenHabits kArtistProGen2 {
    .second_button_is_eraser = true,
    .coil_height_mm = 0.055677699 * 25.4,
};

constexpr PenHabits kKamvasPro19 { .third_button_is_invert = true };

// Habits of the pens of Huion and Gaomon tablets before a driver switches the tablet's mode.
constexpr PenHabits kHuion { .second_button_is_eraser = true };

// Habits of a mouse used as a pen (app/controllers/mouse_rig.h).
constexpr PenHabits kMouse { .rests_in_silence = true };

constexpr KnownHabits kKnown[] = {
    { 0, kMousePenProduct, kMouse },    { 0x28bd, 0x093a, kArtist24 }, // XP-Pen Artist 24.
    { 0x28bd, 0x092d, kArtist24 },                                     // XP-Pen Artist 24 Pro.
    { 0x28bd, 0x095a, kArtistProGen2 }, // XP-Pen Artist Pro 14 (Gen 2).
    { 0x28bd, 0x095b, kArtistProGen2 }, // XP-Pen Artist Pro 16 (Gen 2).
    { 0x256c, 0x006b, kKamvasPro19 },   // Huion Kamvas Pro 19.
    { 0x256c, 0x0064, kHuion },         { 0x256c, 0x006d, kHuion },
    { 0x256c, 0x006e, kHuion },         { 0x256c, 0x006f, kHuion },
};

} // namespace

PenHabits known_habits(std::uint16_t vendor_id, std::uint16_t product_id, PenButtons const& buttons)
{
    PenHabits habits;
    for (auto const& known : kKnown)
        if (known.vendor_id == vendor_id && known.product_id == product_id)
            habits = known.habits;
    if (buttons.has_second_by_name)
        return { .rests_in_silence = habits.rests_in_silence };
    bool const cannot_turn = buttons.has_eraser && !buttons.has_invert;
    habits.second_button_is_eraser = habits.second_button_is_eraser
        ? !buttons.has_second || buttons.has_second_as_tip
        : !buttons.has_second && cannot_turn;
    return habits;
}

} // namespace tractus::drivers
