#include "ui/lens.h"

#include <QPainter>
#include <algorithm>

namespace ui {

namespace {

constexpr QColor kGapColour(255, 90, 60);
constexpr double kGapPixels = 2.0;
constexpr std::size_t kMostGaps = 20'000;  ///< as many as are painted while the slider moves
constexpr int kRestMs = 250;

}  // namespace

Lens::Lens(BoardViews& views, models::SelectionModel& selection, QObject* parent)
    : QObject(parent), m_views(views), m_selection(selection) {
    connect(&selection, &models::SelectionModel::selectionChanged, this, &Lens::search);
    connect(&selection, &models::SelectionModel::netsChanged, this, &Lens::search);
    connect(&m_background, &Background::finished, this, &Lens::deliver);
    m_rest.setSingleShot(true);
    m_rest.setInterval(kRestMs);
    connect(&m_rest, &QTimer::timeout, this, &Lens::light);
    views.flat().addPainter([this](QPainter& painter) { paint(painter); });
}

void Lens::setBoard(const LoadedBoard& board) {
    m_background.cancel();
    m_board = board.document;
    m_place.origin = board.model->origin;
    m_near.clear();
    search();
}

void Lens::setOn(bool isOn) {
    m_isOn = isOn;
    search();
}

void Lens::setReach(double nm) {
    m_reach = std::min(nm, kMostReach);
    apply();
}

void Lens::search() {
    m_background.cancel();
    m_near.clear();
    if (!m_isOn || !m_board) {
        apply();
        return;
    }
    std::vector<model::ElementId> elements = m_selection.ownElements();  // copies have no neighbours beyond their step
    if (elements.empty()) {
        apply();
        return;
    }
    m_answer = std::make_shared<Answer>();
    m_background.start(
        [board = m_board, elements = std::move(elements), answer = m_answer](base::Progress& progress) {
            *answer = model::copperNear(*board, elements, kMostReach, progress);
        },
        "Looking around");
    emit told(QStringLiteral("looking…"));
}

void Lens::deliver() {
    const std::shared_ptr<Answer> answer = std::move(m_answer);
    if (answer && *answer && **answer) {
        m_near = std::move(***answer);
    }
    apply();
}

std::span<const model::Nearby> Lens::lit() const {
    return std::span(m_near).first(m_litCount);
}

void Lens::setUnit(models::LengthUnit unit) {
    m_unit = unit;
    tell();
}

void Lens::apply() {
    const auto end =
        std::ranges::upper_bound(m_near, m_reach, {}, [](const model::Nearby& n) { return n.gap.distance; });
    m_litCount = static_cast<std::size_t>(end - m_near.begin());
    m_views.flat().requestOverlay();
    tell();
    // What ends is dark at once; what moves is lit at once only where the board is drawn as quickly.
    const bool isSlow = m_views.flat().isSlow() || m_views.solid().isSlow();
    if (isSlow && m_litCount > 0) {
        m_rest.start();
    } else {
        light();
    }
}

void Lens::light() {
    m_rest.stop();
    std::vector<model::BoardElement> elements;
    for (const model::Nearby& near : lit()) {
        elements.push_back({0, near.element});
    }
    m_selection.setNearby(std::move(elements));
}

void Lens::tell() {
    if (!m_isOn) {
        emit told({});
    } else if (m_selection.selected().empty() && m_selection.nets().empty()) {
        emit told(QStringLiteral("select something"));
    } else if (!isSearching()) {
        emit told(QStringLiteral("%L1 within %2").arg(m_litCount).arg(models::lengthText(m_reach, m_unit)));
    }
}

void Lens::paint(QPainter& painter) const {
    painter.setPen(QPen(kGapColour, kGapPixels, Qt::SolidLine, Qt::RoundCap));
    const CameraController& controller = m_views.flat().controller();
    const QRectF canvas(QPointF(), controller.viewport());
    for (const model::Nearby& near : lit().first(std::min(kMostGaps, m_litCount))) {
        const auto from = controller.screenOf(m_place.toModel(near.gap.from));
        const auto to = controller.screenOf(m_place.toModel(near.gap.to));
        if (!from || !to || !(canvas.contains(*from) || canvas.contains(*to))) {
            continue;
        }
        if ((*to - *from).manhattanLength() < kGapPixels) {
            painter.fillRect(QRect(from->toPoint() - QPoint(1, 1), QSize(2, 2)), kGapColour);  // quicker than a stroke
        } else {
            painter.drawLine(*from, *to);
        }
    }
}

}  // namespace ui
