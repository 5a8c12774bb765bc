#include "app/options/drawing_options.h"

#include "app/options/recordings_help.h"
#include "app/options/shared_options.h"

#include <fmt/core.h>

namespace tractus::options {

void add_drawing_options(CLI::App& command, DrawingArguments& drawing, std::string const& without)
{
    auto* const log
        = command
              .add_option("--drawing", drawing.log,
                          fmt::format("What was drawn, kept by every plant: {}; or strokes in "
                                      "space, .tilt, .strokes or .txt; without it, {}",
                                      kRecordings, without))
              ->type_name("LOG");
    add_rig_option(command, drawing.rig)->needs(log);
    add_height_option(command, drawing.height)->needs(log);
}

std::optional<batch::DrawingOptions> drawing_options(DrawingArguments const& drawing,
                                                     tools::Methods const& methods)
{
    if (drawing.log.empty())
        return std::nullopt;
    batch::DrawingOptions options { .log = drawing.log, .methods = methods };
    if (!drawing.rig.empty())
        options.rig = drawing.rig;
    if (!drawing.height.empty())
        options.height = drawing.height;
    return options;
}

} // namespace tractus::options
