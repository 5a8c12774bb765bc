#include "drivers/pens/families.h"

#include "drivers/pens/small_makers.h"
#include "drivers/pens/uclogic.h"
#include "drivers/pens/veikk.h"
#include "drivers/pens/wacom.h"
#include "drivers/pens/xp_pen.h"

#include <algorithm>
#include <vector>

namespace tractus::drivers {

std::span<PenFamily const> pen_families()
{
    static auto const families = [] {
        std::vector<PenFamily> all;
        for (auto const some : { wacom_families(), uclogic_families(), xp_pen_families(),
                                 veikk_families(), small_makers_families() })
            all.insert(all.end(), some.begin(), some.end());
        return all;
    }();
    return families;
}

PenFamily const* find_pen_family(std::string_view name)
{
    auto const families = pen_families();
    auto const found = std::find_if(families.begin(), families.end(),
                                    [&](auto const& family) { return family.name == name; });
    return found == families.end() ? nullptr : &*found;
}

} // namespace tractus::drivers
