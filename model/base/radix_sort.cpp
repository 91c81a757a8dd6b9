#include "model/base/radix_sort.h"

#include <algorithm>
#include <array>
#include <utility>

namespace base {
namespace {

/// 11 + 11 + 10 bits at a time.
constexpr std::array<int, 3> kShift = {32, 43, 54};
using Starts = std::array<std::array<std::uint32_t, 2048>, kShift.size()>;

/// Below this, comparing beats counting into 3 x 2048 buckets.
constexpr std::size_t kSmall = 1024;

std::size_t digit(std::uint64_t word, std::size_t pass) {
    return word >> kShift[pass] & 2047;
}

/// Do all words have the digit of this one? `starts` as startsOf made them.
bool isSameInAll(const Starts& starts, std::uint64_t word, std::size_t pass, std::size_t count) {
    const auto& ofPass = starts[pass];
    const std::size_t own = digit(word, pass);
    return ofPass[own] == 0 && (own + 1 == ofPass.size() || ofPass[own + 1] == count);
}

/// Per pass, where the words of each digit go.
Starts startsOf(const std::uint64_t* words, std::size_t count) {
    Starts starts{};
    for (std::size_t i = 0; i < count; ++i) {
        for (std::size_t pass = 0; pass < kShift.size(); ++pass) {
            ++starts[pass][digit(words[i], pass)];
        }
    }
    for (auto& ofPass : starts) {
        std::uint32_t sum = 0;
        for (std::uint32_t& start : ofPass) {
            sum += std::exchange(start, sum);
        }
    }
    return starts;
}

}  // namespace

std::uint64_t* sortByKey(std::uint64_t* words, std::uint64_t* spare, std::size_t count) {
    if (count <= kSmall) {
        std::sort(words, words + count);
        return words;
    }
    Starts starts = startsOf(words, count);
    for (std::size_t pass = 0; pass < kShift.size(); ++pass) {
        if (isSameInAll(starts, words[0], pass, count)) {
            continue;
        }
        for (std::size_t i = 0; i < count; ++i) {
            spare[starts[pass][digit(words[i], pass)]++] = words[i];
        }
        std::swap(words, spare);
    }
    return words;
}

}  // namespace base
