#pragma once

#include "engine/base/result.h"

#include <filesystem>
#include <string>
#include <string_view>

namespace tractus::controllers {

// A file's stem as a name for people: "lombardy_poplar" is "Lombardy poplar".
std::string name_in_words(std::string stem);

// What a drawing is called: as a person has named its session (Session::name()); else after the
// plant, where the file is named so (unnamed_session.h), or after the file.
std::string name_of_drawing(std::filesystem::path const& session, std::string const& given);

// A name as a person has typed it, without blanks around it. Fails, as the user's fault, if it is
// empty, longer than 60 bytes, or has characters that are no text.
Result<std::string> name_as_typed(std::string_view typed);

// A name as a part of a file's name.
std::string file_name_of(std::string name);

} // namespace tractus::controllers
