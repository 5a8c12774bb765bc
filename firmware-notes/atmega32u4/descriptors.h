#pragma once

#include <stdint.h>

// USB descriptors of the sensor, as listed in ../height-sensor.md.

struct descriptor {
    uint8_t const* bytes; // In program memory; null if there is none.
    uint16_t size;
};

// Returns the answer to GET_DESCRIPTOR with this wValue: the high byte is the type, the low byte
// the index.
struct descriptor find_descriptor(uint16_t value);
