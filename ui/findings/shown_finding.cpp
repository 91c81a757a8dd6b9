#include "ui/findings/shown_finding.h"

#include <utility>

namespace ui {

ShownFinding::ShownFinding(SelectionModel& selection, BoardViews& views, QObject* parent)
    : QObject(parent), m_selection(selection), m_views(views) {
    connect(&selection, &SelectionModel::selectionChanged, this, [this] {
        if (m_selection.selected() != m_selected) {
            end();
        }
    });
}

void ShownFinding::show(std::vector<model::BoardElement> elements, std::vector<model::LayerId> layers) {
    m_isShown = false;
    m_selection.select(std::move(elements));
    m_selected = m_selection.selected();
    m_isShown = true;
    m_views.setContrastLayers(std::move(layers));
}

void ShownFinding::end() {
    if (std::exchange(m_isShown, false)) {
        m_views.setContrastLayers({});
        emit ended();
    }
}

}  // namespace ui
