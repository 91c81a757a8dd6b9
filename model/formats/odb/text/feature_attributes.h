#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "model/board/document.h"
#include "model/formats/odb/text/attribute_types.h"

namespace model::odb {

/// The attributes of one features file: its `@` and `&` tables, and each distinct set that its records carry once.
/// Records refer to a set by its row. Sets are written as in the file, `0=1,2`.
struct FeatureAttributes {
    static constexpr std::uint32_t kNone = 0xffffffffU;

    std::vector<std::string> names;  ///< by number of the `@` line; unlisted ones are empty
    std::vector<std::string> texts;  ///< by number of the `&` line
    std::vector<std::string> sets;

    /// A set in words; entries whose name the file does not list are left out.
    [[nodiscard]] AttributeValues values(std::uint32_t set, const AttributeTypes& types) const;
};

/// Collects the sets while a file is parsed, without a copy per record. The text of the file must outlive it.
class AttributeCollector {
public:
    explicit AttributeCollector(FeatureAttributes& into) : m_into(into) {}

    /// `@number name` or `&number text`. False when the line is neither.
    bool tableLine(std::string_view line);
    /// Row of the set in the tail of a record, `0=1,2=5;ID=7`; kNone when it is empty.
    std::uint32_t set(std::string_view tail);
    /// What attribute .drill of a set says; where it is silent, a set with .rout_plated is plated.
    [[nodiscard]] Plating plating(std::uint32_t set) const { return set == kNone ? Plating::NotSaid : m_platings[set]; }

private:
    static constexpr std::uint32_t kNone = FeatureAttributes::kNone;

    [[nodiscard]] Plating findPlating(std::string_view set) const;

    FeatureAttributes& m_into;
    std::unordered_map<std::string_view, std::uint32_t> m_rows;
    std::vector<Plating> m_platings;
    std::string m_drillAttribute;   ///< "3" when attribute 3 is .drill
    std::string m_routedAttribute;  ///< the same of .rout_plated, a boolean
    std::string_view m_last;        ///< neighbours mostly carry the same
    std::uint32_t m_lastRow = kNone;
};

}  // namespace model::odb
