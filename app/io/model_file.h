#pragma once

#include "engine/base/result.h"
#include "engine/lsystem/language/model.h"
#include "engine/scene/edit.h"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace tractus::io {

inline constexpr std::string_view kCpfgDialect = "cpfg";
inline constexpr std::string_view kBookDialect = "book";

// Files and settings of a model besides its rules, which cpfg gets on its command line. An empty
// path stands for the file beside the model.
struct ModelCompanions {
    std::filesystem::path view;
    std::filesystem::path colors; // Colour file, a .mat or .map file.
    std::string environment; // Text for parse_environment(); empty: the environment of the view.
    // Notation of the rules: kCpfgDialect, or kBookDialect (engine/lsystem/notations/book_text.h),
    // which is translated while it is read.
    std::string dialect { kCpfgDialect };
};

// Reads a model: the rules at `path` and the view beside them (MODEL.v for MODEL.l) if there is
// one. Colours, which cpfg keeps in separate files, are added to the view. The colour files are
// MODEL.mat and MODEL.map, or the only files with these extensions if the folder contains no other
// model. (A file without "Lsystem:" is not a model.) Fails with a user error if the rules cannot be
// read, if they are in another program's language (engine/lsystem/notations/foreign_text.h), or if
// a colour file is invalid.
Result<lsystem::ModelSource> load_model_source(std::filesystem::path const& path,
                                               ModelCompanions const& companions = {});

// Returns warnings for up to three view and colour files beside the model that the model does not
// use, and how many more there are. Files that belong to another model, and kinds of files that the
// user has chosen explicitly, are skipped.
std::vector<std::string> warnings_of_unused_companions(std::filesystem::path const& path,
                                                       ModelCompanions const& companions = {});

// Prints the warnings of warnings_of_unused_companions(). Call this after more important output.
void warn_of_unused_companions(std::filesystem::path const& path,
                               ModelCompanions const& companions = {});

// True for file names, as in include statements, that lead out of the model's folder.
bool leads_out_of_folder(std::filesystem::path const& name);

// Returns a function that reads a model's includes (other rules, functions) from the model's
// folder. It refuses names that lead out of that folder. For a missing file it asks the methods,
// which can generate some inputs (all_inputs.h).
lsystem::IncludeReader model_includes(std::filesystem::path const& path);

// Reads a model and its companions as an edit. The edit contains their texts, so that a scene does
// not need the files later. Fails like load_model_source(), and if the model's text has errors.
Result<scene::LoadModel> load_model_edit(std::filesystem::path const& path,
                                         ModelCompanions const& companions = {});

// Reads a plant as an edit. The plant is a model, as for load_model_edit(); a skeleton of lines
// drawn by another program, in an .obj or .glb file (skeleton_lines.h, glb_lines.h); or a measured
// plant (measured_file.h). Fails like load_model_edit() and the readers of those files; .gltf files
// are refused. Warns about files beside a model that the model does not use.
Result<scene::Edit> load_plant_edit(std::filesystem::path const& path,
                                    ModelCompanions const& companions = {});

// Like load_plant_edit(), without the warnings about unused files.
Result<scene::Edit> load_plant_quietly(std::filesystem::path const& path,
                                       ModelCompanions const& companions);

// Reads and compiles a model with its companions. Fails like load_model_edit().
Result<lsystem::Model> load_model(std::filesystem::path const& path,
                                  ModelCompanions const& companions = {});

} // namespace tractus::io
