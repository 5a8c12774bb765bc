#pragma once

#include <stdint.h>

// The sensor's USB descriptors, as ../height-sensor.md lists them.

struct descriptor {
    uint8_t const* bytes; // In program memory; null if there is none.
    uint16_t size;
};

// The answer to GET_DESCRIPTOR with this wValue: its high byte is the kind, its low byte the index.
struct descriptor find_descriptor(uint16_t value);
