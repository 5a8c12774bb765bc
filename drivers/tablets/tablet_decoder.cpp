#include "drivers/tablets/tablet_decoder.h"

#include "drivers/pens/descriptor_decoder.h"
#include "drivers/reports/report_descriptor.h"
#include "drivers/tablets/tablet_parameters.h"
#include "engine/base/check.h"

#include <algorithm>
#include <bitset>
#include <utility>

namespace tractus::drivers {

namespace {

using ReportIds = std::bitset<256>;

// Report id that Linux's hid-uclogic invents for keys and dials: a descriptor with this id was
// written by that driver (UCLOGIC_RDESC_V1_FRAME_ID in its source).
constexpr std::uint8_t kKernelPadReport = 0xF7;

struct NodeReports {
    ReportIds described; // Ids of reports with a field of known meaning.
    ReportIds makers_own;
    bool is_rewritten_by_kernel = false;
    bool use_ids = true;
};

NodeReports reports_of(HidReportDescriptor const& descriptor)
{
    // True for usages without a known meaning: those of vendor-defined pages, and number 0 of any
    // page.
    auto const says_nothing
        = [](HidUsage usage) { return usage >= 0xFF00'0000 || (usage & 0xFFFF) == 0; };
    NodeReports result;
    for (auto const& field : descriptor.fields)
        if (field.kind == HidReportKind::Input)
            (says_nothing(field.usage) ? result.makers_own : result.described).set(field.report_id);
    result.makers_own &= ~result.described;
    result.is_rewritten_by_kernel = result.described[kKernelPadReport];
    result.use_ids = !result.described[0] && !result.makers_own[0];
    return result;
}

// True if the strings whose reading switches the tablet have been read.
bool is_switched_by_strings(DeviceInfo const& info, TabletIdentifier const& identifier)
{
    auto const& strings = identifier.setup.strings;
    return !strings.empty() && std::all_of(strings.begin(), strings.end(), [&](int index) {
        auto const found = info.strings.find(index);
        return found != info.strings.end() && !found->second.empty();
    });
}

class TabletDecoder final : public PenDecoder {
public:
    struct Parts {
        PenFamily family;
        std::unique_ptr<PenDecoder> own; // Decoder of the maker's own reports; never null.
        // Decoder of the described reports; null if the descriptor describes no pen.
        std::unique_ptr<PenDecoder> described;
        ReportIds described_ids;
        bool own_comes_first = false;
        bool use_ids = true;
    };

    explicit TabletDecoder(Parts parts)
        : parts_(std::move(parts))
        , last_(parts_.described && !parts_.own_comes_first ? parts_.described.get()
                                                            : parts_.own.get())
        , traits_(last_->traits())
    {
    }

    using PenDecoder::decode;
    PenTraits const& traits() const override { return traits_; }
    Result<void> decode(Timestamp received, std::span<std::byte const> report,
                        std::vector<PenSample>& out) override;
    std::optional<Duration> silence_limit() const override { return last_->silence_limit(); }
    std::optional<PenSample> leave(Timestamp time) override { return last_->leave(time); }

private:
    Result<void> decode_with_id(Timestamp received, std::span<std::byte const> report,
                                std::vector<PenSample>& out);
    PenDecoder* decoder_for(std::span<std::byte const> report) const;

    Parts parts_;
    PenDecoder* last_; // The decoder that gave the last sample.
    PenTraits traits_;
    RawReport with_id_; // Copy of a report that came without an id, with an id in front.
};

// Returns the decoder for a report; null if the report is not about a pen.
PenDecoder* TabletDecoder::decoder_for(std::span<std::byte const> report) const
{
    FamilyState ignored;
    bool const is_described = parts_.described_ids[std::to_integer<std::uint8_t>(report[0])];
    if (!is_described || (parts_.own_comes_first && parts_.family.decode(report, ignored)))
        return parts_.own.get();
    return parts_.described.get();
}

// Decodes a report. Formats count offsets from the report id; for a device without ids, a 0 is put
// in front.
Result<void> TabletDecoder::decode(Timestamp received, std::span<std::byte const> report,
                                   std::vector<PenSample>& out)
{
    if (report.empty())
        return fail(Fault::Device, "an empty report");
    if (parts_.use_ids)
        return decode_with_id(received, report, out);
    with_id_.size = std::min(report.size() + 1, with_id_.storage.size());
    std::copy_n(report.begin(), with_id_.size - 1, with_id_.storage.begin() + 1);
    return decode_with_id(received, with_id_.bytes(), out);
}

Result<void> TabletDecoder::decode_with_id(Timestamp received, std::span<std::byte const> report,
                                           std::vector<PenSample>& out)
{
    auto* const decoder = decoder_for(report);
    if (!decoder)
        return {};
    bool const is_described = decoder == parts_.described.get();
    auto const as_it_came = is_described && !parts_.use_ids ? report.subspan(1) : report;
    auto const first = out.size();
    TRY(decoder->decode(received, as_it_came, out));
    if (out.size() == first || decoder == last_)
        return {};
    // The pen leaves the previous decoder before it arrives in the new one, as when a pen is turned
    // over. The sample in which it leaves replaces the new decoder's first sample.
    if (auto const left = std::exchange(last_, decoder)->leave(out[first].time))
        out[first] = *left;
    return {};
}

} // namespace

TabletShape tablet_shape(DeviceInfo const& info, TabletMatch const& match)
{
    auto const& tablet = *match.tablet;
    TabletShape shape { .size_mm = tablet.size_mm,
                        .is_size_assumed = tablet.is_size_in_doubt || match.alternatives > 0
                            || match.identifier->is_any_product,
                        .x_maximum = tablet.x_maximum,
                        .y_maximum = tablet.y_maximum,
                        .pressure_maximum = tablet.pressure_maximum,
                        .button_count = tablet.pen_buttons };
    for (auto const& [index, text] : info.strings)
        if (auto const told = parse_parameters(index, text)) {
            shape.size_mm = told->size_mm();
            shape.is_size_assumed = false;
            shape.x_maximum = told->x_maximum;
            shape.y_maximum = told->y_maximum;
            shape.pressure_maximum = told->pressure_maximum;
        }
    if (shape.is_size_assumed && info.size_mm) {
        shape.size_mm = *info.size_mm;
        shape.is_size_assumed
            // An unknown model may have another number of counts.
            = match.identifier->is_any_product;
    }
    return shape;
}

Result<std::unique_ptr<PenDecoder>> make_tablet_decoder(DeviceInfo const& info,
                                                        TabletMatch const& match)
{
    auto const shape = tablet_shape(info, match);
    auto described = make_descriptor_decoder(
        info, shape.is_size_assumed ? std::nullopt : std::optional(shape.size_mm),
        match.width_to_height);
    NodeReports reports;
    if (auto const descriptor = parse_report_descriptor(info.report_descriptor))
        reports = reports_of(*descriptor);
    bool const is_switched
        = is_switched_by_strings(info, *match.identifier) && !reports.is_rewritten_by_kernel;
    bool const has_own_reports
        = reports.makers_own.any() || is_switched || info.report_descriptor.empty();
    if (!has_own_reports || match.identifier->family == kPadFamily)
        return described;

    auto const* const family = find_pen_family(match.identifier->family);
    CHECK(family); // A test of the table ensures that the family exists.
    return std::make_unique<TabletDecoder>(TabletDecoder::Parts {
        .family = *family,
        .own = make_family_decoder(*family, shape),
        .described = described ? *std::move(described) : nullptr,
        .described_ids = reports.described,
        .own_comes_first = is_switched,
        .use_ids = reports.use_ids,
    });
}

} // namespace tractus::drivers
