// Fuzzes what a tablet answers when it is opened: its USB strings, the reports that it refuses, and
// its report descriptor; and the reports that it sends afterwards. The tablet's ids are those of a
// known one, chosen by the first two bytes. Parts, each with a byte that is its length, follow:
// first the string descriptors that the program may ask for, in the order in which it asks, then
// the report descriptor, then reports. A third byte says by its bits which requests fail.

#include "drivers/tablets/mode_switch.h"
#include "drivers/tablets/pen_decoders.h"
#include "drivers/tablets/tablet_lookup.h"
#include "drivers/tablets/tablet_port.h"
#include "drivers/usb/string_descriptor.h"
#include "tests/fuzz/fuzz_input.h"
#include "tests/fuzz/pen_watch.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace {

using namespace tractus;

constexpr std::size_t kMaxStrings = 4; // The most that the program asks one tablet for.

std::span<std::byte const> take_bytes(FuzzInput& input)
{
    auto const length = std::min<std::size_t>(input.take_byte(), input.bytes().size());
    auto const bytes = input.bytes().first(length);
    input = { reinterpret_cast<std::uint8_t const*>(bytes.data()) + length,
              input.bytes().size() - length };
    return bytes;
}

// A tablet that answers with the input's bytes.
class FuzzPort final : public drivers::TabletPort {
public:
    FuzzPort(unsigned refusals, FuzzInput& input)
        : refusals_(refusals)
    {
        for (std::size_t i = 0; i < kMaxStrings; ++i)
            strings_.push_back(drivers::string_descriptor_text(take_bytes(input)));
    }

    Result<void> send_feature(std::span<std::byte const>) override { return take_report(); }
    Result<void> send_output(std::span<std::byte const>) override { return take_report(); }

    Result<std::string> read_string(int) override
    {
        if (fails_next())
            return fail(Fault::User, "it cannot be asked");
        return asked_ < strings_.size() ? strings_[asked_++] : std::string();
    }

private:
    bool fails_next()
    {
        bool const fails = (refusals_ & 1U) != 0;
        refusals_ >>= 1U;
        return fails;
    }

    Result<void> take_report()
    {
        return fails_next() ? fail(Fault::Device, "it does not take the report") : Result<void>();
    }

    unsigned refusals_;
    std::vector<std::string> strings_;
    std::size_t asked_ = 0;
};

drivers::TabletIdentifier const& identifier_of(unsigned number)
{
    static auto const all = [] {
        std::vector<drivers::TabletIdentifier const*> identifiers;
        for (auto const& tablet : drivers::known_tablets())
            for (auto const& identifier : tablet.identifiers)
                identifiers.push_back(&identifier);
        return identifiers;
    }();
    return *all[number % all.size()];
}

void decode_reports(drivers::PenDecoder& decoder, FuzzInput input)
{
    PenWatch watch;
    drivers::PenSilence silence;
    // The first time is above 0, because the first samples of a report get earlier times than the
    // report.
    Timestamp time { std::chrono::seconds(1) };
    while (!input.text().empty()) {
        time += std::chrono::milliseconds(5);
        if (auto const gone = silence.leave_after_silence(decoder, time))
            watch.see(*gone);
        std::vector<drivers::PenSample> samples;
        (void)decoder.decode(time, take_bytes(input), samples);
        for (auto const& sample : samples) {
            watch.see(sample);
            silence.heard(sample);
        }
    }
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(std::uint8_t const* data, std::size_t size)
{
    FuzzInput input(data, size);
    auto const low = input.take_byte();
    auto const& identifier = identifier_of(low + 256 * input.take_byte());
    auto const refusals = input.take_byte();
    drivers::DeviceInfo info { .name = "Tablet",
                               .interface_number = identifier.interface_number.value_or(-1),
                               .vendor_id = identifier.vendor_id,
                               .product_id = identifier.product_id };
    FuzzPort port(refusals, input);
    auto const descriptor = take_bytes(input);
    info.report_descriptor.assign(descriptor.begin(), descriptor.end());

    drivers::switch_to_full_mode(info, port, drivers::SwitchedBy::Nobody);
    constexpr std::size_t kMaxWarnings = 3;
    CHECK(info.warnings.size() <= kMaxWarnings);
    if (auto const match = drivers::find_tablet(info))
        CHECK(!drivers::tablet_name(*match).empty());
    auto const decoder = drivers::make_pen_decoder(info);
    if (!decoder) {
        CHECK(!decoder.error().message.empty());
        return 0;
    }
    CHECK(((*decoder)->traits().size_mm.array() > 0).all());
    decode_reports(**decoder, input);
    return 0;
}
