#include "ui/clearance/lens.h"

#include <algorithm>

namespace ui {

namespace {

constexpr std::size_t kMostSpacings = LensPainter::kMostLines;

}  // namespace

Lens::Lens(BoardViews& views, Workspace& workspace, QObject* parent)
    : QObject(parent), m_views(views), m_workspace(workspace), m_selection(workspace.selection()) {
    connect(&workspace, &Workspace::boardOpened, this, &Lens::setBoard);
    connect(&workspace, &Workspace::unitChanged, this, &Lens::tell);
    connect(&m_selection, &SelectionModel::selectionChanged, this, &Lens::search);
    connect(&m_selection, &SelectionModel::netsChanged, this, &Lens::search);
    connect(&m_search.background(), &Background::finished, this, &Lens::deliver);
    views.flat().addPainter([this](QPainter& painter) { paint(painter); });
}

void Lens::setBoard(const LoadedBoard& board) {
    m_search.cancel();
    m_board = board.document;
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
    m_search.cancel();
    m_near.clear();
    m_trouble.clear();
    std::vector<model::ElementId> elements;
    if (m_isOn && m_board) {
        elements = m_selection.ownElements();  // copies have no neighbours beyond their step
    }
    if (elements.empty()) {
        apply();
        return;
    }
    m_search.run([board = m_board, elements = std::move(elements)](
                     base::Progress& progress) { return model::copperNear(*board, elements, kMostReach, progress); },
                 tr("Searching nearby copper"), tr("there is not enough memory to search nearby copper"));
    emit reported(tr("searching…"));
}

void Lens::deliver() {
    if (auto near = m_search.take()) {
        m_near = std::move(*near);
    } else {
        m_trouble = QString::fromStdString(near.error().text);
    }
    apply();
}

std::span<const model::Nearby> Lens::highlighted() const {
    return std::span(m_near).first(m_highlightedCount);
}

void Lens::apply() {
    const auto end =
        std::ranges::upper_bound(m_near, m_reach, {}, [](const model::Nearby& n) { return n.spacing.distance; });
    m_highlightedCount = static_cast<std::size_t>(end - m_near.begin());
    std::vector<model::BoardElement> elements;
    for (const model::Nearby& near : highlighted()) {
        elements.push_back({0, near.element});
    }
    m_selection.setNearby(std::move(elements));
    m_views.flat().requestOverlay();
    tell();
}

void Lens::tell() {
    if (!m_isOn) {
        emit reported({});
    } else if (m_selection.selected().empty() && m_selection.nets().empty()) {
        emit reported(tr("select something"));
    } else if (!m_trouble.isEmpty()) {
        emit reported(m_trouble);
    } else if (m_selection.ownElements().empty()) {
        emit reported(tr("not in copies of other steps"));
    } else if (!isSearching()) {
        emit reported(tr("%L1 within %2").arg(m_highlightedCount).arg(lengthText(m_reach, m_workspace.unit())));
    }
}

void Lens::paint(QPainter& painter) {
    const BoardView& view = m_views.flat();
    std::vector<LensPainter::Line> lines;
    lines.reserve(std::min(kMostSpacings, m_highlightedCount));
    for (const model::Nearby& near : highlighted().first(std::min(kMostSpacings, m_highlightedCount))) {
        const auto from = view.screenOf(near.spacing.from);
        const auto to = view.screenOf(near.spacing.to);
        if (from && to) {
            lines.push_back({*from, *to, near.spacing.distance});
        }
    }
    LensPainter lens(painter, {QPointF(), view.controller().viewport()});
    lens.keepFree(view.corners());
    m_numbers = lens.paint(lines, m_workspace.unit());
}

}  // namespace ui
