#pragma once

#include <string_view>
#include <unordered_map>
#include <vector>

#include "model/formats/ipc2581/reading.h"

namespace model::ipc2581 {

enum class LineEnd : std::uint8_t { Round, Square, None };
/// Erasing lines take away what was drawn before them on their layer; broken ones are dotted, dashed or the like.
enum class LineProperty : std::uint8_t { Solid, Broken, Erasing };

/// A LineDesc: how lines and outlines are drawn. Nanometres.
struct LineStyle {
    double width = 0.0;
    LineEnd end = LineEnd::Round;
    LineProperty property = LineProperty::Solid;

    [[nodiscard]] LineStyle scaledBy(double factor) const { return {width * factor, end, property}; }
};

enum class FillKind : std::uint8_t { Fill, Hollow, Hatch, Void };

/// A FillDesc: what is inside an outline. Nothing said: filled.
struct FillStyle {
    FillKind kind = FillKind::Fill;
    double lineWidth = 0.0;
    double pitch1 = 0.0;  ///< of hatches
    double pitch2 = 0.0;  ///< of the second set of lines; 0: there is none
    double angle1 = 0.0;  ///< degrees, counter-clockwise
    double angle2 = 0.0;
};

/// An entry of a dictionary of shapes: read anew where it is used.
struct DictionaryEntry {
    XmlSection section;
    double unitNm = 0.0;
};

/// The dictionaries of the Content section, each with units of its own. Entries are found by their ids as written.
class Dictionaries {
public:
    explicit Dictionaries(Reading& reading);

    [[nodiscard]] const DictionaryEntry* standard(std::string_view id) const { return find(m_standard, id); }
    [[nodiscard]] const DictionaryEntry* user(std::string_view id) const { return find(m_user, id); }
    /// Takes in a LineDesc, FillDesc or a reference to one. False if the element is none of them, nor one of a colour.
    bool readStyle(const XmlCursor& at, double unitNm, LineStyle& line, FillStyle& fill) const;

private:
    template <class Value>
    using Table = std::unordered_map<std::string_view, Value>;
    template <class Value>
    static const Value* find(const Table<Value>& table, std::string_view id) {
        const auto found = table.find(id);
        return found == table.end() ? nullptr : &found->second;
    }

    void readEntry(const XmlSection& section, double unitNm);
    [[nodiscard]] LineStyle lineStyle(const XmlCursor& at, double unitNm) const;
    [[nodiscard]] FillStyle fillStyle(const XmlCursor& at, double unitNm) const;
    template <class Value>
    void refer(const Table<Value>& table, const XmlCursor& at, Value& value) const;

    Reading& m_reading;
    Table<DictionaryEntry> m_standard;
    Table<DictionaryEntry> m_user;
    Table<LineStyle> m_lines;
    Table<FillStyle> m_fills;
};

}  // namespace model::ipc2581
