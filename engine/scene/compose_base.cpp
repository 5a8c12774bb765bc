#include "engine/scene/compose_base.h"

#include "engine/plant/join_plants.h"

#include <algorithm>
#include <fmt/core.h>
#include <utility>

namespace tractus::scene {

namespace {

class Composition {
public:
    explicit Composition(PlantState const& plant)
        : plant_(plant)
    {
    }

    void add(PartPrefix const& prefix, BasePlant const& base, PartPlace const& place)
    {
        PlantPart part { .prefix = prefix,
                         .plant = base.plant,
                         .index = base.rest->addresses.index() };
        part.in_whole = append_part(whole_, *base.plant, place, hidden_of(part));
        parts_.push_back(std::move(part));
        for (auto const& warning : base.warnings)
            warn(warning);
    }

    void add(Graft const& graft, BasePlant const& base)
    {
        auto const on = addresses().find_segment(whole_, graft.at);
        if (!on) {
            warn(fmt::format("{} waits: the branch that it was put on is not there", graft.name));
            return;
        }
        PartPlace place { .on = *on };
        if (auto const angle = graft.turn_rad.norm(); angle > 0)
            place.turn = Eigen::AngleAxisd(angle, graft.turn_rad / angle);
        place.moved_mm = whole_.node_position_mm[nodes_of(whole_, *on).tip] + graft.base_mm;
        add(graft.prefix, base, place);
    }

    std::shared_ptr<BasePlant const> finish(BasePlant const& own)
    {
        auto base = std::make_shared<BasePlant>();
        base->fitted = place_on_desk(whole_);
        rescale(base->fitted, own.fitted.scale); // Parts do not affect the document's scale.
        base->plant = std::make_shared<Plant const>(std::move(whole_));
        base->rest = variation::SharedRestShape(base->plant, addresses());
        base->warnings = std::move(warnings_);
        return base;
    }

private:
    PlantAddresses addresses() const { return PlantAddresses(parts_); }

    // By segment of the part: whether it is hidden. Descendants of hidden segments are not marked.
    std::vector<bool> hidden_of(PlantPart const& part) const
    {
        std::vector<bool> hidden;
        for (auto const& at : plant_.hidden_branches) {
            if (!is_in_part(part.prefix, at))
                continue;
            auto const own = part.index.find_segment(*part.plant, without_part(part.prefix, at));
            if (!own) // The segment is in a part of this part, or does not exist at present.
                continue;
            hidden.resize(part.plant->segment_count());
            hidden[*own] = true;
        }
        return hidden;
    }

    void warn(std::string const& warning)
    {
        if (std::find(warnings_.begin(), warnings_.end(), warning) == warnings_.end())
            warnings_.push_back(warning);
    }

    PlantState const& plant_;
    Plant whole_;
    std::vector<PlantPart> parts_;
    std::vector<std::string> warnings_;
};

} // namespace

bool is_composed(PlantState const& plant)
{
    return !plant.grafts.empty() || !plant.hidden_branches.empty();
}

std::shared_ptr<BasePlant const>
compose_base(PlantState const& plant, std::shared_ptr<BasePlant const> const& own,
             std::vector<std::shared_ptr<BasePlant const>> const& parts)
{
    Composition composition(plant);
    composition.add({}, *own, {});
    for (std::size_t i = 0; i < parts.size(); ++i)
        composition.add(plant.grafts[i], *parts[i]);
    return composition.finish(*own);
}

} // namespace tractus::scene
