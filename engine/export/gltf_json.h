#pragma once

#include <cstddef>
#include <cstdint>
#include <set>
#include <string>
#include <string_view>

namespace tractus {

// A JSON array that grows.
class JsonArray {
public:
    // Answers the new element's index.
    std::size_t add(std::string_view element);

    std::size_t count() const { return count_; }
    std::string const& text() const { return text_; } // Without brackets.

private:
    std::string text_;
    std::size_t count_ = 0;
};

// A glTF 2.0 document as it is put together: elements as text, extensions by name.
struct GltfJson {
    JsonArray scene; // The scene's root nodes.
    JsonArray nodes, meshes, materials, textures, images, samplers, accessors, buffer_views,
        animations;
    // Those that a reader must know, and those that it may pass over.
    std::set<std::string> required_extensions;
    std::set<std::string> optional_extensions;

    // The document, with a buffer of so many bytes.
    std::string text(std::uint64_t buffer_bytes) const;
};

// A JSON string, quotes included; what is not UTF-8 becomes a replacement character.
std::string quoted(std::string const& text);

} // namespace tractus
