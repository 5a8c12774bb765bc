#pragma once

#include <stdbool.h>
#include <stdint.h>

// Computes 13-bit readings from 10-bit conversions, and the report that carries them. Independent
// of the board: the simulator and other boards use the same code.
//
// A reading is the sum of the last 64 conversions, divided by 8. Noise of a count or more between
// conversions, which a long wire always causes, provides the three additional bits (Atmel,
// application note AVR121). There is a new reading every 32 conversions, so each conversion is part
// of two readings, and a reading's centre is always 32 conversions old: a constant latency, which
// calibration finds.

enum {
    kSliderReport = 1,      // Report id of the slider's report.
    kSliderReportBytes = 3, // Report id, low byte, high byte.
    kSliderHalf = 32,       // Number of conversions between readings.
    kSliderShift = 3,
    kSliderFullScale = 2u * kSliderHalf * 1023u >> kSliderShift, // Greatest reading, 8184.
};

// State of the averaging; initialise it to zero.
struct slider {
    uint16_t sum;      // Sum of the conversions since the last reading, at most 32 * 1023.
    uint16_t previous; // Sum of the 32 conversions before those.
    uint8_t count;     // Number of conversions in `sum`.
    bool has_previous;
};

// Adds a conversion, 0 to 1023. Returns true if it completes a reading, which is then in `report`.
bool slider_add(struct slider* slider, uint16_t conversion, uint8_t report[kSliderReportBytes]);
