#pragma once

#include <cstddef>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

namespace tractus::exports {

// A JSON value that keeps the members of objects in the order of insertion.
using Json = nlohmann::ordered_json;

// Returns a number that reads back as the same double or float; a float has no digits that only a
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

// A JSON array for many elements. They are stored as text, since a file may have a million nodes,
// which would take several times as much memory as values.
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

// A glTF 2.0 document under construction: elements in arrays, extensions by name.
struct GltfJson {
    std::vector<std::size_t> scene; // The scene's root nodes.
    JsonArray nodes, meshes, materials, textures, images, samplers, accessors, buffer_views,
        animations;
    // Names of extensions that a reader must support, and of those that it may ignore.
    std::set<std::string> required_extensions;
    std::set<std::string> optional_extensions;
    // Size of the fallback buffer, which is declared but not stored: compressed views refer to
    // their decompressed data in it.
    std::uint64_t fallback_bytes = 0;

    // Returns the document, with a buffer of `buffer_bytes`, and the fallback buffer if it is used.
    std::string text(std::uint64_t buffer_bytes) const;
};

} // namespace tractus::exports
