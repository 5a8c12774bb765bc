#include "app/commands/render.h"

#include "app/batch/plant_group.h"
#include "app/batch/session_plant.h"
#include "app/options/checks.h"
#include "app/render/offscreen_context.h"
#include "app/render/renderer.h"
#include "engine/base/file.h"
#include "engine/export/glb_reader.h"
#include "engine/mesh/make_mesh.h"

#include <charconv>
#include <fmt/core.h>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

namespace tractus::commands {

namespace {

constexpr int kSmallest_px = 16;
constexpr int kLargest_px = 8192;

struct RenderArguments {
    std::string input;
    std::string output;
    std::string size = "1200x900";
    double azimuth_deg = 25;
    double elevation_deg = 9;
};

struct Size {
    int width = 0;
    int height = 0;
};

// Parses a size in pixels such as "1200x900". Returns no value if the text is not a size or out of
// range.
std::optional<Size> parse_size(std::string_view text)
{
    Size size;
    char const* const end = text.data() + text.size();
    auto const first = std::from_chars(text.data(), end, size.width);
    if (first.ec != std::errc() || first.ptr == end || *first.ptr != 'x')
        return std::nullopt;
    auto const second = std::from_chars(first.ptr + 1, end, size.height);
    auto const drawable = [](int px) { return px >= kSmallest_px && px <= kLargest_px; };
    if (second.ec != std::errc() || second.ptr != end || !drawable(size.width)
        || !drawable(size.height))
        return std::nullopt;
    return size;
}

std::string check_size(std::string const& text)
{
    return parse_size(text)
        ? std::string()
        : fmt::format("'{}' is no size: give WIDTHxHEIGHT in pixels, each {} to {}, as in 1200x900",
                      text, kSmallest_px, kLargest_px);
}

Result<mesh::Mesh> load_mesh(std::string const& path, scene::EditKinds kinds)
{
    if (batch::is_session_file(path)) {
        auto const scene = TRY(batch::load_session_scene(path, kinds));
        return mesh::make_mesh(TRY(batch::shown_plants(scene)));
    }
    auto const bytes = TRY(read_file(path));
    auto mesh = exports::read_glb(bytes);
    if (!mesh)
        return fail(mesh.error().fault, fmt::format("{}: {}", path, mesh.error().message));
    return *std::move(mesh);
}

Result<void> run(RenderArguments const& arguments, scene::EditKinds kinds)
{
    TRY(check_writable(arguments.output));
    auto const mesh = TRY(load_mesh(arguments.input, kinds));
    auto const context = TRY(render::OffscreenContext::create());
    auto renderer = TRY(render::Renderer::create());
    render::GpuMesh const on_card(mesh);
    render::Stage stage;
    stage.meshes.push_back({ &on_card });
    auto const size = parse_size(arguments.size).value();
    render::Framing framing({ radians(arguments.azimuth_deg), radians(arguments.elevation_deg) },
                            static_cast<double>(size.width) / size.height);
    framing.add(mesh);
    auto const picture = renderer.picture(stage, framing.camera(), size.width, size.height);
    return write_file(arguments.output,
                      [&](std::ostream& out) { return render::write_png(out, picture); });
}

} // namespace

void add_render_command(CLI::App& root, options::Action& action, tools::Methods const& methods)
{
    // Shared with the command's action, which runs after this function has returned.
    auto const arguments = std::make_shared<RenderArguments>();
    auto* const command = root.add_subcommand(
        "render", "Draw the plants of a glTF file, or of a session, as a picture");
    command->footer(
        "Draws what a binary glTF 2.0 file (.glb) shows, ours or another program's, lit on a\n"
        "ground, without a window or a graphics card.");
    command
        ->add_option("FILE", arguments->input,
                     "What to draw: binary glTF 2.0 (.glb), or a session (.tractus)")
        ->required();
    command->add_option("-o,--output", arguments->output, "The picture")
        ->type_name("FILE.png")
        ->check(options::picture_name())
        ->required();
    command->add_option("--size", arguments->size, "Width and height in pixels, 16 to 8192 each")
        ->type_name("WxH")
        ->check(CLI::Validator(check_size, ""))
        ->capture_default_str();
    command
        ->add_option("--azimuth", arguments->azimuth_deg,
                     "From which side, -360 to 360: 0 from where the user sits, growing around the "
                     "plant to the right")
        ->type_name("DEGREES")
        ->check(options::number(-360, 360))
        ->capture_default_str();
    command
        ->add_option("--elevation", arguments->elevation_deg,
                     "From how high above the horizon, 0 to 85")
        ->type_name("DEGREES")
        ->check(options::number(0, 85))
        ->capture_default_str();
    command->callback([&action, arguments, kinds = methods.edits] {
        action = [arguments, kinds] { return run(*arguments, kinds); };
    });
}

} // namespace tractus::commands
