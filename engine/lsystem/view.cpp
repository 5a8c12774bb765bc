#include "engine/lsystem/view.h"

#include "engine/lsystem/function_file.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <fmt/core.h>
#include <optional>

namespace tractus {

namespace {

// cpfg's statements that do not concern geometry, or that we leave to others.
constexpr std::array<std::string_view, 49> kIgnoredKeys { "viewpoint",
                                                          "view reference point",
                                                          "twist",
                                                          "projection",
                                                          "front distance",
                                                          "back distance",
                                                          "scale factor",
                                                          "z buffer",
                                                          "cue range",
                                                          "shade mode",
                                                          "light direction",
                                                          "diffuse reflection",
                                                          "surface ambient",
                                                          "surface diffuse",
                                                          "line",
                                                          "surface",
                                                          "box",
                                                          "background color",
                                                          "ambient light",
                                                          "font",
                                                          "polygonization level",
                                                          "blob",
                                                          "light",
                                                          "texture",
                                                          "render mode",
                                                          "line style",
                                                          "tapered lines",
                                                          "contour sides",
                                                          "contour",
                                                          "viewing angle",
                                                          "background scene",
                                                          "twist of cylinders",
                                                          "interpretation step",
                                                          "interpretation past %",
                                                          "tsurface",
                                                          "rayshade objects",
                                                          "rayshade scale",
                                                          "initial scale",
                                                          "scale multiplier",
                                                          "environment display",
                                                          "antialiasing",
                                                          "min zoom",
                                                          "max zoom",
                                                          "generate on view change",
                                                          "winfont",
                                                          "concave polygons",
                                                          "shadow map",
                                                          "PS linecap",
                                                          "view volume" };

constexpr double kUnitsPerPixel = 0.05;

std::string_view trimmed(std::string_view text)
{
    auto const is_space = [](char c) { return std::isspace(static_cast<unsigned char>(c)); };
    while (!text.empty() && is_space(text.front()))
        text.remove_prefix(1);
    while (!text.empty() && is_space(text.back()))
        text.remove_suffix(1);
    return text;
}

std::vector<std::string_view> words(std::string_view text, std::string_view separators)
{
    std::vector<std::string_view> result;
    while (true) {
        auto const begin = text.find_first_not_of(separators);
        if (begin == std::string_view::npos)
            return result;
        text.remove_prefix(begin);
        auto const end = std::min(text.find_first_of(separators), text.size());
        result.push_back(text.substr(0, end));
        text.remove_prefix(end);
    }
}

std::optional<double> number(std::string_view text)
{
    if (!text.empty() && text.front() == '+')
        text.remove_prefix(1);
    double value = 0;
    auto const [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value))
        return std::nullopt;
    return value;
}

class ViewParser {
public:
    ViewParser(SourceText const& source, IncludeReader const& include)
        : source_(source)
        , include_(include)
    {
    }

    Result<View> parse();

private:
    Result<void> statement(std::string_view key, std::string_view value);
    Result<bool> scalar(std::string_view key, std::string_view value);
    Result<double> read_number(std::string_view text) const;
    Result<Vec3> read_vector(std::string_view text) const;
    Result<void> line_width(std::string_view value);
    Result<void> tropism(std::string_view value, bool is_torque);
    Result<void> function(std::string_view value);
    Result<void> function_set(std::string_view value);
    Result<void> curve(std::string_view value);
    Result<void> material(std::string_view value);
    Result<void> organ(std::string_view value);
    Result<void> organ_field(OrganDefinition& organ, std::string_view field);
    Result<void> radii(std::string_view value);
    void warn(std::string const& what)
    {
        view_.warnings.push_back(fmt::format("{}: {}", source_.place(at_), what));
    }
    tl::unexpected<Error> error(std::string const& what) const
    {
        return fail(Fault::User, fmt::format("{}: {}", source_.place(at_), what));
    }

    SourceText const& source_;
    IncludeReader const& include_;
    View view_;
    std::size_t at_ = 0; // The statement's first character.
};

Result<View> ViewParser::parse()
{
    std::string_view const text = source_.text;
    std::size_t begin = 0;
    while (begin < text.size()) {
        auto const end = std::min(text.find('\n', begin), text.size());
        auto const line = trimmed(text.substr(begin, end - begin));
        at_ = text.find_first_not_of(" \t", begin);
        begin = end + 1;
        if (line.empty())
            continue;
        auto const colon = line.find(':');
        if (colon == std::string_view::npos) {
            warn(fmt::format("found '{}', expected 'key: value'; the line is skipped", line));
            continue;
        }
        TRY(statement(trimmed(line.substr(0, colon)), trimmed(line.substr(colon + 1))));
    }
    return std::move(view_);
}

Result<void> ViewParser::statement(std::string_view key, std::string_view value)
{
    if (key == "initial line width")
        return line_width(value);
    if (key == "tropism" || key == "torque")
        return tropism(value, key == "torque");
    if (key == "function")
        return function(value);
    if (key == "function set")
        return function_set(value);
    if (key == "curve")
        return curve(value);
    if (key == "material")
        return material(value);
    if (key == "organ")
        return organ(value);
    if (key == "radii")
        return radii(value);
    bool const found = TRY(scalar(key, value));
    if (!found && std::find(kIgnoredKeys.begin(), kIgnoredKeys.end(), key) == kIgnoredKeys.end())
        warn(fmt::format("unknown statement '{}:'", key));
    return {};
}

Result<bool> ViewParser::scalar(std::string_view key, std::string_view value)
{
    if (key == "tropism direction") {
        auto const direction = TRY(read_vector(value));
        if (!(direction.norm() > 0))
            return error("the tropism direction must not be zero");
        view_.tropism_direction = direction.normalized();
        return true;
    }
    double* target = nullptr;
    if (key == "line width increment")
        target = &view_.line_width_step;
    else if (key == "initial elasticity")
        target = &view_.elasticity;
    else if (key == "elasticity increment")
        target = &view_.elasticity_step;
    else if (key != "angle factor" && key != "angle increment" && key != "initial color"
             && key != "color increment")
        return false;
    auto const first = words(value, " \t,");
    if (first.empty() || !number(first[0])) {
        warn(fmt::format("found '{}', expected a number; the statement is skipped", value));
        return true;
    }
    auto const read = *number(first[0]);
    if (target)
        *target = read;
    else if (key == "angle increment")
        view_.angle_increment_deg = read;
    else if (key == "angle factor" && read != 0)
        view_.angle_increment_deg = 360 / read;
    else if (key == "initial color")
        view_.color = static_cast<int>(std::clamp(read, 0.0, 255.0));
    else if (key == "color increment")
        view_.color_step = static_cast<int>(std::clamp(read, -255.0, 255.0));
    return true;
}

Result<double> ViewParser::read_number(std::string_view text) const
{
    if (auto const value = number(trimmed(text)))
        return *value;
    return error(fmt::format("found '{}', expected a number", trimmed(text)));
}

Result<Vec3> ViewParser::read_vector(std::string_view text) const
{
    auto const parts = words(text, " \t,");
    if (parts.size() != 3)
        return error(fmt::format("found '{}', expected three numbers", text));
    Vec3 result;
    for (int i = 0; i < 3; ++i)
        result[i] = TRY(read_number(parts[static_cast<std::size_t>(i)]));
    return result;
}

// A width in pixels means lines on a screen; a plant needs some thickness.
Result<void> ViewParser::line_width(std::string_view value)
{
    auto const parts = words(value, " \t");
    if (parts.empty())
        return error("found nothing, expected the line width");
    auto const width = TRY(read_number(parts[0]));
    bool const is_pixels = parts.size() > 1 && parts[1].substr(0, 1) == "p";
    view_.line_width = std::max(0.0, width) * (is_pixels ? kUnitsPerPixel : 1);
    return {};
}

// T: x y z [A: angle] [I: intensity] [E: elasticity] [S: step], as cpfg reads it: separators are
// blanks, commas and colons.
Result<void> ViewParser::tropism(std::string_view value, bool is_torque)
{
    auto const parts = words(value, " \t,:");
    Tropism tropism;
    tropism.is_torque = is_torque;
    double intensity = 1;
    for (std::size_t i = 0; i < parts.size();) {
        auto const letter = parts[i++][0];
        std::size_t const count = letter == 'T' ? 3 : 1;
        if (i + count > parts.size())
            return error(fmt::format("found {} at the line's end, expected its value", letter));
        Vec3 numbers = Vec3::Zero();
        for (std::size_t k = 0; k < count; ++k)
            numbers[static_cast<int>(k)] = TRY(read_number(parts[i + k]));
        i += count;
        if (letter == 'T')
            tropism.direction = numbers;
        else if (letter == 'A')
            tropism.angle_deg = numbers[0];
        else if (letter == 'I' || letter == 'i')
            intensity = std::clamp(numbers[0], -1.0, 1.0);
        else if (letter == 'E' || letter == 'a')
            tropism.elasticity = numbers[0];
        else if (letter == 'S')
            tropism.elasticity_step = numbers[0];
        else
            return error(fmt::format("found {}, expected T, A, I, E or S", letter));
    }
    if (!(tropism.direction.norm() > 0))
        return error("the tropism direction must not be zero");
    tropism.direction = tropism.direction.normalized() * intensity;
    view_.tropisms.push_back(tropism);
    return {};
}

Result<void> ViewParser::function(std::string_view value)
{
    auto const parts = words(value, " \t");
    if (parts.empty())
        return error("found nothing, expected the function's file");
    auto const name = std::string(parts[0]);
    FunctionTable table { name.substr(0, name.find('.')), { 0, 0 } };
    auto const text = include_ ? include_(name)
                               : Result<std::string>(fail(Fault::User, "this model has no folder"));
    if (!text) {
        warn(fmt::format("cannot read the function {} ({}); it is 0", name, text.error().message));
    } else {
        auto read = TRY(parse_functions(name, *text));
        if (!read.empty())
            table.values = std::move(read.front().values);
    }
    view_.functions.push_back(std::move(table));
    return {};
}

Result<void> ViewParser::function_set(std::string_view value)
{
    auto const name = std::string(value);
    auto const text = include_ ? include_(name)
                               : Result<std::string>(fail(Fault::User, "this model has no folder"));
    if (!text) {
        warn(fmt::format("cannot read the function set {} ({}); its functions are 0", name,
                         text.error().message));
        return {};
    }
    for (auto& table : TRY(parse_functions(name, *text)))
        view_.functions.push_back(std::move(table));
    return {};
}

Result<void> ViewParser::curve(std::string_view value)
{
    auto const parts = words(value, " \t");
    if (parts.empty())
        return error("found nothing, expected the curve's file");
    auto const name = std::string(parts[0]);
    auto const samples = parts.size() > 1 ? TRY(read_number(parts[1])) : 100;
    auto const text = include_ ? include_(name)
                               : Result<std::string>(fail(Fault::User, "this model has no folder"));
    if (!text) {
        warn(fmt::format("cannot read the curve {} ({}); it is a point", name,
                         text.error().message));
        CurveTable point;
        point.name = name.substr(0, name.find('.'));
        point.control.assign(4, Vec3::Zero());
        point.lengths.assign(2, 0);
        view_.curves.push_back(std::move(point));
        return {};
    }
    view_.curves.push_back(TRY(
        parse_curve(name, *text, static_cast<std::size_t>(std::clamp(samples, 2.0, 100'000.0)))));
    return {};
}

Result<void> ViewParser::material(std::string_view value)
{
    static constexpr std::array<std::string_view, 5> kKinds { "bark", "stem", "leaf", "petal",
                                                              "solid" };
    auto const parts = words(value, " \t");
    if (parts.size() < 2)
        return error("expected 'material: INDEX NAME kind=... color=R,G,B'");
    auto const index = TRY(read_number(parts[0]));
    Material material;
    material.name = parts[1];
    for (auto const part : std::vector(parts.begin() + 2, parts.end())) {
        auto const equals = std::min(part.find('='), part.size() - 1);
        auto const key = part.substr(0, equals);
        auto const text = part.substr(equals + 1);
        if (key == "kind") {
            auto const kind = std::find(kKinds.begin(), kKinds.end(), text);
            if (kind == kKinds.end())
                return error(
                    fmt::format("found kind={}, expected bark, stem, leaf, petal or solid", text));
            material.kind = static_cast<Material::Kind>(kind - kKinds.begin());
        } else if (key == "color") {
            auto const color = TRY(read_vector(text));
            material.base_color = color.cwiseMax(0).cwiseMin(1).cast<float>();
        } else if (key == "roughness" || key == "translucency") {
            auto const number = std::clamp(TRY(read_number(text)), 0.0, 1.0);
            (key == "roughness" ? material.roughness : material.translucency)
                = static_cast<float>(number);
        } else {
            return error(fmt::format(
                "found '{}', expected kind=, color=, roughness= or translucency=", part));
        }
    }
    if (index < 0 || index > 255 || index != std::floor(index))
        return error(fmt::format("found the index {}, expected a turtle colour, 0 to 255", index));
    view_.materials.insert_or_assign(static_cast<int>(index), material);
    return {};
}

Result<void> ViewParser::organ(std::string_view value)
{
    auto const parts = words(value, " \t");
    if (parts.size() < 2 || parts[0].size() != 1)
        return error("expected 'organ: LETTER NAME kind=... material=INDEX length=... width=...'");
    OrganDefinition organ;
    organ.letter = parts[0][0];
    organ.shape.name = parts[1];
    organ.shape.length_mm = 1;
    organ.shape.width_mm = 0.5;
    for (auto const part : std::vector(parts.begin() + 2, parts.end()))
        TRY(organ_field(organ, part));
    auto const same = std::find_if(view_.organs.begin(), view_.organs.end(),
                                   [&](auto const& other) { return other.letter == organ.letter; });
    if (same != view_.organs.end())
        *same = organ;
    else
        view_.organs.push_back(organ);
    return {};
}

Result<void> ViewParser::organ_field(OrganDefinition& organ, std::string_view field)
{
    static constexpr std::array<std::string_view, 4> kKinds { "blade", "needle", "disc", "ball" };
    auto& shape = organ.shape;
    auto const equals = std::min(field.find('='), field.size() - 1);
    auto const key = field.substr(0, equals);
    auto const text = field.substr(equals + 1);
    if (key == "kind") {
        auto const kind = std::find(kKinds.begin(), kKinds.end(), text);
        if (kind == kKinds.end())
            return error(fmt::format("found kind={}, expected blade, needle, disc or ball", text));
        shape.kind = static_cast<OrganShape::Kind>(kind - kKinds.begin());
        return {};
    }
    struct Entry {
        std::string_view key;
        double* target;
        double min;
        double max;
    };
    double material = shape.material;
    double lobe_count = shape.lobe_count;
    double fold_deg = degrees(shape.fold_rad);
    double curl_deg = degrees(shape.curl_rad);
    std::array const entries {
        Entry { "material", &material, 0, 255 },
        Entry { "length", &shape.length_mm, 1e-6, 1e6 },
        Entry { "width", &shape.width_mm, 1e-6, 1e6 },
        Entry { "petiole", &shape.petiole_mm, 0, 1e6 },
        Entry { "widest", &shape.widest, 0, 1 },
        Entry { "tip", &shape.tip_sharpness, 0, 10 },
        Entry { "base", &shape.base_sharpness, 0, 10 },
        Entry { "lobes", &shape.lobes, 0, 1 },
        Entry { "lobe_count", &lobe_count, 0, 100 },
        Entry { "fold", &fold_deg, -90, 90 },
        Entry { "curl", &curl_deg, -360, 360 },
    };
    auto const* const entry
        = std::find_if(entries.begin(), entries.end(), [&](auto const& e) { return e.key == key; });
    if (entry == entries.end())
        return error(fmt::format(
            "found '{}', expected kind=, material=, length=, width=, petiole=, widest=, "
            "tip=, base=, lobes=, lobe_count=, fold= or curl=",
            field));
    auto const value = TRY(read_number(text));
    if (value < entry->min || value > entry->max)
        return error(
            fmt::format("found {}={}, expected {} to {}", key, value, entry->min, entry->max));
    *entry->target = value;
    shape.material = static_cast<MaterialId>(material);
    shape.lobe_count = static_cast<int>(lobe_count);
    shape.fold_rad = radians(fold_deg);
    shape.curl_rad = radians(curl_deg);
    return {};
}

Result<void> ViewParser::radii(std::string_view value)
{
    auto const parts = words(value, " \t");
    if (parts.size() != 3 || parts[0] != "pipe")
        return error("expected 'radii: pipe EXPONENT TIP_RADIUS'");
    view_.pipe_exponent = TRY(read_number(parts[1]));
    view_.pipe_tip_radius = TRY(read_number(parts[2]));
    if (view_.pipe_exponent < 0.5 || view_.pipe_exponent > 10 || !(view_.pipe_tip_radius > 0))
        return error("expected an exponent from 0.5 to 10 and a radius above 0");
    view_.pipe_model = true;
    return {};
}

} // namespace

Result<View> parse_view(std::string const& name, std::string_view text,
                        IncludeReader const& include)
{
    auto const source = TRY(preprocess(name, text, include));
    return ViewParser(source, include).parse();
}

} // namespace tractus
