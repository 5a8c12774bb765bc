#pragma once

#include "app/render/camera.h"
#include "app/render/picture_size.h"
#include "engine/base/result.h"
#include "engine/export/glb_writer.h"
#include "engine/export/usd_writer.h"
#include "engine/mesh/mesh.h"
#include "engine/plant/plant.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace tractus::batch {

// How plants are made solid for printing, in .stl and .ply files.
struct SolidFileOptions {
    // True: one closed shell around everything. False: in a .stl file each branch and leaf is a
    // closed surface of its own, and a .ply file has the plant as it is shown.
    bool is_watertight = false;
    // Thickness of the print to which thinner branches and leaves are thickened; also closes the
    // surfaces of a .ply file. No value: kPrintableThickness_mm where surfaces are closed.
    std::optional<double> least_thickness_mm {};
    // Height of the printed plant, to which it is scaled. No value: its natural size.
    std::optional<double> height_mm {};
    bool without_leaves = false; // True: leaves, flowers and fruits are left out.

    bool closes() const
    {
        return is_watertight || without_leaves || least_thickness_mm || height_mm;
    }
};

// Two lines of a printer with the usual nozzle of 0.4 mm.
constexpr double kPrintableThickness_mm = 0.8;

struct PlantFileOptions {
    render::PictureSize picture {}; // Size of a picture.
    // Camera of a picture; no value: fits the whole plant.
    std::optional<render::Camera> camera {};
    exports::GlbOptions glb {};
    exports::UsdOptions usd {};
    SolidFileOptions solid {};
};

// The content of a file: a plant or its mesh, and its name inside the file.
struct PlantContent {
    std::string name;
    std::variant<Plant const*, mesh::Mesh const*> plant;
};

struct WrittenFile {
    std::uint64_t triangles = 0; // 0 if the format has none.
    std::string note {};         // What is to say of the file to the user; may be empty.

    // Returns the note as the end of a sentence: "; the surface is closed". Empty without a note.
    std::string sentence() const { return note.empty() ? note : "; " + note; }
};

// A format in which plants are written.
struct PlantFormat {
    std::string_view ending; // Of the file's name, such as ".obj".
    std::string_view label;  // What it is, for lists.
    bool has_triangles;      // False: it is of branches, and cannot be written from a mesh.
    Result<WrittenFile> (*write)(PlantContent const& content, std::filesystem::path const& path,
                                 PlantFileOptions const& options);
};

// All formats. This list is what the program knows: commands and the window offer what is in it.
std::span<PlantFormat const> plant_formats();

// Returns the format for a file's extension; null if there is none.
PlantFormat const* plant_format_of(std::filesystem::path const& path);

// True if a plant can be written to a file of this name.
bool is_plant_file(std::filesystem::path const& path);

// Returns the extensions of all formats, or of those that can be written from a mesh.
std::vector<std::string> plant_endings();
std::vector<std::string> mesh_endings();

// Returns the extensions as a list for sentences: ".glb, .obj or .png".
std::string listed(std::vector<std::string> const& endings);

} // namespace tractus::batch
