// A USB host for the firmware in firmware-notes/atmega32u4, which runs in simavr. It enumerates the
// device like a kernel, feeds the input of the device's converter, and fetches the device's
// reports. It writes the reports as a .tractus-log, and the converter's input as a list. It shares
// no code with the program and is not part of it, because simavr is under the GPL.
//
// Usage: usb_host FIRMWARE.elf LOG CONVERSIONS
#include <simavr/avr_adc.h>
#include <simavr/avr_usb.h>
#include <simavr/sim_avr.h>
#include <simavr/sim_elf.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { kClock_Hz = 16000000, kSupply_mV = 5000, kReports = 400 };

static avr_t *avr;
static avr_irq_t *converter;
static FILE *conversions;
static uint32_t conversion_count;

static void fail(char const *what)
{
    fprintf(stderr, "usb_host: %s\n", what);
    exit(1);
}

static void run_us(uint32_t us)
{
    avr_cycle_count_t const end = avr->cycle + (avr_cycle_count_t)us * (kClock_Hz / 1000000);
    while (avr->cycle < end) {
        int const state = avr_run(avr);
        if (state == cpu_Done || state == cpu_Crashed)
            fail("the firmware has stopped");
    }
}

// Returns the voltage of the wiper in millivolts, so that each of the converter's 1024 steps
// occurs. The wiper rests at one end, then at the other end, and then moves with pseudo-random
// noise. The noise does not depend on the arithmetic of the firmware.
static uint32_t wiper_mV(uint32_t conversion)
{
    static uint32_t noise = 1;
    noise = noise * 1664525u + 1013904223u;
    if (conversion < 1600)
        return 0;
    if (conversion < 3200)
        return kSupply_mV;
    return (conversion - 3200) * 2 % kSupply_mV + noise % 40000 / 1000;
}

static void convert(avr_irq_t *irq, uint32_t value, void *parameter)
{
    (void)irq;
    (void)value;
    (void)parameter;
    static bool is_asked = false;
    // This callback is called when the converter is started, and again when each conversion ends.
    if (!is_asked) {
        is_asked = true;
        return;
    }
    uint32_t mV = wiper_mV(conversion_count++);
    if (mV > kSupply_mV)
        mV = kSupply_mV;
    avr_raise_irq(converter, mV);
    fprintf(conversions, "%u\n", (unsigned)(mV * 1023 / kSupply_mV));
}

// ---- USB transfers

static int usb(uint32_t what, uint8_t pipe, void *bytes, uint32_t *size)
{
    struct avr_io_usb packet = { pipe, *size, bytes };
    int const result = avr_ioctl(avr, what, &packet);
    *size = packet.sz;
    return result;
}

// Repeats a transfer until the device answers with anything but NAK.
static int usb_until(uint32_t what, uint8_t pipe, void *bytes, uint32_t *size)
{
    for (int tries = 0; tries < 1000; ++tries) {
        uint32_t count = *size;
        int const result = usb(what, pipe, bytes, &count);
        if (result != AVR_IOCTL_USB_NAK) {
            *size = count;
            return result;
        }
        run_us(100);
    }
    fail("the device answers nothing but NAK");
    return -1;
}

struct setup {
    uint8_t type, request;
    uint16_t value, index, length;
};

static void send_setup(struct setup setup)
{
    uint32_t size = sizeof setup;
    if (usb(AVR_IOCTL_USB_SETUP, 0, &setup, &size) != AVR_IOCTL_USB_OK)
        fail("the device takes no SETUP");
    run_us(100);
}

// Sends a request with a reply, and returns the size of the reply; -1 if the request is refused.
// The reply may be shorter than requested.
static int get(struct setup setup, uint8_t *bytes)
{
    send_setup(setup);
    uint32_t got = 0;
    for (bool more = true; more && got < setup.length;) {
        uint32_t size = 64;
        if (usb_until(AVR_IOCTL_USB_READ, 0, bytes + got, &size) == AVR_IOCTL_USB_STALL)
            return -1;
        got += size;
        more = size == 64;
    }
    uint32_t none = 0;
    usb_until(AVR_IOCTL_USB_WRITE, 0, NULL, &none);
    return (int)got;
}

// Sends a request without data. Returns false if the device refuses it.
static bool set(struct setup setup)
{
    send_setup(setup);
    uint8_t bytes[64];
    uint32_t size = sizeof bytes;
    return usb_until(AVR_IOCTL_USB_READ, 0, bytes, &size) != AVR_IOCTL_USB_STALL;
}

// ---- What a host's kernel does

static uint8_t report_descriptor[256];
static int report_descriptor_size;

static void enumerate(void)
{
    uint8_t bytes[256];
    avr_ioctl(avr, AVR_IOCTL_USB_VBUS, (void *)1);
    run_us(10000);
    avr_ioctl(avr, AVR_IOCTL_USB_RESET, NULL);
    run_us(2500);
    if (get((struct setup) { 0x80, 6, 0x0100, 0, 64 }, bytes) != 18)
        fail("the device descriptor has not 18 bytes");
    if (!set((struct setup) { 0x00, 5, 7, 0, 0 }))
        fail("the address is refused");
    run_us(2000);
    if (get((struct setup) { 0x80, 6, 0x0100, 0, 18 }, bytes) != 18 || bytes[8] != 0x09
        || bytes[9] != 0x12)
        fail("the device descriptor is another");
    if (get((struct setup) { 0x80, 6, 0x0200, 0, 9 }, bytes) != 9 || bytes[2] != 34)
        fail("the configuration has not 34 bytes");
    if (get((struct setup) { 0x80, 6, 0x0200, 0, 34 }, bytes) != 34 || bytes[4] != 1
        || bytes[14] != 3)
        fail("the configuration has no HID interface");
    if (get((struct setup) { 0x80, 6, 0x0600, 0, 10 }, bytes) != -1)
        fail("a full-speed device tells what it would be at high speed");
    if (get((struct setup) { 0x80, 6, 0x0302, 0x0409, 255 }, bytes) != 28 || bytes[2] != 'H')
        fail("the product has no name");
    if (!set((struct setup) { 0x00, 9, 1, 0, 0 }))
        fail("the configuration is refused");
    if (!set((struct setup) { 0x21, 10, 0, 0, 0 }))
        fail("SET_IDLE is refused");
    report_descriptor_size
        = get((struct setup) { 0x81, 6, 0x2200, 0, sizeof report_descriptor }, report_descriptor);
    if (report_descriptor_size <= 0)
        fail("there is no report descriptor");
}

static void write_header(FILE *log)
{
    fprintf(log, "D: 0\nR: %d", report_descriptor_size);
    for (int i = 0; i < report_descriptor_size; ++i)
        fprintf(log, " %02x", report_descriptor[i]);
    fprintf(log, "\nN: tractus Height slider\nP: simavr/input0\nI: 3 1209 0001\n");
}

static void write_report(FILE *log, uint8_t const *bytes, uint32_t size)
{
    uint64_t const us = avr->cycle / (kClock_Hz / 1000000);
    fprintf(log, "E: %06u.%06u %u", (unsigned)(us / 1000000), (unsigned)(us % 1000000),
            (unsigned)size);
    for (uint32_t i = 0; i < size; ++i)
        fprintf(log, " %02x", bytes[i]);
    fprintf(log, "\n");
}

static void start(char const *firmware_file)
{
    elf_firmware_t firmware = { 0 };
    if (elf_read_firmware(firmware_file, &firmware) != 0)
        fail("there is no firmware");
    avr = avr_make_mcu_by_name("atmega32u4");
    if (!avr)
        fail("simavr does not know the chip");
    avr_init(avr);
    firmware.frequency = kClock_Hz;
    firmware.vcc = firmware.avcc = firmware.aref = kSupply_mV;
    avr_load_firmware(avr, &firmware);
    converter = avr_io_getirq(avr, AVR_IOCTL_ADC_GETIRQ, ADC_IRQ_ADC7);
    avr_irq_register_notify(avr_io_getirq(avr, AVR_IOCTL_ADC_GETIRQ, ADC_IRQ_OUT_TRIGGER), convert,
                            NULL);
}

int main(int argument_count, char **arguments)
{
    if (argument_count != 4) {
        fprintf(stderr, "usage: usb_host FIRMWARE.elf LOG CONVERSIONS\n");
        return 2;
    }
    FILE *const log = fopen(arguments[2], "w");
    conversions = fopen(arguments[3], "w");
    if (!log || !conversions)
        fail("cannot write");
    start(arguments[1]);
    enumerate();
    write_header(log);
    for (int i = 0; i < kReports;) {
        uint8_t bytes[8];
        uint32_t size = sizeof bytes;
        int const result = usb(AVR_IOCTL_USB_READ, 1, bytes, &size);
        if (result == AVR_IOCTL_USB_OK && size > 0) {
            write_report(log, bytes, size);
            ++i;
        }
        run_us(1000);
        if (conversion_count > 100 * kReports)
            fail("no reports come");
    }
    run_us(10000); // Runs until readings are complete whose conversions have already been fed.
    return fclose(log) == 0 && fclose(conversions) == 0 ? 0 : 1;
}
