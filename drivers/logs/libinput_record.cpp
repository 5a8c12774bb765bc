#include "drivers/logs/foreign_log.h"
#include "drivers/logs/foreign_log_builder.h"
#include "drivers/logs/line_splitter.h"
#include "drivers/reports/event_pen.h"

#include <algorithm>
#include <charconv>
#include <fmt/core.h>
#include <linux/input-event-codes.h>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>
#include <yaml.h>

namespace tractus::drivers {

namespace {

// Feeds a stream to libyaml until a line is too long to be text.
class TextLines {
public:
    explicit TextLines(std::istream& in)
        : in_(in)
    {
    }

    bool has_too_long_line() const { return since_break_ > LineSplitter::kMaxLineBytes; }

    static int read(void* self, unsigned char* to, std::size_t most, std::size_t* size)
    {
        *size = static_cast<TextLines*>(self)->read_some(to, most);
        return 1;
    }

private:
    std::size_t read_some(unsigned char* to, std::size_t most)
    {
        in_.read(reinterpret_cast<char*>(to), static_cast<std::streamsize>(most));
        auto const size = static_cast<std::size_t>(in_.gcount());
        for (std::size_t i = 0; i < size && !has_too_long_line(); ++i)
            since_break_ = to[i] == '\n' ? 0 : since_break_ + 1;
        return has_too_long_line() ? 0 : size;
    }

    std::istream& in_;
    std::size_t since_break_ = 0;
};

Result<std::int64_t> number_in(std::string_view text)
{
    bool const is_hex = text.starts_with("0x") || text.starts_with("0X");
    auto const digits = is_hex ? text.substr(2) : text;
    auto const* const end = digits.data() + digits.size();
    std::int64_t value = 0;
    auto const [read, error] = std::from_chars(digits.data(), end, value, is_hex ? 16 : 10);
    if (error != std::errc() || read != end)
        return fail(Fault::User, fmt::format("\"{}\" is no whole number", text.substr(0, 40)));
    return value;
}

// The input events of the current device, used if it has no raw reports.
struct RecordedEvents {
    EventAbilities abilities {};
    std::optional<EventPen> pen {}; // Set when an event of a pen has been read.
    // Index in the log's devices; set when the device has sent an event.
    std::optional<std::size_t> device {};
    std::vector<std::int64_t> numbers {}; // Numbers of the list being read, in the file's order.
};

// Reads the recording value by value, so that only reports stay in memory.
class RecordReader {
public:
    explicit RecordReader(std::string_view name)
        : builder_(name)
    {
    }

    // Handles one YAML event. Fails if it cannot belong to a recording; the caller adds the place
    // to the message.
    Result<void> take_event(yaml_event_t const& event)
    {
        line_ = event.start_mark.line + 1;
        switch (event.type) {
        case YAML_SCALAR_EVENT:
            return take_scalar({ reinterpret_cast<char const*>(event.data.scalar.value),
                                 event.data.scalar.length });
        case YAML_ALIAS_EVENT:
            return take_scalar("");
        case YAML_SEQUENCE_START_EVENT:
            return open(Level::Kind::List);
        case YAML_MAPPING_START_EVENT:
            return open(Level::Kind::Map);
        case YAML_SEQUENCE_END_EVENT:
        case YAML_MAPPING_END_EVENT:
            return close();
        default:
            return {};
        }
    }

    Log take()
    {
        remove_seen_twice();
        return builder_.take();
    }

private:
    // An open list or map.
    struct Level {
        enum class Kind { List, Map } kind = Kind::List;
        std::string key {}; // In a map, the key of the next value. Empty in a list.
        bool has_key = false;
    };

    Result<void> open(Level::Kind kind)
    {
        if (levels_.size() == kMaxLevels)
            return fail(Fault::User, "lists in lists without end");
        if (!levels_.empty() && levels_.back().kind == Level::Kind::Map && !levels_.back().has_key)
            return fail(Fault::User, "a list or a map in place of a name");
        levels_.push_back({ kind });
        if (is_at({ "devices", "", "events", "", "hid" }))
            report_line_ = line_;
        return {};
    }

    Result<void> close()
    {
        if (is_at({ "devices", "", "events", "", "hid" }))
            TRY(end_report());
        else if (is_at({ "devices", "", "events", "", "evdev", "" }))
            TRY(end_input_event());
        else if (is_in_map_of({ "devices", "", "evdev", "codes" }))
            TRY(end_codes(levels_[4].key));
        else if (is_in_map_of({ "devices", "", "evdev", "absinfo" }))
            TRY(end_axis(levels_[4].key));
        else if (is_at({ "devices", "" }))
            end_device();
        levels_.pop_back();
        end_value();
        return {};
    }

    void end_value()
    {
        if (!levels_.empty())
            levels_.back().has_key = false;
    }

    // True if `path` leads to the innermost list or map. It consists of the keys of the maps around
    // it, from the outside inwards, with "" for each list around it.
    bool is_at(std::initializer_list<std::string_view> path) const
    {
        if (levels_.size() != path.size() + 1)
            return false;
        auto level = levels_.begin();
        for (auto const key : path) {
            bool const is_list = level->kind == Level::Kind::List;
            if (is_list != key.empty() || (!is_list && level->key != key))
                return false;
            ++level;
        }
        return true;
    }

    // True if the innermost list is a value, under any key, of the map to which `path` leads.
    bool is_in_map_of(std::initializer_list<std::string_view> path) const
    {
        auto const depth = path.size() + 1;
        return levels_.size() == depth + 1 && levels_[depth - 1].kind == Level::Kind::Map
            && std::equal(path.begin(), path.end(), levels_.begin(),
                          [](std::string_view key, Level const& level) {
                              return (level.kind == Level::Kind::List) == key.empty()
                                  && (key.empty() || level.key == key);
                          });
    }

    Result<void> take_scalar(std::string_view value)
    {
        if (levels_.empty())
            return {};
        auto& level = levels_.back();
        if (level.kind == Level::Kind::Map && !level.has_key) {
            level.key = value;
            level.has_key = true;
            return {};
        }
        TRY(take_value(level, value));
        end_value();
        return {};
    }

    Result<void> take_value(Level const& level, std::string_view value)
    {
        if (is_at({ "devices", "" }) && level.key == "node")
            info_.location = fmt::format("{}:{}", builder_.log().name, value);
        else if (is_at({ "devices", "", "evdev" }) && level.key == "name")
            info_.name = value;
        else if (is_at({ "devices", "", "evdev", "id" }))
            return append(ids_, value, 3, 0xffff);
        else if (is_at({ "devices", "", "hid" }))
            return append(info_.report_descriptor, value, kMaxDescriptorBytes, 0xff);
        else if (is_at({ "devices", "", "events", "", "hid", "time" }))
            return append(time_, value, 2, kMaxSeconds);
        else if (levels_.size() == 7 && levels_[5].key.starts_with("hidraw")
                 && is_at({ "devices", "", "events", "", "hid", levels_[5].key }))
            return append(reports_[levels_[5].key], value, kMaxBlockBytes, 0xff);
        else if (is_at({ "devices", "", "events", "", "evdev", "" })
                 || is_in_map_of({ "devices", "", "evdev", "codes" })
                 || is_in_map_of({ "devices", "", "evdev", "absinfo" }))
            return append(events_.numbers, value, KEY_CNT, kMaxSeconds, -kMaxSeconds);
        return {};
    }

    // Appends a number to a list. Values beyond the `most` first ones are ignored.
    template<typename Value>
    static Result<void> append(std::vector<Value>& values, std::string_view text, std::size_t most,
                               std::int64_t largest, std::int64_t least = 0)
    {
        auto const number = TRY(number_in(text));
        if (number < least || number > largest)
            return fail(Fault::User, fmt::format("{} is not in {} to {}", number, least, largest));
        if (values.size() < most)
            values.push_back(static_cast<Value>(number));
        return {};
    }

    // Ends an event that carries raw reports. A hidraw node's reports are listed under one of the
    // input devices that it feeds.
    Result<void> end_report()
    {
        time_.resize(2);
        auto const when = timestamp_ns((time_[0] * 1'000'000 + time_[1]) * 1000);
        for (auto const& [node, bytes] : reports_) {
            auto found = nodes_.find(node);
            if (found == nodes_.end())
                found = nodes_.emplace(node, TRY(builder_.add_device({}))).first;
            TRY(builder_.append_report(report_line_, found->second, when, bytes));
        }
        reports_.clear();
        time_.clear();
        return {};
    }

    // Reads "1: [320, 330]": an event type, and the codes of that type that the device has.
    Result<void> end_codes(std::string const& type)
    {
        auto const codes = std::exchange(events_.numbers, {});
        if (TRY(number_in(type)) == EV_KEY)
            for (auto const code : codes)
                events_.abilities.keys.insert(static_cast<std::uint16_t>(code));
        return {};
    }

    // Reads "0: [0, 15200, 4, 0, 100]": an axis, and its minimum, maximum, fuzz, flat and
    // resolution.
    Result<void> end_axis(std::string const& code)
    {
        auto numbers = std::exchange(events_.numbers, {});
        numbers.resize(5);
        auto const value = [&](std::size_t i) { return saturated(numbers[i]); };
        events_.abilities.axes[static_cast<std::uint16_t>(TRY(number_in(code)))]
            = { .minimum = value(0), .maximum = value(1), .resolution = value(4) };
        return {};
    }

    static std::int32_t saturated(std::int64_t number)
    {
        using Limits = std::numeric_limits<std::int32_t>;
        return static_cast<std::int32_t>(
            std::clamp<std::int64_t>(number, Limits::min(), Limits::max()));
    }

    // Reads "[0, 1250, 3, 0, 12]": seconds, microseconds, type, code and value.
    Result<void> end_input_event()
    {
        constexpr std::size_t kEventNumbers = 5;
        auto const numbers = std::exchange(events_.numbers, {});
        if (numbers.size() != kEventNumbers || numbers[0] < 0 || numbers[1] < 0)
            return fail(Fault::User,
                        "an input event is not five numbers: seconds, microseconds, "
                        "type, code and value");
        if (!nodes_.empty() || !is_event_pen(events_.abilities))
            return {};
        if (!events_.pen)
            events_.pen.emplace(events_.abilities);
        auto const when = timestamp_ns((numbers[0] * 1'000'000 + numbers[1]) * 1000);
        auto const report
            = events_.pen->push(static_cast<std::uint16_t>(numbers[2]),
                                static_cast<std::uint16_t>(numbers[3]), saturated(numbers[4]));
        if (report.empty())
            return {};
        if (!events_.device)
            events_.device = TRY(builder_.add_device({}));
        return builder_.append_report(line_, *events_.device, when, report);
    }

    void end_device()
    {
        ids_.resize(3);
        info_.bus = ids_[0];
        info_.vendor_id = ids_[1];
        info_.product_id = ids_[2];
        for (auto const& [node, device] : nodes_)
            builder_.log().devices[device] = info_;
        if (events_.device) {
            info_.report_descriptor = describe_event_pen(events_.abilities);
            info_.physical_path = event_pen_path("");
            builder_.log().devices[*events_.device] = info_;
        }
        nodes_.clear();
        ids_.clear();
        info_ = {};
        events_ = {};
    }

    // Removes pens made of input events if raw reports of the same device exist. A hidraw node
    // feeds several input devices, so the raw reports may be listed under another one than the
    // events.
    void remove_seen_twice()
    {
        auto const& devices = builder_.log().devices;
        for (auto i = devices.size(); i-- > 0;)
            if (has_event_pen_reports(devices[i])
                && std::ranges::any_of(devices, [&](DeviceInfo const& other) {
                       return !has_event_pen_reports(other) && other.bus == devices[i].bus
                           && other.vendor_id == devices[i].vendor_id
                           && other.product_id == devices[i].product_id;
                   }))
                builder_.remove_device(i);
    }

    static constexpr std::size_t kMaxLevels = 100;
    static constexpr std::size_t kMaxDescriptorBytes = 4096; // HID_MAX_DESCRIPTOR_SIZE of Linux.
    static constexpr std::size_t kMaxBlockBytes = std::size_t { 1 } << 16;
    static constexpr std::int64_t kMaxSeconds = 9'000'000'000;

    RecordedEvents events_;
    ForeignLogBuilder builder_;
    std::vector<Level> levels_;
    DeviceInfo info_; // The device being read.
    std::vector<std::uint16_t> ids_;
    // The device's hidraw nodes → indices in the log's devices.
    std::map<std::string, std::size_t> nodes_;
    std::vector<std::int64_t> time_; // Time of the report being read: seconds, microseconds.
    std::map<std::string, std::vector<std::byte>> reports_;
    std::size_t line_ = 0; // Line of the YAML event being handled.
    std::size_t report_line_ = 0;
};

} // namespace

Result<Log> parse_libinput_record(std::istream& in, std::string_view name)
{
    RecordReader reader(name);
    TextLines lines(in);
    yaml_parser_t parser;
    if (yaml_parser_initialize(&parser) == 0)
        return fail(Fault::Station, "not enough memory to read YAML");
    std::unique_ptr<yaml_parser_t, void (*)(yaml_parser_t*)> const cleared(&parser,
                                                                           yaml_parser_delete);
    yaml_parser_set_input(&parser, TextLines::read, &lines);
    for (bool goes_on = true; goes_on;) {
        yaml_event_t event;
        bool const is_yaml = yaml_parser_parse(&parser, &event) != 0;
        if (lines.has_too_long_line())
            return fail(Fault::User,
                        fmt::format("{} has a line of more than {} bytes: this is no log", name,
                                    LineSplitter::kMaxLineBytes));
        auto const taken = is_yaml
            ? reader.take_event(event)
            : fail(Fault::User, parser.problem ? parser.problem : "it is not YAML");
        auto const line = (is_yaml ? event.start_mark : parser.problem_mark).line + 1;
        goes_on = is_yaml && event.type != YAML_DOCUMENT_END_EVENT
            && event.type != YAML_STREAM_END_EVENT;
        if (is_yaml)
            yaml_event_delete(&event);
        if (!taken)
            return fail(Fault::User,
                        fmt::format("{}:{}: not a recording by libinput record: {}", name, line,
                                    taken.error().message));
    }
    auto log = reader.take();
    if (log.devices.empty())
        return fail(Fault::User,
                    fmt::format("{} has no raw reports, and no input events of a pen: record it "
                                "with \"libinput record --with-hidraw\"",
                                name));
    return log;
}

} // namespace tractus::drivers
