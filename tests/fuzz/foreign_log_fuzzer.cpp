// Fuzzes recordings by other programs. The first byte chooses the program: usbhid-dump, libinput or
// evemu; the rest is the recording. What can be read must be a log, and its pen must be decodable
// without a fault.

#include "drivers/logs/foreign_log.h"
#include "drivers/tablets/pen_decoders.h"
#include "tests/fuzz/fuzz_input.h"
#include "tests/fuzz/log_round_trip.h"

#include <algorithm>
#include <sstream>
#include <string>
#include <vector>

static tractus::Result<tractus::drivers::Log> read_foreign_log(tractus::FuzzInput input)
{
    using namespace tractus::drivers;
    auto const program = input.take_byte() % 3;
    static_cast<void>(guess_log_format(input.text()));
    std::istringstream text { std::string(input.text()) };
    return program == 0 ? parse_usbhid_dump(text, "fuzz")
        : program == 1  ? parse_libinput_record(text, "fuzz")
                        : parse_evemu(text, "fuzz");
}

// True if no time goes back. In our own logs, a time that goes back begins another part.
static bool has_one_part(tractus::drivers::Log const& log)
{
    return std::is_sorted(log.records.begin(), log.records.end(),
                          [](auto const& one, auto const& other) { return one.time < other.time; });
}

extern "C" int LLVMFuzzerTestOneInput(std::uint8_t const* data, std::size_t size)
{
    using namespace tractus;
    auto const log = read_foreign_log({ data, size });
    if (!is_read(log))
        return 0;
    if (has_one_part(*log))
        check_log_round_trip(*log);
    for (std::size_t device = 0; device < log->devices.size(); ++device) {
        auto const decoder = drivers::make_pen_decoder(log->devices[device]);
        if (!decoder)
            continue;
        std::vector<drivers::PenSample> samples;
        for (auto const& record : log->records)
            if (record.device == device)
                (void)(*decoder)->decode(record.time, log->report(record), samples);
        CHECK(std::all_of(samples.begin(), samples.end(), [](drivers::PenSample const& sample) {
            return sample.position_mm.allFinite();
        }));
    }
    return 0;
}
