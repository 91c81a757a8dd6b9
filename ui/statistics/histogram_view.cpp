#include "ui/statistics/histogram_view.h"

#include <QHelpEvent>
#include <QKeyEvent>
#include <QLocale>
#include <QPainter>
#include <QToolTip>
#include <algorithm>
#include <cmath>

namespace ui {

namespace {

constexpr std::size_t kMostBars = 16;
constexpr double kMargin = 6.0;

}  // namespace

HistogramView::HistogramView(QWidget* parent) : QWidget(parent) {
    setFocusPolicy(Qt::StrongFocus);
    setAccessibleName(tr("Histogram"));
    setMinimumSize(fontMetrics().averageCharWidth() * 40, fontMetrics().height() * 5);
}

void HistogramView::setDocument(std::shared_ptr<const model::Document> document) {
    m_document = std::move(document);
    invalidate();
}

void HistogramView::setMeasure(model::Measure measure) {
    m_measure = measure;
    invalidate();
}

void HistogramView::setUnit(LengthUnit unit) {
    m_unit = unit;
    update();
}

void HistogramView::invalidate() {
    m_histogram.reset();
    m_current.reset();
    update();
}

const model::Histogram& HistogramView::histogram() const {
    if (!m_histogram) {
        m_histogram = m_document ? model::histogramOf(*m_document, m_measure, kMostBars) : model::Histogram{};
    }
    return *m_histogram;
}

QRectF HistogramView::columnRect(std::size_t bar) const {
    const double line = fontMetrics().height();
    const double wide = (width() - 2 * kMargin) / static_cast<double>(histogram().bars.size());
    return {kMargin + wide * static_cast<double>(bar), kMargin, wide, height() - 2 * kMargin - line};
}

QString HistogramView::lengthsText(const model::HistogramBar& bar) const {
    const QString least = lengthText(bar.least, m_unit);
    return bar.least == bar.most ? least : tr("%1 to %2").arg(least, lengthText(bar.most, m_unit));
}

void HistogramView::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.fillRect(rect(), palette().base());
    painter.setPen(palette().color(QPalette::Text));
    if (histogram().bars.empty()) {
        painter.drawText(rect(), Qt::AlignCenter, tr("There is nothing of this kind on the board"));
        return;
    }
    painter.drawText(QRectF(rect()).adjusted(0.0, 2.0, -kMargin, 0.0), Qt::AlignRight, QLatin1String(unitName(m_unit)));
    for (std::size_t bar = 0; bar < histogram().bars.size(); ++bar) {
        paintBar(painter, bar);
        paintCount(painter, bar);
        paintLabel(painter, bar);
    }
}

QString HistogramView::countText(std::size_t bar) const {
    return QLocale().toString(qulonglong{histogram().bars[bar].count});
}

/// With the space to the next one.
double HistogramView::widestCount() const {
    int widest = 0;
    for (std::size_t bar = 0; bar < histogram().bars.size(); ++bar) {
        widest = std::max(widest, fontMetrics().horizontalAdvance(countText(bar)));
    }
    return widest + fontMetrics().averageCharWidth();
}

HistogramView::Counts HistogramView::counts() const {
    const QRectF column = columnRect(0);
    const double widest = widestCount();
    if (widest <= column.width()) {
        return Counts::Level;
    }
    return column.width() >= fontMetrics().height() && column.height() >= 2 * widest ? Counts::Turned : Counts::None;
}

/// The square root keeps a bar of one element visible beside one of thousands; the count is over it.
double HistogramView::topOf(std::size_t bar) const {
    const auto& bars = histogram().bars;
    const auto count = [](const model::HistogramBar& of) { return static_cast<double>(of.count); };
    const double highest = count(*std::ranges::max_element(bars, {}, &model::HistogramBar::count));
    const QRectF column = columnRect(bar);
    const double room = column.height() - (counts() == Counts::Turned ? widestCount() : fontMetrics().height());
    return column.bottom() - std::max(2.0, room * std::sqrt(count(bars[bar]) / highest));
}

QRectF HistogramView::countRect(std::size_t bar) const {
    if (counts() == Counts::None) {
        return {};
    }
    const QRectF column = columnRect(bar);
    const double high = counts() == Counts::Turned ? widestCount() : fontMetrics().height();
    return {column.left(), topOf(bar) - high, column.width(), high};
}

void HistogramView::paintBar(QPainter& painter, std::size_t bar) const {
    const QRectF column = columnRect(bar);
    const double space = std::min(3.0, column.width() / 6);
    const double top = topOf(bar);
    const QRectF filled(column.left() + space, top, column.width() - 2 * space, column.bottom() - top);
    painter.fillRect(filled, palette().color(bar == m_current ? QPalette::Highlight : QPalette::PlaceholderText));
}

void HistogramView::paintCount(QPainter& painter, std::size_t bar) const {
    const QRectF at = countRect(bar);
    if (counts() == Counts::Level) {
        painter.drawText(at, Qt::AlignCenter, countText(bar));
    } else if (counts() == Counts::Turned) {
        painter.save();
        painter.translate(at.bottomLeft());
        painter.rotate(-90.0);
        const double space = fontMetrics().averageCharWidth() / 2.0;
        painter.drawText(QRectF(space, 0.0, at.height() - space, at.width()), Qt::AlignVCenter | Qt::AlignLeft,
                         countText(bar));
        painter.restore();
    }
}

/// The least one alone stands where the bar begins.
void HistogramView::paintLabel(QPainter& painter, std::size_t bar) const {
    const QRectF column = columnRect(bar);
    const QString label = labelUnder(bar);
    const bool isWhole = label == numbersText(lengthsText(histogram().bars[bar])) &&
                         fontMetrics().horizontalAdvance(label) <= column.width();
    const QRectF below(column.left(), column.bottom(), isWhole ? column.width() : width() - column.left(),
                       fontMetrics().height());
    painter.drawText(below, isWhole ? Qt::AlignCenter : Qt::AlignLeft | Qt::AlignVCenter, label);
}

QString HistogramView::numbersText(const QString& lengths) const {
    return QString(lengths).remove(QStringLiteral(" ") + QLatin1String(unitName(m_unit)));
}

QString HistogramView::labelUnder(std::size_t bar) const {
    const std::vector<model::HistogramBar>& bars = histogram().bars;
    const double room = columnRect(bar).width();
    const double space = fontMetrics().averageCharWidth();
    const auto widest = [&](const auto& textOf) {
        double most = 0.0;
        for (const model::HistogramBar& each : bars) {
            most = std::max(most, fontMetrics().horizontalAdvance(numbersText(textOf(each))) + space);
        }
        return most;
    };
    const auto whole = [this](const model::HistogramBar& each) { return lengthsText(each); };
    if (widest(whole) <= room) {
        return numbersText(whole(bars[bar]));
    }
    const auto least = [this](const model::HistogramBar& each) { return lengthText(each.least, m_unit); };
    const auto every = static_cast<std::size_t>(std::max(1.0, std::ceil(widest(least) / room)));
    const double end = columnRect(bar).left() + widest(least);
    return bar % every == 0 && end <= width() ? numbersText(least(bars[bar])) : QString();
}

std::size_t HistogramView::barAt(QPointF at) const {
    std::size_t bar = 0;
    while (bar < histogram().bars.size() && !(at.x() >= columnRect(bar).left() && at.x() < columnRect(bar).right())) {
        ++bar;
    }
    return bar;
}

void HistogramView::choose(std::size_t bar) {
    if (bar >= histogram().bars.size()) {
        return;
    }
    m_current = bar;
    update();
    emit chosen(model::elementsOf(*m_document, histogram(), histogram().bars[bar]));
}

void HistogramView::mousePressEvent(QMouseEvent* event) {
    if (event->button() == Qt::LeftButton) {
        choose(barAt(event->position()));
    }
}

void HistogramView::keyPressEvent(QKeyEvent* event) {
    const std::size_t count = histogram().bars.size();
    if (event->key() == Qt::Key_Right) {
        choose(m_current ? std::min(*m_current + 1, count - 1) : 0);
    } else if (event->key() == Qt::Key_Left && count > 0) {
        choose(m_current ? *m_current - std::min<std::size_t>(*m_current, 1) : count - 1);
    } else {
        QWidget::keyPressEvent(event);
    }
}

bool HistogramView::event(QEvent* event) {
    if (event->type() == QEvent::ToolTip) {
        const auto* help = static_cast<QHelpEvent*>(event);
        const std::size_t bar = barAt(help->pos());
        const QString tip = bar < histogram().bars.size() ? tr("%1: %L2 elements, click to select them")
                                                                .arg(lengthsText(histogram().bars[bar]))
                                                                .arg(qulonglong{histogram().bars[bar].count})
                                                          : QString();
        QToolTip::showText(help->globalPos(), tip, this);
        return true;
    }
    return QWidget::event(event);
}

}  // namespace ui
