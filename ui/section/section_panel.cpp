#include "ui/section/section_panel.h"

#include <QComboBox>
#include <QHeaderView>
#include <QSplitter>

#include "ui/common/panel_parts.h"
#include "ui/common/table_view.h"
#include "ui/section/section_list_model.h"
#include "ui/workspace/actions.h"

namespace ui {

namespace {

constexpr int kLeastHeight = 250;  // commands, a view that can be read, three lines of notes

}  // namespace

SectionPanel::SectionPanel(SelectionModel& selection, SectionListModel& saved, const ActionSet& actions,
                           QWidget* parent)
    : QWidget(parent),
      m_view(new SectionView(selection)),
      m_list(new TableView(saved)),
      m_heights(new QComboBox),
      m_notes(new QLabel) {
    m_heights->addItem(tr("Heights to fill the view"), 0);
    for (const int times : {1, 2, 5, 10, 20, 50, 100}) {
        m_heights->addItem(tr("Heights × %1").arg(times), times);
    }
    m_notes->setWordWrap(true);
    m_notes->hide();
    // A label that wraps says nothing of its height to docks, which would take it from the view.
    setMinimumHeight(kLeastHeight);
    QAction* clear =
        command(*this, "clearSection", tr("Clear"), tr("Remove the line and its section"), [this] { emit cleared(); });
    addListCommands();
    auto* row = buttonRow({&actions[ActionId::DrawSection], &actions[ActionId::SectionAlongNet],
                           &actions[ActionId::OpenAlongSection], &actions[ActionId::SaveSection],
                           &actions[ActionId::ExportSection], clear});
    row->addWidget(m_heights);
    m_view->addActions({&actions[ActionId::OpenAlongSection], &actions[ActionId::SaveSection],
                        &actions[ActionId::ExportSection], clear});
    auto* all = columnIn(*this, 4);
    all->addLayout(row);
    const auto showList = [this, &saved] { m_list->setVisible(saved.rowCount() > 0); };
    connect(&saved, &QAbstractItemModel::modelReset, m_list, showList);
    auto* both = new QSplitter;
    both->addWidget(m_view);
    both->addWidget(m_list);
    showList();
    both->setStretchFactor(0, 5);
    both->setStretchFactor(1, 1);
    both->setChildrenCollapsible(false);
    all->addWidget(both, 1);
    all->addWidget(m_notes);
    connect(m_heights, &QComboBox::currentIndexChanged, this,
            [this] { m_view->setHeightTimes(m_heights->currentData().toDouble()); });
}

void SectionPanel::addListCommands() {
    m_list->addAction(tr("Show"), m_list, [this] { m_list->choose(m_list->currentIndex()); });
    m_list->addAction(tr("Rename\tF2"), m_list, [this] { m_list->edit(m_list->currentIndex()); });
    m_list->addDelete(tr("Delete the selected section (Del)"));
    m_list->setSelectionMode(QAbstractItemView::SingleSelection);
    // A double click is a click that was meant well: the next key does not overwrite the name.
    m_list->setEditTriggers(QAbstractItemView::EditKeyPressed);
    m_list->horizontalHeader()->setStretchLastSection(true);
    m_list->setAccessibleName(tr("Saved sections"));
    m_list->setToolTip(tr("Saved sections: a click or Enter shows one, F2 renames it, Del deletes it"));
}

void SectionPanel::setNotes(const QString& notes) {
    m_notes->setText(notes);
    m_notes->setVisible(!notes.isEmpty());
}

}  // namespace ui
