#pragma once

#include <cstddef>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

namespace tractus::exports {

// A JSON value whose objects keep their members in the order of insertion.
using Json = nlohmann::ordered_json;

// Returns a number that reads back as the same double or float. A float gets no digits that only a
// double would need. Whole numbers are written without a decimal point, and 0 without a sign.
Json json_number(double value);
Json json_number(float value);

// Returns the elements of an Eigen vector as an array.
template<typename Vector> Json json_numbers(Vector const& vector)
{
    Json::array_t numbers;
    numbers.reserve(static_cast<std::size_t>(vector.size()));
    for (auto const value : vector)
        numbers.push_back(json_number(value));
    return numbers;
}

// Returns a value as text; invalid UTF-8 becomes replacement characters.
std::string json_text(Json const& value);

// A JSON array for many elements. They are stored as text: a file may have a million nodes, and as
// JSON values they would take several times as much memory.
class JsonArray {
public:
    // Appends an element; returns its index.
    std::size_t add(Json const& element);

    std::size_t count() const { return count_; }
    std::string const& text() const { return text_; } // The elements without the array's brackets.

private:
    std::string text_;
    std::size_t count_ = 0;
};

// A glTF 2.0 document under construction: its arrays of elements, and the names of its extensions.
struct GltfJson {
    std::vector<std::size_t> scene; // Indices of the scene's root nodes.
    JsonArray nodes, meshes, materials, textures, images, samplers, accessors, buffer_views,
        animations;
    // Names of extensions that a reader must support, and of those that it may ignore.
    std::set<std::string> required_extensions;
    std::set<std::string> optional_extensions;
    // Size of the fallback buffer (EXT_meshopt_compression). It is declared but not stored;
    // compressed views refer to the places in it where their decompressed data would be.
    std::uint64_t fallback_bytes = 0;

    // Returns the document as text, with a buffer of `buffer_bytes`, and with the fallback buffer
    // if it has a size.
    std::string text(std::uint64_t buffer_bytes) const;
};

} // namespace tractus::exports
