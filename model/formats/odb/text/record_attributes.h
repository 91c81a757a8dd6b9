#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "model/formats/odb/text/feature_attributes.h"
#include "model/formats/odb/text/records.h"

namespace model::odb {

/// A name and its value as text: an attribute (".comp_height", "0.65") or a PRP record ("MPN", "M00219").
struct TextProperty {
    std::string name;
    std::string value;
    bool operator==(const TextProperty&) const = default;
};

/// The attributes of records that are not features: the `@number name` and `&number text` lines of their file, and the
/// tails of its records (`;0=1,2,5=12.5;ID=123`) in words.
class RecordAttributes {
public:
    /// Takes a line if it is one of the two kinds. Its text must outlive this.
    bool record(std::string_view line) { return (line[0] == '@' || line[0] == '&') && m_collector.tableLine(line); }
    /// The attributes of a tail (Fields::tail()) in its order, IDs left out. Entries that no `@` line names are
    /// reported.
    [[nodiscard]] std::vector<TextProperty> resolve(std::string_view tail, const AttributeTypes& types,
                                                    const FileCursor& at);

private:
    FeatureAttributes m_tables;
    AttributeCollector m_collector{m_tables};
};

/// Takes `PRP name 'value' number…` records, whose values may run over several lines.
class PropertyReader {
public:
    /// True when the line is a PRP record or goes on with the value of one; the finished ones are put into `into`.
    bool record(std::string_view line, std::vector<TextProperty>& into);

private:
    bool m_isOpen = false;  ///< the last value has no closing quote yet
};

}  // namespace model::odb
