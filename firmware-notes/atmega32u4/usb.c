#include "usb.h"

#include "descriptors.h"

#include <avr/io.h>
#include <avr/pgmspace.h>

enum { kEndpoint = 1, kPacketBytes = 64 };

// Request codes: bmRequestType in the high byte, bRequest in the low byte (USB 2.0, section 9.4;
// HID 1.11, section 7).
enum {
    kGetDeviceStatus = 0x8000,
    kGetInterfaceStatus = 0x8100,
    kGetEndpointStatus = 0x8200,
    kClearEndpointFeature = 0x0201,
    kSetEndpointFeature = 0x0203,
    kSetAddress = 0x0005,
    kGetDeviceDescriptor = 0x8006,
    kGetInterfaceDescriptor = 0x8106,
    kGetConfiguration = 0x8008,
    kSetConfiguration = 0x0009,
    kGetInterface = 0x810a,
    kGetReport = 0xa101,
    kGetIdle = 0xa102,
    kSetIdle = 0x210a,
};

struct setup {
    uint16_t request; // Request code, such as kGetDeviceStatus.
    uint16_t value;
    uint16_t length;
};

static uint8_t configuration;
static bool halted;

// ---- Endpoint 0

static void wait_for_room(void)
{
    while (!(UEINTX & (1 << TXINI))) { }
}

static void send_packet(void)
{
    UEINTX = (uint8_t) ~(1 << TXINI);
}

// Sends an empty packet as the answer.
static void acknowledge(void)
{
    send_packet();
}

static void stall(void)
{
    UECONX = 1 << STALLRQ | 1 << EPEN;
}

static uint8_t byte_at(uint8_t const *bytes, bool is_in_flash)
{
    return is_in_flash ? pgm_read_byte(bytes) : *bytes;
}

// Sends an answer of at most the requested size. A packet that is not full ends the transfer, so if
// the last one is full, an empty one follows, unless the host knows the size.
static void answer(uint8_t const *bytes, uint16_t size, bool is_in_flash, uint16_t asked)
{
    if (size > asked)
        size = asked;
    uint8_t count;
    do {
        uint8_t ready;
        do {
            ready = UEINTX & (1 << TXINI | 1 << RXOUTI);
        } while (!ready);
        if (ready & 1 << RXOUTI)
            return; // The host has ended the transfer.
        count = size < kPacketBytes ? (uint8_t)size : kPacketBytes;
        for (uint8_t i = 0; i < count; ++i)
            UEDATX = byte_at(bytes++, is_in_flash);
        size -= count;
        send_packet();
    } while (size > 0 || count == kPacketBytes);
}

static void answer_byte(uint8_t byte, uint16_t asked)
{
    answer(&byte, 1, false, asked);
}

static uint8_t next_byte(void)
{
    return UEDATX;
}

static uint16_t next_word(void)
{
    uint8_t const low = next_byte();
    return low | (uint16_t)next_byte() << 8;
}

static struct setup read_setup(void)
{
    struct setup setup;
    uint8_t const type = next_byte();
    setup.request = (uint16_t)type << 8 | next_byte();
    setup.value = next_word();
    next_word(); // Skips wIndex, since there is only one interface and one endpoint.
    setup.length = next_word();
    UEINTX = (uint8_t) ~(1 << RXSTPI | 1 << RXOUTI | 1 << TXINI);
    return setup;
}

// ---- The device

static void open_endpoint(void)
{
    UENUM = kEndpoint;
    UECONX = 1 << EPEN;
    UECFG0X = 1 << EPTYPE1 | 1 << EPTYPE0 | 1 << EPDIR; // Endpoint type interrupt, direction IN.
    UECFG1X = 1 << ALLOC; // Size 8 bytes, one bank.
    UERST = 1 << kEndpoint;
    UERST = 0;
    UENUM = 0;
}

static void set_address(struct setup setup)
{
    acknowledge();
    // The new address applies only after the host has received the acknowledgement.
    wait_for_room();
    UDADDR = (uint8_t)(1 << ADDEN | setup.value);
}

static void set_configuration(struct setup setup)
{
    configuration = (uint8_t)setup.value;
    halted = false;
    acknowledge();
    open_endpoint();
}

static void set_halt(bool is_halted)
{
    halted = is_halted;
    acknowledge();
    UENUM = kEndpoint;
    if (is_halted) {
        UECONX = 1 << STALLRQ | 1 << EPEN;
    } else {
        UECONX = 1 << STALLRQC | 1 << RSTDT | 1 << EPEN;
        UERST = 1 << kEndpoint;
        UERST = 0;
    }
    UENUM = 0;
}

static void answer_descriptor(struct setup setup)
{
    struct descriptor const found = find_descriptor(setup.value);
    if (found.bytes)
        answer(found.bytes, found.size, true, setup.length);
    else
        stall();
}

static void answer_status(bool is_set, uint16_t asked)
{
    uint8_t const status[] = { is_set, 0 };
    answer(status, sizeof status, false, asked);
}

static void handle(struct setup setup, uint8_t const *report, uint8_t size)
{
    switch (setup.request) {
    case kGetDeviceDescriptor:
    case kGetInterfaceDescriptor:
        return answer_descriptor(setup);
    case kSetAddress:
        return set_address(setup);
    case kSetConfiguration:
        return setup.value <= 1 ? set_configuration(setup) : stall();
    case kGetConfiguration:
        return answer_byte(configuration, setup.length);
    case kGetDeviceStatus:
    case kGetInterfaceStatus:
        return answer_status(false, setup.length);
    case kGetEndpointStatus:
        return answer_status(halted, setup.length);
    case kSetEndpointFeature:
        return set_halt(true);
    case kClearEndpointFeature:
        return set_halt(false);
    case kGetInterface:
    case kGetIdle:
        return answer_byte(0, setup.length);
    case kSetIdle: // Accepted without effect: every reading is sent, changed or not.
        return acknowledge();
    case kGetReport:
        return answer(report, size, false, setup.length);
    }
    stall();
}

static void open_control(void)
{
    UENUM = 0;
    UECONX = 1 << EPEN;
    UECFG0X = 0; // Endpoint type control.
    UECFG1X = 1 << EPSIZE1 | 1 << EPSIZE0 | 1 << ALLOC; // Size 64 bytes, one bank.
}

void usb_start(void)
{
    UHWCON = 1 << UVREGE; // Enables the USB pad regulator.
    USBCON = 1 << USBE | 1 << FRZCLK;
    PLLCSR = 1 << PINDIV | 1 << PLLE; // Generates 48 MHz from 16 MHz.
    while (!(PLLCSR & 1 << PLOCK)) { }
    USBCON = 1 << USBE | 1 << OTGPADE;
    UDCON = 0; // Attaches to the bus at full speed.
}

void usb_serve(uint8_t const *report, uint8_t size)
{
    if (UDINT & 1 << EORSTI) {
        UDINT = (uint8_t) ~(1 << EORSTI);
        configuration = 0;
        open_control();
    }
    UENUM = 0;
    if (UEINTX & 1 << RXSTPI)
        handle(read_setup(), report, size);
}

void usb_send(uint8_t const *report, uint8_t size)
{
    if (!configuration || halted)
        return;
    UENUM = kEndpoint;
    if (UEINTX & 1 << TXINI) {
        UEINTX = (uint8_t) ~(1 << TXINI);
        for (uint8_t i = 0; i < size; ++i)
            UEDATX = report[i];
        UEINTX = (uint8_t) ~(1 << FIFOCON);
    }
    UENUM = 0;
}
