// Fuzzes report descriptors and the decoding of reports. The first byte is the size of a report,
// which is at the end of the input. The bytes between them are the report's descriptor.

#include "drivers/height_decoders.h"
#include "drivers/reports/height_decoder.h"
#include "drivers/tablets/pen_decoders.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

extern "C" int LLVMFuzzerTestOneInput(std::uint8_t const* data, std::size_t size)
{
    using namespace tractus;
    if (size == 0)
        return 0;
    auto const input = std::as_bytes(std::span(data, size)).subspan(1);
    auto const report_size = std::min<std::size_t>(data[0], input.size());
    auto const descriptor = input.first(input.size() - report_size);
    auto const report = input.last(report_size);

    drivers::DeviceInfo const info { .report_descriptor
                                     = { descriptor.begin(), descriptor.end() } };
    if (auto pen = drivers::make_pen_decoder(info))
        for (int i = 0; i < 2; ++i) { // Twice, because the decoder keeps state.
            std::vector<drivers::PenSample> samples;
            (void)(*pen)->decode({}, report, samples);
        }
    if (auto const height = drivers::make_height_decoder(info)) {
        std::vector<drivers::HeightSample> samples;
        (void)(*height)->decode({}, report, samples);
    }
    return 0;
}
