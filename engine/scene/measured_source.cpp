#include "engine/scene/measured_source.h"

#include "engine/plant/mtg.h"
#include "engine/plant/ply_skeleton.h"
#include "engine/plant/qsm.h"

#include <span>
#include <utility>

namespace tractus::scene {

Result<BuiltSource> build_measured(LoadMeasured const& measured, LoadOptions const&)
{
    switch (measured.format) {
    case LoadMeasured::Format::Mtg: {
        auto read = TRY(parse_mtg_with_warnings(measured.name, measured.text));
        return BuiltSource { .plant = std::move(read.plant), .warnings = std::move(read.warnings) };
    }
    case LoadMeasured::Format::Qsm:
        return BuiltSource { .plant = TRY(parse_qsm(measured.name, measured.text)) };
    case LoadMeasured::Format::Ply:
        break;
    }
    auto const bytes = std::as_bytes(std::span(measured.text));
    return BuiltSource { .plant = TRY(parse_ply_skeleton(measured.name, bytes)) };
}

} // namespace tractus::scene
