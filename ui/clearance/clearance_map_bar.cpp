#include "ui/clearance/clearance_map_bar.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QSlider>
#include <algorithm>
#include <iterator>

#include "ui/common/panel_parts.h"
#include "ui/workspace/actions.h"

namespace ui {

namespace {

constexpr double kReachesUm[] = {20,  25,  30,  40,   50,   60,   80,   100,  125,  150,  200,  250,  300,  400,
                                 500, 600, 800, 1000, 1250, 1500, 2000, 2500, 3000, 4000, 5000, 6000, 8000, 10'000};
constexpr double kFirstReachUm = 500;

}  // namespace

ClearanceMapBar::ClearanceMapBar(const ActionSet& actions, QWidget* parent)
    : QWidget(parent), m_slider(new QSlider(Qt::Horizontal)), m_reach(new QLabel), m_text(new QLabel) {
    m_slider->setRange(0, static_cast<int>(std::size(kReachesUm)) - 1);
    m_slider->setPageStep(3);
    m_slider->setValue(static_cast<int>(std::ranges::find(kReachesUm, kFirstReachUm) - std::begin(kReachesUm)));
    m_slider->setMaximumWidth(220);
    m_slider->setToolTip(tr("The map is coloured up to this distance; what is farther is darkened a little"));
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->addWidget(toolButton(actions[ActionId::ClearanceMap]));
    row->addWidget(m_slider, 1);
    row->addWidget(m_reach);
    row->addWidget(m_text, 1);
    connect(m_slider, &QSlider::valueChanged, this, [this] {
        showReach();
        emit reachChanged(reach());
    });
    showReach();
}

void ClearanceMapBar::setUnit(LengthUnit unit) {
    m_unit = unit;
    showReach();
}

void ClearanceMapBar::showText(const QString& text) {
    m_text->setText(text);
}

double ClearanceMapBar::reach() const {
    return kReachesUm[m_slider->value()] * base::kNmPerUm;
}

QString ClearanceMapBar::text() const {
    return m_text->text();
}

void ClearanceMapBar::showReach() {
    m_reach->setText(lengthText(reach(), m_unit));
}

}  // namespace ui
