#include "slider.h"

bool slider_add(struct slider *slider, uint16_t conversion, uint8_t report[kSliderReportBytes])
{
    slider->sum += conversion;
    if (++slider->count < kSliderHalf)
        return false;
    bool const is_whole = slider->has_previous;
    uint16_t const reading = (uint16_t)(slider->previous + slider->sum) >> kSliderShift;
    slider->previous = slider->sum;
    slider->has_previous = true;
    slider->sum = 0;
    slider->count = 0;
    report[0] = kSliderReport;
    report[1] = reading & 0xff;
    report[2] = reading >> 8;
    return is_whole;
}
