#include "model/formats/odb/text/record_attributes.h"

#include <algorithm>

namespace model::odb {

std::vector<TextProperty> RecordAttributes::resolve(std::string_view tail, const AttributeTypes& types,
                                                    const FileCursor& at) {
    std::vector<TextProperty> found;
    const std::string_view list = trimmed(tail.substr(0, tail.find(';')));
    if (list.empty() || list.starts_with("ID=")) {
        return found;
    }
    for (const auto& [name, value] : m_tables.values(m_collector.set(tail), types)) {
        found.push_back({name, value});
    }
    if (found.size() <= static_cast<std::size_t>(std::ranges::count(list, ','))) {
        at.report(Severity::Warning, "an attribute that the file does not name was left out");
    }
    return found;
}

bool PropertyReader::record(std::string_view line, std::vector<TextProperty>& into) {
    if (m_isOpen && !into.empty()) {
        const std::size_t quote = line.rfind('\'');
        m_isOpen = quote == std::string_view::npos;
        into.back().value += '\n' + toUtf8(line.substr(0, quote));
        return true;
    }
    if (!line.starts_with("PRP") || (line.size() > 3 && line[3] != ' ' && line[3] != '\t')) {
        return false;
    }
    const std::string_view text = trimmed(line.substr(3));
    const std::size_t first = text.find('\'');
    const std::size_t last = text.rfind('\'');
    const std::string_view name = trimmed(text.substr(0, std::min(first, text.find_first_of(" \t"))));
    if (first == std::string_view::npos) {
        into.push_back({toUtf8(name), toUtf8(trimmed(text.substr(name.size())))});
        return true;
    }
    m_isOpen = first == last;
    std::string value = toUtf8(text.substr(first + 1, m_isOpen ? std::string_view::npos : last - first - 1));
    if (const std::string_view numbers = m_isOpen ? std::string_view() : trimmed(text.substr(last + 1));
        !numbers.empty()) {
        value += (value.empty() ? "" : " ") + std::string(numbers);
    }
    into.push_back({toUtf8(name), std::move(value)});
    return true;
}

}  // namespace model::odb
