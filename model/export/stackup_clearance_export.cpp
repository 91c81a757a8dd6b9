#include "model/export/stackup_clearance_export.h"

#include <array>
#include <map>

#include "model/base/units.h"
#include "model/export/side_json.h"
#include "model/text/formatting.h"
#include "model/text/json_text.h"

namespace model {

using nlohmann::ordered_json;

namespace {

double micrometres(double nm) {
    return nm / base::kNmPerUm;
}

/// Both sides of a distance in words.
class Names {
public:
    explicit Names(const Document& board) : m_board(board), m_tree(unfoldCopies(board)) {}

    [[nodiscard]] Side of(const BoardElement& at) {
        const std::uint32_t step = m_tree.copies[at.copy].step;
        return m_names.try_emplace(step, *m_tree.steps[step]).first->second.of(at.element);
    }
    /// "pcb 2: " on panels.
    [[nodiscard]] std::string copyOf(const BoardElement& at) const {
        return m_tree.copies.size() == 1
                   ? ""
                   : m_tree.steps[m_tree.copies[at.copy].step]->job.step + ' ' + std::to_string(at.copy) + ": ";
    }
    [[nodiscard]] const std::string& layer(LayerId id) const { return m_board.layer(id).name; }

private:
    const Document& m_board;
    StepTree m_tree;
    std::map<std::uint32_t, SideNames> m_names;  ///< by step
};

std::string textOf(Names& names, const StackupClearance& c) {
    return formatted("%10.3f %10.3f %10.3f  %11.4f %11.4f  ", micrometres(c.spacing.distance), micrometres(c.planar),
                     micrometres(c.height), base::toMm(c.spacing.from.x), base::toMm(c.spacing.from.y)) +
           names.copyOf(c.a) + textOf(names.of(c.a)) + " on " + names.layer(c.layerA) + "  |  " + names.copyOf(c.b) +
           textOf(names.of(c.b)) + " on " + names.layer(c.layerB) + '\n';
}

std::string csvOf(Names& names, const StackupClearance& c) {
    std::string row = formatted("%.3f,%.3f,%.3f,%.6f,%.6f,%.6f,%.6f", micrometres(c.spacing.distance),
                                micrometres(c.planar), micrometres(c.height), base::toMm(c.spacing.from.x),
                                base::toMm(c.spacing.from.y), base::toMm(c.spacing.to.x), base::toMm(c.spacing.to.y));
    for (const auto& [at, layer] : {std::pair(c.a, c.layerA), std::pair(c.b, c.layerB)}) {
        const Side side = names.of(at);
        row += ',' + csvField(names.layer(layer)) + ',' + std::to_string(at.copy) + ',' + csvField(side.net) + ',' +
               csvField(side.pin) + ',' + csvField(side.kind) + ',' + std::to_string(at.element.value);
    }
    return row + '\n';
}

ordered_json jsonOf(Names& names, const StackupClearance& c) {
    const Side a = names.of(c.a);
    const Side b = names.of(c.b);
    return {{"distance_um", micrometres(c.spacing.distance)},
            {"planar_um", micrometres(c.planar)},
            {"height_um", micrometres(c.height)},
            {"layers", {names.layer(c.layerA), names.layer(c.layerB)}},
            {"nets", {a.net, b.net}},
            {"copies", {c.a.copy, c.b.copy}},
            {"sides", {sideJson(a), sideJson(b)}},
            {"from_mm", {base::toMm(c.spacing.from.x), base::toMm(c.spacing.from.y)}},
            {"to_mm", {base::toMm(c.spacing.to.x), base::toMm(c.spacing.to.y)}}};
}

}  // namespace

std::string stackupClearanceReport(const Document& board, std::span<const StackupClearance> clearances,
                                   ReportFormat format) {
    Names names(board);
    if (format == ReportFormat::Json) {
        ordered_json list = ordered_json::array();
        for (const StackupClearance& c : clearances) {
            list.push_back(jsonOf(names, c));
        }
        return jsonText({{"through_stackup", list}});
    }
    const bool isText = format == ReportFormat::Text;
    std::string text = isText ? formatted("%10s %10s %10s  %11s %11s  %s\n", "dist. um", "planar um", "height um",
                                          "x mm", "y mm", "one side  |  other side")
                              : "distance um,planar um,height um,x mm on a,y mm on a,x mm on b,y mm on b,layer a,copy "
                                "a,net a,pin a,kind a,element a,layer b,copy b,net b,pin b,kind b,element b\n";
    for (const StackupClearance& c : clearances) {
        text += isText ? textOf(names, c) : csvOf(names, c);
    }
    return text;
}

}  // namespace model
