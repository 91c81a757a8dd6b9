#pragma once

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "model/base/point.h"

namespace model {

/// The `#number` of an entity; 0 is none and written as `$`.
using StepId = std::uint32_t;

/// The data section of a STEP file as text (ISO 10303-21), an entity per line, numbered as they are written. Lengths
/// come in nanometres and are written in millimetres with 8 digits behind the point, which is 0.01 nm; directions
/// with 9. A reader that asks for a tolerance of 1e-6 mm finds every vertex on its curves. Exports spend most of their
/// time here: characters go straight into a buffer, and nothing is allocated once it is as large as it gets.
class StepText {
public:
    /// A part of an entity that is a length in nm, written in mm and always with a point: 1500000 is `1.5`.
    struct Length {
        double nm;
    };
    /// A part that is a plain number, with 9 digits behind the point.
    struct Ratio {
        double value;
    };

    /// What was written since the last clear().
    [[nodiscard]] std::string_view text() const { return {m_buffer.data(), m_size}; }
    void clear() { m_size = 0; }
    [[nodiscard]] StepId lastId() const { return m_last; }

    /// An entity that is written out: `add("PLANE('',", axis, ")")` becomes `#7=PLANE('',#3);`. Parts are words,
    /// references, lists of them, and numbers.
    template <class... Parts>
    StepId add(const Parts&... parts) {
        const StepId id = begin();
        (put(parts), ...);
        put(";\n");
        return id;
    }

    StepId point(base::PointD p, double z);
    StepId direction(double x, double y, double z);

private:
    /// Where the next `most` characters can be put at the most; end() says how many there were.
    char* room(std::size_t most) {
        if (m_size + most > m_buffer.size()) {
            m_buffer.resize(std::max(2 * m_buffer.size(), m_size + most));
        }
        return m_buffer.data() + m_size;
    }
    void end(const char* at) { m_size = static_cast<std::size_t>(at - m_buffer.data()); }

    StepId begin();
    void put(std::string_view words) {
        std::memcpy(room(words.size()), words.data(), words.size());
        m_size += words.size();
    }
    void put(const char* words) { put(std::string_view(words)); }
    void put(StepId id);
    void put(Length length);
    void put(Ratio ratio);
    void put(int number) { put(std::string_view(std::to_string(number))); }
    /// A list of whatever put() takes, in parentheses.
    template <class Item>
    void put(std::span<const Item> items) {
        const char* before = "(";
        for (const Item& item : items) {
            put(before);
            put(item);
            before = ",";
        }
        put(items.empty() ? "()" : ")");
    }
    template <class Item>
    void put(const std::vector<Item>& items) {
        put(std::span<const Item>(items));
    }

    std::vector<char> m_buffer;
    std::size_t m_size = 0;  ///< characters of m_buffer that were written
    StepId m_last = 0;
};

/// A name between quotes as Part 21 wants it: quotes and backslashes doubled, everything beyond ASCII as `\X2\...\X0\`
/// or `\X4\...\X0\`. Bytes that are no UTF-8 become `?`.
[[nodiscard]] std::string stepString(std::string_view utf8);

}  // namespace model
