#include "engine/scene/edit_ids.h"

#include "engine/scene/anchored.h"

namespace tractus::scene {

namespace {

class IdGiver final : public Fields {
public:
    explicit IdGiver(ItemId id)
        : id_(id)
    {
    }

    void field(char const*, FieldRef) override { }
    void word(char const*, int&, std::span<char const* const>) override { }
    void numbers(Stroke&) override { }
    void numbers(std::vector<SkeletonPiece>&) override { }
    void bytes(std::string&) override { }
    void id(std::uint64_t& id) override
    {
        if (id == 0)
            id = id_;
    }

private:
    ItemId id_;
};

} // namespace

Edit with_id(Edit const& edit, std::uint64_t number)
{
    IdGiver giver(item_id(number, 0));
    return edit.changed_by(giver);
}

} // namespace tractus::scene
