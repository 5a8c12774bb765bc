#include "drivers/reports/report_descriptor.h"

#include "engine/base/check.h"
#include "engine/base/vectors.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <endian.h>
#include <fmt/core.h>

namespace tractus::drivers {

static constexpr std::size_t kMaxDescriptorBytes = std::size_t { 64 } << 10;
static constexpr std::uint64_t kMaxReportBits = std::uint64_t { 16 } << 13;
static constexpr std::uint32_t kMaxFieldBits = 256;
static constexpr std::size_t kMaxPushes = 64;
static constexpr std::size_t kMaxFields = std::size_t { 1 } << 16;

namespace {

// The supported items of a report descriptor: each prefix byte with its two size bits cleared.
enum class Tag : std::uint8_t {
    Input = 0x80,
    Output = 0x90,
    Collection = 0xA0,
    Feature = 0xB0,
    EndCollection = 0xC0,
    UsagePage = 0x04,
    LogicalMinimum = 0x14,
    LogicalMaximum = 0x24,
    PhysicalMinimum = 0x34,
    PhysicalMaximum = 0x44,
    UnitExponent = 0x54,
    Unit = 0x64,
    ReportSize = 0x74,
    ReportId = 0x84,
    ReportCount = 0x94,
    Push = 0xA4,
    Pop = 0xB4,
    Usage = 0x08,
    UsageMinimum = 0x18,
    UsageMaximum = 0x28,
};

// A short item (HID 1.11, section 6.2.2.2): prefix and data.
struct Item {
    Tag tag {};
    std::uint8_t size = 0; // Bytes of data: 0, 1, 2 or 4.
    std::uint32_t data = 0;
    std::size_t offset = 0; // Offset of the prefix in the descriptor, for error messages.

    std::int64_t as_signed() const
    {
        switch (size) {
        case 1:
            return static_cast<std::int8_t>(data);
        case 2:
            return static_cast<std::int16_t>(data);
        default:
            return static_cast<std::int32_t>(data);
        }
    }
};

constexpr std::uint8_t kLongItem = 0xFE;

// A minimum or maximum whose signedness is known only when both have been read.
struct Bound {
    std::int64_t as_signed = 0;
    std::int64_t as_unsigned = 0;
};

struct Globals {
    std::uint32_t usage_page = 0;
    Bound logical_minimum, logical_maximum, physical_minimum, physical_maximum;
    std::uint32_t unit = 0;
    int unit_exponent = 0;
    std::uint32_t report_size = 0;
    std::uint32_t report_count = 0;
    std::uint8_t report_id = 0;
};

struct UsageRange {
    HidUsage first = 0;
    HidUsage last = 0;
    bool has_own_page = false; // True if the usage was written in four bytes, with its page.
};

// Iterates over the usages of one main item. If there are more fields than usages, the last usage
// repeats (HID 1.11, section 6.2.2.8).
class UsageCursor {
public:
    explicit UsageCursor(std::span<UsageRange const> ranges)
        : ranges_(ranges)
    {
        if (!ranges_.empty())
            next_ = ranges_.front().first;
    }

    HidUsage next()
    {
        if (ranges_.empty())
            return 0;
        auto const usage = next_;
        if (next_ < ranges_[index_].last)
            ++next_;
        else if (index_ + 1 < ranges_.size())
            next_ = ranges_[++index_].first;
        return usage;
    }

private:
    std::span<UsageRange const> ranges_;
    std::size_t index_ = 0;
    HidUsage next_ = 0;
};

class Parser {
public:
    explicit Parser(std::span<std::byte const> bytes)
        : bytes_(bytes)
    {
    }

    Result<HidReportDescriptor> parse();

private:
    struct ReportLayout {
        HidReportKind kind {};
        std::uint8_t id = 0;
        std::uint64_t bits = 0; // Size in bits, including the report id.
    };

    Result<std::optional<Item>> next_item();
    Result<void> apply(Item const&);
    Result<void> apply_global(Item const&);
    void apply_local(Item const&);
    Result<void> add_fields(Item const&, HidReportKind);
    Result<void> end_collection(Item const&);
    void begin_collection(Item const&);
    ReportLayout& layout(HidReportKind, std::uint8_t id);
    HidField field_template(Item const&, HidReportKind) const;
    HidUsage with_page(Item const&) const;
    void complete_usages();
    static tl::unexpected<Error> broken(std::size_t offset, std::string const& what);

    std::span<std::byte const> bytes_;
    std::size_t position_ = 0;
    Globals globals_;
    std::vector<Globals> pushed_;
    std::vector<UsageRange> usages_;
    std::optional<HidUsage> usage_minimum_;
    std::optional<std::size_t> collection_; // Index of the innermost open collection.
    std::vector<ReportLayout> layouts_;
    HidReportDescriptor result_;
};

tl::unexpected<Error> Parser::broken(std::size_t offset, std::string const& what)
{
    return fail(Fault::Device, fmt::format("report descriptor, byte {}: {}", offset, what));
}

Result<HidReportDescriptor> Parser::parse()
{
    if (bytes_.empty())
        return fail(Fault::Device, "the report descriptor is empty");
    if (bytes_.size() > kMaxDescriptorBytes)
        return fail(Fault::Device,
                    fmt::format("the report descriptor has {} bytes, more than {}", bytes_.size(),
                                kMaxDescriptorBytes));
    while (auto const item = TRY(next_item()))
        TRY(apply(*item));
    if (collection_)
        return broken(bytes_.size(), "it ends inside a collection");

    for (auto const& layout : layouts_)
        result_.reports.push_back({ layout.kind, layout.id, (layout.bits + 7) / 8 });
    return std::move(result_);
}

// Reads the next short item. Long items (HID 1.11, section 6.2.2.3), of which none is defined, are
// skipped.
Result<std::optional<Item>> Parser::next_item()
{
    while (position_ < bytes_.size()) {
        auto const offset = position_;
        auto const prefix = std::to_integer<std::uint8_t>(bytes_[position_++]);
        auto const left = bytes_.size() - position_;
        if (prefix == kLongItem) {
            auto const length = left >= 2 ? 2 + std::to_integer<std::size_t>(bytes_[position_]) : 3;
            if (length > left)
                return broken(offset, "it ends inside a long item");
            position_ += length;
            continue;
        }
        Item item { .tag = static_cast<Tag>(prefix & 0xFC),
                    .size = static_cast<std::uint8_t>((prefix & 3) == 3 ? 4 : prefix & 3),
                    .offset = offset };
        if (item.size > left)
            return broken(offset, fmt::format("it ends inside the item {:02X}", prefix));
        for (unsigned i = 0; i < item.size; ++i)
            item.data |= std::to_integer<std::uint32_t>(bytes_[position_ + i]) << (8 * i);
        position_ += item.size;
        return std::optional(item);
    }
    return std::optional<Item>();
}

Result<void> Parser::apply(Item const& item)
{
    // In a main item both bits of the type are 0 (HID 1.11, section 6.2.2.4).
    if ((static_cast<unsigned>(item.tag) & 0x0C) == 0)
        complete_usages();
    switch (item.tag) {
    case Tag::Input:
        TRY(add_fields(item, HidReportKind::Input));
        break;
    case Tag::Output:
        TRY(add_fields(item, HidReportKind::Output));
        break;
    case Tag::Feature:
        TRY(add_fields(item, HidReportKind::Feature));
        break;
    case Tag::Collection:
        begin_collection(item);
        break;
    case Tag::EndCollection:
        TRY(end_collection(item));
        break;
    case Tag::Usage:
    case Tag::UsageMinimum:
    case Tag::UsageMaximum:
        apply_local(item);
        return {};
    default:
        return apply_global(item);
    }
    // Local items apply to one main item only (HID 1.11, section 6.2.2.8).
    usages_.clear();
    usage_minimum_.reset();
    return {};
}

Result<void> Parser::apply_global(Item const& item)
{
    Bound const bound { item.as_signed(), item.data };
    switch (item.tag) {
    case Tag::UsagePage:
        globals_.usage_page = item.data;
        break;
    case Tag::LogicalMinimum:
        globals_.logical_minimum = bound;
        break;
    case Tag::LogicalMaximum:
        globals_.logical_maximum = bound;
        break;
    case Tag::PhysicalMinimum:
        globals_.physical_minimum = bound;
        break;
    case Tag::PhysicalMaximum:
        globals_.physical_maximum = bound;
        break;
    case Tag::UnitExponent: {
        auto const nibble = static_cast<int>(item.data & 0xF);
        globals_.unit_exponent = nibble < 8 ? nibble : nibble - 16;
        break;
    }
    case Tag::Unit:
        globals_.unit = item.data;
        break;
    case Tag::ReportSize:
        globals_.report_size = item.data;
        break;
    case Tag::ReportCount:
        globals_.report_count = item.data;
        break;
    case Tag::ReportId:
        if (item.data == 0 || item.data > 255)
            return broken(item.offset, fmt::format("report id {} is not in 1 to 255", item.data));
        globals_.report_id = static_cast<std::uint8_t>(item.data);
        break;
    case Tag::Push:
        if (pushed_.size() == kMaxPushes)
            return broken(item.offset, fmt::format("more than {} pushes", kMaxPushes));
        pushed_.push_back(globals_);
        break;
    case Tag::Pop:
        if (pushed_.empty())
            return broken(item.offset, "pop without push");
        globals_ = pushed_.back();
        pushed_.pop_back();
        break;
    default:
        break; // Designators, strings, delimiters and additions of later versions are ignored.
    }
    return {};
}

// Returns an item's usage with its page. A usage of four bytes contains the page (HID 1.11, section
// 6.2.2.8).
HidUsage Parser::with_page(Item const& item) const
{
    return item.size == 4 ? item.data : globals_.usage_page << 16 | item.data;
}

void Parser::apply_local(Item const& item)
{
    auto const usage = with_page(item);
    if (item.tag == Tag::Usage) {
        usages_.push_back({ usage, usage, item.size == 4 });
    } else if (item.tag == Tag::UsageMinimum) {
        usage_minimum_ = usage;
    } else if (usage_minimum_) {
        usages_.push_back({ *usage_minimum_, std::max(*usage_minimum_, usage), item.size == 4 });
        usage_minimum_.reset();
    }
}

// Adds the page to usages that have none. The last page declared before the main item counts (HID
// 1.11, section 6.2.2.7), so usages may precede their page. If one item has usages of two pages,
// each keeps its own page, as in Linux.
void Parser::complete_usages()
{
    for (auto range = usages_.rbegin(); range != usages_.rend(); ++range) {
        if (range->has_own_page)
            continue;
        if (range->first >> 16 == globals_.usage_page)
            break;
        for (auto* const usage : { &range->first, &range->last })
            *usage = globals_.usage_page << 16 | (*usage & 0xFFFF);
    }
}

void Parser::begin_collection(Item const& item)
{
    result_.collections.push_back({ .usage = usages_.empty() ? 0 : usages_.front().first,
                                    .type = static_cast<std::uint8_t>(item.data),
                                    .parent = collection_ });
    collection_ = result_.collections.size() - 1;
}

Result<void> Parser::end_collection(Item const& item)
{
    if (!collection_)
        return broken(item.offset, "the end of a collection that was not begun");
    collection_ = result_.collections[*collection_].parent;
    return {};
}

Parser::ReportLayout& Parser::layout(HidReportKind kind, std::uint8_t id)
{
    auto const found = std::find_if(layouts_.begin(), layouts_.end(), [&](auto const& layout) {
        return layout.kind == kind && layout.id == id;
    });
    if (found != layouts_.end())
        return *found;
    return layouts_.emplace_back(ReportLayout { kind, id, id == 0 ? 0u : 8u });
}

HidField Parser::field_template(Item const& item, HidReportKind kind) const
{
    // A maximum is unsigned if the minimum is not negative. Many devices encode a maximum of 255 in
    // one byte, which would be -1 as a signed number.
    auto const maximum = [](Bound const& low, Bound const& high) {
        return low.as_signed < 0 ? high.as_signed : high.as_unsigned;
    };
    auto const& g = globals_;
    return { .kind = kind,
             .report_id = g.report_id,
             .collection = collection_,
             .bit_size = g.report_size,
             .is_array = (item.data & 0x02) == 0,
             .is_relative = (item.data & 0x04) != 0,
             .has_null_state = (item.data & 0x40) != 0,
             .logical_minimum = g.logical_minimum.as_signed,
             .logical_maximum = maximum(g.logical_minimum, g.logical_maximum),
             .physical_minimum = g.physical_minimum.as_signed,
             .physical_maximum = maximum(g.physical_minimum, g.physical_maximum),
             .unit = g.unit,
             .unit_exponent = g.unit_exponent };
}

Result<void> Parser::add_fields(Item const& item, HidReportKind kind)
{
    auto& report = layout(kind, globals_.report_id);
    std::uint64_t const size = globals_.report_size;
    std::uint64_t const count = globals_.report_count;
    if (size > kMaxFieldBits)
        return broken(item.offset,
                      fmt::format("a field of {} bits, more than {}", size, kMaxFieldBits));
    if (report.bits + size * count > kMaxReportBits)
        return broken(
            item.offset,
            fmt::format("report {} grows beyond {} bytes", report.id, kMaxReportBits / 8));

    bool const is_constant = (item.data & 0x01) != 0;
    if (!is_constant && size > 0) {
        if (result_.fields.size() + count > kMaxFields)
            return broken(item.offset, fmt::format("more than {} fields", kMaxFields));
        auto field = field_template(item, kind);
        UsageCursor usages(usages_);
        if (field.is_array && !usages_.empty()) {
            field.usage = usages_.front().first;
            field.usage_maximum = usages_.back().last;
        }
        for (std::uint64_t i = 0; i < count; ++i) {
            if (!field.is_array)
                field.usage = field.usage_maximum = usages.next();
            field.bit_offset = static_cast<std::uint32_t>(report.bits + i * size);
            result_.fields.push_back(field);
        }
    }
    report.bits += size * count;
    return {};
}

double power_of_ten(int exponent)
{
    return std::pow(10.0, exponent);
}

// Returns the physical range in the field's unit, or the logical range if the descriptor declares
// no physical one (HID 1.11, section 6.2.2.7).
std::optional<double> physical_span(HidField const& field)
{
    auto span = field.physical_maximum - field.physical_minimum;
    if (field.physical_minimum == 0 && field.physical_maximum == 0)
        span = field.logical_maximum - field.logical_minimum;
    if (span <= 0 || field.logical_maximum <= field.logical_minimum)
        return std::nullopt;
    return static_cast<double>(span) * power_of_ten(field.unit_exponent);
}

} // namespace

std::size_t HidReportDescriptor::report_size(HidReportKind kind, std::uint8_t report_id) const
{
    for (auto const& report : reports)
        if (report.kind == kind && report.report_id == report_id)
            return report.bytes;
    return 0;
}

Result<HidReportDescriptor> parse_report_descriptor(std::span<std::byte const> bytes)
{
    return Parser(bytes).parse();
}

std::int64_t read_field(HidField const& field, std::span<std::byte const> report)
{
    auto const first = field.bit_offset / 8;
    // Index of the byte after the field's last one.
    auto const last = (field.bit_offset + field.bit_size + 7) / 8;
    CHECK(field.bit_size >= 1 && field.bit_size <= 32 && last <= report.size());
    // Little-endian (HID 1.11, section 8.4). At most five bytes are needed; eight are loaded if the
    // report has them.
    std::uint64_t bits = 0;
    auto shift = field.bit_offset % 8;
    if (report.size() >= sizeof(bits)) {
        auto const from = std::min<std::size_t>(first, report.size() - sizeof(bits));
        std::memcpy(&bits, report.data() + from, sizeof(bits));
        bits = le64toh(bits);
        shift += static_cast<std::uint32_t>(first - from) * 8;
    } else {
        for (auto i = last; i-- > first;)
            bits = bits << 8 | std::to_integer<std::uint64_t>(report[i]);
    }
    bits >>= shift;
    auto const unused = 64 - field.bit_size;
    if (field.logical_minimum < 0)
        return static_cast<std::int64_t>(bits << unused) >> unused;
    return static_cast<std::int64_t>(bits << unused >> unused);
}

std::optional<double> physical_span_mm(HidField const& field)
{
    // The lowest nibble of the unit is the system, the next one the power of length.
    if (field.unit != 0x11 && field.unit != 0x13)
        return std::nullopt;
    auto const span = physical_span(field);
    if (!span)
        return std::nullopt;
    return *span * (field.unit == 0x11 ? 10.0 : 25.4);
}

std::optional<double> radians_per_count(HidField const& field)
{
    if (field.unit != 0x12 && field.unit != 0x14)
        return std::nullopt;
    auto const span = physical_span(field);
    if (!span)
        return std::nullopt;
    auto const per_unit = field.unit == 0x12 ? 1.0 : radians(1.0);
    return *span * per_unit / static_cast<double>(field.logical_maximum - field.logical_minimum);
}

} // namespace tractus::drivers
