#include "ui/views/frame_display.h"

#include <QFontMetricsF>
#include <QLocale>
#include <QPainter>
#include <algorithm>

namespace ui {

namespace {

constexpr int kRestMs = 300;  // longer than a view that moves waits before it draws itself finely
constexpr double kMargin = 8.0;
constexpr double kPadding = 6.0;
constexpr double kBetween = 10.0;  // names and values
constexpr QColor kGround(20, 22, 26, 190);
constexpr QColor kNameInk(165, 172, 182);
constexpr QColor kValueInk(240, 242, 245);
constexpr double kBytesPerMib = 1024.0 * 1024.0;

QString count(std::uint64_t number) {
    return QLocale(QLocale::English).toString(static_cast<qulonglong>(number));
}

QString timesText(const std::optional<render::FrameStats>& stats) {
    if (!stats) {
        return FrameDisplay::tr("not known yet");
    }
    const QString cpu = FrameDisplay::tr("%1 ms to record it").arg(stats->cpuMs, 0, 'f', 1);
    return stats->gpuMs > 0.0 ? FrameDisplay::tr("%1 ms on the device, ").arg(stats->gpuMs, 0, 'f', 1) + cpu : cpu;
}

}  // namespace

QString backendText(render::Backend backend) {
    switch (backend) {
        case render::Backend::Auto: return FrameDisplay::tr("automatic");
        case render::Backend::Mesh: return FrameDisplay::tr("mesh shaders");
        case render::Backend::Pull: return FrameDisplay::tr("vertex pulling");
        case render::Backend::Impostor: return FrameDisplay::tr("exact outlines");
        case render::Backend::Raster: return FrameDisplay::tr("compute shaders");
        case render::Backend::Standard: return FrameDisplay::tr("stored triangles");
    }
    return {};
}

BoardCounts countsOf(const model::Document& document, const render::BoardModel& model) {
    BoardCounts counts;
    const model::StepTree tree = model::unfoldCopies(document);
    for (const model::StepCopy& copy : tree.copies) {
        counts.elements += tree.steps[copy.step]->elements.size();
    }
    counts.copies = tree.copies.size() - 1;
    const auto add = [&counts](const render::BoardModel& step) {
        counts.lets += step.lets.size();
        counts.triangles += step.indices.size() / 3;
    };
    add(model);
    std::ranges::for_each(model.steps, add);
    return counts;
}

FrameDisplay::FrameDisplay(BoardViews& views, Workspace& workspace, QObject* parent) : QObject(parent), m_views(views) {
    connect(&workspace, &Workspace::boardOpened, this, &FrameDisplay::setBoard);
    m_rest.setSingleShot(true);
    m_rest.setInterval(kRestMs);
    connect(&m_rest, &QTimer::timeout, this, &FrameDisplay::showTimes);
    connect(&views.solid(), &BoardView::timed, this, &FrameDisplay::onTimed);
    views.solid().addPainter([this](QPainter& painter) { paint(painter); }, BoardView::Shown::OnCanvas);
}

void FrameDisplay::setBoard(const LoadedBoard& board) {
    m_counts = countsOf(*board.document, *board.model);
    m_last.reset();
    m_views.solid().requestOverlay();
}

void FrameDisplay::setOn(bool isOn) {
    m_isOn = isOn;
    m_views.solid().requestOverlay();
}

/// A frame that is drawn only to show a time tells nothing new, even where the board had to be drawn for it: it would
/// ask for the next one, forever.
void FrameDisplay::onTimed(const render::FrameStats& stats) {
    if (std::exchange(m_isOwn, false) || stats.isOverlayAlone || !stats.isByDevice) {
        return;
    }
    m_last = stats;
    if (m_isOn) {
        m_rest.start();
    }
}

void FrameDisplay::showTimes() {
    m_isOwn = m_isOn;
    if (m_isOn) {
        m_views.solid().requestOverlay();
    }
}

QList<std::pair<QString, QString>> FrameDisplay::lines() const {
    const render::BoardScene* scene = m_views.scene();
    if (scene == nullptr) {
        return {};
    }
    QString elements = count(m_counts.elements);
    if (m_counts.copies > 0) {
        elements += FrameDisplay::tr(" with %1 copies of steps").arg(count(m_counts.copies));
    }
    return {{FrameDisplay::tr("Last frame"), timesText(m_last)},
            {FrameDisplay::tr("Drawn by"), m_last ? backendText(m_last->backend) : FrameDisplay::tr("not known yet")},
            {FrameDisplay::tr("Elements"), elements},
            {FrameDisplay::tr("Lets"), FrameDisplay::tr("%1 stored").arg(count(m_counts.lets))},
            {FrameDisplay::tr("Triangles"), FrameDisplay::tr("%1 stored, of areas").arg(count(m_counts.triangles))},
            {FrameDisplay::tr("Memory"), FrameDisplay::tr("%1 MiB on the device for this board")
                                             .arg(static_cast<double>(scene->gpuBytes()) / kBytesPerMib, 0, 'f', 1)}};
}

void FrameDisplay::paint(QPainter& painter) const {
    const auto written = m_isOn ? lines() : QList<std::pair<QString, QString>>();
    if (written.isEmpty()) {
        return;
    }
    const QFontMetricsF metrics(painter.font());
    double names = 0.0;
    double values = 0.0;
    for (const auto& [name, value] : written) {
        names = std::max(names, metrics.horizontalAdvance(name));
        values = std::max(values, metrics.horizontalAdvance(value));
    }
    const double height = metrics.height() * static_cast<double>(written.size()) + 2 * kPadding;
    const double bottom = m_views.solid().controller().viewport().height() - kMargin;
    painter.setPen(Qt::NoPen);
    painter.setBrush(kGround);
    painter.drawRoundedRect(QRectF(kMargin, bottom - height, names + kBetween + values + 2 * kPadding, height), 4, 4);
    double base = bottom - height + kPadding + metrics.ascent();
    for (const auto& [name, value] : written) {
        painter.setPen(kNameInk);
        painter.drawText(QPointF(kMargin + kPadding, base), name);
        painter.setPen(kValueInk);
        painter.drawText(QPointF(kMargin + kPadding + names + kBetween, base), value);
        base += metrics.height();
    }
}

}  // namespace ui
