#pragma once

#include <stdbool.h>
#include <stdint.h>

// The chip's USB as a HID device with one endpoint. Everything runs in the main loop; no interrupt
// is used (ATmega16U4/32U4 data sheet, chapters 21 and 22).

// Shows the device to the host.
void usb_start(void);

// Does what the host has asked for since the last call. `report` is what GET_REPORT answers.
void usb_serve(uint8_t const* report, uint8_t size);

// Offers a report to the host. It is dropped where the host has not fetched the one before, and
// before the host has configured the device.
void usb_send(uint8_t const* report, uint8_t size);
