// The height sensor of ../height-sensor.md on an ATmega32U4, with the potentiometer's ends at 5 V
// and GND, and its wiper at A0 (PF7, ADC7).

#include "slider.h"
#include "usb.h"

#include <avr/interrupt.h>
#include <avr/io.h>
#include <string.h>
#include <util/atomic.h>

// Written by the interrupt, read by the main loop.
static uint8_t fresh_report[kSliderReportBytes];
static volatile bool is_fresh;

ISR(ADC_vect)
{
    static struct slider slider;
    if (slider_add(&slider, ADC, fresh_report))
        is_fresh = true;
}

// Starts 9,615 conversions a second: 16 MHz / 128 is the fastest converter clock that the data
// sheet allows for all ten bits, and a conversion takes 13 cycles. This gives 300 readings a
// second.
static void start_converter(void)
{
    DIDR0 = 1 << ADC7D; // Disables the digital input at the pin.
    ADMUX = 1 << REFS0 | 7; // Reference is the supply, as for the potentiometer; input is ADC7.
    ADCSRB = 0; // Selects free-running conversions.
    ADCSRA = 1 << ADEN | 1 << ADATE | 1 << ADIE | 1 << ADPS2 | 1 << ADPS1 | 1 << ADPS0;
    ADCSRA |= 1 << ADSC;
}

static bool take_report(uint8_t report[kSliderReportBytes])
{
    bool taken = false;
    ATOMIC_BLOCK(ATOMIC_RESTORESTATE)
    {
        taken = is_fresh;
        if (taken)
            memcpy(report, fresh_report, kSliderReportBytes);
        is_fresh = false;
    }
    return taken;
}

int main(void)
{
    static uint8_t report[kSliderReportBytes] = { kSliderReport };
    CLKPR = 1 << CLKPCE; // Selects the full 16 MHz, whatever the fuses are.
    CLKPR = 0;
    usb_start();
    start_converter();
    sei();
    for (;;) {
        usb_serve(report, kSliderReportBytes);
        if (take_report(report))
            usb_send(report, kSliderReportBytes);
    }
}
