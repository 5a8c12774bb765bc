#include "app/python/stroke_classes.h"

#include "app/batch/drawing.h"
#include "app/io/stroke_file.h"
#include "app/methods/all_methods.h"
#include "app/python/arrays.h"
#include "app/python/errors.h"
#include "app/terminal/progress.h"
#include "app/tools/tool.h"
#include "calib/rig_file.h"
#include "drivers/logs/log.h"

#include <cstddef>
#include <filesystem>
#include <fmt/format.h>
#include <optional>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>
#include <string>
#include <utility>
#include <vector>

namespace tractus::python {

namespace {

namespace py = pybind11;
using namespace pybind11::literals;

struct StrokeHandle {
    Stroke stroke;
    std::string tool;
};

// A replayed recording.
struct RecordingHandle {
    std::string name;
    std::vector<StrokeHandle> strokes;
    batch::DrawingReport report {};
};

py::array tips_of(StrokeHandle const& handle)
{
    constexpr std::size_t kWidth = 5;
    auto const& tips = handle.stroke.tips.vector();
    std::vector<double> numbers;
    numbers.reserve(kWidth * tips.size());
    for (auto const& tip : tips) {
        auto const& position_mm = tip.position_mm;
        numbers.insert(numbers.end(),
                       { position_mm.x(), position_mm.y(), position_mm.z(), tip.pressure,
                         to_seconds(tip.time) });
    }
    return take_array(std::move(numbers), { extent(tips.size()), extent(kWidth) });
}

Result<RecordingHandle> replay_recording(std::filesystem::path const& path,
                                         std::optional<std::filesystem::path> const& rig,
                                         std::optional<std::string> const& height)
{
    RecordingHandle recording { .name = path.stem().string(), .strokes = {} };
    if (io::is_stroke_file(path)) {
        for (auto& stroke : TRY(io::load_strokes(path)))
            recording.strokes.push_back({ std::move(stroke), "" });
        return recording;
    }
    terminal::Progress progress;
    batch::DrawingOptions const options {
        .log = path, .methods = methods::all_methods(), .rig = rig, .height = height
    };
    auto const drawing
        = TRY(batch::read_drawing(options, scene::Scene {}, progress, recording.report));
    for (auto const& drawn : drawing.strokes)
        if (!drawn.stroke.tips.empty()) // Actions without a stroke have no tips.
            recording.strokes.push_back({ drawn.stroke, tools::words_for(drawn.tool).name });
    return recording;
}

RecordingHandle replay(std::filesystem::path const& path,
                       std::optional<std::filesystem::path> const& rig,
                       std::optional<std::string> const& height)
{
    return value_of(without_gil([&] { return replay_recording(path, rig, height); }));
}

// Returns the text of a rig: of a rig's file, or of the one that a log holds.
Result<std::string> rig_text(std::filesystem::path const& path)
{
    if (path.extension() == ".toml")
        return calib::print_rig(TRY(calib::load_rig(path)));
    auto const log = TRY(drivers::read_log(path));
    if (log.rig_text.empty())
        return fail(Fault::User,
                    fmt::format("{} holds no rig: it was recorded without a "
                                "calibration",
                                path.string()));
    return calib::print_rig(TRY(calib::parse_rig(log.rig_text, log.name)));
}

py::object read_rig(std::filesystem::path const& path)
{
    auto const text = value_of(without_gil([&] { return rig_text(path); }));
    return py::module_::import("tomllib").attr("loads")(text);
}

void add_recording(py::module_& module)
{
    py::class_<RecordingHandle>(module, "Recording", "The strokes of a recorded drawing.")
        .def_readonly("name", &RecordingHandle::name)
        .def_readonly("strokes", &RecordingHandle::strokes, "In the order of drawing.")
        .def_property_readonly(
            "reports", [](RecordingHandle const& recording) { return recording.report.reports; },
            "The number of the devices' reports; 0 for a file of strokes.")
        .def_property_readonly(
            "notes", [](RecordingHandle const& recording) { return recording.report.notes; },
            "What the program says of the recording, such as of lost samples.")
        .def("__len__", [](RecordingHandle const& recording) { return recording.strokes.size(); })
        .def("__repr__", [](RecordingHandle const& recording) {
            return fmt::format("<tractus.Recording {}: {} strokes>", recording.name,
                               recording.strokes.size());
        });
}

} // namespace

void add_stroke_classes(py::module_& module)
{
    py::class_<StrokeHandle>(module, "Stroke", "A stroke of the pen, from touch to lift.")
        .def_property_readonly("tips", &tips_of,
                               R"((n, 5) float64: x, y, z, pressure, t of the pen's tip. Made anew.

x, y, z in millimetres of the world's frame: right-handed, +z up, origin on the desk under the
tablet's centre. Pressure from 0 to 1. t in seconds since the recording began.)")
        .def_readonly("tool", &StrokeHandle::tool,
                      "The name of the tool in hand; empty in a file of strokes.")
        .def("__len__", [](StrokeHandle const& handle) { return handle.stroke.tips.size(); })
        .def("__repr__", [](StrokeHandle const& handle) {
            return fmt::format("<tractus.Stroke of {} tips>", handle.stroke.tips.size());
        });
    add_recording(module);
    module.def("replay", &replay, "path"_a, py::kw_only(), "rig"_a = py::none(),
               "height"_a = py::none(), R"(Replay a recording, and return its strokes.

path: a log of tractus or of another program, or a file of strokes (.tilt, .strokes).
rig: a .rig.toml that replaces the recording's calibration. height: heights that replace its sensor,
as in `tractus replay --height`.

Raises Error if the recording cannot be read, or has neither heights nor a rig.)");
    module.def("read_rig", &read_rig, "path"_a,
               R"(The calibration in a .rig.toml, or the one that a log holds, as a dict.

Its keys have their units: max_travel_mm, rotation_deg. Raises Error if there is none.)");
}

} // namespace tractus::python
