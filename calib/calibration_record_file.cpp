#include "calib/calibration_record_file.h"

#include "calib/height_fit.h"

#include <cmath>
#include <fmt/core.h>
#include <fmt/ranges.h>
#include <sstream>

namespace tractus::calib {

namespace {

using From = HeightCapture::From;

// Words in the order of HeightCapture::From.
std::vector<std::string_view> const kFroms { "nowhere", "below", "above" };
std::vector<std::string_view> const kKinds { "linear", "string", "monotone" };

// Returns a text as a quoted TOML string.
std::string quoted(std::string const& text)
{
    std::ostringstream out;
    out << toml::value(text);
    return out.str();
}

Result<std::size_t> whole(TomlTable& table, std::string_view key)
{
    return static_cast<std::size_t>(TRY(table.integer(key, NumberRange::NotNegative)));
}

Result<HeightCapture> parse_capture(TomlTable& table)
{
    HeightCapture capture;
    capture.ruler_mm = TRY(table.number("ruler_mm"));
    capture.counts = TRY(table.number("counts"));
    capture.noise_counts = TRY(table.number("noise_counts", NumberRange::NotNegative));
    capture.readings = TRY(whole(table, "readings"));
    capture.from = static_cast<From>(TRY(table.word("from", kFroms)));
    for (double const tally : TRY(table.number_list("scatter")))
        capture.scatter.push_back(static_cast<int>(std::clamp(tally, 0.0, 1e9)));
    TRY(table.refuse_unknown_keys());
    return capture;
}

// Parses the indices of slipped captures, which are counted from 1 in the file.
Result<std::vector<std::size_t>> parse_slipped(TomlTable& table, std::size_t captures)
{
    std::vector<std::size_t> slipped;
    for (double const number : TRY(table.number_list("slipped"))) {
        if (!(number >= 1 && number <= static_cast<double>(captures)
              && number == std::floor(number)))
            return table.wrong(
                "slipped",
                fmt::format("has {}, expected numbers of captures, 1 to {}", number, captures));
        slipped.push_back(static_cast<std::size_t>(number) - 1);
    }
    return slipped;
}

Result<HeightRecord> parse_height(TomlTable& table)
{
    HeightRecord record { .date = TRY(table.text("date")) };
    record.sensor = { .name = TRY(table.text("sensor")),
                      .id = TRY(table.text("sensor_id")),
                      .serial = TRY(table.text("sensor_serial")) };
    record.reason = TRY(table.text("reason"));
    record.errors = TRY(table.number_list("errors"));
    record.rms_mm = TRY(table.number("rms_mm", NumberRange::NotNegative));
    record.max_mm = TRY(table.number("max_mm", NumberRange::NotNegative));
    record.heights_mm = TRY(table.vec2("heights_mm"));
    record.mm_per_count = TRY(table.vec2("mm_per_count", NumberRange::NotNegative));
    record.noise_counts = TRY(table.number("noise_counts", NumberRange::NotNegative));
    if (table.has("hysteresis_mm"))
        record.hysteresis_mm = TRY(table.vec2("hysteresis_mm"));
    record.raised_mm = TRY(table.number("raised_mm"));
    if (table.has("shifted_counts"))
        record.shifted_counts = TRY(table.number("shifted_counts"));
    record.ruler_error_mm = TRY(table.number("ruler_error_mm", NumberRange::Positive));
    if (table.has("linearity_percent"))
        record.linearity_percent = TRY(table.number("linearity_percent", NumberRange::NotNegative));
    if (table.has("asked_model"))
        record.requested_kind
            = static_cast<HeightModelKind>(TRY(table.word("asked_model", kKinds)));
    for (auto& capture : TRY(table.tables("captures")))
        record.captures.push_back(TRY(parse_capture(capture)));
    record.slipped = TRY(parse_slipped(table, record.captures.size()));
    TRY(table.refuse_unknown_keys());
    return record;
}

Result<TravelRecord> parse_travel(TomlTable& table)
{
    TravelRecord record { .date = TRY(table.text("date")) };
    record.shear_error = TRY(table.vec2("shear_error", NumberRange::NotNegative));
    record.tilt_deg = TRY(table.number("tilt_deg"));
    record.tilt_error_deg = TRY(table.number("tilt_error_deg", NumberRange::NotNegative));
    record.rise_mm = TRY(table.number("rise_mm"));
    record.rms_mm = TRY(table.number("rms_mm", NumberRange::NotNegative));
    record.touches = TRY(whole(table, "touches"));
    TRY(table.refuse_unknown_keys());
    return record;
}

Result<LatencyRecord> parse_latency(TomlTable& table)
{
    LatencyRecord record { .date = TRY(table.text("date")) };
    record.delay_ms = TRY(table.number("delay_ms"));
    record.error_ms = TRY(table.number("error_ms", NumberRange::NotNegative));
    record.correlation = TRY(table.number("correlation"));
    record.rms_mm = TRY(table.number("rms_mm", NumberRange::NotNegative));
    record.touches = TRY(whole(table, "touches"));
    if (table.has("direction_mm"))
        record.direction_mm = TRY(table.vec2("direction_mm"));
    TRY(table.refuse_unknown_keys());
    return record;
}

Result<TiltRecord> parse_tilt(TomlTable& table)
{
    TiltRecord record { .date = TRY(table.text("date")) };
    record.coil_height_mm = TRY(table.vec2("coil_height_mm"));
    record.coil_height_error_mm = TRY(table.vec2("coil_height_error_mm", NumberRange::NotNegative));
    record.min_tilt_deg = TRY(table.vec2("least_tilt_deg"));
    record.most_tilt_deg = TRY(table.vec2("most_tilt_deg"));
    record.rms_mm = TRY(table.number("rms_mm", NumberRange::NotNegative));
    record.touches = TRY(whole(table, "touches"));
    TRY(table.refuse_unknown_keys());
    return record;
}

Result<CheckRecord> parse_check(TomlTable& table)
{
    CheckRecord record { .date = TRY(table.text("date")) };
    record.within_mm = TRY(table.number("within_mm", NumberRange::NotNegative));
    record.heights_mm = TRY(table.number_list("heights_mm"));
    record.errors_mm = TRY(table.number_list("errors_mm"));
    TRY(table.refuse_unknown_keys());
    return record;
}

std::string print_capture(HeightCapture const& capture)
{
    return fmt::format("    {{ ruler_mm = {}, counts = {}, noise_counts = {}, readings = {}, "
                       "from = \"{}\", scatter = [{}] }},\n",
                       capture.ruler_mm, capture.counts, capture.noise_counts, capture.readings,
                       kFroms[static_cast<std::size_t>(capture.from)],
                       fmt::join(capture.scatter, ", "));
}

std::string print(HeightRecord const& record)
{
    auto text
        = fmt::format(R"(
[calibration.height]
date = {}
sensor = {}
sensor_id = {}  # The height sensor's bus, vendor and product.
sensor_serial = {}
reason = {}
)",
                      quoted(record.date), quoted(record.sensor.name), quoted(record.sensor.id),
                      quoted(record.sensor.serial), quoted(record.reason));
    text += fmt::format(
        R"(errors = [{}]  # Standard errors of the model's parameters, in their order.
rms_mm = {}                   # Root mean square of ruler minus model, without slipped captures.
max_mm = {}                   # Largest difference between ruler and model.
heights_mm = [{}, {}]         # The calibrated range of heights.
mm_per_count = [{}, {}]       # Height per count at the two ends of the range.
noise_counts = {}             # Standard deviation of readings at rest.
)",
        fmt::join(record.errors, ", "), record.rms_mm, record.max_mm, record.heights_mm.x(),
        record.heights_mm.y(), record.mm_per_count.x(), record.mm_per_count.y(),
        record.noise_counts);
    if (record.hysteresis_mm)
        text += fmt::format("hysteresis_mm = [{}, {}]  # Height from below minus height from "
                            "above; its standard error.\n",
                            record.hysteresis_mm->x(), record.hysteresis_mm->y());
    text += fmt::format(
        "raised_mm = {}                # Shift of all heights by zeroing again since then.\n"
        "ruler_error_mm = {}           # Standard deviation of the ruler.\n",
        record.raised_mm, record.ruler_error_mm);
    if (record.linearity_percent != 0)
        text += fmt::format(
            "linearity_percent = {}        # The potentiometer's linearity, from its data sheet.\n",
            record.linearity_percent);
    if (record.shifted_counts != 0)
        text += fmt::format("shifted_counts = {}           # Shift of all readings since then, "
                            "because the string slipped.\n",
                            record.shifted_counts);
    if (record.requested_kind)
        text += fmt::format("asked_model = \"{}\"\n", name_of(*record.requested_kind));
    auto slipped = record.slipped;
    for (auto& index : slipped)
        ++index;
    text += fmt::format("slipped = [{}]  # Captures that the fit left out, counted from 1.\n"
                        "captures = [\n",
                        fmt::join(slipped, ", "));
    for (auto const& capture : record.captures)
        text += print_capture(capture);
    return text + "]\n";
}

std::string print(TravelRecord const& record)
{
    return fmt::format(R"(
[calibration.travel]          # Measurement of tablet.travel_shear.
date = {}
shear_error = [{}, {}]
tilt_deg = {}                 # Angle between the carriage's track and the tablet's normal.
tilt_error_deg = {}
rise_mm = {}
rms_mm = {}                   # Root mean square distance of the pen from the straight edge.
touches = {}
)",
                       quoted(record.date), record.shear_error.x(), record.shear_error.y(),
                       record.tilt_deg, record.tilt_error_deg, record.rise_mm, record.rms_mm,
                       record.touches);
}

std::string print(LatencyRecord const& record)
{
    auto text = fmt::format(R"(
[calibration.latency]         # Measurement of tablet.latency_ms minus height.latency_ms.
date = {}
delay_ms = {}
error_ms = {}
correlation = {}              # Correlation between pen position and height.
rms_mm = {}                   # Root mean square distance of the pen from the straight edge.
touches = {}
)",
                            quoted(record.date), record.delay_ms, record.error_ms,
                            record.correlation, record.rms_mm, record.touches);
    if (record.direction_mm)
        text += fmt::format(
            "direction_mm = [{}, {}]  # Pen position on the way up minus that on the "
            "way down; its standard error.\n",
            record.direction_mm->x(), record.direction_mm->y());
    return text;
}

std::string print(TiltRecord const& record)
{
    return fmt::format(R"(
[calibration.tilt]            # Measurement of pen.coil_height_mm.
date = {}
coil_height_mm = [{}, {}]
coil_height_error_mm = [{}, {}]
least_tilt_deg = [{}, {}]     # Smallest tilt of the pen towards +x and +y.
most_tilt_deg = [{}, {}]
rms_mm = {}                   # Root mean square distance of the nib from its mean place.
touches = {}
)",
                       quoted(record.date), record.coil_height_mm.x(), record.coil_height_mm.y(),
                       record.coil_height_error_mm.x(), record.coil_height_error_mm.y(),
                       record.min_tilt_deg.x(), record.min_tilt_deg.y(), record.most_tilt_deg.x(),
                       record.most_tilt_deg.y(), record.rms_mm, record.touches);
}

std::string print(CheckRecord const& record)
{
    return fmt::format(R"(
[calibration.check]
date = {}
within_mm = {}
heights_mm = [{}]  # Heights measured with the ruler.
errors_mm = [{}]   # The rig's height minus the ruler's.
)",
                       quoted(record.date), record.within_mm, fmt::join(record.heights_mm, ", "),
                       fmt::join(record.errors_mm, ", "));
}

// Parses the table `key` if it exists.
template<typename Record>
Result<std::optional<Record>> parse_optional(TomlTable& table, std::string_view key,
                                             Result<Record> (*parse)(TomlTable&))
{
    if (!table.has(key))
        return std::optional<Record>();
    auto part = TRY(table.table(key));
    return std::optional<Record>(TRY(parse(part)));
}

} // namespace

Result<CalibrationRecord> parse_calibration_record(TomlTable& table)
{
    CalibrationRecord record;
    record.height = TRY(parse_optional(table, "height", parse_height));
    record.travel = TRY(parse_optional(table, "travel", parse_travel));
    record.latency = TRY(parse_optional(table, "latency", parse_latency));
    record.tilt = TRY(parse_optional(table, "tilt", parse_tilt));
    record.check = TRY(parse_optional(table, "check", parse_check));
    TRY(table.refuse_unknown_keys());
    return record;
}

std::string print_calibration_record(CalibrationRecord const& record)
{
    std::string text;
    if (record.height)
        text += print(*record.height);
    if (record.travel)
        text += print(*record.travel);
    if (record.latency)
        text += print(*record.latency);
    if (record.tilt)
        text += print(*record.tilt);
    if (record.check)
        text += print(*record.check);
    return text;
}

} // namespace tractus::calib
