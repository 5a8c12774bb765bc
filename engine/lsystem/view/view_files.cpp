#include "engine/lsystem/view/view_files.h"

#include "engine/lsystem/view/contour_file.h"
#include "engine/lsystem/view/function_file.h"
#include "engine/lsystem/view/triangle_file.h"

#include <algorithm>
#include <cmath>
#include <fmt/core.h>

namespace tractus::lsystem {

namespace {

std::string stem(std::string const& name)
{
    return name.substr(0, name.find('.'));
}

using ParseSurface
    = Result<BezierSurface> (*)(std::string const& name, std::string_view text, double size);

// Reads the value of a statement of the form LETTER FILE SIZE.
Result<void> define_surface(ViewReader& reader, std::string_view value, ParseSurface parse)
{
    auto const parts = words(value);
    if (parts.size() < 3 || parts[0].size() != 1)
        return reader.error("expected 'surface: LETTER FILE SIZE'");
    auto const letter = parts[0][0];
    auto const name = std::string(parts[1]);
    auto size = std::min(TRY(reader.number(parts[2])), 1e6);
    if (!(size > 0)) // As in cpfg, an invalid size counts as 1.
        size = 1;
    if (reader.view.surfaces.count(letter) > 0)
        reader.warn(fmt::format("the surface {} is defined before; {} is left out", letter, name));
    else if (auto const text = reader.file("surface", name, "it is a plain leaf"))
        reader.view.surfaces.emplace(letter, TRY(parse(name, *text, size)));
    return {};
}

} // namespace

Result<void> read_function(ViewReader& reader, std::string_view value)
{
    auto const parts = words(value);
    if (parts.empty())
        return reader.error("found nothing, expected the function's file");
    auto const name = std::string(parts[0]);
    FunctionTable table { stem(name), { 0, 0 } };
    if (auto const text = reader.file("function", name, "it is 0")) {
        auto read = TRY(parse_functions(name, *text));
        if (!read.empty())
            table.values = std::move(read.front().values);
    }
    reader.view.functions.push_back(std::move(table));
    return {};
}

Result<void> read_function_set(ViewReader& reader, std::string_view value)
{
    auto const name = std::string(value);
    if (auto const text = reader.file("function set", name, "its functions are 0"))
        for (auto& table : TRY(parse_functions(name, *text)))
            reader.view.functions.push_back(std::move(table));
    return {};
}

Result<void> read_curve(ViewReader& reader, std::string_view value)
{
    auto const parts = words(value);
    if (parts.empty())
        return reader.error("found nothing, expected the curve's file");
    auto const name = std::string(parts[0]);
    auto const samples = parts.size() > 1 ? TRY(reader.number(parts[1])) : 100;
    CurveTable curve;
    if (auto const text = reader.file("curve", name, "it is a point")) {
        auto const count = static_cast<std::size_t>(std::clamp(samples, 2.0, 100'000.0));
        curve = TRY(parse_curve(name, *text, count));
    } else {
        curve.name = stem(name);
        curve.control.assign(4, Vec3::Zero());
        curve.lengths.assign(2, 0);
    }
    reader.view.curves.push_back(std::move(curve));
    return {};
}

Result<void> read_contour(ViewReader& reader, std::string_view value)
{
    auto const parts = words(value);
    if (parts.size() < 2)
        return reader.error("expected 'contour: ID FILE'");
    auto const id = TRY(reader.number(parts[0]));
    if (id < 0 || id > 1'000'000 || id != std::floor(id))
        return reader.error(fmt::format("found the id {}, expected a whole number from 0", id));
    auto const name = std::string(parts[1]);
    if (auto const text = reader.file("contour", name, "it is a circle"))
        reader.view.contours.insert_or_assign(static_cast<int>(id),
                                              TRY(parse_contour(name, *text)));
    return {};
}

Result<void> read_surface(ViewReader& reader, std::string_view value)
{
    return define_surface(reader, value, parse_surface);
}

Result<void> read_triangle_surface(ViewReader& reader, std::string_view value)
{
    return define_surface(reader, value, parse_triangle_surface);
}

} // namespace tractus::lsystem
