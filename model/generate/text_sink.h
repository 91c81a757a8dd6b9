#pragma once

#include <charconv>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

namespace model::generate {

/// Takes text piece by piece and hands it on in large blocks; counts what went through.
class TextSink {
public:
    using Flush = std::function<void(std::string_view)>;
    /// Without `flush` the text is only counted.
    explicit TextSink(Flush flush = {}) : m_flush(std::move(flush)) {}
    ~TextSink() { flush(); }
    TextSink(const TextSink&) = delete;
    TextSink& operator=(const TextSink&) = delete;

    TextSink& operator<<(std::string_view text) {
        m_bytes += text.size();
        m_text += text;
        if (m_text.size() >= kBlock) {
            flush();
        }
        return *this;
    }
    TextSink& operator<<(std::int64_t number) {
        char digits[24];
        const auto end = std::to_chars(digits, digits + sizeof(digits), number).ptr;
        return *this << std::string_view(digits, static_cast<std::size_t>(end - digits));
    }
    /// Micrometres as millimetres with three decimals.
    TextSink& mm(std::int32_t um) {
        const std::int32_t size = um < 0 ? -um : um;
        const char decimals[] = {'.', static_cast<char>('0' + size / 100 % 10), static_cast<char>('0' + size / 10 % 10),
                                 static_cast<char>('0' + size % 10)};
        return *this << (um < 0 ? "-" : "") << std::int64_t{size / 1000} << std::string_view(decimals, 4);
    }

    [[nodiscard]] std::uint64_t bytes() const { return m_bytes; }

private:
    static constexpr std::size_t kBlock = std::size_t{1} << 20;

    void flush() {
        if (m_flush) {
            m_flush(m_text);
        }
        m_text.clear();
    }

    Flush m_flush;
    std::string m_text;
    std::uint64_t m_bytes = 0;
};

}  // namespace model::generate
