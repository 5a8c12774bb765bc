#pragma once

#include "engine/base/result.h"
#include "engine/lsystem/language/model.h"
#include "engine/scene/edit.h"

#include <filesystem>
#include <string>
#include <vector>

namespace tractus::io {

// Files that cpfg is given beside the rules on its command line; without them, those beside the
// model.
struct ModelCompanions {
    std::filesystem::path view;
    std::filesystem::path colors; // .mat or .map
    std::string environment;      // Text for parse_environment(); the view's without it.
};

// Reads a model: the rules at `path` and the view beside them (MODEL.v for MODEL.l) where there is
// one. Colours that cpfg has in files of their own are read into the view: MODEL.mat and MODEL.map,
// or the only ones in a folder that has no other model (a file without Lsystem: is none). Fails, as
// the user's fault, if the rules cannot be read or such a file holds no colours.
Result<lsystem::ModelSource> load_model_source(std::filesystem::path const& path,
                                               ModelCompanions const& companions = {});

// Prints a warning for each view and each file of colours beside the model that it does not use and
// that is no other model's; none of a kind that somebody has chosen.
void warn_of_unused_companions(std::filesystem::path const& path,
                               ModelCompanions const& companions = {});

// True for names of files, as models include them, that lead out of the model's folder.
bool leads_out_of_folder(std::filesystem::path const& name);

// Gives what a model includes (other rules, functions) from the model's folder. Names that lead out
// of that folder are refused. What is not there may be made by a method (all_inputs.h).
lsystem::IncludeReader model_includes(std::filesystem::path const& path);

// Reads a model and its companions as an edit, so that a scene holds the model's texts and needs no
// file again. Fails like load_model_source(), and with what is wrong in the model's text.
Result<scene::LoadModel> load_model_edit(std::filesystem::path const& path,
                                         ModelCompanions const& companions = {});

// A plant as an edit: a model as above; the skeleton that another program has drawn as lines, in a
// Wavefront OBJ file (skeleton_lines.h) or a binary glTF file (glb_lines.h), if the name ends in
// .obj or .glb; or a measured plant (measured_file.h). Fails like load_model_edit() and as the
// readers of those files do; a .gltf is refused. Warns of what a model does not use.
Result<scene::Edit> load_plant_edit(std::filesystem::path const& path,
                                    ModelCompanions const& companions = {});

// Reads and compiles a model and its companions. Fails like load_model_edit().
Result<lsystem::Model> load_model(std::filesystem::path const& path,
                                  ModelCompanions const& companions = {});

} // namespace tractus::io
