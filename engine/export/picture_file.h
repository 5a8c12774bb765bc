#pragma once

#include <string>

namespace tractus::exports {

// A picture that an exported file refers to and that must be stored beside it.
struct PictureFile {
    std::string name;
    std::string bytes; // Contents of a PNG file; of a JPEG file for pictures that were imported.
};

} // namespace tractus::exports
