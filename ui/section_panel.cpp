#include "ui/section_panel.h"

#include <QAction>
#include <QComboBox>
#include <QVBoxLayout>

#include "ui/actions.h"
#include "ui/tool_button.h"

namespace ui {

SectionPanel::SectionPanel(models::SelectionModel& selection, const ActionSet& actions, QWidget* parent)
    : QWidget(parent), m_view(new SectionView(selection)), m_heights(new QComboBox), m_remarks(new QLabel) {
    m_heights->addItem(QStringLiteral("Heights to fill the view"), 0);
    for (const int times : {1, 2, 5, 10, 20, 50, 100}) {
        m_heights->addItem(QStringLiteral("Heights × %1").arg(times), times);
    }
    m_remarks->setWordWrap(true);
    m_remarks->hide();
    auto* clear = new QAction(QStringLiteral("Clear"), this);
    clear->setToolTip(QStringLiteral("Take the line and its section away"));
    connect(clear, &QAction::triggered, this, &SectionPanel::cleared);

    auto* row = new QHBoxLayout;
    for (const ActionId id : {ActionId::DrawSection, ActionId::OpenAlongSection, ActionId::ExportSection}) {
        row->addWidget(toolButton(actions[id]));
    }
    row->addWidget(toolButton(*clear));
    row->addStretch(1);
    row->addWidget(m_heights);
    auto* all = new QVBoxLayout(this);
    all->setContentsMargins(4, 4, 4, 4);
    all->addLayout(row);
    all->addWidget(m_view, 1);
    all->addWidget(m_remarks);
    connect(m_heights, &QComboBox::currentIndexChanged, this,
            [this] { m_view->setHeightTimes(m_heights->currentData().toDouble()); });
}

void SectionPanel::setRemarks(const QString& remarks) {
    m_remarks->setText(remarks);
    m_remarks->setVisible(!remarks.isEmpty());
}

}  // namespace ui
