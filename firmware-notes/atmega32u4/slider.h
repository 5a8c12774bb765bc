#pragma once

#include <stdbool.h>
#include <stdint.h>

// Readings of 13 bits out of conversions of 10, and the report that carries them. It knows nothing
// of the board: the simulator and any other board run the same lines.
//
// A reading is the sum of the last 64 conversions, divided by 8: noise of a count or more between
// them, which a long wire always brings, decides the three bits more (Atmel, application note
// AVR121). There is a new reading every 32 conversions, so that each conversion is in two of them,
// and their middle is always the same 32 conversions ago: one latency, which calibrating finds.

enum {
    kSliderReport = 1,      // Its id.
    kSliderReportBytes = 3, // Id, low byte, high byte.
    kSliderHalf = 32,       // Conversions from reading to reading.
    kSliderShift = 3,
    kSliderFullScale = 2u * kSliderHalf * 1023u >> kSliderShift, // 8184
};

// All zero at first.
struct slider {
    uint16_t sum;      // Sum of the conversions since the last reading, at most 32 * 1023.
    uint16_t previous; // Sum of the 32 before them.
    uint8_t count;     // Conversions in `sum`.
    bool has_previous;
};

// Takes a conversion, 0 to 1023. True if it completes a reading, which is in `report` then.
bool slider_add(struct slider* slider, uint16_t conversion, uint8_t report[kSliderReportBytes]);
