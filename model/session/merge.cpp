#include "model/session/merge.h"

#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

namespace model::session {

namespace {

struct Entry {
    std::string id;  ///< no other one of the same part has it
    Json value;
};

/// The entries of a part by their ids.
class Entries {
public:
    Entries(Unit unit, const Json& part) {
        for (const auto& [key, value] : part.items()) {
            add(part.is_object() ? key : unit == Unit::Name ? nameOf(value) : textOf(value), value);
        }
        for (const Entry& entry : m_list) {
            m_values.emplace(entry.id, &entry.value);
        }
    }

    [[nodiscard]] const std::vector<Entry>& list() const { return m_list; }
    /// Null for none.
    [[nodiscard]] const Json& of(const std::string& id) const {
        static const Json kNone;
        const auto found = m_values.find(id);
        return found != m_values.end() ? *found->second : kNone;
    }

private:
    static std::string textOf(const Json& value) { return value.dump(-1, ' ', true, Json::error_handler_t::replace); }
    static std::string nameOf(const Json& item) {
        return item.is_object() ? textOf({item.value("name", Json()), item.value("step", Json())}) : textOf(item);
    }
    /// The second one of an id is another entry.
    void add(const std::string& id, const Json& value) {
        m_list.push_back({id + '#' + std::to_string(++m_counts[id]), value});
    }

    std::vector<Entry> m_list;
    std::unordered_map<std::string, int> m_counts;
    std::unordered_map<std::string, const Json*> m_values;
};

bool hasEntries(const Json& part) {
    return part.is_object() || part.is_array();
}

/// True if all parts that are there are of one kind, which `kind` becomes an empty one of.
bool areAlike(std::initializer_list<const Json*> parts, Json& kind) {
    for (const Json* part : parts) {
        if (part->is_null()) {
            continue;
        }
        if (!hasEntries(*part) || (!kind.is_null() && kind.type() != part->type())) {
            return false;
        }
        kind = part->is_object() ? Json::object() : Json::array();
    }
    return true;
}

const Json& pick(const Json& base, const Json& mine, const Json& theirs, Merged& merged) {
    if (mine == base) {
        merged.hasTheirs = merged.hasTheirs || theirs != mine;
        return theirs;
    }
    merged.replacesTheirs = merged.replacesTheirs || (theirs != base && theirs != mine);
    return mine;
}

void append(Json& part, const std::string& id, const Json& value) {
    if (value.is_null()) {
        return;
    }
    if (part.is_object()) {
        part[id.substr(0, id.rfind('#'))] = value;
    } else {
        part.push_back(value);
    }
}

}  // namespace

Merged merge(Unit unit, const Json& base, const Json& mine, const Json& theirs) {
    Merged merged;
    Json part;
    const bool areEqual = mine == base || theirs == base;
    if (unit == Unit::Whole || areEqual || !areAlike({&base, &mine, &theirs}, part)) {
        merged.part = pick(base, mine, theirs, merged);
        return merged;
    }
    const Entries before(unit, base);
    const Entries here(unit, mine);
    const Entries there(unit, theirs);
    for (const auto& [id, value] : here.list()) {
        append(part, id, pick(before.of(id), value, there.of(id), merged));
    }
    for (const auto& [id, value] : there.list()) {
        if (here.of(id).is_null()) {
            append(part, id, pick(before.of(id), {}, value, merged));
        }
    }
    merged.part = part.empty() ? Json() : std::move(part);
    return merged;
}

}  // namespace model::session
