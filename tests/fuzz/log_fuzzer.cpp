// Fuzzes device logs. A log that can be read must be equal after it was written and read again.

#include "tests/fuzz/log_round_trip.h"

#include <cstddef>
#include <cstdint>
#include <string_view>

extern "C" int LLVMFuzzerTestOneInput(std::uint8_t const* data, std::size_t size)
{
    using namespace tractus;
    if (auto const log = drivers::parse_log({ reinterpret_cast<char const*>(data), size }, "fuzz"))
        check_log_round_trip(*log);
    return 0;
}
