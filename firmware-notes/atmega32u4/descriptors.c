#include "descriptors.h"

#include "slider.h"

#include <avr/pgmspace.h>

enum { kDevice = 1, kConfiguration = 2, kString = 3, kHid = 0x21, kReport = 0x22 };

#define LOW(number) ((number) & 0xff)
#define HIGH(number) ((number) >> 8)

static uint8_t const kReportDescriptor[] PROGMEM = {
    0x05, 0x01, // Usage Page (Generic Desktop)
    0x09, 0x08, // Usage (Multi-axis Controller)
    0xa1, 0x01, // Collection (Application)
    0x85, kSliderReport, // Report ID
    0x09, 0x36, // Usage (Slider)
    0x15, 0x00, // Logical Minimum (0)
    0x26, LOW(kSliderFullScale), HIGH(kSliderFullScale), // Logical Maximum (8184)
    0x75, 0x10, // Report Size (16)
    0x95, 0x01, // Report Count (1)
    0x81, 0x02, // Input (Data, Variable, Absolute)
    0xc0, // End Collection
};

// Ids 1209:0001, which pid.codes reserves for private tests.
static uint8_t const kDeviceDescriptor[] PROGMEM = {
    18, kDevice, 0x00, 0x02, // Specification USB 2.0.
    0, 0, 0, 64, // Class defined by the interface; endpoint 0 has 64-byte packets.
    0x09, 0x12, 0x01, 0x00, 0x00, 0x01, // Device version 1.00.
    1, 2, 0, 1, // Strings for maker and product, no serial number; one configuration.
};

#define HID_DESCRIPTOR 9, kHid, 0x11, 0x01, 0, 1, kReport, sizeof kReportDescriptor, 0

static uint8_t const kConfigurationDescriptor[] PROGMEM = {
    9, kConfiguration, 34, 0, 1, 1, 0, 0x80, 50, // Bus-powered, 100 mA.
    9, 4, 0, 0, 1, 3, 0, 0, 0, // A HID interface with one endpoint.
    HID_DESCRIPTOR,
    7, 5, 0x81, 3, 8, 0, 1, // Endpoint IN 1, interrupt, 8 bytes, polled each millisecond.
};

static uint8_t const kHidDescriptor[] PROGMEM = { HID_DESCRIPTOR };

static uint8_t const kLanguages[] PROGMEM = { 4, kString, 0x09, 0x04 };
static uint8_t const kMaker[] PROGMEM
    = { 16, kString, 't', 0, 'r', 0, 'a', 0, 'c', 0, 't', 0, 'u', 0, 's', 0 };
static uint8_t const kProduct[] PROGMEM
    = { 28, kString, 'H', 0, 'e', 0, 'i', 0, 'g', 0, 'h', 0, 't', 0, ' ', 0, 's', 0, 'l', 0,
        'i', 0, 'd', 0, 'e', 0, 'r', 0 };

#define ANSWER(bytes) return (struct descriptor) { bytes, sizeof(bytes) }

struct descriptor find_descriptor(uint16_t value)
{
    switch (value) {
    case kDevice << 8:
        ANSWER(kDeviceDescriptor);
    case kConfiguration << 8:
        ANSWER(kConfigurationDescriptor);
    case kString << 8:
        ANSWER(kLanguages);
    case kString << 8 | 1:
        ANSWER(kMaker);
    case kString << 8 | 2:
        ANSWER(kProduct);
    case kHid << 8:
        ANSWER(kHidDescriptor);
    case kReport << 8:
        ANSWER(kReportDescriptor);
    }
    return (struct descriptor) { 0, 0 };
}
