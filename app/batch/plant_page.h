#pragma once

#include "engine/base/result.h"
#include "engine/export/glb_writer.h"

#include <ostream>
#include <span>
#include <string>

namespace tractus::batch {

// Writes a web page that shows plants and lets people turn them, in any browser with WebGL 2. The
// page is one file: it contains the plants as glTF, in quantized vertices with instanced organs,
// and asks the network for nothing. Of `options` the textures and before_writing() are used.
//
// `title` stands above the plants; it is in UTF-8. Fails like exports::write_glb(); the sizes that
// it returns are those of the glTF, three quarters of the page's.
Result<exports::GlbSummary> write_page(std::ostream& out, std::string const& title,
                                       std::span<exports::PlacedMesh const> plants,
                                       exports::GlbOptions const& options);

} // namespace tractus::batch
