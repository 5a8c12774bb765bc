#include "sim/gesture_script.h"

#include "calib/toml_table.h"
#include "sim/unkindness_table.h"

#include <array>
#include <fmt/core.h>

namespace tractus::sim {

static constexpr std::int64_t kScriptVersion = 1;
static constexpr double kSlowest_mm_s = 5;
static constexpr double kFastest_mm_s = 1000;

static constexpr std::array<std::string_view, 3> kPropagations { "selected", "descendants",
                                                                 "both" };

static Result<PathShape> parse_line(calib::TomlTable& table)
{
    LineShape line;
    line.from_mm = TRY(table.vec3("from_mm"));
    line.to_mm = TRY(table.vec3("to_mm"));
    return line;
}

static Result<PathShape> parse_arc(calib::TomlTable& table)
{
    HelixShape arc;
    arc.foot_mm = TRY(table.vec3("center_mm"));
    arc.radius_mm = arc.end_radius_mm
        = TRY(table.number("radius_mm", calib::NumberRange::Positive));
    arc.turns = TRY(table.number("sweep_deg")) / 360;
    arc.start_rad = radians(TRY(table.number_or("start_deg", 0)));
    arc.rise_mm = TRY(table.number_or("rise_mm", 0));
    return arc;
}

static Result<PathShape> parse_helix(calib::TomlTable& table)
{
    HelixShape helix;
    helix.foot_mm = TRY(table.vec3("foot_mm"));
    helix.radius_mm = TRY(table.number("radius_mm", calib::NumberRange::NotNegative));
    helix.end_radius_mm
        = TRY(table.number_or("end_radius_mm", helix.radius_mm, calib::NumberRange::NotNegative));
    helix.turns = TRY(table.number("turns"));
    helix.start_rad = radians(TRY(table.number_or("start_deg", 0)));
    helix.rise_mm = TRY(table.number_or("rise_mm", 0));
    return helix;
}

static Result<PathShape> parse_s_curve(calib::TomlTable& table)
{
    SCurveShape curve;
    curve.from_mm = TRY(table.vec3("from_mm"));
    curve.to_mm = TRY(table.vec3("to_mm"));
    curve.swing_mm = TRY(table.number("swing_mm"));
    return curve;
}

static Result<PathShape> parse_branch(calib::TomlTable& table)
{
    BranchShape branch;
    branch.from_mm = TRY(table.vec3("from_mm"));
    branch.length_mm = TRY(table.number("length_mm", calib::NumberRange::Positive));
    branch.heading_rad = radians(TRY(table.number("heading_deg")));
    branch.elevation_rad = radians(TRY(table.number("elevation_deg")));
    branch.turn_rad = radians(TRY(table.number_or("turn_deg", 0)));
    branch.bend_rad = radians(TRY(table.number_or("bend_deg", 0)));
    return branch;
}

static Result<PathShape> parse_polyline(calib::TomlTable& table)
{
    return PolylineShape { TRY(table.vec3_list("points_mm")) };
}

struct NamedPath {
    std::string_view name;
    Result<PathShape> (*parse)(calib::TomlTable&);
};

static constexpr NamedPath kPaths[] = {
    { "line", parse_line },       { "arc", parse_arc },       { "helix", parse_helix },
    { "s_curve", parse_s_curve }, { "branch", parse_branch }, { "polyline", parse_polyline },
};

static Result<PathShape> parse_path(calib::TomlTable& table)
{
    std::vector<std::string_view> names;
    for (auto const& path : kPaths)
        names.push_back(path.name);
    auto const& named = kPaths[TRY(table.word("path", names))];
    auto shape = TRY(named.parse(table));
    if (!is_drawable(shape))
        return table.wrong("path", "cannot be drawn, expected one from 0 to 10 m long");
    return shape;
}

static Result<AxisTrace> parse_trace(calib::TomlTable& table, std::string const& tool)
{
    TRY(table.word("trace", { "axis" }));
    if (tool != "select")
        return table.wrong(
            "trace", fmt::format("is for the tool \"select\", expected a path for \"{}\"", tool));
    AxisTrace trace;
    trace.rank
        = static_cast<std::size_t>(TRY(table.integer("axis", calib::NumberRange::NotNegative)));
    trace.height_mm = TRY(table.number_or("height_mm", trace.height_mm));
    return trace;
}

static bool is_at_once(std::string_view words)
{
    constexpr std::string_view kNow = "now";
    return words == kNow || words.starts_with("now ") || words.ends_with(" now");
}

static Result<Gesture> parse_gesture(calib::TomlTable& table)
{
    Gesture gesture { .place = table.place() };
    gesture.tool = TRY(table.text("tool"));
    if (table.has("words"))
        gesture.words = TRY(table.text("words"));
    else if (gesture.tool == "draw")
        gesture.words = kPropagations[TRY(
            table.word("propagation", { kPropagations.begin(), kPropagations.end() }))];
    if (table.has("trace"))
        gesture.path = TRY(parse_trace(table, gesture.tool));
    else if (is_at_once(gesture.words))
        gesture.path = AtOnce {};
    else
        gesture.path = TRY(parse_path(table));
    gesture.speed_mm_s = TRY(table.number_or("speed_mm_s", gesture.speed_mm_s));
    if (gesture.speed_mm_s < kSlowest_mm_s || gesture.speed_mm_s > kFastest_mm_s)
        return table.wrong("speed_mm_s",
                           fmt::format("is {}, expected {} to {}", gesture.speed_mm_s,
                                       kSlowest_mm_s, kFastest_mm_s));
    TRY(table.refuse_unknown_keys());
    return gesture;
}

static Result<void> parse_lean(calib::TomlTable& root, GestureScript& script)
{
    constexpr double kFarthest_deg = 85;
    script.coil_height_mm
        = TRY(root.number_or("coil_height_mm", 0, calib::NumberRange::NotNegative));
    if (root.has("lean_deg"))
        script.lean_deg = TRY(root.vec2("lean_deg"));
    script.leaned_around_deg = TRY(root.vec2_or("leaned_around_deg", Vec2::Zero()));
    Vec2 const most
        = script.lean_deg.value_or(Vec2::Zero()).cwiseAbs() + script.leaned_around_deg.cwiseAbs();
    if (most.maxCoeff() > kFarthest_deg)
        return root.wrong(script.lean_deg ? "lean_deg" : "leaned_around_deg",
                          fmt::format("leans the pen by {} degrees, expected at most {}",
                                      most.maxCoeff(), kFarthest_deg));
    return {};
}

Result<GestureScript> parse_gesture_script(std::string_view text, std::string const& file)
{
    auto root = TRY(calib::TomlTable::parse(text, file));
    TRY(root.require_version(kScriptVersion));
    GestureScript script;
    if (root.has("seed"))
        script.seed = static_cast<std::uint64_t>(
            TRY(root.integer("seed", calib::NumberRange::NotNegative)));
    if (root.has("tools"))
        script.tools
            = static_cast<GestureScript::Tools>(TRY(root.word("tools", { "newest", "older" })));
    TRY(parse_lean(root, script));
    if (root.has("unkind")) {
        auto table = TRY(root.table("unkind"));
        script.unkindness = TRY(parse_unkindness(table, script.seed));
    }
    for (auto& table : TRY(root.tables("gesture")))
        script.gestures.push_back(TRY(parse_gesture(table)));
    TRY(root.refuse_unknown_keys());
    return script;
}

// Traces a branch as seen on the tablet, and returns it as a path in the world.
static Result<Path> trace_path(AxisTrace const& trace, RigGeometry const& geometry,
                               AxisTracer const& tracer)
{
    auto const T_world_tablet = tractus::calib::T_world_tablet(true_rig(geometry));
    PolylineShape polyline;
    for (auto const& place_mm : TRY(tracer(trace.rank)))
        polyline.points_mm.push_back(T_world_tablet
                                     * Vec3(place_mm.x(), place_mm.y(), trace.height_mm));
    if (!is_drawable(polyline))
        return fail(Fault::User,
                    fmt::format("axis {} has no length on the tablet, so it cannot be "
                                "traced: choose another",
                                trace.rank));
    return make_path(polyline);
}

static Result<Path> path_of(Gesture const& gesture, RigGeometry const& geometry,
                            AxisTracer const& tracer)
{
    auto const* const trace = std::get_if<AxisTrace>(&gesture.path);
    auto path = trace ? trace_path(*trace, geometry, tracer)
                      : Result<Path>(make_path(std::get<PathShape>(gesture.path)));
    if (path)
        TRY(check_reach(geometry, *path));
    return path;
}

Result<std::vector<HandStroke>> strokes_of(GestureScript const& script, RigGeometry const& geometry,
                                           AxisTracer const& tracer)
{
    std::vector<HandStroke> strokes;
    for (auto const& gesture : script.gestures) {
        if (std::holds_alternative<AtOnce>(gesture.path))
            continue;
        auto path = path_of(gesture, geometry, tracer);
        if (!path)
            return fail(path.error().fault,
                        fmt::format("{}: {}", gesture.place, path.error().message));
        strokes.push_back({ .path = *std::move(path), .speed_mm_s = gesture.speed_mm_s });
    }
    add_hooks(strokes, geometry, script.unkindness);
    add_dabs(strokes, geometry, script.unkindness);
    return strokes;
}

} // namespace tractus::sim
