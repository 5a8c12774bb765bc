// Fuzzes the file with the user's window settings. What can be read must be equal after it was
// written and read again.

#include "app/commands/window_look.h"
#include "tests/fuzz/fuzz_input.h"

extern "C" int LLVMFuzzerTestOneInput(std::uint8_t const* data, std::size_t size)
{
    using namespace tractus;
    FuzzInput const input(data, size);
    auto const look = commands::parse_look(input.text(), "fuzz");
    auto const extents = commands::parse_look_extents(input.text(), "fuzz");
    if (!is_read(look) || !is_read(extents))
        return 0;
    auto const text = commands::print_look(*look, *extents);
    CHECK(commands::parse_look(text, "again").value() == *look);
    CHECK(commands::parse_look_extents(text, "again").value() == *extents);
    return 0;
}
