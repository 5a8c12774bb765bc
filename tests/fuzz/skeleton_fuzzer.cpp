// Fuzzes the readers of plants from other programs. The first byte chooses the kind of file; the
// rest is its content. The result must be a valid plant, which can be written as an MTG and read
// again.

#include "engine/plant/mtg.h"
#include "engine/plant/ply_skeleton.h"
#include "engine/plant/qsm.h"
#include "engine/plant/skeleton_lines.h"
#include "tests/fuzz/fuzz_input.h"

#include <sstream>

static tractus::Result<tractus::Plant> read_plant(tractus::FuzzInput input)
{
    using namespace tractus;
    switch (input.take_byte() % 4) {
    case 0:
        return parse_mtg("fuzz", input.text());
    case 1:
        return parse_qsm("fuzz", input.text());
    case 2:
        return parse_ply_skeleton("fuzz", input.bytes());
    default:
        return plant_from_lines("fuzz", TRY(parse_obj_lines("fuzz", input.text())));
    }
}

extern "C" int LLVMFuzzerTestOneInput(std::uint8_t const* data, std::size_t size)
{
    using namespace tractus;
    auto const plant = read_plant({ data, size });
    if (!is_read(plant))
        return 0;
    check_plant(*plant);
    std::ostringstream text;
    write_mtg(text, *plant);
    auto const again = parse_mtg("again", text.str());
    if (is_read(again))
        check_plant(*again);
    return 0;
}
