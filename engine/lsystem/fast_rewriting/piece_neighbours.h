#pragma once

#include "engine/lsystem/language/model.h"
#include "engine/lsystem/language/module_string.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace tractus::lsystem {

// The roles of each kind of module when neighbours are searched for.
struct NeighbourRoles {
    // Role of a kind: an ordinary module, one that contexts ignore, or an opening or closing
    // bracket.
    enum class Role : std::uint8_t { Seen, Ignored, Opening, Closing };

    std::array<Role, 256> of_kind {};
    KindId none = 0;           // Value that represents "no neighbour".
    bool sees_branches = true; // True if right contexts distinguish branches.
};

// A piece of a string in a parallel search for each module's neighbours. Neighbours outside the
// piece are unknown when it is scanned; they are represented by placeholders and resolved by
// join_neighbours(). Pieces can therefore be scanned at the same time.
class PieceNeighbours {
public:
    // Writes the right neighbours of the piece's modules, `begin` to `end` of the string, except
    // those that lie after the piece. `rights` has an entry for each module of the string.
    void read(NeighbourRoles const& roles, KindId const* string, std::size_t begin, std::size_t end,
              KindId* rights);

    // Writes the right neighbours that lie after the piece; to be called after join_neighbours().
    void write_missing(KindId* rights) const;

    // The left neighbour of the piece's first module; valid after join_neighbours().
    KindId left() const { return left_; }
    // Left neighbours of the modules that follow the branches which begin before the piece and end
    // in it. The last entry is for the first branch to end. There are fewer if brackets do not
    // match.
    std::vector<KindId> const& waiting_lefts() const { return waiting_lefts_; }

private:
    template<bool kSeesBranches>
    void read_all(NeighbourRoles const& roles, KindId const* string, std::size_t begin,
                  std::size_t end, KindId* rights);

    friend void join_neighbours(NeighbourRoles const& roles, std::span<PieceNeighbours> pieces);

    // A kind; or kOutside + i, a placeholder for the right neighbour at the piece's end, seen from
    // i open branches further out.
    using Neighbour = std::uint32_t;
    static constexpr Neighbour kOutside = 256;

    struct Missing {
        std::size_t module = 0;
        std::size_t outside = 0;
    };

    KindId value(Neighbour neighbour) const
    {
        return static_cast<KindId>(neighbour < kOutside ? neighbour
                                                        : outside_[neighbour - kOutside]);
    }
    void take_from_right(NeighbourRoles const& roles, KindId& right, std::vector<KindId>& waiting);
    void take_from_left(NeighbourRoles const& roles, KindId& left, std::vector<KindId>& waiting);

    // Modules whose right neighbours are unknown, in right-to-left order.
    std::vector<Missing> missing_;
    Neighbour right_ = 0; // Right neighbour of the module before the piece.
    // Right neighbour of each branch that begins before the piece and ends in it.
    Column<Neighbour> waiting_;
    std::size_t taken_count_ = 0; // Number of branches that begin in the piece and end after it.
    std::vector<KindId> outside_; // Values of the placeholders kOutside + i.
    // Left neighbours at the end of the piece, and before each of the branches that begin in the
    // piece and end after it, from the last to the first. No value: the same as the next entry.
    std::vector<std::optional<KindId>> lefts_;
    std::size_t closing_count_ = 0; // Number of branches that begin before the piece and end in it.
    KindId left_ = 0;
    std::vector<KindId> waiting_lefts_;
};

// Passes the neighbours from outside to each piece of the string, in both directions.
void join_neighbours(NeighbourRoles const& roles, std::span<PieceNeighbours> pieces);

} // namespace tractus::lsystem
