#include "model/formats/gerber/naming/layer_pairs.h"

#include <algorithm>
#include <optional>

#include "model/formats/gerber/naming/file_role.h"
#include "model/formats/gerber/text/words.h"

namespace model::gerber {

bool LayerPair::namesPlanes() const {
    return std::ranges::any_of(endings, [](const std::string& ending) {
        const std::optional<FileRole> role = roleOfName("x." + ending);
        return role && role->isNegative;
    });
}

bool looksLikeLayerPairs(std::string_view head) {
    return head.find("DrillFile=") != std::string_view::npos && head.find("DrillLayers=") != std::string_view::npos;
}

std::vector<LayerPair> parseLayerPairs(std::string_view text) {
    std::vector<LayerPair> pairs;
    Lines lines(text);
    while (lines.next()) {
        LayerPair pair;
        for (const std::string_view field : split(trimmed(lines.line()), '|')) {
            if (field.starts_with("DrillFile=")) {
                const std::string_view path = field.substr(10);
                pair.drillFile = upperCase(path.substr(path.find_last_of("/\\") + 1));
            } else if (field.starts_with("DrillLayers=")) {
                for (const std::string_view ending : split(field.substr(12), ',')) {
                    pair.endings.push_back(upperCase(trimmed(ending)));
                }
            }
        }
        if (!pair.drillFile.empty() && pair.endings.size() > 1) {
            pairs.push_back(std::move(pair));
        }
    }
    return pairs;
}

}  // namespace model::gerber
