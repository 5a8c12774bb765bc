#pragma once

#include <cstddef>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

namespace tractus::exports {

// Members stay in the order in which they were added.
using Json = nlohmann::ordered_json;

// A number that is read back as the same double or float: a float without the digits that only a
// double needs. Whole ones have no point, and 0 has no sign.
Json json_number(double value);
Json json_number(float value);

// An array of an Eigen vector's numbers.
template<typename Vector> Json json_numbers(Vector const& vector)
{
    Json::array_t numbers;
    numbers.reserve(static_cast<std::size_t>(vector.size()));
    for (auto const value : vector)
        numbers.push_back(json_number(value));
    return numbers;
}

// A value as text; what is not UTF-8 becomes a replacement character.
std::string json_text(Json const& value);

// A JSON array that grows. Its elements are kept as text: a file may have a million nodes, and as
// values they would take several times as much memory.
class JsonArray {
public:
    // Returns the new element's index.
    std::size_t add(Json const& element);

    std::size_t count() const { return count_; }
    std::string const& text() const { return text_; } // Excludes the brackets.

private:
    std::string text_;
    std::size_t count_ = 0;
};

// A glTF 2.0 document as it is put together: elements in arrays, extensions by name.
struct GltfJson {
    std::vector<std::size_t> scene; // The scene's root nodes.
    JsonArray nodes, meshes, materials, textures, images, samplers, accessors, buffer_views,
        animations;
    // Extensions that a reader must know, and those that it may pass over.
    std::set<std::string> required_extensions;
    std::set<std::string> optional_extensions;
    // Bytes of the second buffer, which is not there: compressed views say that they lie in it
    // decompressed.
    std::uint64_t fallback_bytes = 0;

    // The document, with a buffer of so many bytes, and that one if it has any.
    std::string text(std::uint64_t buffer_bytes) const;
};

} // namespace tractus::exports
