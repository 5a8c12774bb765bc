#pragma once

#include "engine/base/result.h"

#include <filesystem>
#include <string>
#include <string_view>

namespace tractus::controllers {

// Makes a display name of a file's stem: "lombardy_poplar" becomes "Lombardy poplar".
std::string name_in_words(std::string stem);

// The display name of a drawing: `given`, the session's own name (Session::name()), if there is
// one; otherwise the plant's name for a generated file name (unnamed_session.h), or else the
// file's.
std::string name_of_drawing(std::filesystem::path const& session, std::string const& given);

// Trims spaces around a typed name. Fails with a user error if it is empty, longer than 60 bytes,
// or has characters that are not printable text.
Result<std::string> name_as_typed(std::string_view typed);

// Converts a name to part of a file name.
std::string file_name_of(std::string name);

} // namespace tractus::controllers
