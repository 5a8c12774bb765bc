#pragma once

#include "app/methods/all_methods.h"
#include "app/station/log_replay.h"
#include "tests/app/small_model.h"

#include <utility>
#include <vector>

namespace tractus {

// Result of replaying a log, with the strokes drawn.
struct Replayed {
    station::StationCounts counts;
    scene::Scene scene;
    std::vector<document::DrawnStroke> strokes;
};

inline Replayed replayed(drivers::Log const& log, station::ReplayOptions options = {},
                         scene::Scene scene = small_scene())
{
    options.methods = methods::all_methods();
    auto replay = station::LogReplay::create(log, options).value();
    document::Document document(std::move(scene), document::Document::Working::AtOnce);
    replay.run(document);
    return { replay.station().counts(), document.newest()->scene,
             document.take_finished_strokes() };
}

} // namespace tractus
