#include "model/board/holes.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <map>
#include <string_view>
#include <tuple>
#include <utility>

#include "model/geometry/path_length.h"

namespace model {

namespace {

constexpr Nm kSizeTolerance = 1'000;

/// Of what no drill makes the tolerance would be more than the size.
bool isNear(Nm a, Nm b) {
    return a > 0 && std::abs(std::int64_t{a} - b) <= std::min(kSizeTolerance, b / 10);
}

/// By how much the nearer one of the tool's sizes differs.
std::int64_t differenceOf(const DrillTool& tool, Nm size) {
    const auto from = [size](Nm known) {
        return known > 0 ? std::abs(std::int64_t{known} - size) : std::numeric_limits<std::int64_t>::max();
    };
    return std::min(from(tool.finishedSize), from(tool.drillSize));
}

bool isLaser(const DrillTool* tool) {
    return tool != nullptr && (tool->process == "LASER" || tool->process == "PHOTO");
}

bool isOuter(const Document& document, LayerId layer) {
    const LayerSide side = document.layer(layer).side;
    return side == LayerSide::Top || side == LayerSide::Bottom;
}

bool isCopperBetween(const Document& document, LayerId top, LayerId bottom) {
    for (std::size_t row = top.row() + 1; row < bottom.row(); ++row) {
        if (document.layers[row].isBoardCopper()) {
            return true;
        }
    }
    return false;
}

bool isOnlyCopper(const Document& document, LayerId layer) {
    const auto isOther = [&](const Layer& other) { return other.isBoardCopper() && &other != &document.layer(layer); };
    return std::ranges::none_of(document.layers, isOther);
}

/// By the layer alone.
HoleSpan layerSpan(const Document& document, const Layer& layer) {
    if (layer.use == LayerUse::Backdrill) {
        return HoleSpan::Backdrill;
    }
    if (!layer.spanTop.isValid() || !layer.spanBottom.isValid()) {
        return HoleSpan::Through;
    }
    const bool isTop = document.layer(layer.spanTop).side == LayerSide::Top;
    const bool isBottom = document.layer(layer.spanBottom).side == LayerSide::Bottom;
    const bool isSingle = layer.spanTop == layer.spanBottom && layer.use != LayerUse::DualDiameter &&
                          (isTop || isOnlyCopper(document, layer.spanTop));
    if ((isTop && isBottom) || isSingle) {
        return HoleSpan::Through;
    }
    return isOuter(document, layer.spanTop) || isOuter(document, layer.spanBottom) ? HoleSpan::Blind : HoleSpan::Buried;
}

bool isMicro(const Document& document, const Layer& layer, const DrillRow& hole) {
    const bool isNarrow = hasDrilledSize(hole) && hole.diameter <= kMostMicrovia;
    return (isLaser(hole.tool) || isNarrow || hole.isCalledMicrovia) &&
           !isCopperBetween(document, layer.spanTop, layer.spanBottom);
}

/// Ends are whole nanometres: slots that are alike differ by a few.
Nm toStep(double length) {
    constexpr double kStep = 100.0;
    return static_cast<Nm>(std::lround(length / kStep) * std::lround(kStep));
}

/// The shorter side of the box around an area.
Nm areaWidth(const Document& document, std::size_t hole) {
    const Box box = document.boxOf(ElementId{hole});
    return toStep(static_cast<double>(std::min(box.width(), box.height())));
}

/// Of a track that a hole is, with its round ends, or the longer side of the box around an area.
Nm lengthOf(const Document& document, ElementId hole) {
    const std::uint32_t row = document.elements.geometry[hole.row()];
    double length = 0.0;
    switch (document.elements.kind[hole.row()]) {
        case ElementKind::Circle: break;
        case ElementKind::Line: {
            const LineGeometry& line = document.lines[row];
            length = pathLength({line.a, {}, EdgeKind::Line}, line.b) + line.width;
            break;
        }
        case ElementKind::Arc: {
            const ArcGeometry& arc = document.arcs[row];
            length = pathLength(arc.node, arc.end) + arc.width;
            break;
        }
        case ElementKind::Trail: {
            const std::span<const PathNode> nodes = document.nodesOf(document.trails[row]);
            length = document.trails[row].width;
            for (std::size_t i = 0; i + 1 < nodes.size(); ++i) {
                length += pathLength(nodes[i], nodes[i + 1].point);
            }
            break;
        }
        case ElementKind::Area: {
            const Box box = document.boxOf(hole);
            length = static_cast<double>(std::max(box.width(), box.height()));
            break;
        }
    }
    return toStep(length);
}

bool isCalledMicrovia(const Document& document, ElementId hole) {
    const auto isMicro = [](const auto& attribute) {
        return attribute.first == kViaType && attribute.second == kMicroviaType;
    };
    return std::ranges::any_of(document.attributesOf(hole), isMicro);
}

/// Shape and sizes of one hole.
DrillRow measured(const Document& document, std::size_t element) {
    const std::uint32_t row = document.elements.geometry[element];
    DrillRow out;
    const auto set = [&out](const char* shape, Nm diameter, Nm open) {
        out.shape = shape;
        out.diameter = diameter;
        out.open = open;
    };
    switch (document.elements.kind[element]) {
        case ElementKind::Circle:
            set("round", document.circles[row].diameter, document.circles[row].innerDiameter);
            break;
        case ElementKind::Line: set("slot", document.lines[row].width, document.lines[row].innerWidth); break;
        case ElementKind::Arc: set("slot", document.arcs[row].width, document.arcs[row].innerWidth); break;
        case ElementKind::Trail: set("path", document.trails[row].width, document.trails[row].innerWidth); break;
        case ElementKind::Area: set("area", areaWidth(document, element), 0); break;
    }
    out.length = lengthOf(document, ElementId{element});
    out.layer = document.elements.layer[element];
    out.kind = holeKind(document.elements.flags[element]);
    out.isCalledMicrovia = isCalledMicrovia(document, ElementId{element});
    return out;
}

/// Holes of one key are one row.
using Key = std::tuple<LayerId, HoleKind, std::string_view, Nm, Nm, Nm, bool>;

Key keyOf(const DrillRow& hole) {
    return {hole.layer, hole.kind, hole.shape, hole.diameter, hole.open, hole.length, hole.isCalledMicrovia};
}

std::vector<DrillTool const*> toolsOf(const Document& document, LayerId layer) {
    std::vector<const DrillTool*> tools;
    for (const DrillTool& tool : document.tools) {
        if (tool.layer == layer) {
            tools.push_back(&tool);
        }
    }
    return tools;
}

bool hasBothSizes(const DrillTool& tool, const DrillRow& hole) {
    return tool.drillSize == hole.diameter && tool.finishedSize == hole.open;
}

/// Of the tools that fit, the one of the same plating counts first: plated and non-plated holes of one size have two.
/// Then both sizes, which the reader takes from the tool where it knows them, then how near its size is, then whether
/// it is for vias. The greater one fits better.
using Rank = std::tuple<bool, bool, std::int64_t, bool>;

Rank rankOf(const DrillTool& tool, const DrillRow& hole) {
    const bool isPlated = hole.kind != HoleKind::NonPlated;
    const bool isSamePlating = model::isPlated(tool.plating) == isPlated;
    const bool isSameUse = (tool.plating == Plating::Via) == (hole.kind == HoleKind::Via);
    return {isSamePlating, hasBothSizes(tool, hole), -differenceOf(tool, hole.diameter), isSamePlating && isSameUse};
}

/// Of tools that fit alike the first one is the tool.
void setTool(const std::vector<const DrillTool*>& tools, DrillRow& hole) {
    Rank best;
    for (const DrillTool* tool : tools) {
        if (!hasDrilledSize(hole) || !fits(*tool, hole.diameter)) {
            continue;
        }
        const Rank rank = rankOf(*tool, hole);
        if (hole.tool == nullptr || rank > best) {
            best = rank;
            hole.tool = tool;
            hole.otherTools.clear();
        } else if (rank == best && tool->number != hole.tool->number) {
            hole.otherTools.push_back(tool->number);
        }
    }
    const auto saysPlating = [&hole](const DrillTool* tool) { return hasBothSizes(*tool, hole); };
    hole.isOpenAssumed =
        hole.kind != HoleKind::NonPlated && hasDrilledSize(hole) && std::ranges::none_of(tools, saysPlating);
}

int toolNumberOf(const DrillRow& row) {
    return row.tool != nullptr ? row.tool->number : -1;
}

/// Are rows of two steps, or of one, the same to a fabricator?
bool areAlike(const DrillRow& a, const DrillRow& b) {
    return keyOf(a) == keyOf(b) && a.span == b.span && toolNumberOf(a) == toolNumberOf(b) &&
           a.otherTools == b.otherTools;
}

/// A row of a step's own table, as a copy of it is drilled.
DrillRow ofCopy(const Document& step, DrillRow row, bool isFlipped) {
    row.layer = step.layerOfCopy(row.layer, isFlipped);
    return row;
}

/// Those that a row of the step's own table counts, as elements of a copy.
void addHoles(const Document& step, const DrillRow& row, std::uint32_t copy, std::vector<BoardElement>& holes) {
    const Range elements = step.layer(row.layer).elements;
    for (std::uint32_t e = elements.first; e < elements.first + elements.count; ++e) {
        if ((step.elements.flags[e] & kHole) != 0 && keyOf(measured(step, e)) == keyOf(row)) {
            holes.push_back({copy, ElementId{e}});
        }
    }
}

/// How often a step is on the board.
struct Placed {
    std::uint32_t upright = 0;
    std::uint32_t flipped = 0;
};

void addRow(std::vector<DrillRow>& rows, DrillRow row, std::uint32_t times) {
    row.count *= times;
    const auto same = std::ranges::find_if(rows, [&](const DrillRow& other) { return areAlike(other, row); });
    if (same != rows.end()) {
        same->count += row.count;
    } else if (times > 0) {
        rows.push_back(row);
    }
}

/// Of holes like this one, whose tool is set.
HoleSpan spanOf(const Document& document, const Layer& layer, const DrillRow& hole) {
    const HoleSpan span = layerSpan(document, layer);
    const bool isPart = span == HoleSpan::Blind || span == HoleSpan::Buried;
    return isPart && isMicro(document, layer, hole) ? HoleSpan::Micro : span;
}

}  // namespace

const char* toString(HoleSpan span) {
    constexpr const char* kNames[] = {"through", "blind", "buried", "micro", "backdrill"};
    return kNames[static_cast<std::size_t>(span)];
}

bool hasDrilledSize(const DrillRow& row) {
    return row.diameter > 0 && row.shape != std::string_view("area");
}

std::string toolsText(const DrillRow& row) {
    constexpr std::size_t kMostRuns = 3;
    std::vector<int> numbers = row.otherTools;
    if (row.tool != nullptr) {
        numbers.push_back(row.tool->number);
    }
    std::ranges::sort(numbers);
    std::string text;
    std::size_t runs = 0;
    for (std::size_t first = 0; first < numbers.size(); ++runs) {
        text += runs == 0 ? "" : ", ";
        if (runs == kMostRuns) {
            return text + "…";
        }
        std::size_t last = first;
        while (last + 1 < numbers.size() && numbers[last + 1] <= numbers[last] + 1) {
            ++last;
        }
        text += std::to_string(numbers[first]);
        if (last > first) {
            text += (last == first + 1 ? ", " : "-") + std::to_string(numbers[last]);
        }
        first = last + 1;
    }
    return text;
}

bool fits(const DrillTool& tool, Nm size) {
    return isNear(tool.finishedSize, size) || isNear(tool.drillSize, size);
}

const DrillTool* findTool(std::span<const DrillTool> tools, Nm size, bool isPlated) {
    const auto rankOf = [&](const DrillTool& tool) {
        return std::tuple(model::isPlated(tool.plating) == isPlated, isNear(tool.finishedSize, size),
                          -differenceOf(tool, size));
    };
    const DrillTool* best = nullptr;
    for (const DrillTool& tool : tools) {
        if (fits(tool, size) && (best == nullptr || rankOf(tool) > rankOf(*best))) {
            best = &tool;
        }
    }
    return best;
}

std::vector<DrillRow> drillTable(const Document& document) {
    std::vector<DrillRow> rows;
    for (std::size_t i = 0; i < document.layers.size(); ++i) {
        const Layer& layer = document.layers[i];
        const std::vector<const DrillTool*> tools = toolsOf(document, LayerId{i});
        std::map<Key, DrillRow> counted;
        for (std::uint32_t e = layer.elements.first; e < layer.elements.first + layer.elements.count; ++e) {
            if ((document.elements.flags[e] & kHole) != 0) {
                const DrillRow hole = measured(document, e);
                ++counted.try_emplace(keyOf(hole), hole).first->second.count;
            }
        }
        for (auto& [key, row] : counted) {
            setTool(tools, row);
            row.span = spanOf(document, layer, row);
            rows.push_back(row);
        }
    }
    return rows;
}

std::vector<DrillRow> drillTableWithCopies(const Document& board) {
    const StepTree tree = unfoldCopies(board);
    std::vector<Placed> placed(tree.steps.size());
    for (const StepCopy& copy : tree.copies) {
        ++(copy.isFlipped ? placed[copy.step].flipped : placed[copy.step].upright);
    }
    std::vector<DrillRow> rows;
    for (std::size_t step = 0; step < placed.size(); ++step) {
        for (const DrillRow& row : drillTable(*tree.steps[step])) {
            addRow(rows, row, placed[step].upright);
            addRow(rows, ofCopy(*tree.steps[step], row, true), placed[step].flipped);
        }
    }
    std::ranges::stable_sort(rows, {}, [](const DrillRow& row) { return std::pair(keyOf(row), toolNumberOf(row)); });
    return rows;
}

DrillRow drillRowOf(const Document& document, ElementId hole) {
    DrillRow row = measured(document, hole.row());
    setTool(toolsOf(document, row.layer), row);
    row.span = spanOf(document, document.layer(row.layer), row);
    row.count = 1;
    return row;
}

HoleSpan spanOf(const Document& document, ElementId hole) {
    return drillRowOf(document, hole).span;
}

std::vector<bool> microviasOf(const Document& document) {
    std::vector<bool> isMicrovia(document.elements.size());
    for (std::size_t i = 0; i < document.layers.size(); ++i) {
        const Layer& layer = document.layers[i];
        const std::vector<const DrillTool*> tools = toolsOf(document, LayerId{i});
        for (std::uint32_t e = layer.elements.first; e < layer.elements.first + layer.elements.count; ++e) {
            if (isPlatedHole(document.elements.flags[e])) {
                DrillRow hole = measured(document, e);
                setTool(tools, hole);
                isMicrovia[e] = spanOf(document, layer, hole) == HoleSpan::Micro;
            }
        }
    }
    return isMicrovia;
}

std::vector<BoardElement> holesOf(const Document& board, std::span<const DrillRow> rows) {
    const StepTree tree = unfoldCopies(board);
    std::vector<std::vector<DrillRow>> tables;
    for (const Document* step : tree.steps) {
        tables.push_back(drillTable(*step));
    }
    std::vector<BoardElement> holes;
    for (std::uint32_t i = 0; i < tree.copies.size(); ++i) {
        const StepCopy& copy = tree.copies[i];
        const Document& step = *tree.steps[copy.step];
        for (const DrillRow& own : tables[copy.step]) {
            const DrillRow drilled = ofCopy(step, own, copy.isFlipped);
            if (std::ranges::any_of(rows, [&](const DrillRow& row) { return areAlike(drilled, row); })) {
                addHoles(step, own, i, holes);
            }
        }
    }
    std::ranges::sort(holes);
    return holes;
}

}  // namespace model
