#pragma once

#include <string_view>

namespace tractus::drivers {

// drivers/tablets/tablets.txt, as it was when the program was built.
std::string_view tablets_text();

} // namespace tractus::drivers
