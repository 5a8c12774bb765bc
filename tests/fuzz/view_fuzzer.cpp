// Fuzzes files that belong to a model, such as views, surfaces and colours. The first byte chooses
// the kind of file; the rest is the file. For a view, the text after a zero byte is that of every
// included file.

#include "engine/lsystem/view/color_files.h"
#include "engine/lsystem/view/contour_file.h"
#include "engine/lsystem/view/curve_file.h"
#include "engine/lsystem/view/function_file.h"
#include "engine/lsystem/view/leaf_sheet.h"
#include "engine/lsystem/view/surface_file.h"
#include "engine/lsystem/view/triangle_file.h"
#include "engine/lsystem/view/view.h"
#include "tests/fuzz/fuzz_input.h"

#include <string>

static void read_as_view(tractus::FuzzInput input)
{
    using namespace tractus;
    auto const view = input.take_part();
    std::string const included(input.text());
    is_read(lsystem::parse_view(
        "fuzz", view, [&](std::string const&) -> Result<std::string> { return included; }));
}

static void check_sheet(std::string_view text)
{
    using namespace tractus;
    auto const sheet = lsystem::parse_leaf_sheet("fuzz", text);
    if (!is_read(sheet))
        return;
    for (auto const& leaf : sheet->leaves)
        for (auto const& corner : leaf->corners)
            CHECK(corner.allFinite());
    auto const written = lsystem::print_leaf_sheet(*sheet);
    auto const again = lsystem::parse_leaf_sheet("again", written);
    CHECK(again);
    CHECK(lsystem::print_leaf_sheet(*again) == written);
}

extern "C" int LLVMFuzzerTestOneInput(std::uint8_t const* data, std::size_t size)
{
    using namespace tractus;
    FuzzInput input(data, size);
    switch (input.take_byte() % 9) {
    case 0:
        read_as_view(input);
        break;
    case 1:
        is_read(lsystem::parse_surface("fuzz", input.text(), 1));
        break;
    case 2:
        is_read(lsystem::parse_triangle_surface("fuzz", input.text(), 1));
        break;
    case 3:
        is_read(lsystem::parse_contour("fuzz", input.text()));
        break;
    case 4:
        is_read(lsystem::parse_curve("fuzz", input.text()));
        break;
    case 5:
        is_read(lsystem::parse_functions("fuzz", input.text()));
        break;
    case 6:
        is_read(lsystem::color_map_statements("fuzz", input.text()));
        break;
    case 7:
        is_read(lsystem::material_file_statements("fuzz", input.text()));
        break;
    default:
        check_sheet(input.text());
    }
    return 0;
}
