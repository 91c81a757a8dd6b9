#include "model/formats/odb/text/feature_attributes.h"

#include <algorithm>

#include "model/base/ascii.h"
#include "model/formats/odb/text/records.h"

namespace model::odb {

namespace {

/// Numbers may skip, but a table of a million is no table.
constexpr std::int32_t kMaxTableNumber = 1'000'000;

/// Where the first entry of a set ends: at a comma, or at blanks before another number (Altium's routed slots).
std::size_t endOfEntry(std::string_view set) {
    for (std::size_t i = 0; i < set.size(); ++i) {
        const std::size_t next = set.find_first_not_of(" \t", i);
        const bool isNextNumber = next != std::string_view::npos && next > i && base::isDigit(set[next]);
        if (set[i] == ',' || (isNextNumber && i > 0 && set[i - 1] != '=')) {
            return i;
        }
    }
    return set.size();
}

/// Calls `use(number, value)` for each entry `number` or `number=value` of a set.
template <class Use>
void forEachEntry(std::string_view set, Use use) {
    while (!set.empty()) {
        const std::size_t end = endOfEntry(set);
        const std::string_view entry = trimmed(set.substr(0, end));
        const std::size_t equals = std::min(entry.find('='), entry.size());
        use(trimmed(entry.substr(0, equals)), entry.substr(std::min(equals + 1, entry.size())));
        set.remove_prefix(std::min(end + 1, set.size()));
    }
}

void store(std::vector<std::string>& table, std::int32_t number, std::string_view text) {
    const auto row = static_cast<std::size_t>(number);
    table.resize(std::max(table.size(), row + 1));
    table[row] = toUtf8(text);
}

}  // namespace

AttributeValues FeatureAttributes::values(std::uint32_t set, const AttributeTypes& types) const {
    AttributeValues values;
    forEachEntry(sets[set], [&](std::string_view number, std::string_view raw) {
        const auto row = parseInteger(number);
        const bool isListed = row && *row >= 0 && static_cast<std::size_t>(*row) < names.size() &&
                              !names[static_cast<std::size_t>(*row)].empty();
        if (isListed) {
            const std::string& name = names[static_cast<std::size_t>(*row)];
            values.emplace_back(name, types.value(name, trimmed(raw), texts));
        }
    });
    return values;
}

bool AttributeCollector::tableLine(std::string_view line) {
    Fields fields(line.substr(1));
    const std::int32_t number = fields.integer();
    if ((line[0] != '@' && line[0] != '&') || fields.failed() || number < 0 || number > kMaxTableNumber) {
        return false;
    }
    // `&` texts may hold blanks and `;`.
    const std::string_view text = trimmed(fields.rest());
    if (line[0] == '&') {
        store(m_into.texts, number, text);
        return true;
    }
    store(m_into.names, number, text);
    if (text == ".drill") {
        m_drillAttribute = std::to_string(number);
    } else if (text == ".rout_plated") {
        m_routedAttribute = std::to_string(number);
    }
    return true;
}

std::uint32_t AttributeCollector::set(std::string_view tail) {
    const std::string_view set = trimmed(tail.substr(0, tail.find(';')));
    if (set.empty()) {
        return kNone;
    }
    if (set == m_last) {
        return m_lastRow;
    }
    const auto [location, isNew] = m_rows.try_emplace(set, static_cast<std::uint32_t>(m_into.sets.size()));
    if (isNew) {
        m_into.sets.emplace_back(set);
        m_platings.push_back(findPlating(set));
    }
    m_last = set;
    m_lastRow = location->second;
    return m_lastRow;
}

Plating AttributeCollector::findPlating(std::string_view set) const {
    static constexpr Plating kValues[] = {Plating::Plated, Plating::NonPlated, Plating::Via};
    Plating drilled = Plating::NotSaid;
    Plating routed = Plating::NotSaid;
    forEachEntry(set, [&](std::string_view number, std::string_view raw) {
        const auto value = parseInteger(raw);
        if (!m_drillAttribute.empty() && number == m_drillAttribute && value && *value >= 0 && *value <= 2) {
            drilled = kValues[*value];
        }
        // A boolean is true by being there; some write its value all the same.
        if (!m_routedAttribute.empty() && number == m_routedAttribute && value != 0) {
            routed = Plating::Plated;
        }
    });
    return drilled != Plating::NotSaid ? drilled : routed;
}

}  // namespace model::odb
