// Fuzzes rig files, which must read back as they were written, and gesture scripts.

#include "calib/rig_file.h"
#include "sim/gesture_script.h"
#include "tests/fuzz/fuzz_input.h"

#include <string>

extern "C" int LLVMFuzzerTestOneInput(std::uint8_t const* data, std::size_t size)
{
    using namespace tractus;
    FuzzInput const input(data, size);
    std::string const text(input.text());
    is_read(sim::parse_gesture_script(text, "fuzz"));
    auto const rig = calib::parse_rig(text, "fuzz");
    if (!is_read(rig))
        return 0;
    auto const written = calib::print_rig(*rig);
    auto const again = calib::parse_rig(written, "again");
    CHECK(again);
    CHECK(calib::print_rig(*again) == written);
    return 0;
}
