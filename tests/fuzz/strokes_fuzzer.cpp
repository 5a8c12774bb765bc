// Fuzzes the readers of strokes from other programs: a text of points, or an Open Brush sketch.

#include "engine/stroke/read_tilt.h"
#include "engine/stroke/stroke_text.h"
#include "tests/fuzz/fuzz_input.h"

#include <string>
#include <vector>

static void check_strokes(std::vector<tractus::Stroke> const& strokes)
{
    for (auto const& stroke : strokes) {
        CHECK(stroke.tips.size() >= 2);
        for (auto const& tip : stroke.tips)
            CHECK(tip.position_mm.allFinite());
    }
}

// Times with more digits than a double are only approximately equal.
static void check_same(std::vector<tractus::Stroke> const& one,
                       std::vector<tractus::Stroke> const& other)
{
    CHECK(one.size() == other.size());
    for (std::size_t i = 0; i < one.size(); ++i) {
        CHECK(one[i].tips.size() == other[i].tips.size());
        for (std::size_t k = 0; k < one[i].tips.size(); ++k) {
            CHECK(one[i].tips[k].position_mm == other[i].tips[k].position_mm);
            CHECK(one[i].tips[k].pressure == other[i].tips[k].pressure);
        }
    }
}

extern "C" int LLVMFuzzerTestOneInput(std::uint8_t const* data, std::size_t size)
{
    using namespace tractus;
    FuzzInput const input(data, size);
    if (auto const sketch = read_tilt("fuzz", input.bytes()); is_read(sketch))
        check_strokes(*sketch);
    auto const strokes = parse_strokes("fuzz", input.text());
    if (!is_read(strokes))
        return 0;
    check_strokes(*strokes);
    auto const again = parse_strokes("again", print_strokes(*strokes));
    CHECK(again);
    check_same(*strokes, *again);
    return 0;
}
