#include "ui/stackup/stackup_view.h"

#include <QHelpEvent>
#include <QKeyEvent>
#include <QPainter>
#include <QToolTip>
#include <algorithm>

#include "ui/common/thickness_text.h"

namespace ui {

namespace {

constexpr double kLabelGap = 6.0;  // between names and thicknesses
constexpr double kMargin = 8.0;
constexpr double kBoreWidth = 10.0;
constexpr double kLeader = 28.0;  // the longest between a layer and its label
constexpr double kShortestLeader = 16.0;
constexpr int kNameLetters = 9;  // names have room for so many, unless the drawing would be too narrow
constexpr QColor kSubstrate(0xb8, 0xa0, 0x60);
constexpr QColor kPlating(0xc8, 0x79, 0x3a);

QString boreNumber(std::size_t row) {
    return QString::number(row + 1);
}

/// A to Z, then AA: holes have numbers.
QString zoneLetters(std::size_t zone) {
    constexpr std::size_t kLetters = 26;
    const QString last = QChar(static_cast<char16_t>(u'A' + zone % kLetters));
    return zone < kLetters ? last : zoneLetters(zone / kLetters - 1) + last;
}

}  // namespace

StackupView::StackupView(QWidget* parent) : QWidget(parent) {
    setFocusPolicy(Qt::StrongFocus);
    setAccessibleName(tr("Stackup drawing"));
}

void StackupView::setStackup(std::shared_ptr<const model::Document> document) {
    m_document = std::move(document);
    m_selected = m_document ? std::min(m_selected, static_cast<int>(m_document->stackup.rows.size()) - 1) : -1;
    const model::StackupDrawing least =
        m_document ? model::drawStackup(*m_document, {0.0, lineHeight(), false}) : model::StackupDrawing{};
    m_boreCount = least.bores.size();
    m_leastHeight = least.height;
    arrange();
}

void StackupView::setStyles(std::vector<QColor> colours, model::LayerId alone) {
    m_colours = std::move(colours);
    m_isolated = alone;
    update();
}

void StackupView::setSelected(int row) {
    m_selected = row;
    update();
}

void StackupView::setExaggerated(bool isOn) {
    m_isExaggerated = isOn;
    arrange();
}

void StackupView::setUnit(LengthUnit unit) {
    m_unit = unit;
    update();
}

QSize StackupView::sizeHint() const {
    return {fontMetrics().averageCharWidth() * 80, minimumHeight()};
}

/// Above the layers a line for the numbers of the holes, below them a line for each and for each letter of a zone, and
/// one to breathe.
double StackupView::roomBeside() const {
    return 2 * kMargin + lineHeight() * (static_cast<double>(m_boreCount + m_letteredZones) + 2.0);
}

void StackupView::arrange() {
    m_letteredZones = 0;
    draw();
    if (hasNarrowZone()) {
        m_letteredZones = m_drawing.columns.size();
        draw();
    }
    setMinimumHeight(static_cast<int>(m_leastHeight + roomBeside()));
    update();
}

void StackupView::draw() {
    m_drawing = m_document ? model::drawStackup(*m_document, {height() - roomBeside(), lineHeight(), m_isExaggerated})
                           : model::StackupDrawing{};
}

/// Does the name of a zone have no room above it?
bool StackupView::hasNarrowZone() const {
    for (std::size_t zone = 0; zone < m_drawing.columns.size() && !m_drawing.bands.empty(); ++zone) {
        if (fontMetrics().horizontalAdvance(zoneName(zone)) > zoneRect(0, zone).width()) {
            return true;
        }
    }
    return false;
}

QString StackupView::zoneName(std::size_t zone) const {
    return QString::fromStdString(m_drawing.columns[zone].part.name);
}

void StackupView::resizeEvent(QResizeEvent*) {
    arrange();
}

QRectF StackupView::bandRect(std::size_t row) const {
    const model::StackupBand& band = m_drawing.bands[row];
    const double top = kMargin + lineHeight();
    return {kMargin, top + band.top, labelLeft() - leader() - kMargin, band.bottom - band.top};
}

QRectF StackupView::zoneRect(std::size_t row, std::size_t zone) const {
    const QRectF band = bandRect(row);
    const model::StackupColumn& column = m_drawing.columns[zone];
    return {band.left() + column.left * band.width(), band.top(), (column.right - column.left) * band.width(),
            band.height()};
}

QRectF StackupView::boreRect(std::size_t row) const {
    const model::StackupBarrel& bore = m_drawing.bores[row];
    const double width = labelLeft() - leader() - kMargin;
    const double wide = std::min(kBoreWidth, bore.breadth * width / 2);  // the layers are seen between the holes
    return {kMargin + bore.x * width - wide / 2, kMargin + lineHeight() + bore.top, wide, bore.bottom - bore.top};
}

QColor StackupView::colourOf(const model::StackupRow& row) const {
    const bool hasOwn = row.layer.row() < m_colours.size() && row.type != model::LayerType::Dielectric;
    QColor colour = hasOwn ? m_colours[row.layer.row()] : kSubstrate;
    if (m_isolated.isValid() && row.layer != m_isolated) {
        colour.setAlphaF(0.3F);
    }
    return colour;
}

void StackupView::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.fillRect(rect(), palette().base());
    painter.setRenderHint(QPainter::Antialiasing);
    paintZoneNames(painter);
    const NameCut cut = nameCut();
    for (std::size_t row = 0; row < m_drawing.bands.size(); ++row) {
        paintBand(painter, row);
        paintLabel(painter, row, cut);
    }
    for (std::size_t row = 0; row < m_drawing.bores.size(); ++row) {
        paintBore(painter, row);
        paintCaption(painter, row);
    }
}

NameCut StackupView::nameCut() const {
    QStringList names;
    for (std::size_t row = 0; row < m_drawing.bands.size(); ++row) {
        if (m_document->stackup.rows[row].layer.isValid()) {
            names << QString::fromStdString(m_document->stackup.rows[row].name);
        }
    }
    return NameCut::forAll(names, fontMetrics(), static_cast<int>(nameRoom()));
}

double StackupView::labelLeft() const {
    const bool hasZones = m_drawing.columns.size() > 1;
    const double most = width() * (hasZones ? 0.52 : 0.42);
    const double least = width() * (hasZones ? 0.42 : 0.3);
    const double names = fontMetrics().averageCharWidth() * kNameLetters;
    return std::clamp(thicknessLeft() - kLabelGap - names, least, most);
}

double StackupView::nameRoom() const {
    return thicknessLeft() - kLabelGap - labelLeft();
}

double StackupView::leader() const {
    return std::clamp(width() * 0.08, kShortestLeader, kLeader);
}

double StackupView::thicknessLeft() const {
    return width() - fontMetrics().horizontalAdvance(QStringLiteral(" 888.888 µm "));
}

/// In the line above the layers; a board without zones has none. Without room for them letters, and below the layers
/// what each stands for.
void StackupView::paintZoneNames(QPainter& painter) const {
    painter.setPen(palette().color(QPalette::Text));
    for (std::size_t zone = 0; zone < m_drawing.columns.size(); ++zone) {
        painter.drawText(zoneHeading(zone), Qt::AlignCenter, m_letteredZones > 0 ? zoneLetters(zone) : zoneName(zone));
    }
    for (std::size_t zone = 0; zone < m_letteredZones; ++zone) {
        const QRectF line = captionLine(zone);
        painter.drawText(line, Qt::AlignVCenter, zoneCaptionOf(zone, static_cast<int>(line.width())));
    }
}

QRectF StackupView::zoneHeading(std::size_t zone) const {
    const QRectF column = zoneRect(0, zone);
    return {column.left(), kMargin, column.width(), lineHeight()};
}

QString StackupView::zoneCaptionOf(std::size_t zone, int room) const {
    return fontMetrics().elidedText(zoneLetters(zone) + QStringLiteral("  ") + zoneName(zone), Qt::ElideMiddle, room);
}

void StackupView::paintBand(QPainter& painter, std::size_t row) const {
    const model::StackupRow& layer = m_document->stackup.rows[row];
    const bool isIsolated = layer.layer.isValid() && layer.layer == m_isolated;
    const bool standsOut = isIsolated || static_cast<int>(row) == m_selected;
    for (std::size_t zone = 0; zone < m_drawing.columns.size(); ++zone) {
        if (!m_drawing.columns[zone].part.has[row]) {
            continue;
        }
        const QRectF band = zoneRect(row, zone);
        painter.fillRect(band, colourOf(layer));
        painter.setPen(standsOut ? QPen(palette().color(QPalette::Highlight), 2.0)
                                 : QPen(palette().color(QPalette::Mid), 0.5));
        painter.drawRect(band);
    }
}

void StackupView::paintLabel(QPainter& painter, std::size_t row, const NameCut& cut) const {
    const model::StackupRow& layer = m_document->stackup.rows[row];
    const QRectF band = bandRect(row);
    const double y = kMargin + lineHeight() + m_drawing.bands[row].label;
    painter.setPen(QPen(palette().color(QPalette::PlaceholderText), 0.7));
    painter.drawPolyline(QPolygonF{{band.right(), band.center().y()},
                                   {band.right() + 5.0, band.center().y()},
                                   {labelLeft() - 7.0, y},
                                   {labelLeft() - 3.0, y}});
    const bool isSelected = static_cast<int>(row) == m_selected;
    if (isSelected) {
        painter.fillRect(QRectF(labelLeft() - 2.0, y - lineHeight() / 2, width() - labelLeft() + 2.0, lineHeight()),
                         palette().highlight());
    }
    painter.setPen(palette().color(isSelected ? QPalette::HighlightedText : QPalette::Text));
    const auto write = [&](double left, double right, const QString& text) {
        painter.drawText(QRectF(left, y - lineHeight() / 2, right - left, lineHeight()), Qt::AlignVCenter, text);
    };
    const double nameRight = thicknessLeft() - kLabelGap;
    write(labelLeft(), nameRight,
          cut.of(QString::fromStdString(layer.name), fontMetrics(), static_cast<int>(nameRight - labelLeft())));
    QFont slanted = font();
    slanted.setItalic(layer.source == model::Source::Assumed);
    slanted.setBold(layer.source == model::Source::Session);
    painter.setFont(slanted);
    write(thicknessLeft(), width(), thicknessText(layer.thickness, m_unit));
    painter.setFont(font());
}

void StackupView::paintBore(QPainter& painter, std::size_t row) const {
    const model::StackupBarrel& bore = m_drawing.bores[row];
    const bool isBackdrill = bore.span == model::HoleSpan::Backdrill;
    const QRectF hole = boreRect(row);
    painter.fillRect(hole, isBackdrill ? QBrush(palette().color(QPalette::Text), Qt::BDiagPattern)
                                       : QBrush(palette().color(QPalette::Base)));
    painter.setPen(bore.isPlated ? QPen(kPlating, 2.0) : QPen(palette().color(QPalette::Text), 1.0));
    painter.drawLine(hole.topLeft(), hole.bottomLeft());
    painter.drawLine(hole.topRight(), hole.bottomRight());
    painter.setPen(palette().color(QPalette::Text));
    painter.drawText(QRectF(hole.center().x() - 20.0, kMargin, 40.0, lineHeight()), Qt::AlignCenter, boreNumber(row));
}

void StackupView::paintCaption(QPainter& painter, std::size_t row) const {
    const QRectF line = captionRect(row);
    painter.setPen(palette().color(QPalette::Text));
    painter.drawText(line, Qt::AlignVCenter, captionOf(row, static_cast<int>(line.width())));
}

QString StackupView::captionOf(std::size_t row, int room) const {
    constexpr int kLeastLetters = 4;
    const QString name = QString::fromStdString(m_document->layer(m_drawing.bores[row].layer).name);
    const QString text = boreText(row);
    const QString number = boreNumber(row) + QStringLiteral("  ");
    const QString rest = text.mid(name.size());
    const int left = room - fontMetrics().horizontalAdvance(number + rest);
    const QString cut = fontMetrics().elidedText(name, Qt::ElideMiddle, std::max(left, 0));
    const bool isNamed = cut == name || cut.size() > kLeastLetters;
    const QString unnamed = rest.mid(QStringView(u": ").size());
    return fontMetrics().elidedText(number + (isNamed ? cut + rest : unnamed), Qt::ElideRight, room);
}

QString StackupView::boreText(std::size_t row) const {
    return QString::fromStdString(model::boreText(*m_document, m_drawing.bores[row], lengthWriter(m_unit)));
}

std::size_t StackupView::boreAt(QPointF at) const {
    std::size_t row = 0;
    while (row < m_drawing.bores.size() && !boreRect(row).contains(at)) {
        ++row;
    }
    return row;
}

/// Below the layers those of the zones come first, then those of the holes.
QRectF StackupView::captionLine(std::size_t row) const {
    const double top = kMargin + m_drawing.height + lineHeight() * (static_cast<double>(row) + 1.5);
    return {kMargin, top, width() - 2 * kMargin, lineHeight()};
}

QRectF StackupView::captionRect(std::size_t row) const {
    return captionLine(m_letteredZones + row);
}

std::size_t StackupView::captionAt(QPointF at) const {
    std::size_t row = 0;
    while (row < m_drawing.bores.size() && !captionRect(row).contains(at)) {
        ++row;
    }
    return row;
}

std::size_t StackupView::rowAt(QPointF at) const {
    std::size_t row = 0;
    for (; row < m_drawing.bands.size(); ++row) {
        const double label = kMargin + lineHeight() + m_drawing.bands[row].label;
        const bool isOnLabel = at.x() >= labelLeft() && std::abs(at.y() - label) <= lineHeight() / 2;
        if (isOnLabel || bandRect(row).contains(at)) {
            break;
        }
    }
    return row;
}

model::LayerId StackupView::layerAt(QPointF at) const {
    if (const std::size_t bore = boreAt(at); bore < m_drawing.bores.size()) {
        return m_drawing.bores[bore].layer;
    }
    const std::size_t row = rowAt(at);
    return row < m_drawing.bands.size() ? m_document->stackup.rows[row].layer : model::LayerId{};
}

QString StackupView::tipAt(QPointF at) const {
    if (const std::size_t bore = boreAt(at); bore < m_drawing.bores.size()) {
        return boreText(bore);
    }
    if (const std::size_t bore = captionAt(at); bore < m_drawing.bores.size()) {
        return boreText(bore);
    }
    for (std::size_t zone = 0; zone < m_letteredZones; ++zone) {
        if (zoneHeading(zone).contains(at)) {
            return zoneName(zone);
        }
    }
    const std::size_t row = rowAt(at);
    if (row >= m_drawing.bands.size()) {
        return {};
    }
    const model::StackupRow& layer = m_document->stackup.rows[row];
    return QStringLiteral("%1: %2%3, %4")
        .arg(QString::fromStdString(layer.name), thicknessText(layer.thickness, m_unit), zonesOf(row),
             layer.layer.isValid() ? tr("Alt+click shows it alone, Esc all again") : tr("no layer of the job"));
}

/// ", in Rigid and Flex"; nothing for a board without zones.
QString StackupView::zonesOf(std::size_t row) const {
    QStringList names;
    for (const model::StackupColumn& column : m_drawing.columns) {
        if (column.part.has[row] && !column.part.name.empty()) {
            names += QString::fromStdString(column.part.name);
        }
    }
    return names.isEmpty() ? QString() : tr(", in %1").arg(names.join(tr(" and ")));
}

void StackupView::mousePressEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton) {
        return;
    }
    const model::LayerId layer = layerAt(event->position());
    const std::size_t row = rowAt(event->position());
    if (event->modifiers().testFlag(Qt::AltModifier) && layer.isValid()) {
        emit isolateRequested(layer);
    }
    if (boreAt(event->position()) < m_drawing.bores.size()) {
        emit holesChosen(layer);
    } else if (row < m_drawing.bands.size()) {
        emit rowChosen(row);
    }
}

void StackupView::keyPressEvent(QKeyEvent* event) {
    switch (event->key()) {
        case Qt::Key_Up: step(-1); break;
        case Qt::Key_Down: step(1); break;
        default: QWidget::keyPressEvent(event);
    }
}

void StackupView::step(int by) {
    const auto count = static_cast<int>(m_drawing.bands.size());
    const int row = m_selected >= 0 ? m_selected + by : by > 0 ? 0 : count - 1;
    if (row >= 0 && row < count) {
        emit rowChosen(static_cast<std::size_t>(row));
    }
}

bool StackupView::event(QEvent* event) {
    if (event->type() == QEvent::ToolTip) {
        const auto* help = static_cast<QHelpEvent*>(event);
        QToolTip::showText(help->globalPos(), tipAt(help->pos()), this);
        return true;
    }
    return QWidget::event(event);
}

}  // namespace ui
