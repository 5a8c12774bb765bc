#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace tractus {

// Bytes as text of 64 signs (RFC 4648, section 4), padded with =.
std::string base64(std::string_view bytes);

// The bytes of such a text, with or without what it is padded with; no value where it has other
// signs.
std::optional<std::string> from_base64(std::string_view text);

} // namespace tractus
