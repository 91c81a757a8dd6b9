#include "model/formats/gerber/image/attributes.h"

#include <algorithm>
#include <charconv>

#include "model/formats/gerber/text/words.h"
#include "model/text/utf8.h"

namespace model::gerber {

namespace {

SubnetKind kindOf(std::string_view function) {
    const std::string_view name = function.substr(0, function.find(','));
    return name == "ViaPad" ? SubnetKind::Via : name == "Conductor" ? SubnetKind::Trace : SubnetKind::Other;
}

std::string keyOf(const formats::Words& words) {
    std::string key;
    for (const auto& [name, value] : words) {
        key += name + '\x1f' + value + '\x1e';
    }
    return key;
}

}  // namespace

std::string_view Image::fileAttribute(std::string_view name) const {
    const auto found = std::ranges::find(fileAttributes, name, &std::pair<std::string, std::string>::first);
    return found == fileAttributes.end() ? std::string_view() : std::string_view(found->second);
}

std::string unescaped(std::string_view text) {
    std::string out;
    while (!text.empty()) {
        const bool isShort = text.starts_with("\\u");
        const std::size_t digits = isShort ? 4 : 8;
        if ((isShort || text.starts_with("\\U")) && text.size() >= 2 + digits) {
            std::uint32_t code = 0;
            const char* const end = text.data() + 2 + digits;
            const std::from_chars_result result = std::from_chars(text.data() + 2, end, code, 16);
            if (result.ec == std::errc() && result.ptr == end && code < 0x110000 && (code < 0xd800 || code > 0xdfff)) {
                appendUtf8(out, code);
                text.remove_prefix(2 + digits);
                continue;
            }
        }
        moveCharacter(text, out);
    }
    return out;
}

bool AttributeState::command(std::string_view code, std::string_view rest) {
    if (code == "TF") {
        set(m_image.fileAttributes, rest);
    } else if (code == "TJ") {
        set(m_image.jobAttributes, rest);
    } else if (code == "TA") {
        set(m_aperture, rest);
        m_isApertureOld = true;
    } else if (code == "TO") {
        set(m_object, rest);
        m_isObjectOld = true;
    } else if (code == "TD") {
        remove(trimmed(rest));
    } else {
        return false;
    }
    return true;
}

void AttributeState::set(formats::Words& words, std::string_view rest) {
    const std::size_t comma = rest.find(',');
    const std::string name = unescaped(trimmed(rest.substr(0, comma)));
    const std::string_view value = comma == std::string_view::npos ? std::string_view() : rest.substr(comma + 1);
    const auto found = std::ranges::find(words, name, &std::pair<std::string, std::string>::first);
    // Commas between fields stay; escaped ones inside a field are resolved where fields are taken apart.
    if (found == words.end()) {
        words.emplace_back(name, trimmed(value));
    } else {
        found->second = trimmed(value);
    }
}

void AttributeState::remove(std::string_view name) {
    const auto isIt = [&](const auto& word) { return name.empty() || word.first == name; };
    m_isApertureOld = std::erase_if(m_aperture, isIt) > 0 || m_isApertureOld;
    m_isObjectOld = std::erase_if(m_object, isIt) > 0 || m_isObjectOld;
}

std::int32_t AttributeState::apertureSet() {
    if (m_isApertureOld) {
        m_isApertureOld = false;
        m_apertureSet = formats::kNoRow;
        if (!m_aperture.empty()) {
            const auto found = std::ranges::find(m_apertureSets, m_aperture);
            m_apertureSet = static_cast<std::int32_t>(found - m_apertureSets.begin());
            if (found == m_apertureSets.end()) {
                m_apertureSets.push_back(m_aperture);
            }
        }
    }
    return m_apertureSet;
}

std::int32_t AttributeState::netRow(std::string_view value) {
    const std::string name = unescaped(value.substr(0, value.find(',')));
    if (name.empty()) {
        return formats::kNoRow;
    }
    const auto [found, isNew] = m_nets.try_emplace(name, static_cast<std::int32_t>(m_image.nets.size()));
    if (isNew) {
        m_image.nets.push_back(name);
    }
    return found->second;
}

std::int32_t AttributeState::componentRow(const std::string& refdes) {
    if (refdes.empty()) {
        return formats::kNoRow;
    }
    const auto [found, isNew] = m_components.try_emplace(refdes, static_cast<std::int32_t>(m_image.components.size()));
    if (isNew) {
        m_image.components.push_back(refdes);
    }
    return found->second;
}

std::int32_t AttributeState::pinRow(std::string_view value) {
    const auto [found, isNew] = m_pins.try_emplace(std::string(value), static_cast<std::int32_t>(m_image.pins.size()));
    if (isNew) {
        const std::vector<std::string_view> fields = split(value, ',');
        m_image.pins.push_back({componentRow(unescaped(fields[0])), fields.size() > 1 ? unescaped(fields[1]) : "",
                                fields.size() > 2 ? unescaped(fields[2]) : ""});
    }
    return found->second;
}

void AttributeState::refreshObject() {
    m_isObjectOld = false;
    m_now.net = m_now.component = m_now.pin = formats::kNoRow;
    m_otherWords.clear();
    m_setRows.clear();
    m_hasLast = false;
    for (const auto& [name, value] : m_object) {
        if (name == ".N") {
            m_now.net = netRow(value);
        } else if (name == ".P") {
            m_now.pin = pinRow(value);
            m_now.component = m_image.pins[static_cast<std::size_t>(m_now.pin)].component;
        } else if (name == ".C") {
            m_now.component = m_now.component < 0 ? componentRow(unescaped(value)) : m_now.component;
        } else {
            m_otherWords.emplace_back(name, unescaped(value));
        }
    }
}

void AttributeState::apply(formats::DrawnFeature& feature, std::int32_t apertureSet) {
    if (m_isObjectOld) {
        refreshObject();
    }
    feature.net = m_now.net;
    feature.component = m_now.component;
    feature.pin = m_now.pin;
    if (!m_hasLast || m_lastSet != apertureSet) {
        look(apertureSet);
    }
    feature.attributes = m_lastRow;
    feature.subnet =
        m_lastKind == SubnetKind::Trace && feature.kind == formats::DrawnKind::Region ? SubnetKind::Plane : m_lastKind;
}

/// Finds out what the attributes of an aperture and those of the object are together.
void AttributeState::look(std::int32_t apertureSet) {
    m_hasLast = true;
    m_lastSet = apertureSet;
    m_lastKind = SubnetKind::Other;
    formats::Words words = apertureSet < 0 ? formats::Words() : m_apertureSets[static_cast<std::size_t>(apertureSet)];
    const auto function = std::ranges::find(words, ".AperFunction", &std::pair<std::string, std::string>::first);
    m_lastKind = function == words.end() ? SubnetKind::Other : kindOf(function->second);
    const auto [found, isNew] = m_setRows.try_emplace(apertureSet, formats::kNoRow);
    m_lastRow = found->second;
    words.insert(words.end(), m_otherWords.begin(), m_otherWords.end());
    if (isNew && !words.empty()) {
        const auto [row, isFirst] =
            m_wordRows.try_emplace(keyOf(words), static_cast<std::int32_t>(m_image.attributes.size()));
        if (isFirst) {
            m_image.attributes.push_back(std::move(words));
        }
        m_lastRow = found->second = row->second;
    }
}

}  // namespace model::gerber
