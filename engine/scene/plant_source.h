#pragma once

#include "engine/base/result.h"
#include "engine/lsystem/language/limits.h"
#include "engine/lsystem/language/model.h"
#include "engine/plant/branch_address.h"
#include "engine/plant/plant.h"

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace tractus::scene {

// Limits and outputs of building a plant. They are not part of the document: they decide only
// whether a plant can be built, not its shape.
struct LoadOptions {
    lsystem::ModelLimits limits {};
    // Receives the text that the model prints; if empty, the text is discarded.
    std::function<void(std::string_view text)> print {};
};

// Returns the limits and outputs for the plant that is built next.
using MakeLoadOptions = std::function<LoadOptions()>;

struct BuiltSource {
    Plant plant {};
    // Warnings, each once, such as features of the source that are not supported.
    std::vector<std::string> warnings {};
    AxisKeys axis_keys {};
};

// A model in the language of cpfg, with the files that it includes, by their names.
struct SourceModel {
    lsystem::ModelSource source {};
    std::map<std::string, std::string> includes {};
};

// Random variation of a plant's source, by which the plants of a collection differ.
struct SourceVariation {
    std::uint64_t seed = 1;
    std::uint32_t plant = 0; // Number of the plant in the collection.
    // Distinguishes sources with the same plant number, such as those of one plant's parts.
    std::uint32_t stream = 0;
    // Amount of variation: 0 is none, 1 that between individuals of a species; at most 4.
    double spread = 1;
};

// User-written rules, with a view file, that replace those of a model generated from a drawing.
struct SourceRules {
    std::string text {};
    std::string view_text {};

    bool operator==(SourceRules const&) const = default;
};

// A kind of plant source: the functions that make base plants from drawn or written data. The data
// are immutable values of one type; edits put them into a document.
struct SourceKind {
    char const* word; // Name of the kind, such as "lsystem".
    // Builds the plant. Fails, in one sentence, if there is no valid plant or it exceeds its
    // limits.
    Result<BuiltSource> (*build)(void const* drawn, LoadOptions const& options);
    // Returns true only if both values certainly give the same plant.
    bool (*same)(void const* one, void const* other);
    // Returns the equivalent model in cpfg's language, for other programs. Null if the kind has no
    // such model.
    Result<SourceModel> (*model)(void const* drawn) = nullptr;
    // Returns a varied copy: drawn elements stay at or near their positions, and what is derived
    // from them varies. The same variation gives the same copy. Null if the kind does not vary.
    std::shared_ptr<void const> (*vary)(void const* drawn, SourceVariation const& variation)
        = nullptr;
    // Returns a copy whose model uses `rules` or, if these have no value, the generated rules
    // again. Values that the rules refer to are still computed from the drawing. Null if rules
    // cannot be replaced.
    std::shared_ptr<void const> (*with_rules)(void const* drawn,
                                              std::optional<SourceRules> const& rules)
        = nullptr;
};

// Makes the table row for sources of type T, which must be comparable.
template<typename T, Result<BuiltSource> (*build)(T const&, LoadOptions const&)>
constexpr SourceKind make_source_kind(char const* word)
{
    return { .word = word,
             .build =
                 [](void const* drawn, LoadOptions const& options) {
                     return build(*static_cast<T const*>(drawn), options);
                 },
             .same =
                 [](void const* one, void const* other) {
                     return *static_cast<T const*>(one) == *static_cast<T const*>(other);
                 } };
}

// The source from which a base plant is built. A value: copies share the drawn data.
class PlantSource {
public:
    PlantSource() = default; // Makes an empty source, which gives a plant without branches.

    template<typename T>
    PlantSource(SourceKind const& kind, T drawn)
        : kind_(&kind)
        , drawn_(std::make_shared<T const>(std::move(drawn)))
    {
    }

    bool empty() const { return kind_ == nullptr; }

    Result<BuiltSource> build(LoadOptions const& options) const
    {
        return empty() ? BuiltSource {} : kind_->build(drawn_.get(), options);
    }

    // Returns the equivalent model, or no value if the kind of source has none.
    Result<std::optional<SourceModel>> model() const
    {
        if (empty() || !kind_->model)
            return std::nullopt;
        return TRY(kind_->model(drawn_.get()));
    }

    bool can_vary() const { return !empty() && kind_->vary; }

    bool accepts_rules() const { return !empty() && kind_->with_rules; }

    PlantSource with_rules(std::optional<SourceRules> const& rules) const
    {
        auto other = *this;
        if (accepts_rules())
            other.drawn_ = kind_->with_rules(drawn_.get(), rules);
        return other;
    }

    PlantSource varied(SourceVariation const& variation) const
    {
        auto other = *this;
        if (can_vary() && variation.spread > 0)
            other.drawn_ = kind_->vary(drawn_.get(), variation);
        return other;
    }

    // Returns the drawn data, or null if the source is of another kind.
    template<typename T> T const* get(SourceKind const& kind) const
    {
        return kind_ == &kind ? static_cast<T const*>(drawn_.get()) : nullptr;
    }

    bool operator==(PlantSource const& other) const
    {
        return kind_ == other.kind_
            && (drawn_ == other.drawn_ || kind_->same(drawn_.get(), other.drawn_.get()));
    }

private:
    SourceKind const* kind_ = nullptr;
    // Drawn data, of the type that belongs to the kind; shared between copies of the source.
    std::shared_ptr<void const> drawn_;
};

} // namespace tractus::scene
