#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace tractus {

// Encodes bytes as base64 (RFC 4648, section 4), padded with =.
std::string base64(std::string_view bytes);

// Decodes base64 text, with or without its padding. Returns no value if the text contains any other
// character.
std::optional<std::string> from_base64(std::string_view text);

} // namespace tractus
