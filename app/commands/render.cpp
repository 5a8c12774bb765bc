#include "app/commands/render.h"

#include "app/batch/plant_group.h"
#include "app/batch/session_plant.h"
#include "app/options/checks.h"
#include "app/options/picture_options.h"
#include "app/render/offscreen_context.h"
#include "app/render/renderer.h"
#include "engine/base/file.h"
#include "engine/export/glb_reader.h"
#include "engine/mesh/make_mesh.h"

#include <fmt/core.h>
#include <memory>
#include <optional>
#include <string>

namespace tractus::commands {

namespace {

struct RenderArguments {
    std::string input;
    std::string output;
    render::PictureSize size { 1200, 900 };
    double azimuth_deg = 25;
    double elevation_deg = 9;
};

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
    auto const& size = arguments.size;
    render::Framing framing({ radians(arguments.azimuth_deg), radians(arguments.elevation_deg) },
                            size.aspect());
    framing.add(mesh);
    auto const picture = renderer.picture(stage, framing.camera(), size.width_px, size.height_px);
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
    options::add_picture_size_option(*command, arguments->size);
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
