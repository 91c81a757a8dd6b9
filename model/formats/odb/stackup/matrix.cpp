#include "model/formats/odb/stackup/matrix.h"

#include <algorithm>
#include <array>
#include <utility>

#include "model/base/limits.h"
#include "model/board/local_stack.h"
#include "model/formats/odb/text/records.h"
#include "model/formats/odb/text/structured_text.h"

namespace model::odb {

namespace {

LayerType layerType(std::string_view name) {
    static constexpr std::array<std::pair<std::string_view, LayerType>, 13> kTypes = {{
        {"SIGNAL", LayerType::Signal},
        {"POWER_GROUND", LayerType::PowerGround},
        {"MIXED", LayerType::Mixed},
        {"DIELECTRIC", LayerType::Dielectric},
        {"SOLDER_MASK", LayerType::SolderMask},
        {"SOLDER_PASTE", LayerType::SolderPaste},
        {"SILK_SCREEN", LayerType::SilkScreen},
        {"DRILL", LayerType::Drill},
        {"ROUT", LayerType::Rout},
        {"COMPONENT", LayerType::Component},
        {"MASK", LayerType::Mask},
        {"CONDUCTIVE_PASTE", LayerType::ConductivePaste},
        {"DOCUMENT", LayerType::Document},
    }};
    const auto* const found =
        std::ranges::find_if(kTypes, [name](const auto& entry) { return equalsIgnoringCase(entry.first, name); });
    return found == kTypes.end() ? LayerType::Other : found->second;
}

/// A keyword in capitals; "None" is what some writers put for nothing.
std::string statedWord(std::string_view text) {
    std::string word = toUtf8(text);
    std::ranges::transform(word, word.begin(),
                           [](char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 32) : c; });
    return word == "NONE" ? "" : word;
}

LayerUse useOf(std::string_view name) {
    static constexpr std::pair<std::string_view, LayerUse> kUses[] = {
        {"SIGNAL_FLEX", LayerUse::Flex},    {"PG_FLEX", LayerUse::Flex},
        {"MIXED_FLEX", LayerUse::Flex},     {"COVERLAY", LayerUse::Coverlay},
        {"COVERCOAT", LayerUse::Coverlay},  {"PSA", LayerUse::Adhesive},
        {"BACKDRILL", LayerUse::Backdrill}, {"DUAL_DIAMETER", LayerUse::DualDiameter}};
    if (name.empty()) {
        return LayerUse::Plain;
    }
    if (name.find("STIFFENER") != std::string_view::npos) {
        return LayerUse::Stiffener;
    }
    const auto* const found = std::ranges::find(kUses, name, &std::pair<std::string_view, LayerUse>::first);
    return found == std::end(kUses) ? LayerUse::Other : found->second;
}

MatrixLayer layerOf(const Block& block, std::string_view path, Diagnostics& diagnostics) {
    MatrixLayer layer;
    layer.line = block.line;
    layer.row = parseInteger(block.value("ROW")).value_or(0);
    layer.name = toUtf8(block.value("NAME"));
    layer.context = equalsIgnoringCase(block.value("CONTEXT"), "MISC") ? LayerContext::Misc : LayerContext::Board;
    layer.type = layerType(block.value("TYPE"));
    layer.isNegative = equalsIgnoringCase(block.value("POLARITY"), "NEGATIVE");
    layer.startName = toUtf8(block.value("START_NAME"));
    layer.endName = toUtf8(block.value("END_NAME"));
    layer.useName = statedWord(block.value("ADD_TYPE"));
    layer.use = useOf(layer.useName);
    layer.form = statedWord(block.value("FORM"));
    layer.dielectricType = statedWord(block.value("DIELECTRIC_TYPE"));
    layer.dielectricName = toUtf8(block.value("DIELECTRIC_NAME"));
    for (const char* key : {"CU_TOP", "CU_BOTTOM"}) {
        if (!block.value(key).empty()) {
            diagnostics.report(Severity::Info, path, block.line,
                               std::string(key) + " is not used: thickness of copper comes from the copper layers");
        }
    }
    if (layer.type == LayerType::Other) {
        diagnostics.report(Severity::Warning, path, block.line, "layer " + layer.name + ": unknown layer type");
    }
    return layer;
}

/// Films, glue and plates of rigid-flex boards lie anywhere in the stackup; so do resistors and capacitors that are
/// embedded (masks and paste that conducts).
bool mayLieInside(const MatrixLayer& layer) {
    return layer.type == LayerType::Dielectric || layer.type == LayerType::Mask ||
           layer.type == LayerType::ConductivePaste || isLaidOn(layer.use);
}

/// Position in `order` behind which no copper belongs: the first surface layer (solder mask, solder paste, silk) that
/// follows copper.
std::size_t bottomSide(const std::vector<MatrixLayer>& layers, const std::vector<std::size_t>& order) {
    bool isBelowCopper = false;
    for (std::size_t i = 0; i < order.size(); ++i) {
        const MatrixLayer& layer = layers[order[i]];
        if (isBelowCopper && !layer.isCopper() && !mayLieInside(layer)) {
            return i;
        }
        isBelowCopper = isBelowCopper || layer.isCopper();
    }
    return order.size();
}

void raiseLateCopper(const std::vector<MatrixLayer>& layers, std::vector<std::size_t>& order, std::string_view path,
                     Diagnostics& diagnostics) {
    const std::size_t bottom = bottomSide(layers, order);
    std::size_t target = bottom;
    while (target > 0 && !layers[order[target - 1]].isCopper()) {
        --target;
    }
    target = target > 0 ? target - 1 : 0;  // above the bottom copper
    for (std::size_t i = bottom; i < order.size(); ++i) {
        if (layers[order[i]].isCopper()) {
            diagnostics.report(
                Severity::Warning, path, layers[order[i]].line,
                "layer " + layers[order[i]].name +
                    ": copper listed below the bottom side; taken as an inner layer above the bottom copper");
            std::rotate(order.begin() + static_cast<std::ptrdiff_t>(target),
                        order.begin() + static_cast<std::ptrdiff_t>(i),
                        order.begin() + static_cast<std::ptrdiff_t>(i) + 1);
            ++target;
        }
    }
}

/// Rows of context MISC are no part of the board: working copies of copper and drills in jobs of CAM systems. Where
/// there is a board, they are shown as drawings; a job that was never sorted has MISC rows only.
void setMiscAside(Matrix& matrix, std::string_view path, Diagnostics& diagnostics) {
    const auto isBoardCopper = [](const MatrixLayer& layer) {
        return layer.isCopper() && layer.context == LayerContext::Board;
    };
    if (std::ranges::none_of(matrix.layers, isBoardCopper)) {
        return;
    }
    std::string names;
    std::uint32_t line = 0;
    for (MatrixLayer& layer : matrix.layers) {
        if (layer.context == LayerContext::Misc && (layer.isCopper() || layer.isHoles())) {
            layer.type = LayerType::Document;
            layer.isNegative = false;
            line = names.empty() ? layer.line : line;
            names += (names.empty() ? "" : ", ") + layer.name;
        }
    }
    if (!names.empty()) {
        diagnostics.report(
            Severity::Info, path, line,
            "copper and drills of context MISC are no part of the board and shown as drawings: " + names);
    }
}

}  // namespace

std::size_t Matrix::rowOf(std::string_view name) const {
    const auto found =
        std::ranges::find_if(layers, [name](const MatrixLayer& layer) { return equalsIgnoringCase(layer.name, name); });
    return static_cast<std::size_t>(found - layers.begin());
}

bool isMarker(const MatrixLayer& layer) {
    static constexpr std::string_view kMarkers[] = {"BEND_AREA",      "FLEX_AREA", "RIGID_AREA",  "PLATING_MASK",
                                                    "IMMERSION_MASK", "OSP_MASK",  "WIRE_BONDING"};
    return layer.type == LayerType::Mask && std::ranges::find(kMarkers, layer.useName) != std::end(kMarkers);
}

bool isPhysical(const MatrixLayer& layer) {
    if (isMarker(layer)) {
        return false;
    }
    switch (layer.type) {
        case LayerType::Dielectric:
        case LayerType::SolderMask:
        case LayerType::SolderPaste:
        case LayerType::SilkScreen:
        case LayerType::ConductivePaste:
        case LayerType::Mask: return layer.context == LayerContext::Board;
        default: return layer.context == LayerContext::Board && layer.isCopper();
    }
}

Matrix parseMatrix(std::string_view text, std::string_view path, Diagnostics& diagnostics) {
    Matrix matrix;
    std::vector<std::pair<int, std::string>> steps;
    for (const Block& block : parseStructured(text, path, diagnostics).blocks) {
        if (equalsIgnoringCase(block.name, "STEP")) {
            steps.emplace_back(parseInteger(block.value("COL")).value_or(0), toUtf8(block.value("NAME")));
        } else if (equalsIgnoringCase(block.name, "LAYER") && matrix.layers.size() == base::kMostLayers) {
            diagnostics.report(
                Severity::Error, path, block.line,
                "the matrix has " + base::moreThan(base::kMostLayers, "layers") + "; the rest was left out");
        } else if (equalsIgnoringCase(block.name, "LAYER")) {
            matrix.layers.push_back(layerOf(block, path, diagnostics));
        } else {
            diagnostics.report(Severity::Info, path, block.line, "unknown kind of block; it was left out");
        }
    }
    std::ranges::stable_sort(steps, {}, &std::pair<int, std::string>::first);
    for (auto& [column, name] : steps) {
        matrix.steps.push_back(std::move(name));
    }
    std::ranges::stable_sort(matrix.layers, {}, &MatrixLayer::row);
    setMiscAside(matrix, path, diagnostics);
    return matrix;
}

std::vector<std::size_t> physicalOrder(const std::vector<MatrixLayer>& layers, std::string_view path,
                                       Diagnostics& diagnostics) {
    std::vector<std::size_t> order;
    std::vector<std::size_t> others;
    for (std::size_t i = 0; i < layers.size(); ++i) {
        (isPhysical(layers[i]) ? order : others).push_back(i);
    }
    raiseLateCopper(layers, order, path, diagnostics);
    order.insert(order.end(), others.begin(), others.end());
    return order;
}

}  // namespace model::odb
