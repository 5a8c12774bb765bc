#include "calib/rig_file.h"

#include "engine/base/random.h"

#include <filesystem>
#include <gtest/gtest.h>

namespace tractus::calib {
namespace {

using namespace std::chrono_literals;

constexpr std::string_view kText = R"(version = 1
[height]
model = "string"
mm_per_count = 0.1
zero_length_mm = 120
offset_mm = 110
base_mm = 80
full_scale_counts = 4095
calibrated_counts = [150, 3900]
latency_ms = 3.5
[tablet]
size_mm = [254, 158.75]
latency_ms = 8
)";

// Returns kText followed by more text.
std::string text_with(std::string_view more)
{
    std::string text(kText);
    return text.append(more);
}

// Returns kText with the first occurrence of `from` replaced.
std::string with(std::string_view from, std::string_view to)
{
    std::string text(kText);
    auto const place = text.find(from);
    EXPECT_NE(place, std::string::npos) << from;
    return text.replace(place, from.size(), to);
}

std::string error_of(std::string const& text)
{
    auto const rig = parse_rig(text, "my.rig.toml");
    if (rig)
        return "no error";
    EXPECT_EQ(rig.error().fault, Fault::User);
    return rig.error().message;
}

TEST(RigFile, ReadsARig)
{
    auto const rig = parse_rig(kText, "my.rig.toml").value();
    auto const& model = std::get<StringHeight>(rig.height_model);
    EXPECT_EQ(model.mm_per_count, 0.1);
    EXPECT_EQ(model.zero_length_mm, 120);
    EXPECT_EQ(model.offset_mm, 110);
    EXPECT_EQ(model.base_mm, 80);
    EXPECT_EQ(rig.full_scale_counts, 4095);
    EXPECT_EQ(rig.calibrated_min_counts, 150);
    EXPECT_EQ(rig.calibrated_max_counts, 3900);
    EXPECT_EQ(rig.height_latency, 3500us);
    EXPECT_EQ(rig.tablet_size_mm, Vec2(254, 158.75));
    EXPECT_EQ(rig.tablet_latency, 8ms);
}

TEST(RigFile, FillsInWhatMayBeLeftOut)
{
    auto const rig = parse_rig(kText, "my.rig.toml").value();
    EXPECT_EQ(rig.rotation_deg, 0);
    EXPECT_EQ(rig.travel_shear, Vec2(0, 0));
    EXPECT_EQ(rig.max_height_age, 50ms);
}

void expect_same(Rig const& a, Rig const& b)
{
    EXPECT_EQ(print_rig(a), print_rig(b));
    EXPECT_EQ(a.height_model.index(), b.height_model.index());
    EXPECT_EQ(a.full_scale_counts, b.full_scale_counts);
    EXPECT_EQ(a.calibrated_min_counts, b.calibrated_min_counts);
    EXPECT_EQ(a.calibrated_max_counts, b.calibrated_max_counts);
    EXPECT_EQ(a.height_latency, b.height_latency);
    EXPECT_EQ(a.max_height_age, b.max_height_age);
    EXPECT_EQ(a.tablet_size_mm, b.tablet_size_mm);
    EXPECT_EQ(a.tablet_latency, b.tablet_latency);
    EXPECT_EQ(a.rotation_deg, b.rotation_deg);
    EXPECT_EQ(a.travel_shear, b.travel_shear);
    EXPECT_EQ(a.pressure.threshold, b.pressure.threshold);
    EXPECT_EQ(a.pressure.full, b.pressure.full);
    EXPECT_EQ(a.pressure.exponent, b.pressure.exponent);
}

// Returns a rig with numbers that have no short decimal form.
Rig awkward_rig()
{
    return {
        .full_scale_counts = 65535,
        .calibrated_min_counts = 1.0 / 3,
        .calibrated_max_counts = 65535 - 1.0 / 7,
        .height_latency = Duration(3'141'593),
        .tablet_size_mm = { 254.0 / 7, 1 + 1e-7 },
        .tablet_latency = Duration(7'999'999'999),
        .rotation_deg = -0.1 - 0.2,
        .travel_shear = { 1.0 / 300, -1e-300 },
        .pressure = { .threshold = 0.1 / 3, .full = 1 - 1e-16, .exponent = 2.0 / 7 },
        .max_height_age = Duration(1),
    };
}

TEST(RigFile, GivesTheSameLinearRigBack)
{
    auto rig = awkward_rig();
    LinearHeight const model { .mm_per_count = 0.1 / 3, .zero_counts = -1e4 / 7 };
    rig.height_model = model;
    auto const back = parse_rig(print_rig(rig), "printed").value();
    expect_same(back, rig);
    EXPECT_EQ(std::get<LinearHeight>(back.height_model).mm_per_count, model.mm_per_count);
    EXPECT_EQ(std::get<LinearHeight>(back.height_model).zero_counts, model.zero_counts);
}

TEST(RigFile, GivesTheSameStringRigBack)
{
    auto rig = awkward_rig();
    StringHeight const model {
        .mm_per_count = 2.0 / 21, .zero_length_mm = 1e3 / 7, .offset_mm = 1e2 / 3, .base_mm = 5e-324
    };
    rig.height_model = model;
    auto const back = parse_rig(print_rig(rig), "printed").value();
    expect_same(back, rig);
    auto const& read = std::get<StringHeight>(back.height_model);
    EXPECT_EQ(read.mm_per_count, model.mm_per_count);
    EXPECT_EQ(read.zero_length_mm, model.zero_length_mm);
    EXPECT_EQ(read.offset_mm, model.offset_mm);
    EXPECT_EQ(read.base_mm, model.base_mm);
}

TEST(RigFile, GivesTheSameCurveAndSpoolBack)
{
    auto rig = awkward_rig();
    rig.calibrated_max_counts = 70'000;
    rig.height_model
        = MonotoneHeight { .knots = { { 1.0 / 3, 20 }, { 700, 10.0 / 7 }, { 1e4, -3 } } };
    auto back = parse_rig(print_rig(rig), "printed").value();
    expect_same(back, rig);
    EXPECT_EQ(parameters_of(back.height_model), parameters_of(rig.height_model));
    rig.height_model = StringHeight { .spool = StringHeight::Spool::Above };
    back = parse_rig(print_rig(rig), "printed").value();
    EXPECT_EQ(std::get<StringHeight>(back.height_model).spool, StringHeight::Spool::Above);
}

TEST(RigFile, GivesTheBendOfATrackBack)
{
    auto rig = awkward_rig();
    EXPECT_EQ(print_rig(rig).find("bend"), std::string::npos) << "where the track is straight";
    HeightModel const straight = StringHeight { .mm_per_count = 0.1, .zero_length_mm = 200 };
    rig.height_model = with_bend(straight, { { 1.0 / 3, 20 }, { 700, 10.0 / 7 }, { 3000, -3 } });
    auto const text = print_rig(rig);
    auto const back = parse_rig(text, "printed");
    ASSERT_TRUE(back) << back.error().message;
    EXPECT_EQ(print_rig(*back), text);
    for (double const counts : { 0.0, 500.0, 2000.0, 4000.0 })
        EXPECT_EQ(height_mm(back->height_model, counts), height_mm(rig.height_model, counts));
}

TEST(RigFile, RefusesABendThatTurns)
{
    auto const message
        = error_of(with("model = \"string\"\nmm_per_count = 0.1\nzero_length_mm = 120\n"
                        "offset_mm = 110\nbase_mm = 80\n",
                        "model = \"linear\"\nmm_per_count = 0.1\nzero_counts = 0\n"
                        "bend = [[0, 0], [1000, -1100]]\n"));
    EXPECT_NE(message.find("height.bend is too steep or out of order"), std::string::npos)
        << message;
}

TEST(RigFile, KeepsAMeasuredSurface)
{
    Rig rig;
    EXPECT_FALSE(parse_rig(print_rig(rig), "x").value().surface_mm);
    rig.tablet_size_mm = rig.surface_mm.emplace(203.2, 127);
    auto const text = print_rig(rig);
    auto const back = parse_rig(text, "x");
    ASSERT_TRUE(back) << back.error().message;
    EXPECT_EQ(back->surface_mm, Vec2(203.2, 127));
    EXPECT_EQ(back->tablet_size_mm, Vec2(203.2, 127));
    auto absurd = text;
    absurd.replace(absurd.find("surface_mm = [203.2"), 19, "surface_mm = [2.032");
    auto const refused = parse_rig(absurd, "x");
    ASSERT_FALSE(refused);
    EXPECT_NE(refused.error().message.find("surface_mm is [2.032, 127], expected sides of 20 to"),
              std::string::npos)
        << refused.error().message;
}

// Older files do not contain `sample_times`; a rig with the default is written without it.
TEST(RigFile, KeepsHowSampleTimesAreTold)
{
    Rig rig;
    auto const old = print_rig(rig);
    EXPECT_EQ(old.find("sample_times"), std::string::npos);
    EXPECT_EQ(parse_rig(old, "x").value().sample_times, SampleTimes::AsArrived);
    rig.sample_times = SampleTimes::Evened;
    auto const text = print_rig(rig);
    auto const back = parse_rig(text, "x");
    ASSERT_TRUE(back) << back.error().message;
    EXPECT_EQ(back->sample_times, SampleTimes::Evened);
    auto wrong = text;
    wrong.replace(wrong.find("\"evened\""), 8, "\"even\"");
    auto const refused = parse_rig(wrong, "x");
    ASSERT_FALSE(refused);
    EXPECT_NE(refused.error().message.find("sample_times"), std::string::npos)
        << refused.error().message;
}

TEST(RigFile, RefusesWhatNoRigCanBe)
{
    Rig rig;
    rig.travel_shear = { 0, 65536 };
    EXPECT_NE(error_of(print_rig(rig)).find("tablet.travel_shear is 65536, expected -1 to 1"),
              std::string::npos)
        << error_of(print_rig(rig));
    rig.travel_shear = { 0.5, -1 };
    EXPECT_TRUE(parse_rig(print_rig(rig), "x"));
    rig.rotation_deg = 361;
    EXPECT_NE(error_of(print_rig(rig)).find("tablet.rotation_deg is 361"), std::string::npos);
    rig.rotation_deg = -360;
    EXPECT_TRUE(parse_rig(print_rig(rig), "x"));
    rig.tablet_size_mm = { 254, 15'900'000 };
    EXPECT_NE(error_of(print_rig(rig)).find("tablet.size_mm is 15900000"), std::string::npos)
        << error_of(print_rig(rig));
    rig.tablet_size_mm = { 254, 159 };
    rig.height_model = LinearHeight { .mm_per_count = 100 };
    EXPECT_NE(error_of(print_rig(rig)).find("no carriage goes beyond 10000 mm"), std::string::npos)
        << error_of(print_rig(rig));
}

TEST(RigFile, RefusesACurveThatTurns)
{
    auto const text = with("model = \"string\"\nmm_per_count = 0.1\nzero_length_mm = 120\n"
                           "offset_mm = 110\nbase_mm = 80\n",
                           "model = \"monotone\"\nknots = [[0, 0], [1000, 90], [2000, 80]]\n");
    EXPECT_EQ(error_of(text),
              "my.rig.toml:4: height.knots do not rise or fall all the way, expected [counts, "
              "height_mm] with counts that rise and heights that only rise or only fall");
}

TEST(RigFile, KeepsHowTheRigWasCalibrated)
{
    auto rig = parse_rig(kText, "my.rig.toml").value();
    HeightRecord height { .date = "2026-11-21",
                          .sensor = { "A \"sensor\"", "0003:1209:0001", "7" },
                          .requested_kind = HeightModelKind::String,
                          .reason = "string: as was asked for",
                          .errors = { 0.1, 0.2 },
                          .slipped = { 1 },
                          .hysteresis_mm = Vec2(0.1, 0.02),
                          .raised_mm = -0.5,
                          .shifted_counts = 12.5 };
    height.captures = { { .ruler_mm = 60,
                          .counts = 812.25,
                          .noise_counts = 1,
                          .readings = 500,
                          .scatter = { 1, 2, 1 } },
                        { .ruler_mm = 90, .counts = 900, .from = HeightCapture::From::Below } };
    rig.calibration = { .height = height,
                        .travel = TravelRecord { .date = "2026-11-21", .touches = 400 },
                        .latency = LatencyRecord { .date = "2026-11-21",
                                                   .delay_ms = -5.25,
                                                   .direction_mm = Vec2(0.5, 0.125) },
                        .tilt = TiltRecord { .date = "2026-11-21",
                                             .coil_height_mm = { 9.25, 9 },
                                             .coil_height_error_mm = { 0.01, 0.02 },
                                             .min_tilt_deg = { -40, -35.5 },
                                             .most_tilt_deg = { 41, 36 },
                                             .rms_mm = 0.1,
                                             .touches = 4000 },
                        .check = CheckRecord { .date = "2026-11-21",
                                               .heights_mm = { 100 },
                                               .errors_mm = { -0.4 },
                                               .within_mm = 0.4 } };
    auto const back = parse_rig(print_rig(rig), "printed").value();
    expect_same(back, rig);
    EXPECT_EQ(back.calibration.height->sensor, height.sensor);
    EXPECT_EQ(back.calibration.height->captures[0].scatter, (std::vector { 1, 2, 1 }));
    EXPECT_EQ(back.calibration.height->captures[1].from, HeightCapture::From::Below);
    EXPECT_EQ(back.calibration.height->slipped, height.slipped);
    EXPECT_EQ(back.calibration.latency->delay_ms, -5.25);
    EXPECT_EQ(back.calibration.latency->direction_mm, Vec2(0.5, 0.125));
    EXPECT_EQ(back.calibration.tilt->coil_height_mm, Vec2(9.25, 9));
    EXPECT_EQ(back.calibration.tilt->coil_height_error_mm, Vec2(0.01, 0.02));
    EXPECT_EQ(back.calibration.tilt->min_tilt_deg, Vec2(-40, -35.5));
    EXPECT_EQ(back.calibration.tilt->touches, 4000u);
    EXPECT_EQ(back.calibration.height->shifted_counts, 12.5);
}

TEST(RigFile, SaysWhatIsWrongInARecord)
{
    auto const text = [](std::string_view captures) {
        return text_with("[calibration.height]\ndate = \"2026-11-21\"\nsensor = \"\"\n"
                         "sensor_id = \"\"\nsensor_serial = \"\"\nreason = \"\"\nerrors = []\n"
                         "rms_mm = 0\nmax_mm = 0\nheights_mm = [0, 1]\nmm_per_count = [1, 1]\n"
                         "noise_counts = 1\nraised_mm = 0\nruler_error_mm = 0.3\n")
            .append(captures);
    };
    EXPECT_EQ(
        error_of(text("slipped = []\ncaptures = [{ ruler_mm = 1 }]\n")),
        "my.rig.toml:29: calibration.height.captures[1].counts is missing, expected a number");
    EXPECT_EQ(error_of(text("slipped = [2]\ncaptures = [{ ruler_mm = 1, counts = 1, noise_counts "
                            "= 1, readings = 1, from = \"above\", scatter = [] }]\n")),
              "my.rig.toml:28: calibration.height.slipped has 2, expected numbers of captures, 1 "
              "to 1");
}

TEST(RigFile, KeepsThePreviousFile)
{
    auto const path = std::filesystem::path(::testing::TempDir()) / "tractus-rig-bak.rig.toml";
    auto const backup = path.string() + ".bak";
    auto rig = parse_rig(kText, "my.rig.toml").value();
    ASSERT_TRUE(save_rig(rig, path));
    EXPECT_FALSE(std::filesystem::exists(backup));
    rig.rotation_deg = 2;
    ASSERT_TRUE(save_rig(rig, path));
    EXPECT_EQ(load_rig(path)->rotation_deg, 2);
    EXPECT_EQ(load_rig(backup)->rotation_deg, 0);
    std::filesystem::remove(path);
    std::filesystem::remove(backup);
}

TEST(RigFile, SavesAndLoads)
{
    auto const path = std::filesystem::path(::testing::TempDir()) / "tractus-rig-test.rig.toml";
    auto const rig = parse_rig(kText, "my.rig.toml").value();
    ASSERT_TRUE(save_rig(rig, path));
    expect_same(load_rig(path).value(), rig);
    std::filesystem::remove(path);
    EXPECT_EQ(load_rig(path).error().message,
              "cannot open " + path.string() + ": No such file or directory");
}

TEST(RigFile, NamesAMissingKey)
{
    EXPECT_EQ(error_of(with("mm_per_count = 0.1\n", "")),
              "my.rig.toml:2: height.mm_per_count is missing, expected a number");
    EXPECT_EQ(error_of(with("size_mm = [254, 158.75]\n", "")),
              "my.rig.toml:11: tablet.size_mm is missing, expected an array of 2 numbers, each a "
              "number greater than 0");
    EXPECT_EQ(error_of("version = 1\n"),
              "my.rig.toml:1: height is missing, expected a table [height]");
    EXPECT_EQ(error_of(""),
              "my.rig.toml:1: version is missing, expected a whole number greater than 0");
}

TEST(RigFile, RefusesEveryKeyThatIsMissing)
{
    for (auto const* line :
         { "version = 1\n", "model = \"string\"\n", "mm_per_count = 0.1\n",
           "zero_length_mm = 120\n", "offset_mm = 110\n", "base_mm = 80\n",
           "full_scale_counts = 4095\n", "calibrated_counts = [150, 3900]\n", "latency_ms = 3.5\n",
           "size_mm = [254, 158.75]\n", "latency_ms = 8\n" })
        EXPECT_NE(error_of(with(line, "")).find("is missing"), std::string::npos) << line;
}

TEST(RigFile, TakesASensorThatCountsDown)
{
    auto const rig = parse_rig(with("0.1", "-0.1"), "my.rig.toml");
    EXPECT_EQ(rig.error().message,
              "my.rig.toml:9: height.calibrated_counts holds 150, where the model has no height: "
              "the string would be shorter than its offset");
    auto text = with("mm_per_count = 0.1\nzero_length_mm = 120",
                     "mm_per_count = -0.1\nzero_length_mm = 530");
    auto const down = parse_rig(text, "my.rig.toml").value();
    EXPECT_GT(*height_mm(down.height_model, 150), *height_mm(down.height_model, 3900));
}

TEST(RigFile, RefusesAScaleOfZero)
{
    EXPECT_EQ(error_of(with("0.1", "0")),
              "my.rig.toml:4: height.mm_per_count is 0, expected a number other than 0");
}

TEST(RigFile, RefusesWhatIsNotANumber)
{
    EXPECT_EQ(error_of(with("zero_length_mm = 120", "zero_length_mm = nan")),
              "my.rig.toml:5: height.zero_length_mm is nan, expected a number");
    EXPECT_EQ(error_of(with("zero_length_mm = 120", "zero_length_mm = inf")),
              "my.rig.toml:5: height.zero_length_mm is inf, expected a number");
    EXPECT_EQ(error_of(with("158.75", "nan")),
              "my.rig.toml:12: tablet.size_mm is [254, nan], expected an array of 2 numbers, each "
              "a number greater than 0");
}

TEST(RigFile, RefusesAWrongType)
{
    EXPECT_EQ(error_of(with("base_mm = 80", "base_mm = \"80\"")),
              "my.rig.toml:7: height.base_mm is '80', expected a number");
    EXPECT_EQ(error_of(with("4095", "4095.5")),
              "my.rig.toml:8: height.full_scale_counts is 4095.5, expected a whole number greater "
              "than 0");
    EXPECT_EQ(error_of("version = 1\nheight = 3\n"),
              "my.rig.toml:2: height is 3, expected a table [height]");
    EXPECT_EQ(error_of(with("model = \"string\"", "model = {}")),
              "my.rig.toml:3: height.model is a table, expected one of \"linear\", \"string\", "
              "\"monotone\"");
}

TEST(RigFile, ShowsTheStartOfALongValue)
{
    EXPECT_EQ(
        error_of(with("base_mm = 80", "base_mm = [[1, 2], \"" + std::string(99, 'x') + "\"]")),
        "my.rig.toml:7: height.base_mm is [[1, 2], '" + std::string(30, 'x')
            + " …, expected a number");
}

TEST(RigFile, ReadsAPensPressures)
{
    auto const rig
        = parse_rig(text_with("[pen]\npressure_threshold = 0.02\n"), "my.rig.toml").value();
    EXPECT_EQ(rig.pressure.threshold, 0.02);
    EXPECT_EQ(rig.pressure.full, 1);
    EXPECT_EQ(rig.pressure.exponent, 1);
}

// Older files do not contain coil_height_mm and nib; a rig with the defaults is written without
// them.
TEST(RigFile, KeepsWhereTheTabletSeesThePenAndHowItsInkLooks)
{
    Rig rig;
    EXPECT_EQ(print_rig(rig).find("coil_height_mm"), std::string::npos);
    EXPECT_EQ(print_rig(rig).find("nib"), std::string::npos);
    rig.coil_height_mm = { 9.25, -8.5 };
    rig.nib = Nib::Side;
    auto const back = parse_rig(print_rig(rig), "x");
    ASSERT_TRUE(back) << back.error().message;
    EXPECT_EQ(back->coil_height_mm, Vec2(9.25, -8.5));
    EXPECT_EQ(back->nib, Nib::Side);
    EXPECT_EQ(error_of(text_with("[pen]\ncoil_height_mm = [101, 9]\n")),
              "my.rig.toml:15: pen.coil_height_mm is 101, expected -100 to 100");
    EXPECT_EQ(error_of(text_with("[pen]\nnib = \"brush\"\n")),
              "my.rig.toml:15: pen.nib is 'brush', expected one of \"point\", \"side\"");
}

TEST(RigFile, RefusesPressuresWithoutSense)
{
    auto const error_of_pen
        = [](std::string const& keys) { return error_of(text_with("[pen]\n" + keys + "\n")); };
    EXPECT_EQ(error_of_pen("pressure_full = 1.5"),
              "my.rig.toml:15: pen.pressure_full is 1.5, expected at most 1");
    EXPECT_EQ(error_of_pen("pressure_threshold = 1"),
              "my.rig.toml:15: pen.pressure_threshold is 1, expected less than pressure_full (1)");
    EXPECT_EQ(error_of_pen("pressure_threshold = -0.1"),
              "my.rig.toml:15: pen.pressure_threshold is -0.1, expected a number of 0 or more");
    EXPECT_EQ(error_of_pen("pressure_exponent = 0"),
              "my.rig.toml:15: pen.pressure_exponent is 0, expected a number greater than 0");
}

TEST(RigFile, RefusesAnUnknownModel)
{
    EXPECT_EQ(error_of(with("\"string\"", "\"laser\"")),
              "my.rig.toml:3: height.model is 'laser', expected one of \"linear\", \"string\", "
              "\"monotone\"");
}

TEST(RigFile, RefusesANewerVersion)
{
    EXPECT_EQ(
        error_of(with("version = 1", "version = 3")),
        "my.rig.toml:1: version is 3, expected at most 2: a later tractus wrote this file, so "
        "use that one to read it");
}

TEST(RigFile, RefusesAMisspeltKey)
{
    auto const message = error_of(text_with("rotaton_deg = 3\n"));
    EXPECT_EQ(message,
              "my.rig.toml:14: tablet.rotaton_deg is not a key of this place, expected "
              "latency_ms, rotation_deg, size_mm, surface_mm, travel_shear");
}

TEST(RigFile, RefusesARangeOrTimeWithoutSense)
{
    EXPECT_EQ(error_of(with("[150, 3900]", "[3900, 150]")),
              "my.rig.toml:9: height.calibrated_counts is empty, expected [least, greatest]");
    EXPECT_EQ(
        error_of(with("[150, 3900]", "[-150, 3900]")),
        "my.rig.toml:9: height.calibrated_counts holds -150, where the model has no height: the "
        "string would be shorter than its offset");
    EXPECT_EQ(error_of(with("3.5", "-1")),
              "my.rig.toml:10: height.latency_ms is -1, expected a number of 0 or more");
    EXPECT_EQ(error_of(with("3.5", "1e300")),
              "my.rig.toml:10: height.latency_ms is 1e+300, expected at most a minute (60000)");
    EXPECT_EQ(error_of(with("4095", "5000000000")),
              "my.rig.toml:8: height.full_scale_counts is too large, expected at most 32 bits");
}

TEST(RigFile, SaysWhereItIsNotToml)
{
    EXPECT_EQ(error_of("version = 1\n[height\n").substr(0, 28), "my.rig.toml:2:8: not TOML: E");
}

TEST(RigFile, SurvivesEveryTruncation)
{
    for (std::size_t size = 0; size + 2 < kText.size(); ++size)
        EXPECT_NE(error_of(std::string(kText.substr(0, size))), "no error") << size;
}

TEST(RigFile, SurvivesDeepNesting)
{
    EXPECT_NE(error_of("version = " + std::string(100'000, '[')), "no error");
}

TEST(RigFile, SurvivesChangedBytes)
{
    Random random({ .seed = 1 });
    int refused = 0;
    for (int i = 0; i < 3000; ++i) {
        std::string text(kText);
        for (int change = 0; change < 3; ++change)
            text[random.next_u32() % text.size()] = static_cast<char>(random.next_u32());
        auto const rig = parse_rig(text, "my.rig.toml");
        refused += !rig;
        if (rig) // A text that is accepted as a rig must also be writable.
            expect_same(parse_rig(print_rig(*rig), "printed").value(), *rig);
    }
    EXPECT_GT(refused, 1500);
}

} // namespace
} // namespace tractus::calib
