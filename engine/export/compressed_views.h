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

// A buffer view compressed by EXT_meshopt_compression, as described in the file.
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
    // The file with one-byte buffers in place of the missing fallback buffers, which tinygltf would
    // try to load. Empty if there are no compressed views.
    std::string glb {};
};

// Finds the compressed views of a binary glTF file. Fails if its header is invalid or its JSON is
// nested too deeply.
Result<CompressedViews> find_compressed_views(std::string_view glb);

// Decompresses the views of the parsed file into an additional buffer. All sizes are validated:
// fails if one is impossible, if views share compressed bytes, or if the data are damaged.
Result<void> decompress_views(std::vector<CompressedView> const& views, tinygltf::Model& model);

} // namespace tractus::exports
