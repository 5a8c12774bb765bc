#include "engine/export/fast_deflate.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <vector>

namespace tractus::exports {

namespace {

constexpr std::size_t kBlock = 1 << 17; // Number of bytes that share a code.
constexpr std::size_t kLiterals = 286;  // Literals, end of block, and lengths.
constexpr std::size_t kEndOfBlock = 256;
constexpr std::size_t kLongest = 258;   // Longest match.
constexpr std::size_t kShortestRun = 5; // Shorter runs of zeros are coded as literals.

// Writes bits, the lowest first. The caller makes sure that there is room.
class BitWriter {
public:
    explicit BitWriter(std::uint8_t* to)
        : to_(to)
    {
    }

    // Adds up to 32 bits.
    void add(std::uint64_t bits, unsigned count)
    {
        held_ |= bits << count_;
        count_ += count;
        if (count_ >= 32)
            flush();
    }

    std::uint8_t* align()
    {
        flush();
        if (count_ > 0) {
            *to_++ = static_cast<std::uint8_t>(held_);
            held_ = 0;
            count_ = 0;
        }
        return to_;
    }

private:
    // Stores all whole bytes.
    void flush()
    {
        std::memcpy(to_, &held_, sizeof held_);
        unsigned const bytes = count_ / 8;
        to_ += bytes;
        held_ = bytes < 8 ? held_ >> (8 * bytes) : 0;
        count_ -= 8 * bytes;
    }

    static_assert(std::endian::native == std::endian::little);
    std::uint8_t* to_;
    std::uint64_t held_ = 0;
    unsigned count_ = 0;
};

// A Huffman code: for each symbol, the number of its bits, 0 if it is not used, and the bits in the
// order in which they are written.
template<std::size_t N> struct Code {
    std::array<std::uint8_t, N> lengths {};
    std::array<std::uint16_t, N> bits {};
};

// Returns the depths of the leaves of a Huffman tree (two queues, for frequencies in ascending
// order).
std::vector<unsigned> tree_depths(std::vector<std::uint32_t> const& frequencies)
{
    auto const count = frequencies.size();
    std::vector<std::uint64_t> weight(frequencies.begin(), frequencies.end());
    std::vector<std::size_t> parent(2 * count);
    std::size_t leaf = 0;
    std::size_t inner = count;
    auto const take = [&] {
        bool const is_leaf
            = leaf < count && (inner >= weight.size() || weight[leaf] <= weight[inner]);
        return is_leaf ? leaf++ : inner++;
    };
    while (weight.size() < 2 * count - 1) {
        auto const a = take();
        auto const b = take();
        parent[a] = parent[b] = weight.size();
        weight.push_back(weight[a] + weight[b]);
    }
    std::vector<unsigned> depths(weight.size());
    for (auto i = weight.size() - 1; i-- > 0;)
        depths[i] = depths[parent[i]] + 1;
    depths.resize(count);
    return depths;
}

// Makes a code whose lengths are at most `most`. Frequencies are made more even until it is short
// enough. At least two symbols get a code, as some decoders expect.
template<std::size_t N> Code<N> make_code(std::array<std::uint32_t, N> frequencies, unsigned most)
{
    Code<N> code;
    for (std::size_t i = 0; i < 2 && std::ranges::count(frequencies, 0u) > std::ptrdiff_t(N) - 2;
         ++i)
        frequencies[i] = std::max(frequencies[i], 1u);
    std::vector<std::size_t> symbols;
    for (std::size_t i = 0; i < N; ++i)
        if (frequencies[i] > 0)
            symbols.push_back(i);
    std::ranges::stable_sort(symbols, {}, [&](std::size_t i) { return frequencies[i]; });
    for (;;) {
        std::vector<std::uint32_t> ascending;
        for (auto const symbol : symbols)
            ascending.push_back(frequencies[symbol]);
        auto const depths = tree_depths(ascending);
        for (std::size_t i = 0; i < symbols.size(); ++i)
            code.lengths[symbols[i]] = static_cast<std::uint8_t>(depths[i]);
        if (std::ranges::max(depths) <= most)
            break;
        for (auto const symbol : symbols)
            frequencies[symbol] = (frequencies[symbol] + 1) / 2;
    }
    // Canonical codes, written with their first bit lowest.
    unsigned next = 0;
    for (unsigned length = 1; length <= most; ++length) {
        for (std::size_t i = 0; i < N; ++i) {
            if (code.lengths[i] != length)
                continue;
            unsigned reversed = 0;
            for (unsigned k = 0; k < length; ++k)
                reversed |= (next >> k & 1u) << (length - 1 - k);
            code.bits[i] = static_cast<std::uint16_t>(reversed);
            ++next;
        }
        next <<= 1;
    }
    return code;
}

// A match's length as the symbol and the extra bits of RFC 1951, section 3.2.5.
struct LengthCode {
    std::uint16_t symbol = 0;
    std::uint8_t extra = 0;
    std::uint16_t value = 0;
};

std::array<LengthCode, kLongest + 1> const& length_codes()
{
    static auto const table = [] {
        std::array<LengthCode, kLongest + 1> made {};
        std::size_t length = 3;
        std::uint16_t symbol = 257;
        for (unsigned extra = 0; length < kLongest; extra += symbol >= 265 && symbol % 4 == 1) {
            for (unsigned value = 0; value < 1u << extra && length < kLongest; ++value)
                made[length++] = { symbol, static_cast<std::uint8_t>(extra),
                                   static_cast<std::uint16_t>(value) };
            ++symbol;
        }
        made[kLongest] = { 285, 0, 0 };
        return made;
    }();
    return table;
}

// A run of zeros behind a stretch of literals.
struct Run {
    std::size_t begin = 0;
    std::size_t length = 0;
};

std::vector<Run> zero_runs(std::span<std::uint8_t const> data)
{
    std::vector<Run> runs;
    for (std::size_t i = 0; i < data.size();) {
        auto const* const found
            = static_cast<std::uint8_t const*>(std::memchr(data.data() + i, 0, data.size() - i));
        if (!found)
            break;
        i = static_cast<std::size_t>(found - data.data());
        auto end = i + 1;
        for (std::uint64_t eight = 0; end + 8 <= data.size(); end += 8) {
            std::memcpy(&eight, data.data() + end, 8);
            if (eight != 0)
                break;
        }
        while (end < data.size() && data[end] == 0)
            ++end;
        if (end - i >= kShortestRun)
            runs.push_back({ i, end - i });
        i = end;
    }
    runs.push_back({ data.size(), 0 });
    return runs;
}

// Calls work(length) for each match of a run. Its first zero is a literal, which the matches
// repeat.
template<typename Work> void for_matches(Run const& run, Work const& work)
{
    for (auto left = run.length - 1; left > 0;) {
        // The rest of a run must not become too short for a match.
        auto const length
            = left > kLongest && left < kLongest + 3 ? left - 3 : std::min(left, kLongest);
        work(length);
        left -= length;
    }
}

std::array<std::uint32_t, kLiterals> count_symbols(std::span<std::uint8_t const> data,
                                                   std::vector<Run> const& runs)
{
    // Neighbouring bytes are counted apart, so that equal ones need not wait for each other.
    std::array<std::array<std::uint32_t, 256>, 4> counts {};
    std::array<std::uint32_t, kLiterals> all {};
    std::size_t at = 0;
    for (auto const& run : runs) {
        for (; at + 4 <= run.begin; at += 4)
            for (std::size_t k = 0; k < 4; ++k)
                ++counts[k][data[at + k]];
        for (; at < run.begin; ++at)
            ++counts[0][data[at]];
        if (run.length == 0)
            break;
        ++counts[0][0];
        for_matches(run, [&](std::size_t length) { ++all[length_codes()[length].symbol]; });
        at = run.begin + run.length;
    }
    for (auto const& part : counts)
        for (std::size_t i = 0; i < part.size(); ++i)
            all[i] += part[i];
    all[kEndOfBlock] = 1;
    return all;
}

// Writes the header of a block with codes of its own (RFC 1951, section 3.2.7). Of distances there
// is a single one, 1, whose code is one bit.
void write_codes(BitWriter& out, Code<kLiterals> const& code)
{
    constexpr std::array<std::uint8_t, 19> kOrder { 16, 17, 18, 0, 8,  7, 9,  6, 10, 5,
                                                    11, 4,  12, 3, 13, 2, 14, 1, 15 };
    struct Word {
        std::uint8_t symbol = 0;
        std::uint8_t extra = 0; // Number of extra bits.
        std::uint8_t value = 0;
    };
    std::vector<std::uint8_t> lengths(code.lengths.begin(), code.lengths.end());
    lengths.push_back(1);
    std::vector<Word> words;
    std::array<std::uint32_t, 19> frequencies {};
    for (std::size_t i = 0; i < lengths.size();) {
        std::size_t end = i;
        while (end < lengths.size() && lengths[end] == 0 && end - i < 138)
            ++end;
        auto const zeros = end - i;
        Word word { .symbol = lengths[i] };
        if (zeros >= 11)
            word = { 18, 7, static_cast<std::uint8_t>(zeros - 11) };
        else if (zeros >= 3)
            word = { 17, 3, static_cast<std::uint8_t>(zeros - 3) };
        words.push_back(word);
        ++frequencies[word.symbol];
        i += zeros >= 3 ? zeros : 1;
    }
    auto const lengths_code = make_code(frequencies, 7);
    out.add(2 << 1, 3); // Not the last block; codes of its own.
    out.add(kLiterals - 257, 5);
    out.add(0, 5);
    out.add(kOrder.size() - 4, 4);
    for (auto const symbol : kOrder)
        out.add(lengths_code.lengths[symbol], 3);
    for (auto const& word : words) {
        out.add(lengths_code.bits[word.symbol], lengths_code.lengths[word.symbol]);
        out.add(word.value, word.extra);
    }
}

void write_block(BitWriter& out, std::span<std::uint8_t const> data)
{
    auto const runs = zero_runs(data);
    auto const code = make_code(count_symbols(data, runs), 15);
    write_codes(out, code);
    auto const put = [&](std::size_t symbol) { out.add(code.bits[symbol], code.lengths[symbol]); };
    std::size_t at = 0;
    for (auto const& run : runs) {
        for (; at + 2 <= run.begin; at += 2) {
            auto const first = data[at];
            auto const second = data[at + 1];
            out.add(std::uint64_t(code.bits[first])
                        | std::uint64_t(code.bits[second]) << code.lengths[first],
                    unsigned(code.lengths[first]) + code.lengths[second]);
        }
        for (; at < run.begin; ++at)
            put(data[at]);
        if (run.length == 0)
            break;
        put(0);
        for_matches(run, [&](std::size_t length) {
            auto const& symbol = length_codes()[length];
            put(symbol.symbol);
            out.add(symbol.value, symbol.extra);
            out.add(0, 1); // The distance.
        });
        at = run.begin + run.length;
    }
    put(kEndOfBlock);
}

} // namespace

void append_deflated(std::span<std::uint8_t const> data, std::string& to)
{
    if (data.empty())
        return;
    // A byte takes at most 15 bits; the codes' lengths and the empty block take less than 1000
    // bytes.
    std::vector<std::uint8_t> packed(2 * std::min(data.size(), kBlock) + 1024);
    for (std::size_t from = 0; from < data.size(); from += kBlock) {
        BitWriter out(packed.data());
        write_block(out, data.subspan(from, std::min(kBlock, data.size() - from)));
        out.add(0, 3); // An empty block of stored bytes, which begins on a whole byte.
        auto* const end = out.align();
        to.append(reinterpret_cast<char const*>(packed.data()),
                  static_cast<std::size_t>(end - packed.data()));
        to.append("\x00\x00\xff\xff", 4);
    }
}

void finish_deflated(std::string& to)
{
    to.append("\x03\x00", 2); // The last block, with fixed codes: its end.
}

} // namespace tractus::exports
