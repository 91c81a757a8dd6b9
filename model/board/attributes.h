#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "model/base/ids.h"

namespace model {

using AttributeSetId = base::Id<struct AttributeSetTag>;

/// Names and values of attributes, in words.
using AttributeValues = std::vector<std::pair<std::string, std::string>>;

/// The distinct sets of attributes that the features of a document carry. Few sets serve many elements, so an element
/// holds 4 bytes: ElementTable::attributes.
class AttributeTable {
public:
    /// The row of this set, added on first use; none for an empty one.
    AttributeSetId add(const AttributeValues& values);
    /// In the order of the record; empty for "none".
    [[nodiscard]] const AttributeValues& values(AttributeSetId set) const;
    [[nodiscard]] std::size_t size() const { return m_sets.size(); }

private:
    std::vector<AttributeValues> m_sets;
    std::map<AttributeValues, AttributeSetId> m_rows;
};

}  // namespace model
