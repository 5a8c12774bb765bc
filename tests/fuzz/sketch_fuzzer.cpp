// Fuzzes the files that the methods' commands read. The first byte chooses the kind of file; the
// rest is the file.

#include "app/methods/construction_lines/line_sketch_file.h"
#include "app/methods/leaves/leaf_sketch_file.h"
#include "app/methods/silhouettes/silhouette_file.h"
#include "app/methods/sketch_lsystem/rule_file.h"
#include "app/svg/svg_sketch.h"
#include "engine/methods/construction_lines/organ_file.h"
#include "tests/fuzz/fuzz_input.h"

#include <nlohmann/json.hpp>

extern "C" int LLVMFuzzerTestOneInput(std::uint8_t const* data, std::size_t size)
{
    using namespace tractus;
    FuzzInput input(data, size);
    switch (input.take_byte() % 6) {
    case 0:
        if (auto const sketch = svg::svg_as_sketch(input.text()); is_read(sketch))
            is_read(lines::parse_line_sketch(sketch->dump(), "fuzz"));
        break;
    case 1:
        is_read(lines::parse_line_sketch(input.text(), "fuzz"));
        break;
    case 2:
        is_read(silhouette::parse_silhouette(input.text(), "fuzz"));
        break;
    case 3:
        is_read(sketch::parse_rule(input.text(), "fuzz"));
        break;
    case 4:
        is_read(leaf::parse_leaf_sketch(input.text(), "fuzz"));
        break;
    default:
        if (auto const organ = lines::parse_organ(input.text(), "fuzz"); is_read(organ))
            CHECK(lines::parse_organ(lines::print_organ(*organ), "printed").has_value());
    }
    return 0;
}
