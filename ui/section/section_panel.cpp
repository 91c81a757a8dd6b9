#include "ui/section/section_panel.h"

#include <QAction>
#include <QComboBox>
#include <QListView>
#include <QSplitter>
#include <QVBoxLayout>

#include "ui/common/panel_parts.h"
#include "ui/workspace/actions.h"

namespace ui {

SectionPanel::SectionPanel(SelectionModel& selection, QAbstractItemModel& kept, const ActionSet& actions,
                           QWidget* parent)
    : QWidget(parent),
      m_view(new SectionView(selection)),
      m_list(new QListView),
      m_heights(new QComboBox),
      m_notes(new QLabel) {
    m_heights->addItem(QStringLiteral("Heights to fill the view"), 0);
    for (const int times : {1, 2, 5, 10, 20, 50, 100}) {
        m_heights->addItem(QStringLiteral("Heights × %1").arg(times), times);
    }
    m_notes->setWordWrap(true);
    m_notes->hide();
    auto* clear = new QAction(QStringLiteral("Clear"), this);
    clear->setToolTip(QStringLiteral("Take the line and its section away"));
    connect(clear, &QAction::triggered, this, &SectionPanel::cleared);

    auto* remove = new QAction(QStringLiteral("Forget"), m_list);
    remove->setShortcut(QKeySequence::Delete);
    remove->setShortcutContext(Qt::WidgetShortcut);
    m_list->addAction(remove);
    m_list->setContextMenuPolicy(Qt::ActionsContextMenu);
    m_list->setModel(&kept);
    m_list->setAccessibleName(QStringLiteral("Kept sections"));
    m_list->setEditTriggers(QAbstractItemView::EditKeyPressed | QAbstractItemView::DoubleClicked);
    m_list->setToolTip(QStringLiteral("Kept sections: a click shows one, F2 names it, Del forgets it"));
    connect(remove, &QAction::triggered, this, [this] {
        if (m_list->currentIndex().isValid()) {
            emit forgotten(m_list->currentIndex().row());
        }
    });
    connect(m_list, &QListView::clicked, this, [this](const QModelIndex& at) { emit chosen(at.row()); });

    auto* row = new QHBoxLayout;
    for (const ActionId id : {ActionId::DrawSection, ActionId::SectionAlongNet, ActionId::OpenAlongSection,
                              ActionId::SaveSection, ActionId::ExportSection}) {
        row->addWidget(toolButton(actions[id]));
    }
    row->addWidget(toolButton(*clear));
    row->addStretch(1);
    row->addWidget(m_heights);
    auto* all = new QVBoxLayout(this);
    all->setContentsMargins(4, 4, 4, 4);
    all->addLayout(row);
    auto* both = new QSplitter;
    both->addWidget(m_view);
    both->addWidget(m_list);
    both->setStretchFactor(0, 5);
    both->setStretchFactor(1, 1);
    both->setChildrenCollapsible(false);
    all->addWidget(both, 1);
    all->addWidget(m_notes);
    connect(m_heights, &QComboBox::currentIndexChanged, this,
            [this] { m_view->setHeightTimes(m_heights->currentData().toDouble()); });
}

void SectionPanel::setRemarks(const QString& notes) {
    m_notes->setText(notes);
    m_notes->setVisible(!notes.isEmpty());
}

}  // namespace ui
