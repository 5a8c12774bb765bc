#pragma once

#include <stdbool.h>
#include <stdint.h>

// The chip's USB interface as a HID device with one endpoint. Everything runs in the main loop,
// without interrupts (ATmega16U4/32U4 data sheet, chapters 21 and 22).

// Connects the device to the host.
void usb_start(void);

// Handles the host's requests since the last call. `report` is the answer to GET_REPORT.
void usb_serve(uint8_t const* report, uint8_t size);

// Offers a report to the host. It is dropped if the host has not fetched the previous one, or has
// not configured the device yet.
void usb_send(uint8_t const* report, uint8_t size);
