#include "app/svg/svg_sketch.h"

#include "app/svg/svg_path.h"
#include "app/svg/svg_transform.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <expat.h>
#include <fmt/format.h>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace tractus::svg {

namespace {

constexpr double kPixel_mm = 25.4 / 96;
// Role of a line that is an additional stem. As for every role, a label only has to begin with it,
// such as "another stem".
constexpr char const* kAnotherStem = "another";

// State of an element that its children inherit.
struct Surroundings {
    // Transform from the element's units to those of the drawing.
    Eigen::Affine2d to_sheet = Eigen::Affine2d::Identity();
    std::string role;
    bool is_drawn = true;
};

struct Drawing {
    XML_Parser parser = nullptr;
    std::vector<std::string> roles;
    std::vector<Surroundings> open;
    std::vector<SvgLine> lines;
    double unit_mm = kPixel_mm;
    std::string fault; // Error message. If it is not empty, reading has stopped.

    void stop(std::string sentence)
    {
        fault = std::move(sentence);
        XML_StopParser(parser, XML_FALSE);
    }
};

class Attributes {
public:
    explicit Attributes(char const** pairs)
        : pairs_(pairs)
    {
    }

    std::optional<std::string_view> find(std::string_view name) const
    {
        for (auto const* pair = pairs_; *pair; pair += 2)
            if (pair[0] == name)
                return pair[1];
        return std::nullopt;
    }

    double number(std::string_view name) const
    {
        auto const text = find(name);
        auto const point = text ? parse_svg_points(std::string(*text) + " 0") : std::nullopt;
        return point && point->size() == 1 ? point->front().x() : 0;
    }

private:
    char const** pairs_;
};

// Returns the role with which a word begins, or an empty text if there is none.
std::string role_in(std::string_view word, std::vector<std::string> const& roles)
{
    std::string lower(word);
    std::transform(lower.begin(), lower.end(), lower.begin(),
                   [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
    for (auto const& role : roles)
        if (lower.starts_with(role))
            return role;
    return {};
}

std::string role_of(Attributes const& attributes, std::vector<std::string> const& roles)
{
    for (auto const* const name : { "inkscape:label", "id", "class" })
        if (auto const word = attributes.find(name))
            if (auto role = role_in(*word, roles); !role.empty())
                return role;
    return {};
}

// Converts an attribute such as "210mm" to a length. 0 if it is empty or in unknown units.
double length_mm(std::string_view text)
{
    constexpr std::array<std::pair<std::string_view, double>, 5> kUnits {
        { { "mm", 1 }, { "cm", 10 }, { "in", 25.4 }, { "pt", 25.4 / 72 }, { "px", kPixel_mm } }
    };
    for (auto const& [unit, unit_mm] : kUnits)
        if (text.ends_with(unit)) {
            auto const number
                = parse_svg_points(std::string(text.substr(0, text.size() - unit.size())) + " 0");
            return number && number->size() == 1 ? number->front().x() * unit_mm : 0;
        }
    return 0;
}

// Returns the millimetres on paper per unit of the drawing, from its width and viewBox; by default
// the size of a CSS pixel.
double unit_of(Attributes const& svg)
{
    auto const box = parse_svg_points(svg.find("viewBox").value_or(""));
    double const width_mm = length_mm(svg.find("width").value_or(""));
    if (!box || box->size() != 2 || !(width_mm > 0) || !((*box)[1].x() > 0))
        return kPixel_mm;
    return width_mm / (*box)[1].x();
}

std::optional<std::vector<std::vector<Vec2>>> lines_of(std::string_view element,
                                                       Attributes const& attributes)
{
    if (element == "path")
        return parse_svg_path(attributes.find("d").value_or(""));
    if (element == "line")
        return std::vector<std::vector<Vec2>> {
            { Vec2(attributes.number("x1"), attributes.number("y1")),
              Vec2(attributes.number("x2"), attributes.number("y2")) }
        };
    if (element != "polyline")
        return std::vector<std::vector<Vec2>>();
    auto points = parse_svg_points(attributes.find("points").value_or(""));
    if (!points)
        return std::nullopt;
    return std::vector<std::vector<Vec2>> { *std::move(points) };
}

// True for elements whose content is drawn only where other elements refer to it.
bool is_stored(std::string_view element)
{
    constexpr std::array<std::string_view, 6> kStores { "defs",   "clipPath", "mask",
                                                        "marker", "pattern",  "symbol" };
    return std::find(kStores.begin(), kStores.end(), element) != kStores.end();
}

void begin_element(void* data, char const* name, char const** pairs)
{
    auto& drawing = *static_cast<Drawing*>(data);
    if (!drawing.fault.empty())
        return;
    std::string_view element = name;
    if (element.starts_with("svg:"))
        element.remove_prefix(4);
    Attributes const attributes(pairs);
    auto here = drawing.open.empty() ? Surroundings() : drawing.open.back();
    if (drawing.open.empty()) {
        if (element != "svg")
            return drawing.stop(
                "it is no SVG drawing: save it as SVG, or write the sketch as JSON");
        drawing.unit_mm = unit_of(attributes);
    }
    auto const line = XML_GetCurrentLineNumber(drawing.parser);
    auto const transform = parse_svg_transform(attributes.find("transform").value_or(""));
    auto const lines = lines_of(element, attributes);
    if (!transform || !lines)
        return drawing.stop(
            fmt::format("the {} on line {} cannot be read: draw it again", element, line));
    here.to_sheet = here.to_sheet * *transform;
    here.is_drawn = here.is_drawn && !is_stored(element);
    if (auto role = role_of(attributes, drawing.roles); !role.empty() && element != "svg")
        here.role = std::move(role);
    for (auto const& points : *lines) {
        if (!here.is_drawn)
            continue;
        drawing.lines.push_back({ here.role, {} });
        for (auto const& point : points)
            drawing.lines.back().points_mm.emplace_back(here.to_sheet * point);
    }
    drawing.open.push_back(std::move(here));
}

void end_element(void* data, char const* /*name*/)
{
    auto& drawing = *static_cast<Drawing*>(data);
    if (drawing.fault.empty())
        drawing.open.pop_back();
}

// Refuses entity declarations. Drawings do not need them, and their expansion can be unlimited.
void refuse_entity(void* data, char const* /*name*/, int /*is_parameter*/, char const* /*value*/,
                   int /*length*/, char const* /*base*/, char const* /*system*/,
                   char const* /*public_id*/, char const* /*notation*/)
{
    static_cast<Drawing*>(data)->stop("it declares entities of its own: save it as plain SVG");
}

nlohmann::json sketch_line(SvgLine const& line)
{
    auto points = nlohmann::json::array();
    for (auto const& point : line.points_mm)
        points.push_back({ point.x(), point.y() });
    return points;
}

nlohmann::json sketch_of(std::vector<SvgLine> const& lines)
{
    bool const said = std::any_of(lines.begin(), lines.end(),
                                  [](SvgLine const& line) { return !line.role.empty(); });
    nlohmann::json sketch = nlohmann::json::object();
    for (auto const& line : lines) {
        auto points = sketch_line(line);
        if (line.role == kAnotherStem) {
            sketch["stems"].push_back(nlohmann::json::object({ { "stem", std::move(points) } }));
            continue;
        }
        auto& stem = sketch.contains("stems") ? sketch["stems"].back() : sketch;
        if (!said)
            sketch["strokes"].push_back(std::move(points));
        else if (line.role == "inclination")
            stem["inclinations"].push_back(std::move(points));
        else if (!line.role.empty())
            stem[line.role] = std::move(points);
    }
    return sketch;
}

} // namespace

Result<std::vector<SvgLine>> read_svg_lines(std::string_view text,
                                            std::vector<std::string> const& roles)
{
    std::unique_ptr<XML_ParserStruct, decltype(&XML_ParserFree)> const parser(
        XML_ParserCreate(nullptr), &XML_ParserFree);
    Drawing drawing;
    drawing.parser = parser.get();
    drawing.roles = roles;
    XML_SetUserData(parser.get(), &drawing);
    XML_SetElementHandler(parser.get(), begin_element, end_element);
    XML_SetEntityDeclHandler(parser.get(), refuse_entity);
    auto const status
        = XML_Parse(parser.get(), text.data(), static_cast<int>(text.size()), XML_TRUE);
    if (!drawing.fault.empty())
        return fail(Fault::User, drawing.fault);
    if (status != XML_STATUS_OK)
        return fail(Fault::User,
                    fmt::format("line {} is no XML: save the drawing again",
                                XML_GetCurrentLineNumber(parser.get())));
    if (drawing.lines.empty())
        return fail(Fault::User,
                    "it has no path, polyline or line: draw the sketch's lines as paths");
    // Turns the drawing's y axis upwards and converts its units to millimetres.
    for (auto& line : drawing.lines)
        for (auto& point : line.points_mm)
            point = drawing.unit_mm * Vec2(point.x(), -point.y());
    return std::move(drawing.lines);
}

Result<nlohmann::json> svg_as_sketch(std::string_view text)
{
    return sketch_of(
        TRY(read_svg_lines(text, { "stem", kAnotherStem, "left", "right", "inclination" })));
}

} // namespace tractus::svg
