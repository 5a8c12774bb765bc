#include "engine/scene/compose_base.h"

#include "engine/plant/join_plants.h"
#include "engine/scene/limb_edits.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <fmt/core.h>
#include <optional>
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
        auto const order = place.on == kNone ? 0 : order_of(place.on) + 1;
        models_.push_back({ &base, next_appearance_offsets(whole_), order });
        append({ .prefix = prefix, .plant = base.plant, .index = base.rest->addresses.index() },
               place);
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

    void add_limb(Graft const& graft)
    {
        auto const on = bearer_of(graft.at);
        if (!on) {
            warn(fmt::format("{} waits: the branch that it was drawn on is not there", graft.name));
            return;
        }
        auto const& limb = *graft.limb;
        auto const [base, tip] = nodes_of(whole_, *on);
        Vec3 const base_mm = whole_.node_position_mm[base];
        Vec3 const step_mm = whole_.node_position_mm[tip] - base_mm;
        auto const radius = [&](NodeId node) { return double(whole_.node_radius_mm[node]); };
        auto const model = models_[part_with(graft.at)];
        variation::LimbAttachment seat {
            .order = order_of(*on) - std::min(model.order, order_of(*on)),
            .radius_mm = radius(base) + limb.joint * (radius(tip) - radius(base)),
        };
        if (double const length_mm = step_mm.norm(); length_mm > 0)
            seat.direction = step_mm / length_mm;
        auto made = std::make_shared<Plant const>(
            variation::make_limb(*model.base->plant, *model.base->rest, limb.points, seat));
        models_.push_back(model); // Limbs on this limb imitate the same plant.
        append({ .prefix = graft.prefix, .plant = made, .index = AddressIndex(*made) },
               { .on = *on,
                 .moved_mm = base_mm + limb.joint * step_mm,
                 .keeps_base = true,
                 .looks = model.looks });
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
    // The base plant of a part. For a limb, the base plant of the part whose branches the limb
    // imitates.
    struct PartModel {
        BasePlant const* base = nullptr;
        // Offsets of the part's materials and shapes in the whole plant.
        AppearanceOffsets looks {};
        std::uint32_t order = 0; // Branching order of the part's stems in the whole plant.
    };

    PlantAddresses addresses() const { return PlantAddresses(parts_); }

    std::uint32_t order_of(SegmentId segment) const
    {
        return whole_.axes[axis_of(whole_, segment)].order;
    }

    void append(PlantPart part, PartPlace const& place)
    {
        part.in_whole = append_part(whole_, *part.plant, place, hidden_of(part));
        parts_.push_back(std::move(part));
    }

    // Returns the index of the innermost part that contains an address.
    std::size_t part_with(SegmentAddress const& at) const
    {
        std::size_t innermost = 0;
        for (std::size_t i = 1; i < parts_.size(); ++i)
            if (parts_[i].prefix.size() > parts_[innermost].prefix.size()
                && is_in_part(parts_[i].prefix, at))
                innermost = i;
        return innermost;
    }

    // Returns the segment to which a limb is attached. If the branch has become shorter since the
    // limb was drawn, or is missing, as in another individual, this is the nearest segment below.
    // No value if the part is missing or the segment is hidden.
    std::optional<SegmentId> bearer_of(SegmentAddress const& at) const
    {
        auto const& part = parts_[part_with(at)];
        auto own = without_part(part.prefix, at);
        if (own.empty() || own.front() == kPartOfPlant)
            return std::nullopt;
        auto found = part.index.find_segment(*part.plant, own);
        while (!found) {
            bool const is_keyed = own.size() == 4 && own.front() == kKeyedAxis;
            if (own.size() < 2 || is_keyed)
                return std::nullopt;
            own.back() = 0;
            if (auto const first = part.index.find_segment(*part.plant, own)) {
                auto const& axis = part.plant->axes[axis_of(*part.plant, *first)];
                found = axis.first_segment + axis.segment_count - 1;
            } else {
                own.resize(own.size() - 2);
                found = part.index.find_segment(*part.plant, own);
            }
        }
        if (part.in_whole[*found] == kNone)
            return std::nullopt;
        return part.in_whole[*found];
    }

    // Returns for each segment of a part whether the user has hidden it, or an empty list if none
    // is hidden. Descendants of hidden segments are not marked.
    std::vector<bool> hidden_of(PlantPart const& part) const
    {
        std::vector<bool> hidden;
        for (auto const& at : plant_.hidden_branches) {
            if (!is_in_part(part.prefix, at))
                continue;
            auto const own = part.index.find_segment(*part.plant, without_part(part.prefix, at));
            if (!own) // The segment belongs to a part of this part, or does not exist at present.
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
    // What the limbs on each part imitate, in the order of parts_.
    std::vector<PartModel> models_;
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
        if (plant.grafts[i].limb)
            composition.add_limb(plant.grafts[i]);
        else
            composition.add(plant.grafts[i], *parts[i]);
    return composition.finish(*own);
}

} // namespace tractus::scene
