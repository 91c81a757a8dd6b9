#include "model/formats/odb/text/attribute_types.h"

#include <algorithm>
#include <array>

#include "model/formats/odb/text/records.h"
#include "model/formats/odb/text/structured_text.h"

namespace model::odb {

namespace {

/// Where the types of a job may be; each generator writes its own selection.
constexpr std::array<std::string_view, 8> kFiles = {"sysattr",        "sysattr.assy",   "sysattr.dfm",
                                                    "sysattr.fab",    "sysattr.intern", "sysattr.frontline",
                                                    "sysattr.mentor", "userattr"};

constexpr std::array<std::string_view, 6> kTexts = {".geometry", ".string", ".comment", ".net_name", ".bit", ".text"};

std::vector<std::string> splitOptions(std::string_view list) {
    std::vector<std::string> options;
    while (!list.empty()) {
        const std::size_t length = std::min(list.find(';'), list.size());
        options.push_back(toUtf8(trimmed(list.substr(0, length))));
        list.remove_prefix(std::min(length + 1, list.size()));
    }
    return options;
}

}  // namespace

AttributeTypes::AttributeTypes() {
    for (const std::string_view name : kTexts) {
        m_types[std::string(name)].isText = true;
    }
    m_types[".drill"].options = {"plated", "non_plated", "via"};
    m_types[".pad_usage"].options = {"toeprint", "via", "g_fiducial", "l_fiducial", "tooling_hole"};
    m_types[".comp_mount_type"].options = {"other", "smt", "thmt", "pressfit"};
}

AttributeTypes::AttributeTypes(const formats::FileTree& job, Diagnostics& diagnostics) : AttributeTypes() {
    for (const std::string_view name : kFiles) {
        const std::string path = "misc/" + std::string(name);
        if (!job.has(path)) {
            continue;
        }
        if (const auto file = job.read(path, diagnostics)) {
            read(file->text(), file->path, diagnostics);
        }
    }
}

void AttributeTypes::read(std::string_view text, std::string_view path, Diagnostics& diagnostics) {
    for (const Block& block : parseStructured(text, path, diagnostics).blocks) {
        Type type;
        type.isText = equalsIgnoringCase(block.name, "TEXT");
        if (equalsIgnoringCase(block.name, "OPTION")) {
            type.options = splitOptions(block.value("OPTIONS"));
        }
        const std::string_view name = block.value("NAME");
        if (!name.empty()) {
            m_types.insert_or_assign(toUtf8(name), std::move(type));
        }
    }
}

std::string AttributeTypes::value(std::string_view name, std::string_view raw,
                                  std::span<const std::string> texts) const {
    if (raw.empty()) {
        return "yes";
    }
    const auto type = m_types.find(name);
    const auto index = parseInteger(raw);
    if (type == m_types.end() || !index || *index < 0) {
        return toUtf8(raw);
    }
    const std::span<const std::string> list = type->second.isText ? texts : type->second.options;
    const auto row = static_cast<std::size_t>(*index);
    return row < list.size() && !list[row].empty() ? list[row] : toUtf8(raw);
}

}  // namespace model::odb
