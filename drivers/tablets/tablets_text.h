#pragma once

#include <string_view>

namespace tractus::drivers {

// Returns the text of drivers/tablets/tablets.txt, as it was when the program was built.
std::string_view tablets_text();

} // namespace tractus::drivers
