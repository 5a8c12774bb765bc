#include "sim/feature_store.h"

#include <map>
#include <memory>

namespace tractus::sim {

UhidAnswers remember_features()
{
    using Store = std::map<std::uint8_t, std::vector<std::byte>>;
    // Both functions share one store.
    auto const store = std::make_shared<Store>();
    return {
        .get_feature = [store](std::uint8_t id) -> std::optional<std::vector<std::byte>> {
            auto const found = store->find(id);
            return found == store->end() ? std::vector { std::byte { id } } : found->second;
        },
        .set_feature =
            [store](std::span<std::byte const> report) {
                if (!report.empty())
                    (*store)[std::to_integer<std::uint8_t>(report[0])].assign(report.begin(),
                                                                              report.end());
                return true;
            },
    };
}

} // namespace tractus::sim
