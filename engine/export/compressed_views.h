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

// A buffer view that EXT_meshopt_compression compresses, as its file describes it.
struct CompressedView {
    std::size_t view = 0;   // Index of the view.
    std::size_t buffer = 0; // Buffer that holds the compressed bytes.
    std::uint64_t offset = 0;
    std::uint64_t bytes = 0;
    std::uint64_t stride = 0;
    std::uint64_t count = 0;
    std::string mode {};
    std::string filter = "NONE";
};

struct CompressedViews {
    std::vector<CompressedView> views {};
    // The file with buffers of a byte in place of those that are not there, which tinygltf would
    // look for. Empty where there are no views.
    std::string glb {};
};

// Finds them in a binary glTF file whose header is sound and whose JSON is not too deep.
Result<CompressedViews> find_compressed_views(std::string_view glb);

// Decompresses the views of the parsed file into a buffer that is added to the others. No size is
// believed: fails if one cannot be, if views share compressed bytes, and on damaged ones.
Result<void> decompress_views(std::vector<CompressedView> const& views, tinygltf::Model& model);

} // namespace tractus::exports
