#include "model/formats/gerber/layer_map.h"

#include <algorithm>
#include <array>
#include <utility>

#include "model/formats/gerber/text/words.h"
#include "model/text/whole_file.h"

namespace model::gerber {

namespace {

using Kind = FileRole::Kind;

constexpr int kMostLayers = 999;

constexpr std::array kKinds = {
    std::pair{Kind::Copper, std::string_view("copper")},   std::pair{Kind::SolderMask, std::string_view("solder-mask")},
    std::pair{Kind::Paste, std::string_view("paste")},     std::pair{Kind::Legend, std::string_view("silkscreen")},
    std::pair{Kind::Profile, std::string_view("outline")}, std::pair{Kind::Drill, std::string_view("drill")},
    std::pair{Kind::Rout, std::string_view("rout")},       std::pair{Kind::Components, std::string_view("components")},
    std::pair{Kind::Glue, std::string_view("glue")},       std::pair{Kind::Document, std::string_view("document")},
    std::pair{Kind::Ignored, std::string_view("ignore")},
};

/// The first word, which is taken off; empty at the end.
std::string_view takeWord(std::string_view& words) {
    words = trimmed(words);
    const std::string_view word = words.substr(0, words.find_first_of(" \t"));
    words.remove_prefix(word.size());
    return word;
}

bool isDrilled(const FileRole& role) {
    return role.kind == Kind::Drill || role.kind == Kind::Rout;
}

/// "top", "non-plated", "negative".
bool takeProperty(std::string_view word, FileRole& role) {
    const auto is = [&](std::string_view other) { return equalsIgnoringCase(word, other); };
    if (is("top") || is("bottom") || is("inner")) {
        role.side = is("top") ? LayerSide::Top : is("bottom") ? LayerSide::Bottom : LayerSide::Inner;
    } else if (is("plated") || is("non-plated")) {
        role.plating = is("plated") ? Plating::Plated : Plating::NonPlated;
    } else if (is("negative")) {
        role.isNegative = true;
    } else {
        return false;
    }
    return true;
}

std::optional<int> layerNumber(std::string_view word) {
    const std::optional<int> number = parseInteger(word);
    return number && *number >= 1 && *number <= kMostLayers ? number : std::nullopt;
}

/// "3", "1-4".
bool takeNumber(std::string_view word, FileRole& role) {
    const std::size_t dash = word.find('-');
    const std::optional<int> first = layerNumber(word.substr(0, dash));
    const std::optional<int> last = dash == std::string_view::npos ? first : layerNumber(word.substr(dash + 1));
    if (!first || !last) {
        return false;
    }
    if (dash == std::string_view::npos) {
        role.order = *first;
        role.isCountedFromTop = true;
    } else {
        role.spanTop = std::min(*first, *last);
        role.spanBottom = std::max(*first, *last);
    }
    return true;
}

/// Words that fit the kind, with what follows from others.
std::optional<FileRole> settled(FileRole role) {
    const bool isCopper = role.kind == Kind::Copper;
    const bool isFit = role.isKnown() && (isCopper || (role.order == 0 && !role.isNegative)) &&
                       (isDrilled(role) || (role.spanTop == 0 && role.plating == Plating::NotSaid));
    if (!isFit) {
        return std::nullopt;
    }
    if (isCopper && role.side == LayerSide::None) {
        role.side = role.order == 1 ? LayerSide::Top : LayerSide::Inner;
    }
    if (isDrilled(role)) {
        role.side = LayerSide::Through;
    }
    return role;
}

bool needsQuotes(std::string_view name) {
    return name.empty() || name[0] == '#' || name[0] == '"' || trimmed(name).size() != name.size();
}

std::string_view withoutQuotes(std::string_view name) {
    const bool isQuoted = name.size() > 1 && name.front() == '"' && name.back() == '"';
    return isQuoted ? name.substr(1, name.size() - 2) : name;
}

}  // namespace

void LayerMap::set(std::string file, FileRole role, std::uint32_t line) {
    role.source = RoleSource::Told;
    const auto found = std::ranges::find_if(m_rows, [&](const Row& r) { return equalsIgnoringCase(r.file, file); });
    if (found != m_rows.end()) {
        *found = {std::move(file), role, line};
    } else {
        m_rows.push_back({std::move(file), role, line});
    }
}

const LayerMap::Row* LayerMap::find(std::string_view path) const {
    const std::string_view name = path.substr(path.find_last_of('/') + 1);
    for (const std::string_view wanted : {path, name}) {
        const auto found =
            std::ranges::find_if(m_rows, [&](const Row& row) { return equalsIgnoringCase(row.file, wanted); });
        if (found != m_rows.end()) {
            return &*found;
        }
    }
    return nullptr;
}

std::optional<FileRole> roleOfWords(std::string_view words) {
    FileRole role;
    role.source = RoleSource::Told;
    for (std::string_view word = takeWord(words); !word.empty(); word = takeWord(words)) {
        const auto kind =
            std::ranges::find_if(kKinds, [&](const auto& known) { return equalsIgnoringCase(known.second, word); });
        if (kind != kKinds.end() && !role.isKnown()) {
            role.kind = kind->first;
        } else if (!takeProperty(word, role) && !takeNumber(word, role)) {
            return std::nullopt;
        }
    }
    return settled(role);
}

std::string wordsOf(const FileRole& role) {
    const auto kind = std::ranges::find(kKinds, role.kind, [](const auto& known) { return known.first; });
    std::string words(kind == kKinds.end() ? "document" : kind->second);
    const bool isSided = !isDrilled(role) && role.kind != Kind::Ignored && role.kind != Kind::Profile;
    words += !isSided                         ? ""
             : role.side == LayerSide::Top    ? " top"
             : role.side == LayerSide::Bottom ? " bottom"
             : role.side == LayerSide::Inner  ? " inner"
                                              : "";
    if (role.kind == Kind::Copper) {
        words += role.order > 0 ? " " + std::to_string(role.order) : "";
        words += role.isNegative ? " negative" : "";
    }
    if (isDrilled(role)) {
        words += role.plating == Plating::NonPlated                                ? " non-plated"
                 : role.plating == Plating::Plated || role.plating == Plating::Via ? " plated"
                                                                                   : "";
        words += role.spanTop > 0 ? " " + std::to_string(role.spanTop) + "-" + std::to_string(role.spanBottom) : "";
    }
    return words;
}

LayerMap parseLayerMap(std::string_view text, std::string_view path, Diagnostics& diagnostics) {
    LayerMap map;
    Lines lines(text);
    while (lines.next()) {
        const std::string_view line = trimmed(lines.line());
        if (line.empty() || line[0] == '#') {
            continue;
        }
        const std::size_t sign = line.rfind('=');
        const std::string_view name = withoutQuotes(trimmed(line.substr(0, sign)));
        const std::optional<FileRole> role =
            sign == std::string_view::npos || name.empty() ? std::nullopt : roleOfWords(line.substr(sign + 1));
        if (role) {
            map.set(std::string(name), *role, lines.number());
        } else {
            diagnostics.report(Severity::Warning, path, lines.number(),
                               "this row of the layer map cannot be understood; it should be as \"top.gbr = copper "
                               "top\"");
        }
    }
    return map;
}

std::string layerMapText(const LayerMap& map) {
    std::string text = "# What the files of a Gerber job draw, for copperscope --layer-map.\n";
    for (const LayerMap::Row& row : map.rows()) {
        text += layerMapRow(row);
    }
    return text;
}

std::string layerMapRow(const LayerMap::Row& row) {
    const std::string quote = needsQuotes(row.file) ? "\"" : "";
    return quote + row.file + quote + " = " + wordsOf(row.role) + "\n";
}

base::Result<LayerMap> readLayerMap(const std::filesystem::path& path, Diagnostics& diagnostics) {
    ASSIGN_OR_RETURN(const std::string text, readWholeFile(path, base::kMostSettingBytes));
    LayerMap map = parseLayerMap(text, path.filename().string(), diagnostics);
    if (map.isEmpty()) {
        return base::Error{base::ErrorCode::BadInput,
                           path.string() + ": this is no layer map; its rows are as \"top.gbr = copper top\""};
    }
    return map;
}

base::Status writeLayerMap(const std::filesystem::path& path, const LayerMap& map) {
    return writeWholeFile(path, layerMapText(map));
}

std::filesystem::path layerMapBeside(const std::filesystem::path& job) {
    // "job/" is the folder job, as for sessions.
    std::filesystem::path path = job.has_filename() ? job : job.parent_path();
    path += ".layers.txt";
    return path;
}

}  // namespace model::gerber
