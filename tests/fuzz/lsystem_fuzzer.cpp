#include "tests/engine/lsystem/whole_pipeline.h"

#include <cstddef>
#include <cstdint>

// Fuzzes the whole way from text to plant. The input is a model's rules and its view, separated by
// a zero byte.
extern "C" int LLVMFuzzerTestOneInput(std::uint8_t const* data, std::size_t size)
{
    tractus::lsystem::run_whole_pipeline({ reinterpret_cast<char const*>(data), size });
    return 0;
}
