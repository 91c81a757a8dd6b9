#include "model/board/attributes.h"

namespace model {

AttributeSetId AttributeTable::add(const AttributeValues& values) {
    if (values.empty()) {
        return {};
    }
    const auto [location, isNew] = m_rows.try_emplace(values, m_sets.size());
    if (isNew) {
        m_sets.push_back(values);
    }
    return location->second;
}

const AttributeValues& AttributeTable::values(AttributeSetId set) const {
    static const AttributeValues kNothing;
    return set.isValid() ? m_sets[set.row()] : kNothing;
}

}  // namespace model
