#pragma once

#include "engine/base/result.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace tinygltf {
class Model;
}

namespace tractus::exports {

// A buffer view compressed by EXT_meshopt_compression, as the file's JSON describes it; not yet
// validated.
struct CompressedView {
    std::size_t view = 0;   // Index of the buffer view.
    std::size_t buffer = 0; // Index of the buffer that holds the compressed bytes.
    std::uint64_t offset = 0;
    std::uint64_t bytes = 0;
    std::uint64_t stride = 0;
    std::uint64_t count = 0;
    std::string mode {};
    std::string filter = "NONE";
};

struct CompressedViews {
    std::vector<CompressedView> views {};
    // A copy of the file for tinygltf, which would try to load the missing fallback buffers: it has
    // one-byte buffers in their place. Empty if there are no compressed views.
    std::string glb {};
};

// Finds the compressed views of a binary glTF file, of which parse_glb() must have checked the
// header and the depth of the JSON. Fails if a size of a view is not a whole number.
Result<CompressedViews> find_compressed_views(std::string_view glb);

// Decompresses the views of the parsed file into an additional buffer. Fails if a size is
// impossible, if the views claim more compressed bytes than the buffers have, or if the data are
// damaged.
Result<void> decompress_views(std::vector<CompressedView> const& views, tinygltf::Model& model);

} // namespace tractus::exports
