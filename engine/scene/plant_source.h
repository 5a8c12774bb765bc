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

// Limits and outputs of building a plant. Not part of the document: they affect only whether a
// plant can be built, not its shape.
struct LoadOptions {
    lsystem::ModelLimits limits {};
    // Receives what the model prints; if empty, output is discarded.
    std::function<void(std::string_view text)> print {};
};

// Returns the limits for the plant that is about to be built.
using MakeLoadOptions = std::function<LoadOptions()>;

struct BuiltSource {
    Plant plant {};
    std::vector<std::string> warnings {}; // Requested features that are not supported, each once.
    AxisKeys axis_keys {};
};

// A model in the language of cpfg, with the files that it includes, by name.
struct SourceModel {
    lsystem::ModelSource source {};
    std::map<std::string, std::string> includes {};
};

// Random variation of a plant's source, for a collection of plants.
struct SourceVariation {
    std::uint64_t seed = 1;
    std::uint32_t plant = 0; // Number of the plant in the collection.
    // Distinguishes plants with the same number, such as parts of one plant.
    std::uint32_t stream = 0;
    // Amount of variation: 0 none, 1 as individuals of a species differ; at most 4.
    double spread = 1;
};

// User-written rules that replace those of the model generated from a drawing, with its view file.
struct SourceRules {
    std::string text {};
    std::string view_text {};

    bool operator==(SourceRules const&) const = default;
};

// A kind of plant source: functions that make base plants from what was drawn or written, as
// immutable values of one type. Edits put these values into a document.
struct SourceKind {
    char const* word; // Name of the kind, such as "lsystem".
    // Builds the plant. Fails, in one sentence, if there is no valid plant or it exceeds its
    // limits.
    Result<BuiltSource> (*build)(void const* drawn, LoadOptions const& options);
    // Returns true only if both values certainly give the same plant.
    bool (*same)(void const* one, void const* other);
    // Returns the equivalent model in cpfg's language, for other programs. Null if the kind has
    // none.
    Result<SourceModel> (*model)(void const* drawn) = nullptr;
    // Returns a varied copy: drawn elements stay at or near their positions, and what is derived
    // from them varies. Deterministic. Null if the kind does not vary.
    std::shared_ptr<void const> (*vary)(void const* drawn, SourceVariation const& variation)
        = nullptr;
    // Returns a copy whose model uses these rules, or its own rules again for no value. Numbers in
    // the rules still follow from the drawing. Null if rules cannot be replaced.
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

// The source of a base plant. A value: copies share the drawn data.
class PlantSource {
public:
    PlantSource() = default; // Empty: gives a plant without branches.

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

    // Returns the equivalent model, or no value if the kind has none.
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

    // Returns what was drawn, or null if the source is of another kind.
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
    // Drawn data, of the type that belongs to the kind; shared between copies.
    std::shared_ptr<void const> drawn_;
};

} // namespace tractus::scene
