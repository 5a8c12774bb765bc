#include "engine/plant/plant_addresses.h"

#include "engine/base/check.h"

#include <algorithm>
#include <cstddef>

namespace tractus {

static constexpr std::size_t kPrefixLength = 4;

// Number of elements in the part prefix of an address.
static std::size_t prefix_length(SegmentAddress const& address)
{
    std::size_t length = 0;
    while (address.size() >= length + kPrefixLength && address[length] == kPartOfPlant)
        length += kPrefixLength;
    return length;
}

static SegmentAddress tail(SegmentAddress const& address, std::size_t from)
{
    return { address.begin() + static_cast<std::ptrdiff_t>(from), address.end() };
}

PartPrefix part_prefix(std::uint64_t id)
{
    constexpr int kHalf = 32;
    return { kPartOfPlant, static_cast<std::uint32_t>(id), static_cast<std::uint32_t>(id >> kHalf),
             0 };
}

std::uint64_t part_of(SegmentAddress const& address)
{
    constexpr int kHalf = 32;
    if (prefix_length(address) == 0)
        return 0;
    return std::uint64_t { address[2] } << kHalf | address[1];
}

SegmentAddress in_part(PartPrefix const& prefix, SegmentAddress const& address)
{
    auto whole = prefix;
    whole.insert(whole.end(), address.begin(), address.end());
    return whole;
}

PathAddress in_part(PartPrefix const& prefix, PathAddress const& address)
{
    return { in_part(prefix, address.first), in_part(prefix, address.last) };
}

bool is_in_part(PartPrefix const& prefix, SegmentAddress const& address)
{
    return address.size() >= prefix.size()
        && std::equal(prefix.begin(), prefix.end(), address.begin());
}

SegmentAddress without_part(PartPrefix const& prefix, SegmentAddress const& address)
{
    CHECK(is_in_part(prefix, address));
    return tail(address, prefix.size());
}

PathAddress without_part(PartPrefix const& prefix, PathAddress const& address)
{
    return { without_part(prefix, address.first), without_part(prefix, address.last) };
}

PlantAddresses::PlantAddresses(std::vector<PlantPart> parts)
{
    SegmentId first = 0;
    for (auto& part : parts) {
        auto& shown = parts_.emplace_back();
        static_cast<PlantPart&>(shown) = std::move(part);
        shown.first = first;
        for (SegmentId own = 0; own < shown.in_whole.size(); ++own)
            if (shown.in_whole[own] != kNone)
                shown.own.push_back(own);
        first += static_cast<SegmentId>(shown.own.size());
    }
}

std::pair<PlantPart const*, SegmentId> PlantAddresses::part_with(SegmentId segment) const
{
    auto const behind = std::upper_bound(
        parts_.begin(), parts_.end(), segment,
        [](SegmentId wanted, ShownPart const& part) { return wanted < part.first; });
    CHECK(behind != parts_.begin());
    auto const& part = *(behind - 1);
    return { &part, part.own.at(segment - part.first) };
}

SegmentAddress PlantAddresses::address_of(Plant const& plant, SegmentId segment) const
{
    if (parts_.empty())
        return whole_.address_of(plant, segment);
    auto const [part, own] = part_with(segment);
    return in_part(part->prefix, part->index.address_of(*part->plant, own));
}

PathAddress PlantAddresses::address_of(Plant const& plant, std::vector<SegmentId> const& path) const
{
    CHECK(!path.empty());
    if (parts_.empty())
        return whole_.address_of(plant, path);
    auto const [first, first_own] = part_with(path.front());
    auto const [last, last_own] = part_with(path.back());
    auto const lowest = first->index.address_of(*first->plant, std::vector { first_own }).first;
    auto const highest = last->index.address_of(*last->plant, std::vector { last_own }).last;
    return { in_part(first->prefix, lowest), in_part(last->prefix, highest) };
}

std::optional<SegmentId> PlantAddresses::find_segment(Plant const& plant,
                                                      SegmentAddress const& address) const
{
    if (parts_.empty())
        return whole_.find_segment(plant, address);
    auto const length = prefix_length(address);
    for (auto const& part : parts_) {
        if (part.prefix.size() != length || !is_in_part(part.prefix, address))
            continue;
        auto const own = part.index.find_segment(*part.plant, tail(address, length));
        if (!own || part.in_whole[*own] == kNone)
            return std::nullopt;
        return part.in_whole[*own];
    }
    return std::nullopt;
}

std::optional<std::vector<SegmentId>> PlantAddresses::find_path(Plant const& plant,
                                                                PathAddress const& address) const
{
    auto const first = find_segment(plant, address.first);
    auto const last = find_segment(plant, address.last);
    if (!first || !last)
        return std::nullopt;
    return path_between(plant, *first, *last);
}

} // namespace tractus
