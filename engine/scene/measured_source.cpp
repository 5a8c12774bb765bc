#include "engine/scene/measured_source.h"

#include "engine/plant/mtg.h"
#include "engine/plant/ply_skeleton.h"
#include "engine/plant/qsm.h"

#include <span>
#include <utility>

namespace tractus {

static Result<Plant> read_plant(LoadMeasured const& measured)
{
    switch (measured.format) {
    case LoadMeasured::Format::Mtg:
        return parse_mtg(measured.name, measured.text);
    case LoadMeasured::Format::Qsm:
        return parse_qsm(measured.name, measured.text);
    case LoadMeasured::Format::Ply:
        break;
    }
    return parse_ply_skeleton(measured.name, std::as_bytes(std::span(measured.text)));
}

Result<BuiltSource> build_measured(LoadMeasured const& measured, LoadOptions const&)
{
    auto plant = TRY(read_plant(measured));
    return BuiltSource { .plant = std::move(plant) };
}

} // namespace tractus
