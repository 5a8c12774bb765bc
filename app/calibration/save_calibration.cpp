#include "app/calibration/save_calibration.h"

#include "app/calibration/calibration_report.h"
#include "app/calibration/height_plots.h"
#include "app/calibration/plot_svg.h"
#include "calib/rig_file.h"
#include "engine/base/file.h"

#include <ctime>
#include <fmt/chrono.h>
#include <fmt/core.h>

namespace tractus::calibration {

static Result<void> write_picture(CalibrationOutcome const& outcome,
                                  std::filesystem::path const& rig,
                                  std::filesystem::path const& picture)
{
    auto const& record = outcome.rig.calibration.height.value();
    auto const plots
        = height_plots(*outcome.height_fit, record.captures, outcome.rig.full_scale_counts);
    PlotSheet const sheet {
        .title = "Height calibration",
        .subtitle = fmt::format("{} · {} · {} · calibrated from {}", rig.filename().string(),
                                record.sensor.name, record.date,
                                describe_heights(record.heights_mm.x(), record.heights_mm.y())),
    };
    return write_file(picture, print_svg(sheet, plots));
}

Result<std::string> save_calibration(CalibrationOutcome const& outcome,
                                     std::filesystem::path const& rig)
{
    TRY(calib::save_rig(outcome.rig, rig));
    auto text = fmt::format("{}: written\n", rig.string());
    if (outcome.height_fit) {
        auto const picture = std::filesystem::path(rig).replace_extension(".svg");
        TRY(write_picture(outcome, rig, picture));
        text += fmt::format("{}: its picture\n", picture.string());
    }
    return text;
}

std::string today()
{
    return fmt::format("{:%Y-%m-%d}", fmt::localtime(std::time(nullptr)));
}

} // namespace tractus::calibration
