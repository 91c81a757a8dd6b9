#include "ui/element/element_facts.h"

#include <QCoreApplication>
#include <QStringList>
#include <algorithm>
#include <optional>

#include "model/board/holes.h"
#include "model/index/pin_names.h"
#include "model/measure/hole_ring.h"
#include "model/statistics/element_sizes.h"
#include "ui/common/net_name.h"

namespace ui {

namespace {

using model::Document;
using model::ElementId;
using model::ElementKind;

/// An element with the document it is a row of.
struct Subject {
    Q_DECLARE_TR_FUNCTIONS(ui::Facts)
public:
    const Document& step;
    const model::PinFinder& pins;
    const model::StepCopy& copy;
    ElementId element;
    LengthUnit unit;

    [[nodiscard]] std::uint32_t geometry() const { return step.elements.geometry[element.row()]; }
    [[nodiscard]] bool has(model::ElementFlag flag) const { return (step.elements.flags[element.row()] & flag) != 0; }
    [[nodiscard]] QString text(double nm) const { return lengthInBoth(nm, unit); }
    /// On which it lies: of a flipped copy another than the row has.
    [[nodiscard]] QString layerName() const {
        const model::LayerId own = step.elements.layer[element.row()];
        return QString::fromStdString(step.layer(step.layerOfCopy(own, copy.isFlipped)).name);
    }
    /// What the drill table says of it; nothing of what is no hole.
    [[nodiscard]] model::DrillRow hole() const {
        return has(model::kHole) ? model::drillRowOf(step, element) : model::DrillRow();
    }
};

QString kindText(const Subject& s) {
    if (s.step.bodyOf(s.element) != nullptr) {
        return s.tr("Body");
    }
    const ElementKind kind = s.step.elements.kind[s.element.row()];
    QString text = kind == ElementKind::Trail ? s.tr("track chain") : QString::fromLatin1(model::toString(kind));
    text[0] = text[0].toUpper();
    if (s.has(model::kHole)) {
        text = s.has(model::kPlated) ? s.tr("Plated hole (%1)").arg(text.toLower())
                                     : s.tr("NPTH (%1)").arg(text.toLower());
    } else if (s.has(model::kPad)) {
        text = s.tr("Pad (%1)").arg(text.toLower());
    }
    return text;
}

/// On the board, as the status line has it.
void addLocation(const Subject& s, model::Point point, const QString& name, Facts& facts) {
    const model::Point at = s.copy.placement.apply(point);
    facts.emplace_back(name, positionText(at.x, at.y, s.unit));
}

/// As the tool list of the job has it.
void addFinishedSize(const Subject& s, const model::DrillRow& hole, Facts& facts) {
    if (hole.tool != nullptr && hole.tool->finishedSize > 0) {
        facts.emplace_back(s.tr("Finished size"), s.text(hole.tool->finishedSize));
    }
}

void addCircle(const Subject& s, Facts& facts) {
    const model::CircleGeometry& circle = s.step.circles[s.geometry()];
    const model::DrillRow hole = s.hole();
    facts.emplace_back(s.tr("Diameter"), s.text(circle.diameter));
    if (circle.innerDiameter > 0 && circle.innerDiameter != circle.diameter) {
        const QString inner = s.text(circle.innerDiameter);
        facts.emplace_back(s.tr("Inner diameter"),
                           hole.isOpenAssumed
                               ? s.tr("%1 (assumed, usual plating of %2)")
                                     .arg(inner, lengthText((circle.diameter - circle.innerDiameter) / 2.0, s.unit))
                               : inner);
    }
    addFinishedSize(s, hole, facts);
    addLocation(s, circle.centre, s.tr("Centre"), facts);
}

void addTrail(const Subject& s, Facts& facts) {
    const model::TrailGeometry& trail = s.step.trails[s.geometry()];
    const auto nodes = s.step.nodesOf(trail);
    facts.emplace_back(s.tr("Width"), s.text(trail.width));
    facts.emplace_back(s.tr("Tracks"), QString::number(nodes.size() - 1));
    addLocation(s, nodes.front().point, s.tr("From"), facts);
    addLocation(s, nodes.back().point, s.tr("To"), facts);
}

/// A pad is where its symbol is placed, or else in the middle of what it covers.
void addArea(const Subject& s, Facts& facts) {
    const model::AreaGeometry& area = s.step.areas[s.geometry()];
    const auto contours = s.step.shapes.contoursOf(area.shape);
    const auto holes = std::ranges::count_if(contours, &model::Contour::isHole);
    if (s.step.elements.symbol[s.element.row()].isValid()) {
        addLocation(s, area.placement.origin, s.tr("Position"), facts);
        const QString turn = angleText(area.placement.clockwiseDeg);
        facts.emplace_back(s.tr("Rotation"), area.placement.isMirrored ? s.tr("%1 clockwise, mirrored").arg(turn)
                                                                       : s.tr("%1 clockwise").arg(turn));
    } else if (s.has(model::kPad)) {
        addLocation(s, s.step.boxOf(s.element).middle(), s.tr("Centre"), facts);
    }
    if (contours.size() > 1) {
        facts.emplace_back(s.tr("Islands"), QString::number(static_cast<std::ptrdiff_t>(contours.size()) - holes));
        facts.emplace_back(s.tr("Holes"), QString::number(holes));
    }
}

void addShape(const Subject& s, Facts& facts) {
    switch (s.step.elements.kind[s.element.row()]) {
        case ElementKind::Line: {
            const model::LineGeometry& line = s.step.lines[s.geometry()];
            facts.emplace_back(s.tr("Width"), s.text(line.width));
            addFinishedSize(s, s.hole(), facts);
            addLocation(s, line.a, s.tr("From"), facts);
            addLocation(s, line.b, s.tr("To"), facts);
            break;
        }
        case ElementKind::Arc: {
            const model::ArcGeometry& arc = s.step.arcs[s.geometry()];
            facts.emplace_back(s.tr("Width"), s.text(arc.width));
            addLocation(s, arc.node.point, s.tr("From"), facts);
            addLocation(s, arc.end, s.tr("To"), facts);
            addLocation(s, arc.node.centre, s.tr("Centre"), facts);
            break;
        }
        case ElementKind::Circle: addCircle(s, facts); break;
        case ElementKind::Trail: addTrail(s, facts); break;
        case ElementKind::Area: addArea(s, facts); break;
    }
}

void addMeasures(const Subject& s, Facts& facts) {
    if (const double length = model::lengthOf(s.step, s.element); length > 0.0) {
        facts.emplace_back(s.tr("Length"), s.text(length));
    }
    facts.emplace_back(s.tr("Area"), areaText(model::areaOf(s.step, s.element), s.unit));
    const model::Box box = s.step.boxOf(s.element);
    facts.emplace_back(s.tr("Extent"),
                       QStringLiteral("%1 × %2").arg(lengthText(static_cast<double>(box.width()), s.unit),
                                                     lengthText(static_cast<double>(box.height()), s.unit)));
    if (const model::Body* body = s.step.bodyOf(s.element)) {
        const QString height = s.text(body->height);
        facts.emplace_back(s.tr("Height"), body->source == model::Source::Assumed
                                               ? s.tr("%1 (assumed, usual for its package)").arg(height)
                                               : height);
    }
}

QString partText(const Subject& s, const model::Component& component) {
    QStringList words{QString::fromStdString(component.refdes)};
    if (!component.part.empty()) {
        words += QString::fromStdString(component.part);
    }
    if (component.package.isValid()) {
        words += QString::fromStdString(s.step.packages[component.package.row()].name);
    }
    return words.join(QStringLiteral("  "));
}

/// Pins, and the components they are of; of a body its component.
void addParts(const Subject& s, Facts& facts) {
    std::vector<model::ComponentId> parts;
    for (const model::PinId pin : s.pins.pinsOf(s.element)) {
        if (!s.step.pins[pin.row()].component.isValid()) {
            continue;
        }
        const Facts::value_type fact{s.tr("Pin"), QString::fromStdString(model::fullPinName(s.step, pin))};
        if (std::ranges::find(facts, fact) ==
            facts.end()) {  // a thermal pad has a pin for each of its vias, all of one name
            facts.push_back(fact);
        }
        parts.push_back(s.step.pins[pin.row()].component);
    }
    if (const model::Body* body = s.step.bodyOf(s.element)) {
        parts.push_back(body->component);
    }
    parts.erase(std::unique(parts.begin(), parts.end()), parts.end());
    for (const model::ComponentId part : parts) {
        if (part.isValid()) {
            facts.emplace_back(s.tr("Component"), partText(s, s.step.components[part.row()]));
        }
    }
}

void addSource(const Subject& s, Facts& facts) {
    const auto& elements = s.step.elements;
    const model::Layer& layer = s.step.layer(elements.layer[s.element.row()]);
    for (const auto& [name, value] : s.step.attributesOf(s.element)) {
        facts.emplace_back(QString::fromStdString(name), value.empty() ? s.tr("yes") : QString::fromStdString(value));
    }
    if (!layer.file.empty() && elements.line[s.element.row()] > 0) {
        facts.emplace_back(
            s.tr("Read from"),
            QStringLiteral("%1:%2").arg(QString::fromStdString(layer.file)).arg(elements.line[s.element.row()]));
    }
}

/// Of a pad with one hole: as the job drills it, and what the pad leaves around it.
void addHoleInPad(const Subject& s, const model::BoardIndex& index, const model::BoardElement& at, Facts& facts) {
    const std::optional<model::PadHole> in = model::holeInPad(index, at);
    if (!in) {
        return;
    }
    if (const model::DrillRow hole = model::drillRowOf(s.step, in->hole); model::hasDrilledSize(hole)) {
        facts.emplace_back(s.tr("Hole"), s.text(hole.diameter));
    }
    facts.emplace_back(s.tr("Annular ring"),
                       in->ring ? s.text(in->ring->distance) : s.tr("none: the hole breaks out of the pad"));
}

Subject subjectOf(const model::BoardIndex& index, const model::BoardElement& at, LengthUnit unit) {
    return {index.stepOf(at.copy), index.pinsOf(at.copy), index.tree.copies[at.copy], at.element, unit};
}

}  // namespace

Facts factsOf(const model::BoardIndex& index, const model::BoardElement& at, LengthUnit unit) {
    const Subject s = subjectOf(index, at, unit);
    const auto& elements = s.step.elements;
    const std::size_t row = at.element.row();
    Facts facts;
    facts.emplace_back(s.tr("Kind"), kindText(s));
    facts.emplace_back(s.tr("Layer"), s.layerName());
    if (elements.net[row].isValid()) {
        facts.emplace_back(s.tr("Net"), netName(s.step, elements.net[row]));
    }
    addParts(s, facts);
    if (elements.symbol[row].isValid()) {
        facts.emplace_back(s.tr("Symbol"), QString::fromStdString(s.step.symbols[elements.symbol[row].row()]));
    }
    addShape(s, facts);
    addHoleInPad(s, index, at, facts);
    addMeasures(s, facts);
    if (at.copy > 0) {
        facts.emplace_back(s.tr("Copy"),
                           s.tr("%1 of step %2").arg(at.copy).arg(QString::fromStdString(s.step.job.step)));
    }
    addSource(s, facts);
    return facts;
}

QString summaryOf(const model::BoardIndex& index, const model::BoardElement& at, LengthUnit unit) {
    const Subject s = subjectOf(index, at, unit);
    const auto& elements = s.step.elements;
    const std::size_t row = at.element.row();
    QStringList words{kindText(s)};
    Facts shape;
    addShape(s, shape);
    for (const auto& [name, value] : shape) {
        if (name == s.tr("Width") || name == s.tr("Diameter")) {
            const QString across = name == s.tr("Width") ? s.tr("%1 wide") : s.tr("%1 across");
            words.back() += QStringLiteral(", ") + across.arg(value.section(' ', 0, 1));
        }
    }
    words += s.layerName();
    if (elements.net[row].isValid()) {
        words += netName(s.step, elements.net[row]);
    }
    Facts parts;
    addParts(s, parts);
    for (const auto& [name, value] : parts) {
        if (name == s.tr("Pin") || parts.size() == 1) {  // pins name their components
            words += value.section(QStringLiteral("  "), 0, 0);
        }
    }
    return words.join(QStringLiteral(" · "));
}

}  // namespace ui
