#include "engine/base/check.h"

#include <cstdio>
#include <cstdlib>

namespace tractus::detail {

void check_failed(char const* expression, char const* file, int line)
{
    std::fprintf(stderr, "station error: CHECK(%s) failed at %s:%d\n", expression, file, line);
    std::abort();
}

} // namespace tractus::detail
