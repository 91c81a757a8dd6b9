#include "model/board/diagnostics.h"

#include <algorithm>

namespace model {

namespace {

std::string causeOf(const Diagnostic& entry) {
    return entry.file + '\n' + entry.text;
}

std::string sentence(std::string_view text) {
    std::string words(text);
    if (!words.empty() && words[0] >= 'a' && words[0] <= 'z') {
        words[0] = static_cast<char>(words[0] - 'a' + 'A');
    }
    return words;
}

}  // namespace

void Diagnostics::report(Severity severity, std::string_view file, std::uint32_t line, std::string_view text,
                         ElementId element) {
    add({severity, std::string(file), line, sentence(text), element, 1, {}});
}

void Diagnostics::append(const Diagnostics& other) {
    for (const Diagnostic& entry : other.m_entries) {
        add(entry);
    }
}

Diagnostics Diagnostics::without(const Diagnostics& other) const {
    Diagnostics rest;
    for (const Diagnostic& entry : m_entries) {
        if (!other.m_rowOfCause.contains(causeOf(entry))) {
            rest.add(entry);
        }
    }
    return rest;
}

void Diagnostics::soften(Severity most) {
    for (Diagnostic& entry : m_entries) {
        entry.severity = std::min(entry.severity, most);
    }
}

void Diagnostics::locate(std::size_t row, ElementId element, std::optional<base::Point> location) {
    m_entries[row].element = element;
    m_entries[row].location = location;
}

std::size_t Diagnostics::count(Severity severity) const {
    return static_cast<std::size_t>(
        std::ranges::count_if(m_entries, [severity](const Diagnostic& entry) { return entry.severity == severity; }));
}

void Diagnostics::add(const Diagnostic& entry) {
    const auto [location, isNew] = m_rowOfCause.try_emplace(causeOf(entry), m_entries.size());
    if (isNew) {
        m_entries.push_back(entry);
    } else {
        m_entries[location->second].count += entry.count;
    }
}

const char* toString(Severity severity) {
    switch (severity) {
        case Severity::Info: return "info";
        case Severity::Warning: return "warning";
        case Severity::Error: return "error";
    }
    return "";
}

}  // namespace model
