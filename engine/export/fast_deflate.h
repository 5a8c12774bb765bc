#pragma once

#include <cstdint>
#include <span>
#include <string>

namespace tractus::exports {

// Appends data as blocks of a deflate stream (RFC 1951) that is not finished by them. The blocks
// end on a byte, so that pieces which were packed by themselves can be joined.
//
// It looks for nothing but runs of zeros and codes all else by its frequency, which suits the
// filtered rows of painted pictures: several times as fast as a search for repetitions, which such
// rows hardly have. The same data always give the same bytes.
void append_deflated(std::span<std::uint8_t const> data, std::string& to);

// The last, empty block of a deflate stream.
void finish_deflated(std::string& to);

} // namespace tractus::exports
