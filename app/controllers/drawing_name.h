#pragma once

#include "engine/base/result.h"

#include <filesystem>
#include <string>
#include <string_view>

namespace tractus::controllers {

// Makes a display name from a file's stem: "lombardy_poplar" becomes "Lombardy poplar".
std::string name_in_words(std::string stem);

// Returns the display name of a drawing. This is `given`, the session's own name (Session::name()),
// if that is not empty. Otherwise it is made from the file's name, without the time that a
// generated name contains (unnamed_session.h).
std::string name_of_drawing(std::filesystem::path const& session, std::string const& given);

// Removes spaces around a typed name. Fails with a user error if the name is empty, longer than 60
// bytes, or contains characters that cannot be printed.
Result<std::string> name_as_typed(std::string_view typed);

// Converts a name to a form that can be part of a file name.
std::string file_name_of(std::string name);

} // namespace tractus::controllers
