#include "app/session/edit_fields.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <filesystem>
#include <fmt/core.h>
#include <limits>
#include <variant>

namespace tractus::session {

namespace {

constexpr char const* kBytes = "bytes";
constexpr std::size_t kTipSize = 5 * 8 + 1; // Bytes that store a tip without its tilt.
constexpr std::size_t kTiltSize = 2 * 8;
constexpr std::size_t kLineSize = 6 * 8;

// Flags of a stored tip, one bit each.
constexpr int kTouching = 1;
constexpr int kEraser = 2;
constexpr int kExtrapolated = 4;
constexpr int kOutside = 8;
constexpr int kTilted = 16;
constexpr int kAllFlags = 31;

// True if JSON can hold the text unchanged: the text is valid UTF-8, without overlong forms or
// surrogates.
bool is_utf8(std::string const& text)
{
    auto const without_others = Json(text).dump(-1, ' ', false, Json::error_handler_t::ignore);
    return Json::parse(without_others, nullptr, false) == text;
}

std::string utf8_of_bytes(std::string const& bytes)
{
    std::string text;
    for (char const signed_byte : bytes) {
        auto const byte = static_cast<unsigned char>(signed_byte);
        if (byte < 0x80) {
            text += signed_byte;
        } else {
            text += static_cast<char>(0xc0 | (byte >> 6));
            text += static_cast<char>(0x80 | (byte & 0x3f));
        }
    }
    return text;
}

// Converts each character from U+0000 to U+00FF to one byte; nullopt if there is any other
// character.
std::optional<std::string> bytes_of_utf8(std::string const& text)
{
    std::string bytes;
    for (std::size_t i = 0; i < text.size(); ++i) {
        auto const first = static_cast<unsigned char>(text[i]);
        if (first < 0x80) {
            bytes += text[i];
        } else if (first == 0xc2 || first == 0xc3) {
            // A second byte exists, because the JSON parser has checked that the text is UTF-8.
            auto const second = static_cast<unsigned char>(text[++i]);
            bytes += static_cast<char>((first << 6) | (second & 0x3f));
        } else {
            return std::nullopt;
        }
    }
    return bytes;
}

void put(std::string& bytes, std::uint64_t value)
{
    for (int shift = 0; shift < 64; shift += 8)
        bytes += static_cast<char>(value >> shift);
}

void put(std::string& bytes, double value)
{
    put(bytes, std::bit_cast<std::uint64_t>(value));
}

void put(std::string& bytes, Vec3 const& value)
{
    for (int i = 0; i < 3; ++i)
        put(bytes, value[i]);
}

// Reads numbers in the order in which put() wrote them. Callers must check that enough bytes are
// left.
class NumberReader {
public:
    explicit NumberReader(std::string_view bytes)
        : bytes_(bytes)
    {
    }

    bool at_end() const { return at_ == bytes_.size(); }
    std::size_t left() const { return bytes_.size() - at_; }
    std::uint8_t u8() { return static_cast<std::uint8_t>(bytes_[at_++]); }
    std::uint64_t u64()
    {
        std::uint64_t value = 0;
        for (int shift = 0; shift < 64; shift += 8)
            value |= std::uint64_t { u8() } << shift;
        return value;
    }
    double f64() { return std::bit_cast<double>(u64()); }
    Vec3 vec3()
    {
        double const x = f64();
        double const y = f64();
        return { x, y, f64() };
    }

private:
    std::string_view bytes_;
    std::size_t at_ = 0;
};

template<typename T> bool read_whole(Json const& json, T& value)
{
    if (json.is_number_unsigned()) {
        auto const number = json.get<std::uint64_t>();
        value = static_cast<T>(number);
        return number <= static_cast<std::uint64_t>(std::numeric_limits<T>::max());
    }
    if (!std::is_signed_v<T> || !json.is_number_integer())
        return false;
    auto const number = json.get<std::int64_t>();
    value = static_cast<T>(number);
    return number >= static_cast<std::int64_t>(std::numeric_limits<T>::min())
        && number <= static_cast<std::int64_t>(std::numeric_limits<T>::max());
}

} // namespace

Json written(bool value)
{
    return value;
}

Json written(int value)
{
    return value;
}

Json written(std::uint32_t value)
{
    return value;
}

Json written(std::uint64_t value)
{
    return value;
}

Json written(double value)
{
    if (std::isfinite(value))
        return value;
    return fmt::format("{:016x}", std::bit_cast<std::uint64_t>(value));
}

Json written(std::string const& value)
{
    if (is_utf8(value))
        return value;
    return { { kBytes, utf8_of_bytes(value) } };
}

Json written(Vec3 const& value)
{
    return Json::array({ written(value.x()), written(value.y()), written(value.z()) });
}

Json written(PathAddress const& value)
{
    return Json::array({ written(value.first), written(value.last) });
}

Json written(TipRange const& value)
{
    return Json::array({ written(value.first), written(value.last) });
}

Json written(std::map<std::string, std::string> const& texts)
{
    auto list = Json::array(); // An array of pairs, because JSON keys must be UTF-8 and names may
                               // not be.
    for (auto const& [name, text] : texts)
        list.push_back({ { "name", written(name) }, { "text", written(text) } });
    return list;
}

bool read(Json const& json, bool& value)
{
    if (json.is_boolean())
        value = json.get<bool>();
    return json.is_boolean();
}

bool read(Json const& json, int& value)
{
    return read_whole(json, value);
}

bool read(Json const& json, std::uint32_t& value)
{
    return read_whole(json, value);
}

bool read(Json const& json, std::uint64_t& value)
{
    return read_whole(json, value);
}

bool read(Json const& json, double& value)
{
    if (json.is_number()) {
        value = json.get<double>();
        return true;
    }
    if (!json.is_string())
        return false;
    auto const& digits = json.get_ref<std::string const&>();
    if (digits.size() != 16 || digits.find_first_not_of("0123456789abcdef") != std::string::npos)
        return false;
    value = std::bit_cast<double>(std::uint64_t { std::stoull(digits, nullptr, 16) });
    return true;
}

bool read(Json const& json, std::string& value)
{
    if (json.is_string()) {
        value = json.get<std::string>();
        return true;
    }
    if (!json.is_object() || json.size() != 1 || !json.contains(kBytes)
        || !json[kBytes].is_string())
        return false;
    auto bytes = bytes_of_utf8(json[kBytes].get<std::string>());
    if (!bytes)
        return false;
    value = *std::move(bytes);
    return true;
}

bool read(Json const& json, Vec3& value)
{
    if (!json.is_array() || json.size() != 3)
        return false;
    return read(json[0], value.x()) && read(json[1], value.y()) && read(json[2], value.z());
}

bool read(Json const& json, PathAddress& value)
{
    if (!json.is_array() || json.size() != 2)
        return false;
    return read(json[0], value.first) && read(json[1], value.last);
}

bool read(Json const& json, TipRange& value)
{
    if (!json.is_array() || json.size() != 2)
        return false;
    return read(json[0], value.first) && read(json[1], value.last);
}

bool read(Json const& json, std::map<std::string, std::string>& texts)
{
    texts.clear();
    if (!json.is_array())
        return false;
    for (auto const& entry : json) {
        std::string name;
        std::string text;
        if (!entry.is_object() || entry.size() != 2 || !entry.contains("name")
            || !entry.contains("text") || !read(entry["name"], name) || !read(entry["text"], text))
            return false;
        texts[name] = text;
    }
    return true;
}

std::string written_tips(Stroke const& stroke)
{
    std::string bytes;
    bytes.reserve(kTipSize * stroke.tips.size());
    for (auto const& tip : stroke.tips) {
        put(bytes, static_cast<std::uint64_t>(tip.time.time_since_epoch().count()));
        put(bytes, tip.position_mm);
        put(bytes, tip.pressure);
        bool const is_extrapolated = tip.height_source == TipSample::HeightSource::Extrapolated;
        bytes += static_cast<char>((tip.touching ? kTouching : 0) | (tip.eraser ? kEraser : 0)
                                   | (is_extrapolated ? kExtrapolated : 0)
                                   | (tip.outside_calibration ? kOutside : 0)
                                   | (tip.tilt_rad ? kTilted : 0));
        if (tip.tilt_rad) {
            put(bytes, tip.tilt_rad->x());
            put(bytes, tip.tilt_rad->y());
        }
    }
    return bytes;
}

std::string written_lines(std::vector<SkeletonPiece> const& lines)
{
    std::string bytes;
    bytes.reserve(kLineSize * lines.size());
    for (auto const& line : lines) {
        put(bytes, line.from_mm);
        put(bytes, line.to_mm);
    }
    return bytes;
}

bool read_tips(std::string_view bytes, Stroke& stroke)
{
    stroke.tips.clear();
    auto& tips = stroke.tips.own();
    tips.reserve(bytes.size() / kTipSize);
    for (NumberReader in(bytes); !in.at_end();) {
        if (in.left() < kTipSize)
            return false;
        auto& tip = tips.emplace_back();
        tip.time = timestamp_ns(static_cast<std::int64_t>(in.u64()));
        tip.position_mm = in.vec3();
        tip.pressure = in.f64();
        int const flags = in.u8();
        if (flags > kAllFlags)
            return false;
        tip.touching = (flags & kTouching) != 0;
        tip.eraser = (flags & kEraser) != 0;
        if ((flags & kExtrapolated) != 0)
            tip.height_source = TipSample::HeightSource::Extrapolated;
        tip.outside_calibration = (flags & kOutside) != 0;
        if ((flags & kTilted) != 0 && in.left() < kTiltSize)
            return false;
        if ((flags & kTilted) != 0) {
            double const x_rad = in.f64();
            tip.tilt_rad = Vec2(x_rad, in.f64());
        }
    }
    return true;
}

bool read_lines(std::string_view bytes, std::vector<SkeletonPiece>& lines)
{
    lines.clear();
    if (bytes.size() % kLineSize != 0)
        return false;
    for (NumberReader in(bytes); !in.at_end();) {
        auto const from_mm = in.vec3();
        lines.push_back({ from_mm, in.vec3() });
    }
    return true;
}

bool leave_out_folders(Json& fields, bool with_name)
{
    bool is_changed = false;
    for (std::string const key : { "name", "model_name", "view_name" }) {
        if (key == "name" && !with_name)
            continue;
        std::filesystem::path path;
        if (std::string name; fields.contains(key) && read(fields[key], name))
            path = name;
        if (!path.is_absolute() || path.filename().empty())
            continue;
        fields[key] = written(path.filename().string());
        is_changed = true;
    }
    return is_changed;
}

void FieldWriter::field(char const* name, scene::FieldRef value)
{
    json_[name] = std::visit([](auto const* typed) { return written(*typed); }, value);
}

void FieldWriter::sparse_field(char const* name, scene::FieldRef value)
{
    auto const json = std::visit([](auto const* typed) { return written(*typed); }, value);
    bool const is_zero = (json.is_number() && json == 0) || json == false;
    bool const is_empty = json.is_string() ? json == "" : json.is_structured() && json.empty();
    if (!is_zero && !is_empty)
        json_[name] = json;
}

void FieldWriter::word(char const* name, int& value, std::span<char const* const> words)
{
    json_[name] = words[static_cast<std::size_t>(value)];
}

void FieldReader::field(char const* name, scene::FieldRef value)
{
    auto const* const json = find(name);
    if (json && !std::visit([&](auto* typed) { return read(*json, *typed); }, value))
        complain_of(name);
}

void FieldReader::word(char const* name, int& value, std::span<char const* const> words)
{
    auto const* const json = find(name);
    if (!json)
        return;
    std::string text;
    auto const found
        = read(*json, text) ? std::find(words.begin(), words.end(), text) : words.end();
    if (found == words.end())
        complain_of(name);
    else
        value = static_cast<int>(found - words.begin());
}

Json const* FieldReader::find(char const* name)
{
    known_.insert(name);
    auto const found = json_.find(name);
    return found == json_.end() ? nullptr : &*found;
}

void FieldReader::take_numbers(bool were_read)
{
    if (!were_read)
        complain_of("numbers");
    numbers_ = {};
}

void FieldReader::complain_of(std::string const& name)
{
    if (complaint_.empty())
        complaint_ = fmt::format("its field \"{}\" does not have the form of one", name);
}

Result<void> FieldReader::finish() const
{
    if (!complaint_.empty())
        return fail(Fault::User, complaint_);
    if (!numbers_.empty())
        return fail(Fault::User, "it has numbers, and should have none");
    for (auto const& [name, value] : json_.items())
        if (!known_.contains(name))
            return fail(Fault::User,
                        fmt::format("its field \"{}\" is unknown to this tractus: a newer one has "
                                    "written it",
                                    name));
    return {};
}

} // namespace tractus::session
