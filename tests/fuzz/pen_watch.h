#pragma once

#include "drivers/reports/pen_sample.h"
#include "engine/base/check.h"

namespace tractus {

// Checks that a decoder's samples describe one consistent pen.
class PenWatch {
public:
    void see(drivers::PenSample const& sample)
    {
        CHECK(sample.position_mm.allFinite());
        CHECK(sample.in_range || (!sample.touching && sample.buttons == 0));
        CHECK(sample.in_range || last_.in_range); // A pen that is away must give no samples.
        CHECK(!(sample.in_range && last_.in_range && sample.eraser != last_.eraser));
        CHECK(sample.in_range || sample.position_mm == last_.position_mm);
        CHECK(!sample.pressure || (*sample.pressure >= 0 && *sample.pressure <= 1));
        CHECK(sample.time >= last_.time);
        last_ = sample;
    }

private:
    drivers::PenSample last_;
};

} // namespace tractus
