#include "model/formats/ipc2581/layer_list.h"

#include <algorithm>
#include <array>
#include <iterator>

#include "model/formats/ipc2581/xml/xml_values.h"
#include "model/geometry/loops/region_booleans.h"
#include "model/geometry/outlines.h"
#include "model/geometry/region.h"

namespace model::ipc2581 {

namespace {

using formats::DrawnLayer;
using formats::kNoRow;

struct Function {
    std::string_view name;
    LayerType type;
    LayerUse use = LayerUse::Plain;
};

/// Those not listed are shown as drawings.
constexpr Function kFunctions[] = {
    {"CONDUCTOR", LayerType::Signal},
    {"SIGNAL", LayerType::Signal},
    {"CONDFILM", LayerType::Signal},
    {"CONDFOIL", LayerType::Signal},
    {"PLANE", LayerType::PowerGround},
    {"MIXED", LayerType::Mixed},
    {"DIELBASE", LayerType::Dielectric},
    {"DIELCORE", LayerType::Dielectric},
    {"DIELPREG", LayerType::Dielectric},
    {"DIELBONDPLY", LayerType::Dielectric},
    {"DIELADHV", LayerType::Dielectric},
    {"DIELCOVERLAY", LayerType::Dielectric},
    {"SOLDERMASK", LayerType::SolderMask},
    {"SOLDERPASTE", LayerType::SolderPaste},
    {"PASTEMASK", LayerType::SolderPaste},
    {"SILKSCREEN", LayerType::SilkScreen},
    {"LEGEND", LayerType::SilkScreen},
    {"CONDUCTIVE_ADHESIVE", LayerType::ConductivePaste},
    {"COATINGCOND", LayerType::Mask, LayerUse::Other},
    {"COATINGNONCOND", LayerType::Mask, LayerUse::Other},
    {"STIFFENER", LayerType::Mask, LayerUse::Stiffener},
    {"DRILL", LayerType::Drill},
    {"ROUT", LayerType::Rout},
    {"COMPONENT", LayerType::Component},
    {"COMPONENT_TOP", LayerType::Component},
    {"COMPONENT_BOTTOM", LayerType::Component},
};

/// What is on these says nothing of the board that its drawing does not show.
constexpr std::string_view kDrawings[] = {"ASSEMBLY", "BOARDFAB", "BOARD_OUTLINE", "COURTYARD",          "DOCUMENT",
                                          "FIXTURE",  "GLUE",     "GRAPHIC",       "LANDPATTERN",        "OTHER",
                                          "PIN",      "PROBE",    "REWORK",        "THIEVING_KEEP_INOUT"};
/// These would make or change something of the board.
constexpr std::string_view kNotMade[] = {
    "CAPACITIVE", "COMPONENT_EMBEDDED", "COMPONENT_FORMED", "EDGE_CHAMFER",      "EDGE_PLATING",
    "HOLEFILL",   "RESISTIVE",          "SOLDERBUMP",       "STACKUP_COMPOSITE", "V_CUT"};

/// Of two outlines at once; they may overlap. `isExact` stays as it is unless arcs become chords.
ShapeSketch united(const ShapeSketch& a, const ShapeSketch& b, bool& isExact) {
    if (b.isEmpty() || !boxOf(a).meets(boxOf(b))) {
        ShapeSketch both = a;
        both.append(b, {});
        return both;
    }
    std::vector<EdgeLoops> all = regionsOf(a);
    std::ranges::move(regionsOf(b), std::back_inserter(all));
    const RegionBoolean whole = unionOf(all);
    isExact = isExact && whole.isExact;
    return sketchOf(whole.regions);
}

LayerSide sideNamed(std::string_view side) {
    if (side == "TOP") {
        return LayerSide::Top;
    }
    if (side == "BOTTOM") {
        return LayerSide::Bottom;
    }
    return side == "INTERNAL" ? LayerSide::Inner : LayerSide::None;
}

/// How far outside a surface layer lies.
int shellOf(LayerType type) {
    switch (type) {
        case LayerType::SilkScreen: return 3;
        case LayerType::SolderPaste:
        case LayerType::ConductivePaste: return 2;
        default: return 1;
    }
}

}  // namespace

bool SourceLayer::isSurface() const {
    switch (drawn.type) {
        case LayerType::SolderMask:
        case LayerType::SolderPaste:
        case LayerType::SilkScreen:
        case LayerType::ConductivePaste:
        case LayerType::Mask: return true;
        default: return false;
    }
}

LayerList::LayerList(Reading& reading, const Specs& specs, ShapeReader& shapes) : m_reading(reading) {
    for (const XmlSection& section : reading.outline().sections) {
        if (section.name == "Layer") {
            XmlCursor at = reading.at(section);
            at.next();
            read(at, specs, shapes);
        }
    }
}

void LayerList::read(XmlCursor& at, const Specs& specs, ShapeReader& shapes) {
    SourceLayer layer;
    const std::string_view name = at.value("name");
    layer.line = at.line();
    layer.function = at.value("layerFunction");
    layer.drawn.name = textOf(name);
    layer.drawn.file = m_reading.path();
    layer.drawn.side = sideNamed(at.value("side"));
    layer.drawn.isNegative = at.value("polarity") == "NEGATIVE";
    setFunction(layer);
    forEachChild(at, [&] {
        if (at.name() == "Span") {
            layer.from = at.value("fromLayer");
            layer.to = at.value("toLayer");
        } else if (at.name() == "Profile") {
            const ShapeSketch outline = shapes.sketch(at, {}, m_reading.unitNm());
            bool isExact = true;
            layer.drawn.outline =
                layer.drawn.outline.isEmpty() ? outline : united(layer.drawn.outline, outline, isExact);
            if (!isExact) {
                m_reading.report(Severity::Warning, at.line(),
                                 "outlines of a layer that meet cannot be united exactly; they are united with "
                                 "straight edges within 1 µm");
            }
        } else if (at.name() == "SpecRef") {
            const Spec* const spec = specs.find(at);
            if (spec != nullptr && spec->isBackdrill && layer.isHoles()) {
                layer.drawn.use = LayerUse::Backdrill;
            } else if (spec != nullptr) {
                Specs::describe(*spec, layer.isCopper(), layer.drawn.facts.material);
            }
        } else {
            m_reading.reportUnknown(at);
        }
    });
    if (!m_rows.try_emplace(name, m_layers.size()).second) {
        return m_reading.report(Severity::Warning, layer.line, "two layers have one name; the first one is used");
    }
    m_layers.push_back(std::move(layer));
}

void LayerList::setFunction(SourceLayer& layer) {
    const auto* const function = std::ranges::find(kFunctions, layer.function, &Function::name);
    const bool isDrawing = function == std::end(kFunctions);
    layer.drawn.type = isDrawing ? LayerType::Document : function->type;
    layer.drawn.use = isDrawing ? LayerUse::Plain : function->use;
    layer.drawn.useName = layer.drawn.use == LayerUse::Plain ? "" : textOf(layer.function);
    layer.drawn.context = isDrawing ? LayerContext::Misc : LayerContext::Board;
    if (std::ranges::find(kNotMade, layer.function) != std::end(kNotMade)) {
        m_reading.report(Severity::Warning, layer.line,
                         "layers of function " + std::string(layer.function) +
                             " are shown as drawings; what they make of the board is not shown");
    } else if (isDrawing && std::ranges::find(kDrawings, layer.function) == std::end(kDrawings)) {
        m_reading.report(Severity::Warning, layer.line,
                         "a layer has no function that is known; it is taken for a drawing");
    }
}

int LayerList::find(std::string_view name) const {
    const auto found = m_rows.find(name);
    return found == m_rows.end() ? -1 : static_cast<int>(found->second);
}

std::size_t LayerList::findOrAdd(std::string_view name, LayerType type, std::uint32_t line) {
    const auto [found, isNew] = m_rows.try_emplace(name, m_layers.size());
    if (isNew) {
        SourceLayer layer;
        layer.drawn.name = textOf(name);
        layer.drawn.file = m_reading.path();
        layer.drawn.type = type;
        layer.drawn.context = type == LayerType::Document ? LayerContext::Misc : LayerContext::Board;
        layer.line = line;
        m_layers.push_back(std::move(layer));
    }
    return found->second;
}

std::size_t LayerList::holesLayer(std::string_view from, std::string_view to, std::uint32_t line) {
    for (std::size_t row = 0; row < m_layers.size(); ++row) {
        const SourceLayer& layer = m_layers[row];
        const bool isSame = (layer.from == from && layer.to == to) || (layer.from == to && layer.to == from);
        if (layer.drawn.type == LayerType::Drill && isSame && layer.drawn.use == LayerUse::Plain) {
            return row;
        }
    }
    SourceLayer layer;
    layer.drawn.name = from.empty() ? "Drill" : "Drill " + textOf(from) + " - " + textOf(to);
    layer.drawn.file = m_reading.path();
    layer.drawn.type = LayerType::Drill;
    layer.from = from;
    layer.to = to;
    layer.line = line;
    m_layers.push_back(std::move(layer));
    m_reading.report(Severity::Info, line,
                     "holes with a span that no drill layer has are on drill layers of their own");
    return m_layers.size() - 1;
}

namespace {

/// Sorts and links what LayerList holds.
class LayerOrder {
public:
    LayerOrder(Reading& reading, LayerList& layers, const std::vector<std::size_t>& stack)
        : m_reading(reading), m_layers(layers), m_order(stack), m_isPlaced(layers.size()) {
        for (const std::size_t row : stack) {
            m_isPlaced[row] = true;
        }
    }

    std::vector<std::int32_t> run(std::vector<DrawnLayer>& ordered) {
        placeCopper();
        placeSurfaces();
        for (std::size_t row = 0; row < m_layers.size(); ++row) {
            if (!m_isPlaced[row]) {
                m_order.push_back(row);
            }
        }
        std::vector<std::int32_t> rows(m_layers.size());
        for (std::size_t i = 0; i < m_order.size(); ++i) {
            rows[m_order[i]] = static_cast<std::int32_t>(i);
        }
        setSpans(rows);
        for (const std::size_t row : m_order) {
            m_layers[row].drawn.line = m_layers[row].line;
            ordered.push_back(std::move(m_layers[row].drawn));
        }
        return rows;
    }

private:
    /// Copper that the stackup does not have: behind the copper written before it, outer layers outside.
    void placeCopper() {
        std::vector<std::size_t> top;
        std::vector<std::size_t> bottom;
        std::size_t last = m_order.size();
        for (std::size_t row = 0; row < m_layers.size(); ++row) {
            if (!m_layers[row].isCopper() && m_layers[row].drawn.type != LayerType::Dielectric) {
                continue;
            }
            if (m_isPlaced[row]) {
                last = row;
                continue;
            }
            m_isPlaced[row] = true;
            if (m_layers[row].drawn.side == LayerSide::Top) {
                top.push_back(row);
            } else if (m_layers[row].drawn.side == LayerSide::Bottom) {
                bottom.push_back(row);
            } else {
                const auto behind = std::ranges::find(m_order, last);
                m_order.insert(behind == m_order.end() ? behind : behind + 1, row);
                last = row;
            }
        }
        m_order.insert(m_order.begin(), top.begin(), top.end());
        m_order.insert(m_order.end(), bottom.begin(), bottom.end());
    }

    void placeSurfaces() {
        std::vector<std::size_t> top;
        std::vector<std::size_t> bottom;
        for (std::size_t row = 0; row < m_layers.size(); ++row) {
            const DrawnLayer& layer = m_layers[row].drawn;
            if (m_isPlaced[row] || !m_layers[row].isSurface()) {
                continue;
            }
            m_isPlaced[row] = true;
            (layer.side == LayerSide::Bottom ? bottom : top).push_back(row);
        }
        const auto shell = [this](std::size_t row) { return shellOf(m_layers[row].drawn.type); };
        std::ranges::stable_sort(top, std::greater(), shell);
        std::ranges::stable_sort(bottom, std::less(), shell);
        m_order.insert(m_order.begin(), top.begin(), top.end());
        m_order.insert(m_order.end(), bottom.begin(), bottom.end());
    }

    void setSpans(const std::vector<std::int32_t>& rows) {
        for (std::size_t row = 0; row < m_layers.size(); ++row) {
            SourceLayer& layer = m_layers[row];
            if (!layer.isHoles() || (layer.from.empty() && layer.to.empty())) {
                continue;
            }
            const std::int32_t from = spanEnd(layer, layer.from, rows);
            const std::int32_t to = spanEnd(layer, layer.to, rows);
            if (from != kNoRow && to != kNoRow) {
                layer.drawn.spanTop = std::min(from, to);
                layer.drawn.spanBottom = std::max(from, to);
            }
        }
    }

    std::int32_t spanEnd(const SourceLayer& layer, std::string_view name, const std::vector<std::int32_t>& rows) {
        const int row = m_layers.find(name);
        if (row >= 0 && m_layers[static_cast<std::size_t>(row)].isCopper()) {
            return rows[static_cast<std::size_t>(row)];
        }
        m_reading.report(Severity::Warning, layer.line,
                         "the span of a layer of holes ends at no copper layer; all copper is passed");
        return kNoRow;
    }

    Reading& m_reading;
    LayerList& m_layers;
    std::vector<std::size_t> m_order;
    std::vector<bool> m_isPlaced;
};

}  // namespace

std::vector<std::int32_t> orderLayers(Reading& reading, LayerList& layers, const std::vector<std::size_t>& stack,
                                      std::vector<DrawnLayer>& ordered) {
    return LayerOrder(reading, layers, stack).run(ordered);
}

}  // namespace model::ipc2581
