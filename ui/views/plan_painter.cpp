#include "ui/views/plan_painter.h"

#include <QFontMetricsF>
#include <QGuiApplication>
#include <QPainter>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "model/figures/distance.h"
#include "model/geometry/outlines.h"
#include "model/index/pin_names.h"
#include "ui/common/net_name.h"
#include "ui/views/label_placing.h"

namespace ui {

namespace {

constexpr double kTickPixels = 64.0;   // between numbers of the rulers
constexpr double kSmallestName = 8.0;  // pixels high; smaller ones cannot be read
constexpr double kLargestName = 18.0;
constexpr double kFilled = 0.7;       // of the width of a stroke by letters
constexpr double kLineHeight = 1.15;  // of two lines, in heights of letters
/// More elements than this in sight are too small to be named.
constexpr std::size_t kMostInSight = 4000;
constexpr std::size_t kMostNames = 400;
/// Layers fainter than this are background.
constexpr float kReadableOpacity = 0.3F;
constexpr QColor kGridColour(150, 160, 175, 70);
constexpr QColor kAxisColour(190, 200, 215, 130);
constexpr QColor kRulerGround(24, 26, 31, 240);
constexpr QColor kRulerInk(190, 195, 205);

QString number(double nm, LengthUnit unit) {
    return QString::number(nm / nmPer(unit), 'g', 6);
}

/// Those through the origin stand out.
QColor gridColour(double at, double step) {
    return std::abs(at) < step / 2.0 ? kAxisColour : kGridColour;
}

/// The stretch of an element that a name can be written along, in nm.
struct Stretch {
    model::Point a;
    model::Point b;
    double width = 0.0;
};

Stretch longestTrack(const model::Document& document, const model::TrailGeometry& trail) {
    const auto nodes = document.nodesOf(trail);
    Stretch best;
    double longest = -1.0;
    for (std::size_t i = 0; i + 1 < nodes.size(); ++i) {
        const double length = std::hypot(double{1} * nodes[i + 1].point.x - nodes[i].point.x,
                                         double{1} * nodes[i + 1].point.y - nodes[i].point.y);
        if (length > longest) {
            longest = length;
            best = {nodes[i].point, nodes[i + 1].point, static_cast<double>(document.widthsOf(trail)[i])};
        }
    }
    return best;
}

/// The middle line of a box, along its longer side.
Stretch middleOf(const model::Box& box) {
    const auto middle = [](model::Nm a, model::Nm b) { return static_cast<model::Nm>((std::int64_t{a} + b) / 2); };
    if (box.width() >= box.height()) {
        const model::Nm y = middle(box.min.y, box.max.y);
        return {{box.min.x, y}, {box.max.x, y}, static_cast<double>(box.height())};
    }
    const model::Nm x = middle(box.min.x, box.max.x);
    return {{x, box.min.y}, {x, box.max.y}, static_cast<double>(box.width())};
}

/// Areas other than pads have no place that is sure to be copper: they get no name.
std::optional<Stretch> stretchOf(const model::Document& document, model::ElementId element) {
    const std::uint32_t row = document.elements.geometry[element.row()];
    switch (document.elements.kind[element.row()]) {
        case model::ElementKind::Line:
            return Stretch{document.lines[row].a, document.lines[row].b,
                           static_cast<double>(document.lines[row].width)};
        case model::ElementKind::Trail: return longestTrack(document, document.trails[row]);
        case model::ElementKind::Circle: return middleOf(document.boxOf(element));
        case model::ElementKind::Area:
            if ((document.elements.flags[element.row()] & model::kPad) != 0) {
                return middleOf(document.boxOf(element));
            }
            return std::nullopt;
        case model::ElementKind::Arc: return std::nullopt;
    }
    return std::nullopt;
}

/// Pixels that letters may be high, so that the lines fit across a stroke and along the room there is.
double heightOf(const QStringList& lines, double width, double room) {
    qsizetype longest = 1;
    for (const QString& line : lines) {
        longest = std::max(longest, line.size());
    }
    const double across = width * kFilled / (lines.size() > 1 ? kLineHeight * static_cast<double>(lines.size()) : 1.0);
    // Letters are about 0.6 as wide as high.
    return std::min({across, kLargestName, room * 0.9 / (0.6 * static_cast<double>(longest))});
}

/// How wide bold letters are, in heights of letters. To ask the font for each text would take its time.
double widthOf(const QString& line) {
    static const std::array<double, 128> kWidths = [] {
        constexpr int kPixels = 100;
        QFont font = QGuiApplication::font();
        font.setBold(true);
        font.setPixelSize(kPixels);
        const QFontMetricsF metrics(font);
        std::array<double, 128> widths{};
        for (std::size_t letter = 0; letter < widths.size(); ++letter) {
            widths[letter] = metrics.horizontalAdvance(QLatin1Char(static_cast<char>(letter))) / kPixels;
        }
        return widths;
    }();
    double width = 0.0;
    for (const QChar letter : line) {
        width += letter.unicode() < kWidths.size() ? kWidths[letter.unicode()] : 1.0;
    }
    return width;
}

/// What the letters of a label cover.
RotatedBox boxOf(const PlanPainter::Label& label) {
    constexpr double kCapitals = 0.8;  // of the height of letters
    const QStringList lines = label.text.split('\n');
    double widest = 0.0;
    for (const QString& line : lines) {
        widest = std::max(widest, widthOf(line));
    }
    const double high = kCapitals + kLineHeight * static_cast<double>(lines.size() - 1);
    return {label.middle, QSizeF(widest, high) * label.height, label.angleDeg};
}

/// The bodies of components that a view draws over a layer, and that nothing is seen through.
class CoveringBodies {
public:
    CoveringBodies(const BoardView& view, const model::BoardIndex& index, const model::Box& shown,
                   model::LayerId beneath)
        : m_view(view), m_index(index), m_copies(model::copiesIn(index, shown)) {
        const bool isFromBelow = view.controller().camera().direction().z > 0.0F;
        const model::LayerSide nearSide = isFromBelow ? model::LayerSide::Bottom : model::LayerSide::Top;
        const std::vector<render::LayerStyle>& styles = view.styles();
        for (std::size_t row = 0; beneath.isValid() && row < styles.size(); ++row) {
            const model::Layer& layer = index.board->layers[row];
            const render::LayerStyle& style = styles[row];
            const bool isOver = layer.side == nearSide && style.raised >= styles[beneath.row()].raised;
            if (layer.type == model::LayerType::ComponentBody && isOver && style.isVisible && style.opacity >= 1.0F) {
                m_layers.emplace_back(row);
            }
        }
    }

    [[nodiscard]] bool lieOver(QPointF at) {
        const base::PointD location = m_view.locationAt(at);
        const model::Box box = boxAt(location);
        return std::ranges::any_of(m_copies, [&](const model::CopyInBox& near) {
            return near.extent.meets(box) && std::ranges::any_of(m_layers, [&](model::LayerId layer) {
                       return isInOneOf(m_index.tree.copies[near.copy], layer, location);
                   });
        });
    }

private:
    static model::Box boxAt(base::PointD location) {
        model::Box box;
        box.include(model::Point{static_cast<model::Nm>(location.x), static_cast<model::Nm>(location.y)});
        return box;
    }
    [[nodiscard]] bool isInOneOf(const model::StepCopy& copy, model::LayerId layer, base::PointD location) {
        const base::PointD own = model::unplaced(location, copy.placement);
        const model::LayerId ownLayer = m_index.board->layerOfCopy(layer, copy.isFlipped);
        bool isIn = false;
        m_index.elements[copy.step].visit(ownLayer, boxAt(own), [&](std::uint32_t row) {
            isIn = isIn || model::isInside(*m_index.figuresOf(copy.step, model::ElementId{row}), 0, own);
        });
        return isIn;
    }

    const BoardView& m_view;
    const model::BoardIndex& m_index;
    std::vector<model::CopyInBox> m_copies;
    std::vector<model::LayerId> m_layers;
};

}  // namespace

PlanPainter::PlanPainter(BoardView& view, Workspace& workspace, const NetStyles& styles, QObject* parent)
    : QObject(parent), m_view(view), m_workspace(workspace), m_styles(styles) {
    connect(&workspace, &Workspace::boardOpened, this, &PlanPainter::setBoard);
    connect(&workspace, &Workspace::unitChanged, this, [this] { m_view.requestOverlay(); });
    view.addPainter([this](QPainter& painter) { paint(painter); });
    showGrid(m_hasGrid);
}

void PlanPainter::setBoard(const LoadedBoard& board) {
    m_index = board.index;
    m_view.requestOverlay();
}

void PlanPainter::showGrid(bool isOn) {
    m_hasGrid = isOn;
    m_view.controller().setMargins(isOn ? QMarginsF(kRulerPixels, kRulerPixels, 0, 0) : QMarginsF());
    m_view.requestOverlay();
}

void PlanPainter::showNames(bool isOn) {
    m_hasNames = isOn;
    m_view.requestOverlay();
}

void PlanPainter::showPinNames(bool isOn) {
    m_hasPinNames = isOn;
    m_view.requestOverlay();
}

model::Box PlanPainter::shownBox() const {
    const QSizeF size = m_view.controller().viewport();
    return m_view.boxBetween({}, {size.width(), size.height()});
}

double PlanPainter::gridStep(double nmPerPixel, LengthUnit unit, double pixels) {
    const double least = nmPerPixel * pixels / nmPer(unit);
    const double power = std::pow(10.0, std::floor(std::log10(least)));
    for (const double factor : {1.0, 2.0, 5.0}) {
        if (factor * power >= least * (1.0 - 1e-9)) {
            return factor * power * nmPer(unit);
        }
    }
    return 10.0 * power * nmPer(unit);
}

QPointF PlanPainter::screenOf(double x, double y) const {
    return m_view.screenOf({x, y}).value_or(QPointF());
}

QRectF PlanPainter::screenBoxOf(const model::BoardElement& at) const {
    const model::Box box = placedBoxOf(at);
    return QRectF(screenOf(box.min.x, box.min.y), screenOf(box.max.x, box.max.y)).normalized();
}

model::Box PlanPainter::placedBoxOf(const model::BoardElement& at) const {
    return m_index->tree.copies[at.copy].placement.boxOf(m_index->stepOf(at.copy).boxOf(at.element));
}

void PlanPainter::paint(QPainter& painter) const {
    if (!m_index) {
        return;
    }
    if (m_hasGrid) {
        paintGrid(painter, gridStep(m_view.controller().nmPerPixel(), m_workspace.unit()));
    }
    if (m_hasNames || m_hasPinNames) {
        paintNames(painter);
    }
    if (m_hasGrid) {
        paintRulers(painter);
    }
}

/// Lines are painted as pictures, which Qt blends at once: a line in a translucent colour it blends in threads that it
/// wakes for each, which took a quarter of a frame.
void PlanPainter::paintGrid(QPainter& painter, double step) const {
    const model::Box box = shownBox();
    const QSize size = m_view.controller().viewport().toSize();
    QImage upright({1, size.height()}, QImage::Format_ARGB32_Premultiplied);
    for (double x = std::ceil(box.min.x / step) * step; x <= box.max.x; x += step) {
        upright.fill(gridColour(x, step));
        painter.drawImage(QPointF(std::floor(screenOf(x, box.min.y).x()), 0.0), upright);
    }
    QImage level({size.width(), 1}, QImage::Format_ARGB32_Premultiplied);
    for (double y = std::ceil(box.min.y / step) * step; y <= box.max.y; y += step) {
        level.fill(gridColour(y, step));
        painter.drawImage(QPointF(0.0, std::floor(screenOf(box.min.x, y).y())), level);
    }
}

PlanPainter::RulerKey PlanPainter::rulerKey(const QFont& font) const {
    const model::Box box = shownBox();
    const double step = gridStep(m_view.controller().nmPerPixel(), m_workspace.unit(), kTickPixels);
    const QSize size = m_view.controller().viewport().toSize();
    return {box, screenOf(box.min.x, box.min.y), step, m_workspace.unit(), size, font};
}

void PlanPainter::paintRulers(QPainter& painter) const {
    QFont font = painter.font();
    font.setPixelSize(10);
    painter.setFont(font);
    painter.setRenderHint(QPainter::Antialiasing, false);  // ticks are sharp
    const RulerKey key = rulerKey(font);
    const QSize size = key.size;
    if (!m_upperRuler.show(painter, key)) {
        m_upperRuler.keep(painter, key, QRect(0, 0, size.width(), kRulerPixels),
                          [&](QPainter& own) { paintUpperRuler(own, key); });
    }
    if (!m_leftRuler.show(painter, key)) {
        m_leftRuler.keep(painter, key, QRect(0, kRulerPixels, kRulerPixels, size.height() - kRulerPixels),
                         [&](QPainter& own) { paintLeftRuler(own, key); });
    }
}

/// A number begins beside its tick. Where it would lie under the corner with the unit, or be cut, it is left out.
std::vector<PlanPainter::RulerTick> PlanPainter::ticks(Ruler ruler, const QFont& font) const {
    const RulerKey key = rulerKey(font);
    const bool isUpper = ruler == Ruler::Upper;
    const double low = isUpper ? key.box.min.x : key.box.min.y;
    const double high = isUpper ? key.box.max.x : key.box.max.y;
    const QFontMetricsF letters(font);
    std::vector<RulerTick> ticks;
    for (double value = std::ceil(low / key.step) * key.step; value <= high; value += key.step) {
        const double at = isUpper ? screenOf(value, key.box.min.y).x() : screenOf(key.box.min.x, value).y();
        RulerTick tick{at, number(value, key.unit)};
        const double width = letters.horizontalAdvance(tick.number);
        const bool hasRoom = isUpper ? tick.at >= kRulerPixels && tick.at + kBesideTick + width <= key.size.width()
                                     : tick.at - kBesideTick - width >= kRulerPixels;
        if (!hasRoom) {
            tick.number.clear();
        }
        ticks.push_back(tick);
    }
    return ticks;
}

/// With the unit in the corner.
void PlanPainter::paintUpperRuler(QPainter& painter, const RulerKey& key) const {
    painter.fillRect(QRect(0, 0, key.size.width(), kRulerPixels), kRulerGround);
    painter.setPen(kRulerInk);
    for (const RulerTick& tick : ticks(Ruler::Upper, key.font)) {
        painter.drawLine(QPointF(tick.at, kRulerPixels - 5), QPointF(tick.at, kRulerPixels));
        painter.drawText(QPointF(tick.at + kBesideTick, kRulerPixels - 6), tick.number);
    }
    const QRect corner(0, 0, kRulerPixels, kRulerPixels);
    painter.fillRect(corner, kRulerGround);
    painter.drawText(corner, Qt::AlignCenter, QLatin1String(unitName(key.unit)));
}

/// Below the upper one.
void PlanPainter::paintLeftRuler(QPainter& painter, const RulerKey& key) const {
    const QRect all(0, kRulerPixels, kRulerPixels, key.size.height() - kRulerPixels);
    painter.save();
    painter.setClipRect(all);
    painter.fillRect(all, kRulerGround);
    painter.setPen(kRulerInk);
    for (const RulerTick& tick : ticks(Ruler::Left, key.font)) {
        painter.drawLine(QPointF(kRulerPixels - 5, tick.at), QPointF(kRulerPixels, tick.at));
        painter.save();
        painter.translate(kRulerPixels - 6, tick.at - kBesideTick);
        painter.rotate(-90);
        painter.drawText(QPointF(0, 0), tick.number);
        painter.restore();
    }
    painter.restore();
}

model::LayerId PlanPainter::namedLayer() const {
    if (!m_index) {
        return {};
    }
    const std::vector<model::Layer>& layers = m_index->board->layers;
    const std::vector<render::LayerStyle>& styles = m_view.styles();
    const bool isFromBelow = m_view.controller().camera().direction().z > 0.0F;
    model::LayerId nearest;
    for (std::size_t row = 0; row < layers.size(); ++row) {
        const render::LayerStyle& style = styles[row];
        if (!layers[row].isCopper() || !style.isVisible || style.opacity <= kReadableOpacity) {
            continue;
        }
        const int nearer = nearest.isValid() ? style.raised - styles[nearest.row()].raised : 1;
        if (nearer > 0 || (nearer == 0 && isFromBelow)) {
            nearest = model::LayerId{row};
        }
    }
    return nearest;
}

/// Neither hidden, nor without anything to be called by.
bool PlanPainter::isNamed(const model::BoardElement& at) const {
    const model::ElementTable& elements = m_index->stepOf(at.copy).elements;
    const model::NetId net = elements.net[at.element.row()];
    const bool isHidden = net.isValid() && m_styles.isHidden({m_index->tree.copies[at.copy].step, net});
    return !isHidden && (net.isValid() || (elements.flags[at.element.row()] & model::kPad) != 0);
}

std::vector<model::BoardElement> PlanPainter::namedElements() const {
    const model::LayerId layer = namedLayer();
    std::vector<model::BoardElement> inSight;
    const std::vector<model::CopyInBox> copies =
        layer.isValid() ? model::copiesIn(*m_index, shownBox()) : std::vector<model::CopyInBox>();
    for (const model::CopyInBox& near : copies) {
        const model::StepCopy& copy = m_index->tree.copies[near.copy];
        const model::LayerId own = m_index->board->layerOfCopy(layer, copy.isFlipped);
        m_index->elements[copy.step].visit(own, near.box, [&](std::uint32_t row) {
            const model::BoardElement at{near.copy, model::ElementId{row}};
            if (inSight.size() <= kMostInSight && isNamed(at)) {
                inSight.push_back(at);
            }
        });
        if (inSight.size() > kMostInSight) {
            return {};
        }
    }
    std::ranges::sort(inSight);  // ids do not depend on how the index was walked
    return inSight;
}

/// "U1.5", and "5" where there is no room for that; "U1" of a pad without a name; empty for what is no pad of one pin.
QStringList PlanPainter::pinNames(const model::BoardElement& at) const {
    const model::Document& step = m_index->stepOf(at.copy);
    const std::vector<model::PinId> pins =
        m_hasPinNames ? m_index->pinsOf(at.copy).pinsOf(at.element) : std::vector<model::PinId>();
    if (pins.size() != 1 || !step.pins[pins.front().row()].component.isValid()) {
        return {};
    }
    const QString full = QString::fromStdString(model::fullPinName(step, pins.front()));
    const QString name = QString::fromStdString(model::pinName(step, pins.front()));
    return name.isEmpty() ? QStringList{full} : QStringList{full, name};
}

/// What may be written on an element, line by line, the most telling first.
std::vector<QStringList> PlanPainter::textsFor(const model::BoardElement& at) const {
    const model::Document& step = m_index->stepOf(at.copy);
    const model::NetId id = step.elements.net[at.element.row()];
    const QString net = m_hasNames ? netName(step, id) : QString();
    const QStringList pins = pinNames(at);
    std::vector<QStringList> texts;
    if (!net.isEmpty()) {
        for (const QString& pin : pins) {
            texts.push_back({pin, net});
        }
        texts.push_back({net});
    }
    for (const QString& pin : pins) {
        texts.push_back({pin});
    }
    return texts;
}

std::optional<PlanPainter::Label> PlanPainter::labelFor(const model::BoardElement& at) const {
    const double perPixel = m_view.controller().nmPerPixel();
    const std::optional<Stretch> stretch = stretchOf(m_index->stepOf(at.copy), at.element);
    if (!stretch || stretch->width / perPixel * kFilled < kSmallestName) {
        return std::nullopt;
    }
    const model::Placement& placement = m_index->tree.copies[at.copy].placement;
    const auto [ax, ay] = placement.apply(base::toDouble(stretch->a));
    const auto [bx, by] = placement.apply(base::toDouble(stretch->b));
    const QPointF a = screenOf(ax, ay);
    const QPointF b = screenOf(bx, by);
    const double room = std::max(QLineF(a, b).length(), stretch->width / perPixel);
    Label label;
    label.middle = (a + b) / 2.0;
    label.angleDeg = std::atan2(b.y() - a.y(), b.x() - a.x()) * 180.0 / M_PI;
    label.angleDeg += label.angleDeg > 90.0 ? -180.0 : label.angleDeg <= -90.0 ? 180.0 : 0.0;
    for (const QStringList& lines : textsFor(at)) {
        label.height = heightOf(lines, stretch->width / perPixel, room);
        if (label.height >= kSmallestName) {
            label.text = lines.join('\n');
            return label;
        }
    }
    return std::nullopt;
}

/// Copper that is selected on layers that the named one hides; none of what is more than can be named.
/// Copper in sight that is seen through what lies over it, as it is selected or highlighted; not where it is too much
/// to be named.
std::vector<PlanPainter::PlacedElement> PlanPainter::standingOutBeneath() const {
    const SelectionModel& selection = m_workspace.selection();
    std::vector<model::BoardElement> standingOut = selection.selected();
    std::vector<PlacedElement> beneath;
    if (standingOut.size() > kMostNames) {
        return beneath;
    }
    if (const std::vector<model::BoardElement> ofNets = selection.elementsOf(selection.nets());
        ofNets.size() <= kMostInSight) {
        standingOut.insert(standingOut.end(), ofNets.begin(), ofNets.end());
    }
    const model::Box shown = shownBox();
    const model::LayerId named = namedLayer();
    for (const model::BoardElement& at : standingOut) {
        const model::LayerId layer = selection.layerOf(at);
        const bool isBeneath =
            layer != named && m_index->board->layer(layer).isCopper() && m_view.styles()[layer.row()].isVisible;
        if (const model::Box box = isBeneath ? placedBoxOf(at) : model::Box(); isBeneath && box.meets(shown)) {
            beneath.push_back({at, box});
        }
    }
    return beneath;
}

/// Does a name lie on one of them, with its middle or an end? It would pass for theirs.
bool PlanPainter::liesOn(const Label& label, const std::vector<PlacedElement>& elements) const {
    const double angle = label.angleDeg * std::numbers::pi / 180.0;
    const QPointF half = boxOf(label).size.width() / 2.0 * QPointF(std::cos(angle), std::sin(angle));
    for (const QPointF& end : {label.middle - half, label.middle, label.middle + half}) {
        const base::PointD location = m_view.locationAt(end);
        const auto covers = [&](const PlacedElement& element) {
            if (!element.box.holds(model::rounded(location))) {
                return false;
            }
            const model::StepCopy& copy = m_index->tree.copies[element.at.copy];
            model::FigureTable point;
            point.addDisc(model::rounded(model::unplaced(location, copy.placement)), 0.0);
            return model::spacingBetween(*m_index->figuresOf(copy.step, element.at.element), point, 0.0).has_value();
        };
        if (std::ranges::any_of(elements, covers)) {
            return true;
        }
    }
    return false;
}

/// What is selected comes first, then pads: a track has its name elsewhere too. A name that would lie on an earlier one
/// is left out, and one whose place a body covers.
std::vector<PlanPainter::Label> PlanPainter::labels() const {
    std::vector<Label> labels;
    LabelRoom room;
    std::vector<QRectF> taken;  // by pads that are selected
    if (!m_index) {
        return labels;
    }
    CoveringBodies bodies(m_view, *m_index, shownBox(), namedLayer());
    const std::vector<PlacedElement> beneath = standingOutBeneath();
    const auto isPad = [&](const model::BoardElement& at) {
        return (m_index->stepOf(at.copy).elements.flags[at.element.row()] & model::kPad) != 0;
    };
    const auto add = [&](const model::BoardElement& at, bool isSeenThrough) {
        const std::optional<Label> label = labels.size() < kMostNames ? labelFor(at) : std::nullopt;
        const auto isOn = [&](const QRectF& pad) { return pad.contains(label->middle); };
        const bool isSeen = label && std::ranges::none_of(taken, isOn) &&
                            (isSeenThrough || (!bodies.lieOver(label->middle) && !liesOn(*label, beneath)));
        if (isSeen && room.take(boxOf(*label))) {
            labels.push_back(*label);
        }
    };
    const auto addSelected = [&](const model::BoardElement& at) {
        add(at, true);
        if (isPad(at)) {
            taken.push_back(screenBoxOf(at));
        }
    };
    std::vector<model::BoardElement> others = namedElements();
    const auto isOther = [&](const model::BoardElement& at) {
        return !std::ranges::binary_search(m_workspace.selection().selected(), at);
    };
    const auto selected = std::ranges::stable_partition(others, isOther);
    std::ranges::for_each(selected, addSelected);
    std::ranges::for_each(beneath, addSelected, &PlacedElement::at);
    others.erase(selected.begin(), selected.end());
    std::ranges::stable_partition(others, isPad);
    std::ranges::for_each(others, [&](const model::BoardElement& at) { add(at, false); });
    return labels;
}

void PlanPainter::paintNames(QPainter& painter) const {
    painter.setRenderHint(QPainter::TextAntialiasing);
    for (const Label& label : labels()) {
        QFont font = painter.font();
        font.setPixelSize(static_cast<int>(label.height));
        font.setBold(true);
        painter.save();
        painter.setFont(font);
        painter.translate(label.middle);
        painter.rotate(label.angleDeg);
        const QRectF room(-500.0, -label.height * 2.0, 1000.0, label.height * 4.0);
        painter.setPen(QColor(0, 0, 0, 190));
        painter.drawText(room.translated(1.0, 1.0), Qt::AlignCenter, label.text);
        painter.setPen(Qt::white);
        painter.drawText(room, Qt::AlignCenter, label.text);
        painter.restore();
    }
}

}  // namespace ui
