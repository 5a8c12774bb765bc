#pragma once

#include <stdint.h>

// What the sensor says of itself on USB, as ../height-sensor.md has it.

struct descriptor {
    uint8_t const* bytes; // In program memory; null if there is none.
    uint16_t size;
};

// The answer to GET_DESCRIPTOR with this wValue: its high byte is the kind, its low byte the index.
struct descriptor find_descriptor(uint16_t value);
