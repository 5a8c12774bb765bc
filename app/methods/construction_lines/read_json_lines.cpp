#include "app/methods/construction_lines/read_json_lines.h"

#include <algorithm>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace tractus::lines {

using nlohmann::json;

static Result<Vec3> read_point(json const& value, std::string const& place)
{
    bool const is_point = value.is_array() && (value.size() == 2 || value.size() == 3)
        && std::all_of(value.begin(), value.end(),
                       [](json const& part) { return part.is_number(); });
    if (!is_point)
        return fail(Fault::User, fmt::format("{} is no point: write [u, v] in millimetres", place));
    return Vec3(value[0].get<double>(), value[1].get<double>(),
                value.size() == 3 ? value[2].get<double>() : 0);
}

bool has_value(json const& file, char const* key)
{
    auto const found = file.find(key);
    return found != file.end() && !found->is_null();
}

Result<std::vector<Vec3>> read_line(json const& value, std::string const& name)
{
    if (!value.is_array())
        return fail(Fault::User,
                    fmt::format("{} is no line: write [[u, v], [u, v]] in millimetres", name));
    std::vector<Vec3> points;
    for (auto const& point : value)
        points.push_back(
            TRY(read_point(point, fmt::format("point {} of {}", points.size() + 1, name))));
    return points;
}

Result<std::vector<Vec2>> read_flat_line(json const& value, std::string const& name)
{
    std::vector<Vec2> points;
    for (auto const& point : TRY(read_line(value, name)))
        points.push_back(point.head<2>());
    return points;
}

} // namespace tractus::lines
