#include "app/options/glb_options.h"

#include "app/io/glb_size.h"
#include "app/options/checks.h"
#include "app/terminal/error_text.h"

#include <algorithm>
#include <string>

namespace tractus::options {

CLI::Option* add_glb_options(CLI::App& command, exports::GlbOptions& options)
{
    using Organs = exports::GlbOptions::Organs;
    options.before_writing = [&options, said = false](exports::GlbSummary const& expected) mutable {
        auto const note = io::large_glb_note(expected, options);
        if (note && !said)
            terminal::print_warning(*note);
        said |= note.has_value(); // The warning appears once for all files.
    };
    auto const choose = [&options](std::string const& word) {
        options.organs = word == "instanced" ? Organs::Instanced
            : word == "nodes"                ? Organs::Nodes
                                             : Organs::Merged;
    };
    command.add_flag_callback(
        "--quantized",
        [&options] {
            options.vertices = std::max(options.vertices, exports::GlbOptions::Vertices::Quantized);
        },
        "Write smaller vertices into a .glb, for readers that know KHR_mesh_quantization");
    command.add_flag_callback(
        "--compressed",
        [&options] { options.vertices = exports::GlbOptions::Vertices::Compressed; },
        "Write a .glb a third as large as with --quantized, which it implies, for readers that "
        "know EXT_meshopt_compression, too: three.js and Babylon.js, not Blender");
    command
        .add_option("--bark-size", options.bark_px,
                    "Width and height in pixels of the pictures of bark in a .glb, 64 to 2048")
        ->type_name("PIXELS")
        ->check(whole_number(64, exports::kMaxBarkPicture_px))
        ->capture_default_str();
    return command
        .add_option_function<std::string>(
            "--organs", choose,
            "How a .glb holds leaves and other organs. merged: in each plant's mesh, one part for "
            "each material; every program opens it, and Blender, Unity, Unreal and Godot want it. "
            "instanced: a mesh and many places (EXT_mesh_gpu_instancing); small, for three.js, "
            "Babylon.js and Blender from 3.6 on. nodes: an object for each, for editing single "
            "leaves; slow to open where there are thousands. A .usda has them instanced "
            "(PointInstancer) unless this says merged")
        ->type_name("HOW")
        ->check(one_of({ "merged", "instanced", "nodes" }))
        ->default_str("merged");
}

} // namespace tractus::options
