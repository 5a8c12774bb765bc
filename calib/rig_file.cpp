#include "calib/rig_file.h"

#include "calib/calibration_record_file.h"
#include "calib/height_fit_range.h"
#include "calib/height_model_file.h"
#include "calib/toml_table.h"
#include "engine/base/file.h"

#include <cmath>
#include <fmt/core.h>
#include <limits>

namespace tractus::calib {

// Version 1 had no [calibration] table and no monotone models.
static constexpr std::int64_t kVersion = 2;
static constexpr std::string_view kSampleTimes = "sample_times";
static constexpr std::size_t kMaxBytes = std::size_t { 1 } << 20;

// Converts milliseconds, the unit of rig files, rounded to the nanosecond.
static Duration from_milliseconds(double milliseconds)
{
    return Duration(std::llround(milliseconds * 1e6));
}

static double to_milliseconds(Duration duration)
{
    return static_cast<double>(duration.count()) / 1e6;
}

static Result<Duration> duration_ms(TomlTable& table, std::string_view key, NumberRange range)
{
    constexpr double kLongest_ms = 60'000;
    double const milliseconds = TRY(table.number(key, range));
    if (milliseconds > kLongest_ms)
        return table.wrong(
            key, fmt::format("is {}, expected at most a minute ({})", milliseconds, kLongest_ms));
    return from_milliseconds(milliseconds);
}

// Limits of plausible values: a greater value in a file is a typing error.
static constexpr double kFarthestMark_mm = 10'000; // Greatest absolute height.
static constexpr double kMinSide_mm = 1;           // Least side of a tablet.
static constexpr double kMaxSide_mm = 5'000;       // Greatest side of a tablet.
static constexpr double kMaxRotation_deg = 360;
static constexpr double kMaxShear = 1; // Shear of a carriage that rises at 45 degrees.
static constexpr double kMaxExponent = 10;
static constexpr double kFarthestCoil_mm = 100;

static Result<void> check_within(TomlTable const& table, std::string_view key, double value,
                                 double least, double most)
{
    if (value >= least && value <= most)
        return {};
    return table.wrong(key, fmt::format("is {}, expected {} to {}", value, least, most));
}

static Result<void> parse_height(TomlTable& table, Rig& rig)
{
    rig.height_model = TRY(parse_height_model(table));

    auto const full_scale = TRY(table.integer("full_scale_counts", NumberRange::Positive));
    if (full_scale > std::numeric_limits<std::int32_t>::max())
        return table.wrong("full_scale_counts", "is too large, expected at most 32 bits");
    rig.full_scale_counts = static_cast<std::int32_t>(full_scale);

    auto const range = TRY(table.vec2("calibrated_counts"));
    if (!(range.x() < range.y()))
        return table.wrong("calibrated_counts", "is empty, expected [least, greatest]");
    for (double const counts : { range.x(), range.y() }) {
        auto const height = height_mm(rig.height_model, counts);
        if (!height)
            return table.wrong(
                "calibrated_counts",
                fmt::format("holds {}, where the model has no height: the string would "
                            "be shorter than its offset",
                            counts));
        if (!(std::abs(*height) <= kFarthestMark_mm))
            return table.wrong(
                "calibrated_counts",
                fmt::format("holds {}, where the model's height is {} mm: no carriage goes "
                            "beyond {} mm",
                            counts, *height, kFarthestMark_mm));
    }
    rig.calibrated_min_counts = range.x();
    rig.calibrated_max_counts = range.y();

    rig.height_latency = TRY(duration_ms(table, "latency_ms", NumberRange::NotNegative));
    if (table.has("max_age_ms"))
        rig.max_height_age = TRY(duration_ms(table, "max_age_ms", NumberRange::Positive));
    return table.refuse_unknown_keys();
}

static Result<Vec2> surface_mm(TomlTable& table)
{
    constexpr std::string_view kKey = "surface_mm";
    Vec2 const sides_mm = TRY(table.vec2(kKey, NumberRange::Positive));
    if (!is_tablet_area(sides_mm))
        return table.wrong(kKey,
                           fmt::format("is [{}, {}], expected sides of {} to {}", sides_mm.x(),
                                       sides_mm.y(), kMinSurfaceSide_mm, kMaxSurfaceSide_mm));
    return sides_mm;
}

static Result<void> parse_tablet(TomlTable& table, Rig& rig)
{
    rig.tablet_size_mm = TRY(table.vec2("size_mm", NumberRange::Positive));
    for (double const side_mm : rig.tablet_size_mm)
        TRY(check_within(table, "size_mm", side_mm, kMinSide_mm, kMaxSide_mm));
    if (table.has("surface_mm"))
        rig.tablet_size_mm = rig.surface_mm.emplace(TRY(surface_mm(table)));
    rig.tablet_latency = TRY(duration_ms(table, "latency_ms", NumberRange::NotNegative));
    rig.rotation_deg = TRY(table.number_or("rotation_deg", 0));
    TRY(check_within(table, "rotation_deg", rig.rotation_deg, -kMaxRotation_deg, kMaxRotation_deg));
    rig.travel_shear = TRY(table.vec2_or("travel_shear", Vec2::Zero()));
    for (double const shear : rig.travel_shear)
        TRY(check_within(table, "travel_shear", shear, -kMaxShear, kMaxShear));
    return table.refuse_unknown_keys();
}

static Result<void> parse_pressure(TomlTable& table, PressureResponse& pressure)
{
    pressure.threshold = TRY(table.number_or("pressure_threshold", 0, NumberRange::NotNegative));
    pressure.full = TRY(table.number_or("pressure_full", 1, NumberRange::Positive));
    pressure.exponent = TRY(table.number_or("pressure_exponent", 1, NumberRange::Positive));
    TRY(check_within(table, "pressure_exponent", pressure.exponent, 0, kMaxExponent));
    if (pressure.full > 1)
        return table.wrong("pressure_full",
                           fmt::format("is {}, expected at most 1", pressure.full));
    if (pressure.threshold >= pressure.full)
        return table.wrong("pressure_threshold",
                           fmt::format("is {}, expected less than pressure_full ({})",
                                       pressure.threshold, pressure.full));
    return {};
}

static Result<void> parse_pen(TomlTable& table, Rig& rig)
{
    TRY(parse_pressure(table, rig.pressure));
    rig.coil_height_mm = TRY(table.vec2_or("coil_height_mm", Vec2::Zero()));
    for (double const height_mm : rig.coil_height_mm)
        TRY(check_within(table, "coil_height_mm", height_mm, -kFarthestCoil_mm, kFarthestCoil_mm));
    if (table.has("nib"))
        rig.nib = static_cast<Nib>(TRY(table.word("nib", { "point", "side" })));
    return table.refuse_unknown_keys();
}

static Result<SampleTimes> parse_sample_times(TomlTable& root)
{
    return static_cast<SampleTimes>(TRY(root.word(kSampleTimes, { "as_arrived", "evened" })));
}

Result<Rig> parse_rig(std::string_view text, std::string const& file)
{
    auto root = TRY(TomlTable::parse(text, file));
    TRY(root.require_version(kVersion));
    Rig rig;
    if (root.has(kSampleTimes))
        rig.sample_times = TRY(parse_sample_times(root));
    auto height = TRY(root.table("height"));
    TRY(parse_height(height, rig));
    auto tablet = TRY(root.table("tablet"));
    TRY(parse_tablet(tablet, rig));
    if (root.has("pen")) {
        auto pen = TRY(root.table("pen"));
        TRY(parse_pen(pen, rig));
    }
    if (root.has("calibration")) {
        auto calibration = TRY(root.table("calibration"));
        rig.calibration = TRY(parse_calibration_record(calibration));
    }
    TRY(root.refuse_unknown_keys());
    return rig;
}

static std::string print_pen(Rig const& rig)
{
    auto const& pressure = rig.pressure;
    auto text = fmt::format(
        R"(
[pen]                         # Pressures are 0 to 1.
pressure_threshold = {}       # Ink begins above this pressure and ends at half of it; 0: ink wherever the pen touches.
pressure_full = {}            # This pressure gives the thickest ink.
pressure_exponent = {}        # Curve between the two pressures: above 1, ink stays thin for longer.
)",
        pressure.threshold, pressure.full, pressure.exponent);
    if (!rig.coil_height_mm.isZero(0))
        text += fmt::format(
            "coil_height_mm = [{}, {}]      # Distance from the nib up the pen to its "
            "coil, for tilt along x and along y.\n",
            rig.coil_height_mm.x(), rig.coil_height_mm.y());
    if (rig.nib == Nib::Side)
        text += "nib = \"side\"                  # The nib is broad: a tilted pen draws broad ink "
                "across its tilt.\n";
    return text;
}

static std::string print_surface(Rig const& rig)
{
    if (!rig.surface_mm)
        return {};
    return fmt::format("surface_mm = [{}, {}]         # Size of the active area, measured; the "
                       "tablet does not report it.\n",
                       rig.surface_mm->x(), rig.surface_mm->y());
}

static std::string print_sample_times(Rig const& rig)
{
    if (rig.sample_times == SampleTimes::AsArrived)
        return {};
    return fmt::format(
        "{} = \"evened\"       # Reports arrive in bursts: their times are spread evenly.\n",
        kSampleTimes);
}

std::string print_rig(Rig const& rig)
{
    return fmt::format(
               R"(# A rig: the calibration of one tractus. Lengths are in millimetres, times in milliseconds, angles in
# degrees; counts are readings of the height sensor's converter.
version = {}
{}
[height]
{}full_scale_counts = {}            # The converter's largest reading.
calibrated_counts = [{}, {}]  # Range of readings in which the model was fitted.
latency_ms = {}               # Time from a height to the arrival of its report.
max_age_ms = {}               # A reading older than this gives no height.

[tablet]
size_mm = [{}, {}]            # Width and depth of the active area.
{}latency_ms = {}               # Time from a pen position to the arrival of its report.
rotation_deg = {}             # Rotation of the tablet on its carriage, counterclockwise from above.
travel_shear = [{}, {}]       # Drift to the right and away from the user per millimetre of rise.
)",
               kVersion, print_sample_times(rig), print_height_model(rig.height_model),
               rig.full_scale_counts, rig.calibrated_min_counts, rig.calibrated_max_counts,
               to_milliseconds(rig.height_latency), to_milliseconds(rig.max_height_age),
               rig.tablet_size_mm.x(), rig.tablet_size_mm.y(), print_surface(rig),
               to_milliseconds(rig.tablet_latency), rig.rotation_deg, rig.travel_shear.x(),
               rig.travel_shear.y())
        + print_pen(rig) + print_calibration_record(rig.calibration);
}

Result<Rig> load_rig(std::filesystem::path const& path)
{
    return parse_rig(TRY(read_text_file(path, kMaxBytes)), path.string());
}

// Copies the existing file, if there is one, to its backup name.
static Result<void> keep_previous(std::filesystem::path const& path)
{
    std::error_code error;
    if (!std::filesystem::is_regular_file(path, error))
        return {};
    auto const bytes = TRY(read_file(path));
    auto backup = path;
    backup += ".bak";
    return write_file(backup, bytes);
}

// Checks that a printed text reads back as the same rig.
static Result<void> check_printed(std::string const& text, std::filesystem::path const& path)
{
    auto const again = parse_rig(text, path.string());
    if (!again)
        return fail(again.error().fault,
                    fmt::format("{} was not written, since nobody could read it: {}", path.string(),
                                again.error().message));
    return check_calibrated_range(*again);
}

Result<void> save_rig(Rig const& rig, std::filesystem::path const& path)
{
    auto const text = print_rig(rig);
    TRY(check_printed(text, path));
    TRY(keep_previous(path));
    return write_file(path, text);
}

} // namespace tractus::calib
