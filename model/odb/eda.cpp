#include "model/odb/eda.h"

#include <algorithm>

#include "model/odb/records.h"

namespace model::odb {

namespace {

/// Everything up to the attributes, without blanks around it.
std::string_view nameOf(std::string_view text) {
    return trimmed(text.substr(0, text.find(';')));
}

/// The longest name that `text` begins with, whole words only; its length, or 0.
std::size_t knownPrefix(std::string_view text, const std::vector<std::string>& names) {
    std::size_t longest = 0;
    for (const std::string& name : names) {
        const bool fits = text.size() >= name.size() && equalsIgnoringCase(text.substr(0, name.size()), name) &&
                          (text.size() == name.size() || text[name.size()] == ' ' || text[name.size()] == '\t');
        longest = fits ? std::max(longest, name.size()) : longest;
    }
    return longest;
}

std::vector<std::string> splitLayers(std::string_view text, const std::vector<std::string>& names) {
    std::vector<std::string> layers;
    for (text = trimmed(text); !text.empty(); text = trimmed(text)) {
        std::size_t length = knownPrefix(text, names);
        length = length > 0 ? length : std::min(text.find_first_of(" \t"), text.size());
        layers.emplace_back(text.substr(0, length));
        text.remove_prefix(length);
    }
    return layers;
}

class EdaParser {
public:
    EdaParser(std::string_view path, const std::vector<std::string>& layerNames, Diagnostics& diagnostics)
        : m_path(path), m_layerNames(layerNames), m_diagnostics(diagnostics) {}

    EdaData parse(std::string_view text) {
        LineReader lines(text);
        while (lines.next()) {
            m_line = lines.number();
            record(lines.line());
        }
        return std::move(m_data);
    }

private:
    static bool isRecord(std::string_view line, std::string_view type) {
        return line.starts_with(type) && (line.size() == type.size() || line[type.size()] == ' ');
    }

    void record(std::string_view line) {
        if (isRecord(line, "FID")) {
            feature(line.substr(3));
        } else if (isRecord(line, "NET")) {
            m_data.nets.push_back(toUtf8(nameOf(line.substr(3))));
            m_isInNet = true;
        } else if (isRecord(line, "PKG")) {
            Fields fields(line.substr(3));
            m_data.packages.push_back({toUtf8(fields.optionalWord()), {}});
            m_isInNet = false;
        } else if (isRecord(line, "PIN")) {
            pin(line.substr(3));
        } else if (isRecord(line, "FGR")) {
            m_isInNet = false;
        } else if (isRecord(line, "LYR")) {
            m_data.layers = splitLayers(toUtf8(line.substr(3)), m_layerNames);
        } else if (isRecord(line, "HDR")) {
            m_data.generator = toUtf8(trimmed(line.substr(3)));
        }
        // Everything else (outlines, subnets, properties, attribute tables) is not needed.
    }

    void feature(std::string_view line) {
        if (!m_isInNet) {
            return;  // feature groups name features that are in no net
        }
        Fields fields(line);
        fields.word();  // C, L or H: not reliable (odb-notes, Stack)
        const std::int32_t layer = fields.integer();
        const std::int32_t number = fields.integer();
        if (fields.failed() || layer < 0 || number < 0 || static_cast<std::size_t>(layer) >= m_data.layers.size()) {
            m_diagnostics.report(Severity::Warning, m_path, m_line,
                                 "the FID record is unreadable or names no layer of the LYR line; it was left out");
            return;
        }
        m_data.netFeatures.push_back({static_cast<std::uint32_t>(m_data.nets.size() - 1),
                                      static_cast<std::uint32_t>(layer), static_cast<std::uint32_t>(number), m_line});
    }

    void pin(std::string_view line) {
        Fields fields(line);
        if (m_data.packages.empty()) {
            m_diagnostics.report(Severity::Warning, m_path, m_line, "a PIN record outside of a package was left out");
            return;
        }
        m_data.packages.back().pins.push_back(toUtf8(fields.optionalWord()));
    }

    EdaData m_data;
    std::string_view m_path;
    const std::vector<std::string>& m_layerNames;
    Diagnostics& m_diagnostics;
    std::uint32_t m_line = 0;
    bool m_isInNet = false;
};

}  // namespace

EdaData parseEda(std::string_view text, std::string_view path, const std::vector<std::string>& layerNames,
                 Diagnostics& diagnostics) {
    return EdaParser(path, layerNames, diagnostics).parse(text);
}

}  // namespace model::odb
