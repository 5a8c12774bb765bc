// Fuzzes the two readers of binary glTF files, which read a mesh and a skeleton of lines.

#include "engine/export/glb_lines.h"
#include "engine/export/glb_reader.h"
#include "tests/fuzz/fuzz_input.h"

extern "C" int LLVMFuzzerTestOneInput(std::uint8_t const* data, std::size_t size)
{
    using namespace tractus;
    FuzzInput const input(data, size);
    is_read(exports::read_glb(input.text()));
    if (auto const lines = exports::read_glb_lines("fuzz", input.text()); is_read(lines))
        is_read(plant_from_lines("fuzz", *lines));
    return 0;
}
