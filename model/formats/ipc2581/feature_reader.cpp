#include "model/formats/ipc2581/feature_reader.h"

#include <algorithm>
#include <cmath>

#include "model/formats/ipc2581/shapes/stadium.h"
#include "model/formats/ipc2581/xml/xml_values.h"
#include "model/geometry/outlines.h"

namespace model::ipc2581 {

namespace {

using formats::DrawnFeature;
using formats::kNoRow;

/// Tools with tolerances that a layer's list keeps; more are no list of tools.
constexpr std::size_t kMostTools = 200;

bool isFiducial(std::string_view name) {
    return name.ends_with("Fiducial") || name == "BadBoardMark" || name == "GoodPanelMark";
}

bool isShapeOfNet(std::string_view name) {
    return name == "Contour" || name == "Polygon" || name == "Outline";
}

Plating platingNamed(std::string_view status) {
    return status == "PLATED"          ? Plating::Plated
           : status == "NONPLATED"     ? Plating::NonPlated
           : status.starts_with("VIA") ? Plating::Via
                                       : Plating::NotSaid;
}

Path squareOf(double side) {
    const double half = side / 2.0;
    Path path;
    for (const PointD corner :
         {PointD{-half, -half}, PointD{half, -half}, PointD{half, half}, PointD{-half, half}, PointD{-half, -half}}) {
        path.push_back({corner, {}, EdgeKind::Line});
    }
    return path;
}

}  // namespace

void FeatureReader::beginLayer(std::size_t layer) {
    m_layer = layer;
    if (m_step.features.size() <= layer) {
        m_step.features.resize(layer + 1);
    }
    const SourceLayer& source = m_layers[layer];
    m_canvas.beginLayer(m_step.features[layer], !source.isCopper() && !source.isHoles());
}

void FeatureReader::readLayerFeature(XmlCursor& at) {
    const std::string_view name = at.value("layerRef");
    if (m_layers.find(name) < 0) {
        m_reading.report(Severity::Warning, at.line(),
                         "a LayerFeature names a layer that is not listed; it is taken for a drawing");
    }
    beginLayer(m_layers.findOrAdd(name, LayerType::Document, at.line()));
    forEachChild(at, [&] {
        if (at.name() == "Set") {
            readSet(at);
        } else {
            m_reading.reportUnknown(at);
        }
    });
}

void FeatureReader::setNet(std::int32_t net) {
    m_canvas.ink().net = m_layers[m_layer].isCopper() || m_layers[m_layer].isHoles() ? net : kNoRow;
}

void FeatureReader::readSet(XmlCursor& at) {
    Set set;
    set.net = m_nets.row(at.value("net"));
    noteStart(set);
    set.isText = at.value("geometryUsage") == "TEXT";
    for (const std::string_view name : {"geometry", "geometryUsage", "padUsage", "componentRef", "netPair"}) {
        const std::string_view value = at.value(name);
        if (!value.empty() && value != "NONE") {
            set.words.emplace_back(std::string(name), textOf(value));
        }
    }
    if (isTrue(at.value("testPoint"))) {
        set.words.emplace_back("testPoint", "true");
    }
    m_isVia = at.value("padUsage") == "VIA";
    m_canvas.ink() = {};
    m_canvas.ink().isNegative = at.value("polarity") == "NEGATIVE";
    setNet(set.net);
    m_shapes.setPen({});
    forEachChild(at, [&] { readPart(at, set); });
    endSet(set);
}

void FeatureReader::readPart(XmlCursor& at, Set& set) {
    const std::string_view name = at.name();
    LineStyle pen;
    FillStyle fill;
    m_canvas.setLine(at.line());
    if (name == "Pad") {
        readPad(at);
    } else if (name == "Features") {
        readFeatures(at);
    } else if (name == "Hole" || name == "SlotCavity") {
        readCut(at, set);
    } else if (name == "NonstandardAttribute") {
        set.words.emplace_back(textOf(at.value("name")), textOf(at.value("value")));
    } else if (isFiducial(name)) {
        readPad(at);
    } else if (m_dictionaries.readStyle(at, m_reading.unitNm(), pen, fill)) {
        m_shapes.setPen(pen.width > 0.0 ? pen : LineStyle{});
    } else if (name == "SpecRef") {
        readSpec(at);
    } else if (name == "NetShort") {
        m_reading.report(Severity::Warning, at.line(),
                         "what joins nets on purpose (NetShort) is not read; they count as shorted");
    } else {
        setKind(isShapeOfNet(name) ? SubnetKind::Plane : SubnetKind::Trace);
        if (m_shapes.draw(at, {}, m_reading.unitNm())) {
            m_reading.report(Severity::Info, at.line(), "shapes right in a Set are read as those in Features");
        } else {
            m_reading.reportUnknown(at);
        }
    }
}

/// From here on features on this layer are those of the Set.
void FeatureReader::noteStart(Set& set) const {
    if (std::ranges::find(set.starts, m_layer, &SetStart::layer) == set.starts.end()) {
        set.starts.push_back({m_layer, m_canvas.count()});
    }
}

/// A Hole or SlotCavity lies on a layer of holes, whatever layer its Set is on; what follows it in the Set does not.
void FeatureReader::readCut(XmlCursor& at, Set& set) {
    const std::size_t layer = m_layer;
    const DrawnFeature ink = m_canvas.ink();
    if (!m_layers[layer].isHoles()) {
        beginLayer(m_layers.holesLayer({}, {}, at.line()));
        noteStart(set);
        setNet(set.net);
    }
    if (at.name() == "Hole") {
        readHole(at);
    } else {
        readSlot(at);
    }
    m_canvas.ink() = ink;
    beginLayer(layer);
}

void FeatureReader::endSet(const Set& set) {
    formats::DrawnGroup group;
    for (const SetStart& start : set.starts) {
        for (std::size_t i = start.feature; i < m_step.features[start.layer].size(); ++i) {
            group.features.emplace_back(static_cast<std::int32_t>(start.layer), static_cast<std::uint32_t>(i));
        }
    }
    if (group.features.empty()) {
        return;
    }
    const std::int32_t attributes = attributesOf(set.words);
    for (const auto& [layer, feature] : group.features) {
        m_step.features[static_cast<std::size_t>(layer)][feature].attributes = attributes;
    }
    const auto text = std::ranges::find(set.words, "TEXT", [](const auto& word) { return word.first; });
    if (set.isText && text != set.words.end()) {
        group.type = "TEXT";
        group.properties.push_back(*text);
        m_step.groups.push_back(std::move(group));
    }
}

std::int32_t FeatureReader::attributesOf(const formats::Words& words) {
    if (words.empty()) {
        return kNoRow;
    }
    std::string key;
    for (const auto& [name, value] : words) {
        key.append(name).append(1, '\0').append(value).append(1, '\0');
    }
    const auto [found, isNew] =
        m_attributes.try_emplace(std::move(key), static_cast<std::int32_t>(m_step.attributes.size()));
    if (isNew) {
        m_step.attributes.push_back(words);
    }
    return found->second;
}

void FeatureReader::readPlaced(XmlCursor& at, Placed& placed) {
    forEachChild(at, [&] {
        if (at.name() == "Location") {
            placed.locations.push_back(m_reading.point(at, m_reading.unitNm()));
        } else if (at.name() == "PinRef") {
            placed.pins.push_back({at.value("componentRef"), at.value("pin")});
        } else if (!readTurn(m_reading, at, m_reading.unitNm(), placed.turn)) {
            placed.shapes.push_back(at);  // Locations may follow
        }
    });
    if (placed.locations.empty()) {
        placed.locations.push_back({});
    }
}

void FeatureReader::drawPlaced(Placed& placed) {
    for (const PointD location : placed.locations) {
        for (const XmlCursor& shape : placed.shapes) {
            XmlCursor at = shape;
            if (!m_shapes.draw(at, placed.at(location), m_reading.unitNm())) {
                m_reading.reportUnknown(at);
            }
        }
    }
}

void FeatureReader::readPad(XmlCursor& at) {
    setKind(m_isVia ? SubnetKind::Via : SubnetKind::Other);
    const std::string_view definition = at.value("padstackDefRef");
    const std::uint32_t line = at.line();
    Placed placed;
    placed.turn.origin = {m_reading.lengthOr(at, "x", m_reading.unitNm(), 0.0),
                          m_reading.lengthOr(at, "y", m_reading.unitNm(), 0.0)};
    readPlaced(at, placed);
    const std::size_t first = m_canvas.count();
    drawPlaced(placed);
    usePadstack(definition, placed, line);
    if (placed.pins.size() > 1) {
        m_reading.report(Severity::Warning, line, "a pad is of several pins; it is taken for that of the first one");
    }
    if (!placed.pins.empty() && m_canvas.count() > first) {
        m_parts.addPad({m_layer, first, placed.pins[0].component, placed.pins[0].pin, m_layers[m_layer].isCopper()});
    }
}

/// A pad without a shape of its own has that of its padstack.
void FeatureReader::usePadstack(std::string_view name, const Placed& placed, std::uint32_t line) {
    const Padstack* const padstack = m_padstacks.find(name);
    if (padstack != nullptr && m_layers[m_layer].drawn.isNegative) {
        checkThermals(*padstack, placed, line);
    }
    for (const PointD location : placed.locations) {
        const Turn turn = placed.at(location);
        if (padstack != nullptr) {
            m_padstacks.use(*padstack, turn, line);
        }
        if (placed.shapes.empty()) {
            drawPadstack(padstack, name, turn, line);
        }
    }
}

/// Allegro writes flashes of thermals that it cannot draw as plain circles. Those narrower than the hole join the plane
/// all around; wider ones keep clear of it, against what their padstack says.
void FeatureReader::checkThermals(const Padstack& padstack, const Placed& placed, std::uint32_t line) {
    for (const XmlCursor& shape : placed.shapes) {
        if (!padstack.isThermal(m_layers[m_layer].drawn.name, shape.value("id"))) {
            continue;
        }
        XmlCursor at = shape;
        const ShapeSketch sketch = m_shapes.sketch(at, {}, m_reading.unitNm());
        const bool isCircle = sketch.contourCount() == 1 && sketch.contour(0).size() == 1;
        if (isCircle && static_cast<double>(boxOf(sketch).width()) > padstack.widestHole) {
            m_reading.report(
                Severity::Warning, line,
                "a thermal on a negative layer is a circle wider than its hole; as drawn it joins nothing");
        }
    }
}

void FeatureReader::drawPadstack(const Padstack* padstack, std::string_view name, const Turn& turn,
                                 std::uint32_t line) {
    if (padstack != nullptr && drawShapesOf(*padstack, turn)) {
        if (m_layers[m_layer].drawn.isNegative) {
            m_reading.report(Severity::Warning, line,
                             "a pad on a negative layer names only its padstack; its regular shape is cleared");
        }
    } else if (!m_shapes.drawStandard(name, turn)) {  // some name the shape itself
        m_reading.report(Severity::Warning, line,
                         "a pad has no shape, nor its padstack on that layer; it draws nothing");
    }
}

/// Those on this layer. False if there are none.
bool FeatureReader::drawShapesOf(const Padstack& padstack, const Turn& turn) {
    const std::string& layer = m_layers[m_layer].drawn.name;
    bool isDrawn = false;
    for (const PadstackPad& pad : padstack.pads) {
        if (textOf(pad.layer) == layer) {
            XmlCursor shape = pad.shape;
            isDrawn = m_shapes.draw(shape, turn.after(pad.turn), m_reading.unitNm()) || isDrawn;
        }
    }
    return isDrawn;
}

void FeatureReader::readFeatures(XmlCursor& at) {
    Placed placed;
    readPlaced(at, placed);
    const bool isPlane =
        std::ranges::any_of(placed.shapes, [](const XmlCursor& shape) { return isShapeOfNet(shape.name()); });
    setKind(isPlane ? SubnetKind::Plane : SubnetKind::Trace);
    drawPlaced(placed);
}

void FeatureReader::setPlating(const XmlCursor& at) {
    DrawnFeature& ink = m_canvas.ink();
    ink.plating = platingNamed(at.value("platingStatus"));
    ink.subnet = ink.plating == Plating::Via ? SubnetKind::Via : SubnetKind::Other;
}

/// Of a Set or a hole.
void FeatureReader::readSpec(const XmlCursor& at) {
    const Spec* const spec = m_specs.find(at);
    if (spec != nullptr && spec->isBackdrill) {
        m_reading.report(
            Severity::Warning, at.line(),
            "a Spec says that single holes are back-drilled; they keep their plating in all of their span");
    } else if (spec != nullptr) {
        m_reading.report(Severity::Info, at.line(), "what Specs say of single features is not read");
    }
}

void FeatureReader::readHole(XmlCursor& at) {
    const XmlCursor start = at;
    drawHole(start, readHolePlace(at));
}

Turn FeatureReader::readHolePlace(XmlCursor& at) {
    Turn turn{m_reading.point(at, m_reading.unitNm()), 0.0, false, 1.0};
    forEachChild(at, [&] {
        if (at.name() == "SpecRef") {
            readSpec(at);
        } else if (!readTurn(m_reading, at, m_reading.unitNm(), turn) && at.name() != "Span") {
            m_reading.reportUnknown(at);
        }
    });
    return turn;
}

void FeatureReader::drawHole(const XmlCursor& start, const Turn& turn) {
    setPlating(start);
    const std::uint32_t line = start.line();
    const double diameter = m_reading.length(start, "diameter", m_reading.unitNm()) * turn.scale;
    const Point size = m_reading.rounded({diameter, 0.0}, line);
    if (size.x <= 0) {
        return m_reading.report(Severity::Warning, line, "a hole without a diameter was left out");
    }
    if (start.value("type") == "SQUARE") {
        m_reading.report(Severity::Info, line, "the diameter of a square hole is taken for its side");
        return m_canvas.fill({squareOf(m_reading.length(start, "diameter", m_reading.unitNm())), {}}, turn);
    }
    m_canvas.addPad(m_canvas.roundSymbol(size.x), {turn.origin, 0.0, false, 1.0});
    addTool(start, size.x);
}

void FeatureReader::addTool(const XmlCursor& at, Nm diameter) {
    const auto tolerance = [&](const char* name) {
        return m_reading.rounded({std::abs(m_reading.lengthOr(at, name, m_reading.unitNm(), 0.0)), 0.0}, at.line()).x;
    };
    DrillTool tool;
    tool.plating = platingNamed(at.value("platingStatus"));
    tool.finishedSize = isPlated(tool.plating) ? diameter : 0;
    tool.drillSize = isPlated(tool.plating) ? 0 : diameter;
    tool.minTolerance = tolerance("minusTol");
    tool.maxTolerance = tolerance("plusTol");
    std::vector<DrillTool>& tools = m_layers[m_layer].drawn.tools;
    const auto isSame = [&](const DrillTool& other) {
        return other.plating == tool.plating && other.finishedSize == tool.finishedSize &&
               other.drillSize == tool.drillSize && other.minTolerance == tool.minTolerance &&
               other.maxTolerance == tool.maxTolerance;
    };
    const bool saysMore = tool.minTolerance > 0 || tool.maxTolerance > 0;
    if (saysMore && tools.size() < kMostTools && std::ranges::none_of(tools, isSame)) {
        tool.number = static_cast<int>(tools.size()) + 1;
        tools.push_back(tool);
    }
}

void FeatureReader::readSlot(XmlCursor& at) {
    setPlating(at);
    Placed placed;
    readPlaced(at, placed);
    std::erase_if(placed.shapes, [this](const XmlCursor& shape) {
        const bool isDepth = shape.name() == "Z_AxisDim" || shape.name() == "Fill" || shape.name() == "MaterialCut" ||
                             shape.name() == "MaterialLeft";
        if (isDepth) {
            m_reading.report(Severity::Info, shape.line(),
                             "depths of slots are not read; they pass the span of their layer");
        }
        return isDepth;
    });
    const std::size_t first = m_canvas.count();
    m_shapes.setOutlines(OutlineMeaning::Area);
    drawPlaced(placed);
    m_shapes.setOutlines(OutlineMeaning::Line);
    for (std::size_t i = first; i < m_canvas.count(); ++i) {
        drillIfStadium(m_canvas.feature(i));
    }
}

/// A slot with round ends is a path of a round cutter, whatever its outline is written as.
void FeatureReader::drillIfStadium(DrawnFeature& feature) {
    if (feature.kind != formats::DrawnKind::Region) {
        return;
    }
    if (const auto stadium = stadiumOf(m_step.regions[static_cast<std::size_t>(feature.region)])) {
        feature.kind = formats::DrawnKind::Line;
        feature.region = kNoRow;
        feature.symbol = m_canvas.roundSymbol(stadium->width);
        feature.a = stadium->a;
        feature.b = stadium->b;
    }
}

void FeatureReader::readLayerHole(XmlCursor& at, std::int32_t net) {
    StackHole hole{at, {}, net, {}, {}};
    XmlCursor inside = at;
    forEachChild(inside, [&] {
        if (inside.name() == "Span") {
            hole.from = inside.value("fromLayer");
            hole.to = inside.value("toLayer");
        }
    });
    hole.turn = readHolePlace(at);
    m_stackHoles.push_back(hole);
}

void FeatureReader::finish() {
    for (const std::size_t row : joinDrawnHoles(m_reading, m_stackHoles, m_step, m_layers)) {
        const StackHole& hole = m_stackHoles[row];
        m_canvas.ink() = {};
        m_canvas.setLine(hole.start.line());
        beginLayer(m_layers.holesLayer(hole.from, hole.to, hole.start.line()));
        setNet(hole.net);
        drawHole(hole.start, hole.turn);
    }
    m_padstacks.reportMissingHoles(m_step, m_layers);
}

void FeatureReader::readPadStack(XmlCursor& at) {
    const std::int32_t net = m_nets.row(at.value("net"));
    bool isVia = false;
    std::vector<XmlCursor> pads;
    forEachChild(at, [&] {
        m_canvas.ink() = {};
        m_canvas.setLine(at.line());
        if (at.name() == "LayerHole") {
            isVia = isVia || platingNamed(at.value("platingStatus")) == Plating::Via;
            readLayerHole(at, net);
        } else if (at.name() == "LayerPad") {
            pads.push_back(at);
        } else {
            m_reading.reportUnknown(at);
        }
    });
    for (XmlCursor& pad : pads) {
        const std::string_view layer = pad.value("layerRef");
        if (m_layers.find(layer) < 0) {
            m_reading.report(Severity::Warning, pad.line(),
                             "a LayerPad names a layer that is not listed; it was left out");
            continue;
        }
        beginLayer(m_layers.findOrAdd(layer, LayerType::Document, pad.line()));
        m_canvas.ink() = {};
        m_canvas.setLine(pad.line());
        setNet(net);
        m_isVia = isVia;
        readPad(pad);
    }
}

}  // namespace model::ipc2581
