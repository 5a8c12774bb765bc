#pragma once

#include <cstddef>
#include <ostream>
#include <string>
#include <type_traits>

namespace tractus::exports {

// Collects little-endian numbers and passes them to a stream in large pieces. This machine must be
// little-endian.
class BinaryStream {
public:
    explicit BinaryStream(std::ostream& out)
        : out_(out)
    {
    }
    ~BinaryStream() { flush(); }
    BinaryStream(BinaryStream const&) = delete;
    BinaryStream& operator=(BinaryStream const&) = delete;

    template<typename Number> void write(Number value)
    {
        static_assert(std::is_arithmetic_v<Number>);
        bytes_.append(reinterpret_cast<char const*>(&value), sizeof value);
        if (bytes_.size() > kFull)
            flush();
    }

    template<typename Vector> void write_vector(Vector const& vector)
    {
        for (auto const value : vector)
            write(value);
    }

    void flush()
    {
        out_.write(bytes_.data(), static_cast<std::streamsize>(bytes_.size()));
        bytes_.clear();
    }

private:
    static constexpr std::size_t kFull = std::size_t { 1 } << 20;

    std::ostream& out_;
    std::string bytes_;
};

} // namespace tractus::exports
