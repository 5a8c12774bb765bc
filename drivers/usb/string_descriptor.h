#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace tractus::drivers {

// Returns the text of a USB string descriptor (USB 2.0, section 9.6.7) in UTF-8; `bytes` is the
// descriptor without its length and type. Never fails: tablets store numbers in such descriptors,
// so unpaired UTF-16 surrogates are encoded like other code points, and an odd last byte is
// dropped.
std::string string_descriptor_text(std::span<std::byte const> bytes);

// Returns the descriptor bytes that string_descriptor_text() converts to `text`.
std::vector<std::byte> string_descriptor_bytes(std::string_view text);

} // namespace tractus::drivers
