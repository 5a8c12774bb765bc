// Fuzzes the decoders of makers' own formats. The first byte chooses a format; the rest are
// reports. Each report follows a byte, whose lower seven bits are the report's length and whose
// highest bit says whether the pen was silent before. For any input, the samples must describe one
// consistent pen.

#include "drivers/pens/family_decoder.h"
#include "tests/fuzz/pen_watch.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

extern "C" int LLVMFuzzerTestOneInput(std::uint8_t const* data, std::size_t size)
{
    using namespace tractus;
    if (size == 0)
        return 0;
    auto const families = drivers::pen_families();
    auto const decoder = drivers::make_family_decoder(families[data[0] % families.size()],
                                                      { .size_mm = { 254, 158.75 },
                                                        .x_maximum = 50'800,
                                                        .y_maximum = 31'750,
                                                        .pressure_maximum = 8191 });
    auto rest = std::as_bytes(std::span(data, size)).subspan(1);
    PenWatch watch;
    drivers::PenSilence silence;
    // The first time is above 0, because the first samples of a report get earlier times than the
    // report.
    Timestamp time { std::chrono::seconds(1) };
    while (!rest.empty()) {
        auto const header = std::to_integer<unsigned>(rest[0]);
        auto const length = std::min<std::size_t>(header & 0x7F, rest.size() - 1);
        time += std::chrono::milliseconds(header & 0x80 ? 150 : 5);
        if (auto const gone = silence.leave_after_silence(*decoder, time))
            watch.see(*gone);
        std::vector<drivers::PenSample> samples;
        (void)decoder->decode(time, rest.subspan(1, length), samples);
        for (auto const& sample : samples) {
            watch.see(sample);
            silence.heard(sample);
        }
        rest = rest.subspan(1 + length);
    }
    return 0;
}
