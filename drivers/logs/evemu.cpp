#include "drivers/logs/foreign_log.h"
#include "drivers/logs/foreign_log_builder.h"
#include "drivers/logs/line_splitter.h"
#include "drivers/logs/log_line.h"
#include "drivers/reports/event_pen.h"

#include <fmt/core.h>
#include <linux/input-event-codes.h>
#include <map>
#include <optional>
#include <string>
#include <utility>

namespace tractus::drivers {

namespace {

// Reads the lines of an evemu recording (src/evemu.c in evemu). Each line's first letter is its
// kind.
class EvemuReader {
public:
    explicit EvemuReader(std::string_view name)
        : builder_(name)
    {
    }

    Result<void> take_line(std::string_view text)
    {
        ++line_;
        if (text.ends_with('\r'))
            text.remove_suffix(1);
        if (text.size() < 2 || text[1] != ':')
            return {};
        char const letter = text[0];
        LogLine line(text.substr(2));
        switch (letter) {
        case 'N':
            info_.name = line.rest();
            return {};
        case 'I':
            read_event_device_ids(line);
            return {};
        case 'B':
            read_event_bits(line);
            return {};
        case 'A':
            read_event_axis(line);
            return {};
        case 'E':
            return read_event(line);
        default:
            return {};
        }
    }

    Result<Log> take_log()
    {
        TRY(begin());
        return builder_.take();
    }

private:
    void read_event_device_ids(LogLine& line)
    {
        if (!line.integer(info_.bus, 16) || !line.integer(info_.vendor_id, 16)
            || !line.integer(info_.product_id, 16))
            builder_.warn(line_, "no bus, vendor and product id: skipped");
    }

    // Reads a line "B: 01 00 00 …": the next part of the bit set of event codes of one type, eight
    // codes to a byte.
    void read_event_bits(LogLine& line)
    {
        unsigned type = 0;
        unsigned bits = 0;
        if (!line.integer(type, 16))
            return builder_.warn(line_, "no type of events: skipped");
        auto& next = next_bit_[type];
        for (; line.integer(bits, 16) && next < KEY_CNT; next += 8)
            for (unsigned i = 0; i < 8; ++i)
                if (type == EV_KEY && (bits >> i & 1) != 0)
                    abilities_.keys.insert(static_cast<std::uint16_t>(next + i));
    }

    void read_event_axis(LogLine& line)
    {
        std::uint16_t code = 0;
        std::int32_t fuzz = 0;
        std::int32_t flat = 0;
        EventAxis axis;
        if (!line.integer(code, 16) || !line.integer(axis.minimum, 10)
            || !line.integer(axis.maximum, 10) || !line.integer(fuzz, 10) || !line.integer(flat, 10)
            || code >= ABS_CNT)
            return builder_.warn(line_, "not the range of an axis: skipped");
        line.integer(axis.resolution, 10); // Evemu 1.0 writes no resolution.
        abilities_.axes[code] = axis;
    }

    Result<void> read_event(LogLine& line)
    {
        TRY(begin());
        Timestamp time {};
        std::uint16_t type = 0;
        std::uint16_t code = 0;
        std::int32_t value = 0;
        if (!line.time(time) || !line.integer(type, 16) || !line.integer(code, 16)
            || !line.integer(value, 10)) {
            builder_.warn(line_, "not an event: skipped");
            return {};
        }
        if (auto const report = pen_->push(type, code, value); !report.empty())
            TRY(builder_.append_report(line_, 0, time, report));
        return {};
    }

    // Ends the description: checks that the device is a pen, and prepares to convert its events.
    Result<void> begin()
    {
        if (pen_)
            return {};
        if (!is_event_pen(abilities_))
            return fail(
                Fault::User,
                fmt::format("{}: its device \"{}\" is no pen: there is no place of two axes "
                            "with a stylus and a touch or pressure",
                            builder_.log().name, info_.name));
        info_.physical_path = event_pen_path("");
        info_.location = builder_.log().name;
        info_.report_descriptor = describe_event_pen(abilities_);
        pen_.emplace(abilities_);
        TRY(builder_.add_device(info_));
        return {};
    }

    ForeignLogBuilder builder_;
    DeviceInfo info_;
    EventAbilities abilities_;
    // Event type → code of the first bit on the type's next line.
    std::map<unsigned, unsigned> next_bit_;
    std::optional<EventPen> pen_; // Set when the first event has been read.
    std::size_t line_ = 0;
};

} // namespace

bool begins_evemu_recording(std::string_view line)
{
    constexpr std::string_view kHead = "# EVEMU ";
    if (line.starts_with(kHead))
        return true;
    // The oldest evemu recordings have no version line. Their I line has four ids, whereas the I
    // line of a hid-recorder file has three.
    LogLine words(line.starts_with("I:") ? line.substr(2) : std::string_view());
    unsigned id = 0;
    int count = 0;
    while (words.integer(id, 16))
        ++count;
    return count == 4;
}

Result<Log> parse_evemu(std::istream& in, std::string_view name)
{
    EvemuReader reader(name);
    TRY(feed_lines(in, name, [&](std::string_view line) { return reader.take_line(line); }));
    return reader.take_log();
}

} // namespace tractus::drivers
