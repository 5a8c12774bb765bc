// Fuzzes the readers of pictures and of their camera metadata.

#include "app/render/read_picture.h"
#include "tests/fuzz/fuzz_input.h"

extern "C" int LLVMFuzzerTestOneInput(std::uint8_t const* data, std::size_t size)
{
    using namespace tractus;
    is_read(render::read_picture(FuzzInput(data, size).text()));
    return 0;
}
