#pragma once

#include <cstdint>
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
/// with 9. A reader that asks for a tolerance of 1e-6 mm finds every vertex on its curves.
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

    /// What was written so far and not taken yet.
    [[nodiscard]] std::string& text() { return m_text; }
    [[nodiscard]] StepId lastId() const { return m_last; }

    /// An entity that is written out: `add("PLANE('',", axis, ")")` becomes `#7=PLANE('',#3);`. Parts are words,
    /// references, lists of them, and numbers.
    template <class... Parts>
    StepId add(const Parts&... parts) {
        const StepId id = begin();
        (put(parts), ...);
        m_text += ";\n";
        return id;
    }

    StepId point(base::PointD p, double z);
    StepId direction(double x, double y, double z);

private:
    StepId begin();
    void put(std::string_view words) { m_text += words; }
    void put(StepId id);
    void put(Length length);
    void put(Ratio ratio);
    void put(int number) { m_text += std::to_string(number); }
    /// A list of whatever put() takes, in parentheses.
    template <class Item>
    void put(const std::vector<Item>& items) {
        m_text += '(';
        for (std::size_t i = 0; i < items.size(); ++i) {
            m_text += i > 0 ? "," : "";
            put(items[i]);
        }
        m_text += ')';
    }
    void put(std::span<const StepId> ids);

    std::string m_text;
    StepId m_last = 0;
};

/// A name between quotes as Part 21 wants it: quotes and backslashes doubled, everything beyond ASCII as `\X2\...\X0\`
/// or `\X4\...\X0\`. Bytes that are no UTF-8 become `?`.
[[nodiscard]] std::string stepString(std::string_view utf8);

}  // namespace model
