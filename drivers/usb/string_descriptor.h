#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace tractus::drivers {

// The text in a USB string descriptor (USB 2.0 section 9.6.7), in UTF-8; `bytes` is what follows
// its length and type. Never fails: tablets put numbers into such descriptors, so halves of UTF-16
// pairs are kept as UTF-8 would write them, and a last odd byte is dropped.
std::string string_descriptor_text(std::span<std::byte const> bytes);

// The bytes that string_descriptor_text made the text of.
std::vector<std::byte> string_descriptor_bytes(std::string_view text);

} // namespace tractus::drivers
