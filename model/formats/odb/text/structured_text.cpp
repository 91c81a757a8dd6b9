#include "model/formats/odb/text/structured_text.h"

#include <algorithm>

#include "model/formats/odb/text/records.h"

namespace model::odb {

namespace {

const Setting* find(const std::vector<Setting>& settings, std::string_view key) {
    const auto found =
        std::ranges::find_if(settings, [key](const Setting& setting) { return equalsIgnoringCase(setting.key, key); });
    return found == settings.end() ? nullptr : &*found;
}

/// "NAME {" gives NAME; anything else gives nothing.
std::string_view blockName(std::string_view line) {
    if (!line.ends_with('{') || line.find('=') != std::string_view::npos) {
        return {};
    }
    return trimmed(line.substr(0, line.size() - 1));
}

void addSetting(Block& block, std::string_view line, std::uint32_t number, std::string_view path,
                Diagnostics& diagnostics) {
    const std::size_t equals = line.find('=');
    if (equals == std::string_view::npos) {
        diagnostics.report(Severity::Warning, path, number,
                           "the line is neither KEY=value nor a block; it was left out");
        return;
    }
    block.settings.push_back({trimmed(line.substr(0, equals)), trimmed(line.substr(equals + 1)), number});
}

}  // namespace

std::string_view Block::value(std::string_view key) const {
    const Setting* setting = find(settings, key);
    return setting == nullptr ? std::string_view() : setting->value;
}

std::uint32_t Block::lineOf(std::string_view key) const {
    const Setting* setting = find(settings, key);
    return setting == nullptr ? 0 : setting->line;
}

StructuredText parseStructured(std::string_view text, std::string_view path, Diagnostics& diagnostics) {
    StructuredText parsed;
    bool isInside = false;
    LineReader lines(text);
    while (lines.next()) {
        const std::string_view line = trimmed(lines.line());
        if (const std::string_view name = blockName(line); !name.empty()) {
            parsed.blocks.push_back({name, lines.number(), {}});
            isInside = true;
        } else if (line == "}") {
            isInside = false;
        } else {
            addSetting(isInside ? parsed.blocks.back() : parsed.top, line, lines.number(), path, diagnostics);
        }
    }
    if (isInside) {
        diagnostics.report(Severity::Error, path, parsed.blocks.back().line,
                           "the block is not closed: the file ends early");
    }
    return parsed;
}

}  // namespace model::odb
